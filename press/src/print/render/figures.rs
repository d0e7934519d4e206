//! Figures and live scenes with their captions, and links that set a scene.

use super::Printer;
use crate::book::script;
use crate::print::scenes;
use crate::read::font_coverage;
use crate::read::items::{Label, LabelKind, Words};
use html::escaped;

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
        Some(format!(
            "<figure class=\"figure {}\" id=\"{}\">\n{}\n<figcaption>{number}{caption}\u{a0}\
             <a class=\"save\" href=\"{up}figures/{}\" download title=\"Save this figure as an SVG file\">SVG</a></figcaption>\n</figure>",
            figure.place,
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
        let presets = if drawn.is_still { String::new() } else { scenes::presets(&scene.live, &mut html) };
        let panel = if drawn.is_still { String::new() } else { scenes::panel(scene, html) };
        let file = script(scene.chapter());
        let module = if drawn.is_still { String::new() } else { format!(" data-module=\"{file}\"") };
        Some(format!(
            "<figure class=\"scene\" id=\"{id}\" data-scene=\"{place}\"{module} aria-labelledby=\"{id}-caption\">\n<p class=\"question\">{question}</p>\n{presets}\
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
