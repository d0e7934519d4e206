//! Figures and live scenes with their captions, and links that set a scene.

use super::Printer;
use crate::book::script;
use crate::html::escaped;
use crate::print::scenes;
use crate::read::font_coverage;
use crate::read::items::{Label, LabelKind, Words};

impl Printer<'_, '_> {
    pub(super) fn figure(&mut self, label: &Label, caption: &Words<'_>) -> Option<String> {
        let figure = self.drawn.figures.iter().find(|figure| figure.id == label.written())?;
        let number = self.registry.find(label).map(|entry| entry.number.clone()).unwrap_or_default();
        let number = match number.as_str() {
            "" => String::new(), // on a page that belongs to no chapter
            number => format!("<span class=\"number\">Figure {number}.</span> "),
        };
        let caption = self.words_of(caption, "caption");
        let up = "../".repeat(self.page.path.matches('/').count());
        let class = if figure.wide { "figure wide" } else { "figure" };
        Some(format!(
            "<figure class=\"{class}\" id=\"{}\">\n{}\n<figcaption>{number}{caption}\u{a0}\
             <a class=\"save\" href=\"{up}figures/{}\" download title=\"Save this figure as an SVG file\">SVG</a></figcaption>\n</figure>",
            label.id(),
            figure.svg.trim(),
            figure.file_name(),
        ))
    }

    /// A live scene: its question, its still, and the panel of its controls if there is a module that moves it.
    pub(super) fn scene(&mut self, label: &Label, caption: &Words<'_>, offset: usize) -> Option<String> {
        let drawn = self.drawn;
        let place = drawn.scenes.iter().position(|scene| scene.live.name == label.name)?;
        let scene = &drawn.scenes[place];
        let number = self.registry.find(label).map(|entry| entry.number.clone()).unwrap_or_default();
        let caption = self.words_of(caption, "caption");
        let mut html = |words: &str| {
            let faces = words.split('$').step_by(2).map(|words| font_coverage::Face::Text.check(words));
            if let Err((_, message)) = faces.collect::<Result<Vec<_>, _>>() {
                self.fault(offset, format!("in the scene, {message}"));
            }
            self.words_of(&scenes::words(words, offset), "scene")
        };
        let (id, question) = (label.id(), html(scene.live.question));
        let panel = if drawn.is_still { String::new() } else { scenes::panel(&scene.live, html) };
        let file = script(scene.chapter);
        let module = if drawn.is_still { String::new() } else { format!(" data-module=\"{file}\"") };
        Some(format!(
            "<figure class=\"scene\" id=\"{id}\" data-scene=\"{place}\"{module} aria-labelledby=\"{id}-caption\">\n<p class=\"question\">{question}</p>\n\
             <div class=\"drawing\">{}</div>\n{panel}\
             <figcaption id=\"{id}-caption\"><span class=\"number\">Scene {number}.</span> {caption}</figcaption>\n</figure>",
            scene.svg.trim(),
        ))
    }

    /// The beginning of a link that sets the scene of the page: `turning?spin=3`.
    pub(super) fn setting(&mut self, setting: &str, offset: usize) -> String {
        let (name, settings) = setting.split_once('?').unwrap_or((setting, ""));
        let label = Label { kind: LabelKind::Scene, name: name.to_owned() };
        let scene = self.drawn.scenes.iter().find(|scene| scene.live.name == name);
        let checked = match (self.registry.find(&label), scene) {
            (Ok(entry), Some(_)) if entry.page != self.page.path => {
                Err(format!("scene:{name} stands on another page: refer to it as @scene:{name}"))
            }
            (Ok(_), Some(scene)) => scenes::check_settings(scene, settings),
            (Err(message), _) => Err(message),
            (_, None) => Ok(()), // said where it should stand
        };
        if let Err(message) = checked {
            self.fault(offset, message);
        }
        format!("<a href=\"#{}\" data-set=\"{}\">", label.id(), escaped(settings))
    }
}

#[cfg(test)]
mod tests {
    use crate::assets::{Figure, Rendered, Scene};
    use crate::print::render::tests::{maths, printed_with};
    use live::{Control, Form, Preset, Reading};

    #[test]
    fn a_scene_has_its_question_still_and_panel_and_links_that_set_it() {
        const SCENE: live::Scene = live::Scene {
            file: "book/a/scene.rs",
            name: "plate",
            title: "",
            description: "",
            question: "Why $x$?",
            size: [[1.0; 2]; 2],
            view: Some([-0.5, 0.25]),
            still: 0.5,
            controls: &[
                Control::slider("spin", "spin, $x$", [-1.0, 4.0, 0.1], "rad/s", 2.0),
                Control::log_slider("drag", "drag", [1e-3, 1.0], "", 0.01),
                Control::choice("camera", "camera", &["room", "body"]),
                Control::switch("cones", "cones", true),
                Control::button("kick", "Kick"),
            ],
            presets: &[Preset { words: "a ball", settings: &[("spin", 1.0), ("drag", 0.1)] }],
            readings: &[Reading { words: "wobbles", form: Form::Fixed(0), unit: "" }],
            symbols: &[],
            start: |_| Err("it never starts".into()),
        };
        let scene = Scene { chapter: "a.md", live: SCENE, svg: "<svg></svg>".to_owned() };
        let mut drawn = Rendered { scenes: vec![scene], ..Rendered::default() };
        let text = "# A\n\n![A *plate*.](scene:plate)\n\n[Set $x$](scene:plate?spin=3&kick=0).\n";
        let x = maths("$x$");
        let range = "<input type=\"range\" id=\"scene-plate-";
        let moving = printed_with(&drawn, text);
        for part in [
            "<figure class=\"scene\" id=\"scene-plate\" data-scene=\"0\" data-module=\"live-a.md.js\" aria-labelledby=\"scene-plate-caption\">\n<p class=\"question\">Why ",
            "<div class=\"drawing\"><svg></svg></div>\n<div class=\"panel\">\n",
            &format!(
                "<label for=\"scene-plate-spin\">spin, {x}</label>{range}spin\" name=\"spin\" min=\"-1\" max=\"4\" \
                 step=\"0.1\" value=\"2\" data-start=\"2\" data-unit=\"rad/s\"><output for=\"scene-plate-spin\">2.0\u{a0}rad/s</output>"
            ),
            &format!("{range}drag\" name=\"drag\" min=\"-3\" max=\"0\" step=\"any\" value=\"-2\""),
            " data-log>",
            "<input type=\"radio\" name=\"scene-plate-camera\" value=\"0\" data-name=\"camera\" checked data-start> room",
            "<input type=\"radio\" name=\"scene-plate-camera\" value=\"1\" data-name=\"camera\"> body",
            "<input type=\"checkbox\" id=\"scene-plate-cones\" name=\"cones\" checked data-start> cones",
            "<button type=\"button\" class=\"press\" name=\"kick\" data-start=\"-1\">Kick</button>",
            "class=\"time\" id=\"scene-plate-time\" min=\"0\" max=\"1\" step=\"any\" value=\"0.5\"",
            &format!(
                "name=\"azimuth\" min=\"-180\" max=\"180\" step=\"any\" value=\"{}\"",
                (-0.5_f64).to_degrees()
            ),
            "<div><dt>wobbles</dt><dd></dd></div>",
            "<button type=\"button\" data-set=\"spin=1&amp;drag=0.1\">a ball</button>",
            "<figcaption id=\"scene-plate-caption\"><span class=\"number\">Scene 1.1.</span> A <em>plate</em>.</figcaption>\n</figure>",
            &format!("<a href=\"#scene-plate\" data-set=\"spin=3&amp;kick=0\">Set {}</a>.", maths("$x$")),
        ] {
            assert!(moving.contains(part), "{part} in {moving}");
        }
        let figure = &moving[moving.find("<figure").unwrap()..moving.find("</figure>").unwrap()];
        assert!(!figure.contains("\n\n"), "Markdown would read on");
        drawn.is_still = true;
        let still = printed_with(&drawn, text);
        assert!(
            !still.contains("panel") && !still.contains("data-module") && still.contains("<svg></svg>"),
            "{still}"
        );
    }

    #[test]
    fn a_note_of_a_caption_stands_below_the_figure() {
        let [svg, standalone] = [String::new(), String::new()];
        let figure = Figure {
            id: "fig:x".to_owned(),
            source: "book/a/figures.rs".to_owned(),
            svg,
            standalone,
            wide: false,
        };
        let drawn = Rendered { figures: vec![figure], ..Rendered::default() };
        let printed = printed_with(&drawn, "# A\n\n![It's so.](fig:x)[^a]\n\n[^a]: A.\n");
        let at = |words: &str| printed.find(words).unwrap_or_else(|| panic!("{words} in {printed}"));
        assert!(at("It’s so.<a class=\"note-mark\"") < at("</figcaption>"));
        assert!(at("</figure>") < at("<aside class=\"note\""));
    }
}
