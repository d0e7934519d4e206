use live::{Moment, Player, Room};
use std::time::Instant;
fn main() {
    let name = std::env::args().nth(1).unwrap();
    let (scene, _) = *live::scenes().iter().find(|(s, _)| s.name == name).unwrap();
    let mut player = Player::new(scene).unwrap();
    let [azimuth, elevation] = scene.view.unwrap_or_default();
    let mut best = [f64::MAX; 3];
    for n in 0..200 {
        let m = Moment { time: 0.01 * n as f64, azimuth, elevation, room: Room::Wide };
        let a = Instant::now();
        let d = player.draw(m).unwrap();
        let b = a.elapsed().as_secs_f64();
        let a = Instant::now();
        let e = d.to_elements().unwrap();
        let c = a.elapsed().as_secs_f64();
        let a = Instant::now();
        player.readings(m.time).unwrap();
        let r = a.elapsed().as_secs_f64();
        best = [best[0].min(b), best[1].min(c), best[2].min(r)];
        std::hint::black_box(e);
    }
    println!("draw {:.3} ms, elements {:.3} ms, readings {:.3} ms", best[0] * 1e3, best[1] * 1e3, best[2] * 1e3);
}
