use live::{Moment, Player, Room};
fn main() {
    let name = std::env::args().nth(1).unwrap();
    let (scene, _) = live::scenes().iter().find(|(s, _)| s.name == name).unwrap();
    let mut player = Player::new(scene).unwrap();
    let [azimuth, elevation] = scene.view.unwrap_or_default();
    let run = player.run();
    let n = 600;
    for _ in 0..3 {
        let (mut a, mut b, mut bytes) = (0.0, 0.0, 0);
        for k in 0..n {
            let time = run.duration * k as f64 / n as f64;
            let t0 = std::time::Instant::now();
            let d = player.draw(Moment { time, azimuth, elevation, room: Room::Wide }).unwrap();
            let t1 = std::time::Instant::now();
            bytes += d.to_elements().unwrap().len();
            b += t1.elapsed().as_secs_f64();
            a += (t1 - t0).as_secs_f64();
        }
        println!(
            "draw {:.3} ms, write {:.3} ms, {} bytes",
            1e3 * a / n as f64,
            1e3 * b / n as f64,
            bytes / n
        );
    }
}
