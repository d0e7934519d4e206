//! Live scenes: what can be wrong with one, and what its page holds of it beside the still.

use crate::assets::Scene;
use crate::fault::{Faults, nearest};
use crate::read::items::Words;
use crate::read::label_syntax::is_name;
use dialect::markdown::options;
use html::escaped;
use live::{Control, Kind};
use pulldown_cmark::{Event, Parser, Tag, TagEnd};
use std::collections::BTreeSet;
use std::fmt::Write as _;

/// What stands in links beside the settings, and ids that the panel or the still has: no control may have such a name.
const TAKEN: [&str; 9] = ["t", "time", "title", "desc", "narrow", "azimuth", "elevation", "caption", "kept"];

/// Of more controls than this only the first few are seen at once.
const MOST_SEEN: usize = 5;
const SEEN: usize = 3;

/// Adds what is wrong with the scenes themselves.
pub(crate) fn check(scenes: &[Scene], faults: &mut Faults) {
    let mut names = BTreeSet::new();
    for scene in scenes {
        let file = scene.source();
        let scene = &scene.live;
        let mut fault = |message: String| faults.add(&file, 0, message);
        if !is_name(scene.name) || !names.insert(scene.name) {
            fault(format!(
                "a scene has a name of its own of lower-case letters, digits and hyphens, not `{}`",
                scene.name
            ));
        }
        if scene.question.trim().is_empty() {
            fault(format!("the scene {} asks nothing", scene.name));
        }
        let mut controls = BTreeSet::new();
        for control in scene.controls {
            let name = control.name;
            let is_taken = TAKEN.contains(&name) && *control != Control::KEEP;
            if !is_name(name) || is_taken || !controls.insert(name) {
                fault(format!("a control of the scene {} cannot have the name `{name}`", scene.name));
            }
            if control.words.trim().is_empty() && control.kind != Kind::Kept {
                fault(format!("nothing says what the control `{name}` of the scene {} is", scene.name));
            }
            if let Some((other, between)) = control.when
                && let Err(message) = check_setting(scene, other, between[0])
            {
                fault(format!(
                    "the control `{name}` of the scene {} waits for something else: {message}",
                    scene.name
                ));
            }
            if let Err(message) = check_value(control, control.start) {
                fault(format!("the scene {} starts with {message}", scene.name));
            }
        }
        for preset in scene.presets {
            for &(name, value) in preset.settings {
                if let Err(message) = check_setting(scene, name, value) {
                    fault(format!("the preset “{}” of the scene {}: {message}", preset.words, scene.name));
                }
            }
        }
    }
}

/// What is wrong with settings, `spin=3&kick=0`.
pub(crate) fn check_settings(scene: &Scene, settings: &str) -> Result<(), String> {
    for setting in settings.split('&') {
        let (name, value) = setting.split_once('=').unwrap_or((setting, ""));
        let Ok(value) = value.parse::<f64>() else {
            return Err(format!("`{setting}` is no setting: they are written spin=3&kick=0"));
        };
        // The time, s of the scene.
        if name != "t" || !(0.0..=f64::MAX).contains(&value) {
            check_setting(&scene.live, name, value)?;
        }
    }
    Ok(())
}

fn check_setting(scene: &live::Scene, name: &str, value: f64) -> Result<(), String> {
    let name = name.strip_prefix("kept.").unwrap_or(name);
    let Some(control) = scene.controls.iter().find(|control| control.name == name) else {
        let near = nearest(name, scene.controls.iter().map(|control| control.name));
        let near = near.map(|near| format!("; is `{near}` meant?")).unwrap_or_default();
        return Err(format!("the scene {} has no control `{name}`{near}", scene.name));
    };
    check_value(control, value)
}

/// What is wrong with a value of a control.
fn check_value(control: &Control, value: f64) -> Result<(), String> {
    let (from, to, step) = match control.kind {
        Kind::Slider { from, to, step, .. } => (from, to, step),
        Kind::LogSlider { from, to, .. } => (from, to, 0.0),
        Kind::Choice(choices) => (0.0, choices.len() as f64 - 1.0, 1.0),
        Kind::Switch => (0.0, 1.0, 1.0),
        Kind::Button(_) => (-1.0, f64::MAX, 0.0),
        Kind::Kept => (f64::MIN, f64::MAX, 0.0),
    };
    let steps = (value - from) / step;
    let is_step = step == 0.0 || (steps - steps.round()).abs() < 1e-6;
    if (from..=to).contains(&value) && is_step {
        return Ok(());
    }
    let steps = if step == 0.0 { String::new() } else { format!(" in steps of {step}") };
    let range =
        if to == f64::MAX { format!("at least {from}") } else { format!("from {from} to {to}{steps}") };
    Err(format!("`{}={value}`, which must be {range}", control.name))
}

/// Words of a scene as those of a caption, all at the place of the scene on its page.
pub(crate) fn words(text: &str, offset: usize) -> Words<'_> {
    Parser::new_ext(text, options())
        .filter(|event| !matches!(event, Event::Start(Tag::Paragraph) | Event::End(TagEnd::Paragraph)))
        .map(|event| (event, offset))
        .collect()
}

/// Settings that the text talks about, between the question and the picture; `html` makes HTML of words.
pub(crate) fn presets(scene: &live::Scene, mut html: impl FnMut(&str) -> String) -> String {
    if scene.presets.is_empty() {
        return String::new();
    }
    let mut out = "<p class=\"presets\">".to_owned();
    for preset in scene.presets {
        let settings = preset.settings.iter().map(|(name, value)| format!("{name}={value}"));
        let settings = escaped(&settings.collect::<Vec<_>>().join("&"));
        let words = html(preset.words);
        let _ = write!(out, "<button type=\"button\" data-set=\"{settings}\">{words}</button> ");
    }
    out + "</p>\n"
}

/// What a reader can change and read beside the picture, and what is said below it, in the room of its longest words.
/// Of many controls the first three, and the buttons behind them, are seen, and the others are folded.
pub(crate) fn panel(drawn: &Scene, mut html: impl FnMut(&str) -> String) -> String {
    let Scene { live: scene, longest: room, sounds, lowest_eye, .. } = drawn;
    let id = format!("scene-{}", scene.name);
    let sound = match *sounds {
        true => "<button type=\"button\" class=\"sound\" aria-pressed=\"false\">Sound</button>",
        false => "",
    };
    let mut out = format!(
        "<div class=\"panel\">\n<div class=\"transport\"><button type=\"button\" class=\"play\">Play</button>\
         <button type=\"button\" class=\"step\">Step</button><button type=\"button\" class=\"reset\">Reset</button>{sound}\
         <output class=\"clock\" for=\"{id}-time\"></output>\
         <span><input type=\"range\" class=\"time\" id=\"{id}-time\" min=\"0\" max=\"1\" step=\"any\" value=\"{}\" aria-label=\"time\"></span>\
         <select class=\"pace\" aria-label=\"pace\"><option value=\"0.25\">slowed 4 times</option><option value=\"0.5\">slowed 2 times</option>\
         <option value=\"1\" selected>as it is</option><option value=\"2\">2 times as fast</option></select></div>\n<div class=\"controls\">\n",
        scene.still
    );
    let seen = scene.controls.iter().filter(|control| control.kind != Kind::Kept);
    let mut left = if seen.count() > MOST_SEEN { SEEN } else { usize::MAX };
    let mut is_folded = false;
    for control in scene.controls {
        let is_counted = !matches!(control.kind, Kind::Button(_) | Kind::Kept) && *control != Control::KEEP;
        if is_counted && left == 0 && !is_folded {
            out.push_str("<details class=\"more\"><summary>More controls</summary>\n<div>\n");
            is_folded = true;
        }
        left -= usize::from(is_counted && left > 0);
        let words = html(control.words);
        out.push_str(&field(control, &id, &words, &mut html));
        out.push('\n');
    }
    out.push_str(if is_folded { "</div></details>\n</div>\n" } else { "</div>\n" });
    if let Some(degrees) = scene.view.map(|view| view.map(f64::to_degrees)) {
        out.push_str("<div class=\"view\" role=\"group\" aria-label=\"look from\">\n");
        let lowest = lowest_eye.to_degrees().round();
        for ((name, words, least, most), value) in
            [("azimuth", "look round", -180.0, 180), ("elevation", "look from above", lowest, 90)]
                .into_iter()
                .zip(degrees)
        {
            let _ = writeln!(
                out,
                "<div><label for=\"{id}-{name}\">{words}</label><input type=\"range\" id=\"{id}-{name}\" name=\"{name}\" \
                 min=\"{least}\" max=\"{most}\" step=\"any\" value=\"{value}\"></div>"
            );
        }
        out.push_str("</div>\n");
    }
    if !scene.readings.is_empty() {
        out.push_str("<dl class=\"readings\">");
        for reading in scene.readings {
            let _ = write!(out, "<div><dt>{}</dt><dd></dd></div>", html(reading.words));
        }
        out.push_str("</dl>\n");
    }
    let room = escaped(room);
    out + &format!(
        "</div>\n<div class=\"panel answer\">\n<div class=\"words\" data-room=\"{room}\"><p class=\"says\" role=\"status\"></p></div>\n<p class=\"share\"><a href=\"#{id}\">Copy the link to this setting</a> <span class=\"copied\" role=\"status\"></span></p>\n</div>\n"
    )
}

/// A control with its words.
fn field(control: &Control, scene: &str, words: &str, html: &mut impl FnMut(&str) -> String) -> String {
    let Control { name, start, kind, .. } = control;
    let when = control
        .when
        .map_or_else(String::new, |(other, [from, to])| format!(" data-when=\"{other} {from} {to}\""));
    let id = format!("{scene}-{name}");
    let range = |[from, to, start]: [f64; 3], step: &str, log: &str| {
        let (unit, shown) = (escaped(control.unit()), control.shown(control.start));
        let lengths =
            [from, to].map(|end| control.shown(if log.is_empty() { end } else { 10_f64.powf(end) }));
        let room = lengths.iter().map(|end| end.chars().count()).max().unwrap_or_default();
        format!(
            "<div class=\"control\"{when}><label for=\"{id}\">{words}</label><input type=\"range\" id=\"{id}\" name=\"{name}\" \
             min=\"{from}\" max=\"{to}\" step=\"{step}\" value=\"{start}\" data-start=\"{start}\" data-unit=\"{unit}\"{log}>\
             <output for=\"{id}\" style=\"min-width: {room}ch\">{shown}</output></div>"
        )
    };
    match kind {
        &Kind::Slider { from, to, step, .. } => range([from, to, *start], &step.to_string(), ""),
        &Kind::LogSlider { from, to, .. } => range([from, to, *start].map(f64::log10), "any", " data-log"),
        Kind::Choice(choices) => {
            let mut out = format!("<fieldset class=\"control\"{when}><legend>{words}</legend>");
            for (place, choice) in choices.iter().enumerate() {
                let checked = if place as f64 == *start { " checked data-start" } else { "" };
                let choice = html(choice);
                let _ = write!(
                    out,
                    "<label><input type=\"radio\" name=\"{id}\" value=\"{place}\" data-name=\"{name}\"{checked}> {choice}</label>"
                );
            }
            out + "</fieldset>"
        }
        Kind::Switch => {
            let checked = if *start == 1.0 { " checked data-start" } else { "" };
            let kept = if *control == Control::KEEP { "<span class=\"kept\"></span>" } else { "" };
            format!(
                "<div class=\"control\"{when}><label><input type=\"checkbox\" id=\"{id}\" name=\"{name}\"{checked}> {words}</label>{kept}</div>"
            )
        }
        Kind::Button(strengths) => {
            let strengths =
                strengths.map_or_else(String::new, |names| format!(" data-adds=\"{}\"", names.join(" ")));
            format!(
                "<div class=\"control\"><button type=\"button\" class=\"press\" name=\"{name}\" data-start=\"{start}\"{strengths}>{words}</button></div>"
            )
        }
        Kind::Kept => format!("<input type=\"hidden\" name=\"{name}\" value=\"{start}\">"),
    }
}
