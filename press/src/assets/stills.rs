//! The live scenes as the press prints them: their stills are drawn here, by the code that moves them in the pages.

use crate::assets::{Control, Input, Scene};
use live::{Form, Kind, Player, written};

/// All of them, in the order in which the module counts them.
///
/// # Errors
/// Which scene cannot be drawn as it starts, and why.
pub(crate) fn all(scenes: &[(&str, &'static live::Scene)]) -> Result<Vec<Scene>, String> {
    scenes.iter().map(|(chapter, scene)| printed(scene, chapter)).collect()
}

fn printed(scene: &'static live::Scene, chapter: &str) -> Result<Scene, String> {
    let cannot = |why: String| format!("{}: the scene {}: {why}", scene.file, scene.name);
    let still = Player::new(scene).and_then(|mut player| player.still());
    let svg = still
        .map_err(|error| cannot(error.to_string()))?
        .to_svg()
        .map_err(|flaw| cannot(flaw.to_string()))?;
    let settings = |settings: &[(&str, f64)]| {
        settings.iter().map(|(name, value)| format!("{name}={value}")).collect::<Vec<_>>().join("&")
    };
    Ok(Scene {
        name: scene.name.to_owned(),
        chapter: chapter.to_owned(),
        source: scene.file.replace('\\', "/"),
        question: scene.question.to_owned(),
        svg,
        still: scene.still,
        view: scene.view.map(|view| view.map(f64::to_degrees)),
        controls: scene.controls.iter().map(control).collect(),
        presets: scene
            .presets
            .iter()
            .map(|preset| (preset.words.to_owned(), settings(preset.settings)))
            .collect(),
        readings: scene.readings.iter().map(|reading| reading.words.to_owned()).collect(),
    })
}

fn control(control: &live::Control) -> Control {
    let (input, unit, digits) = match control.kind {
        Kind::Slider { from, to, step, unit } => {
            let digits = step.to_string().split_once('.').map_or(0, |(_, digits)| digits.len());
            (Input::Slider { from, to, step }, unit, digits)
        }
        Kind::LogSlider { from, to, unit } => {
            let digits = (2.0 - control.start.log10().floor()).clamp(0.0, 15.0) as usize; // three that count
            (Input::LogSlider { from, to }, unit, digits)
        }
        Kind::Choice(choices) => {
            (Input::Choice(choices.iter().map(|&choice| choice.to_owned()).collect()), "", 0)
        }
        Kind::Switch => (Input::Switch, "", 0),
        Kind::Button => (Input::Button, "", 0),
    };
    Control {
        name: control.name.to_owned(),
        words: control.words.to_owned(),
        input,
        start: control.start,
        unit: unit.to_owned(),
        shown: written(control.start, Form::Fixed(digits), unit),
    }
}
