//! Plays a scene on the command line: writes its picture at some times, for some settings, as SVG files.
//!
//! `cargo run -p pages --example play -- turning FOLDER [spin=3 ratio=0.5 …] [t=0,0.2,0.4] [narrow] [azimuth=…]`

use live::{Moment, Player, Room};
use std::error::Error;
use std::path::Path;
use std::time::Instant;
use std::{env, fs};

fn main() -> Result<(), Box<dyn Error + Send + Sync>> {
    let arguments: Vec<String> = env::args().skip(1).collect();
    let [name, folder, rest @ ..] = &arguments[..] else {
        return Err("a scene and a folder, please".into());
    };
    let found = pages::scenes::named(name);
    let scene = found.ok_or_else(|| format!("there is no scene `{name}`"))?;
    let [mut azimuth, mut elevation] = scene.view.unwrap_or_default();
    let (mut times, mut room, mut settings) = (vec![scene.still], Room::Wide, Vec::new());
    for word in rest {
        match word.split_once('=') {
            None if word == "narrow" => room = Room::Narrow,
            Some(("t", list)) => times = list.split(',').map(str::parse).collect::<Result<_, _>>()?,
            Some(("azimuth", value)) => azimuth = value.parse()?,
            Some(("elevation", value)) => elevation = value.parse()?,
            Some((name, value)) => settings.push((name, value.parse()?)),
            None => return Err(format!("`{word}` is no setting").into()),
        }
    }
    let begun = Instant::now();
    let mut player = Player::new(scene)?.changed(&settings)?;
    println!("{:?} to begin; {:?}", begun.elapsed(), player.run());
    fs::create_dir_all(folder)?;
    for (index, &time) in times.iter().enumerate() {
        let begun = Instant::now();
        let drawing = player.draw(Moment { time, azimuth, elevation, room })?;
        let elements = drawing.to_elements()?;
        let took = begun.elapsed();
        let file = Path::new(folder).join(format!("{name}-{index}.svg"));
        fs::write(&file, drawing.to_standalone_svg()?)?;
        println!("{} t = {time} s, {took:?}, {} bytes", file.display(), elements.len());
        for (reading, value) in scene.readings.iter().zip(player.readings(time)?) {
            println!("    {}: {value}", reading.words);
        }
        println!("    {}", player.words(time));
    }
    Ok(())
}
