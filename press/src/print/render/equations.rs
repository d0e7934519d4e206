//! Formulas: in a line, and on lines of their own with their numbers and with links to the code.

use super::Printer;
use crate::print::code_links::CodePlace;
use crate::read::items::EquationLabel;
use std::fmt::Write as _;

impl Printer<'_, '_> {
    pub(super) fn inline(&mut self, tex: &str, offset: usize) -> Option<String> {
        self.maths
            .inline(tex, self.maths.folder(&self.page.path, offset - 1))
            .map_err(|fault| self.fault(offset + fault.offset, fault.message))
            .ok()
    }

    pub(super) fn display(
        &mut self,
        tex: &str,
        label: Option<&EquationLabel>,
        offset: usize,
    ) -> Option<String> {
        let converted = self.maths.display(tex, self.maths.folder(&self.page.path, offset));
        let mathml = converted.map_err(|fault| self.fault(offset + 2 + fault.offset, fault.message)).ok()?;
        let Some(EquationLabel { label, source, corrected }) = label else {
            return Some(format!("<div class=\"equation\"><div class=\"formula\">{mathml}</div></div>"));
        };
        let number = self.registry.find(label).map(|entry| entry.number.clone()).unwrap_or_default();
        let id = label.id();
        let mut marks = format!("<a class=\"number\" href=\"#{id}\">({number})</a>");
        for n in source {
            let (words, title) = if *corrected {
                ("corrects", format!("corrects equation ({n}) of the source"))
            } else {
                ("source", format!("equation ({n}) of the source"))
            };
            let _ = write!(
                marks,
                "<a class=\"source\" id=\"source-{n}\" href=\"#source-{n}\" title=\"{title}\">{words} {n}</a>"
            );
        }
        marks += &self.code(&label.name);
        Some(format!(
            "<div class=\"equation numbered\" id=\"{id}\"><div class=\"formula\">{mathml}</div><div class=\"marks\">{marks}</div></div>"
        ))
    }

    /// Links to the lines of the library that name an equation.
    fn code(&self, equation: &str) -> String {
        let Some(places) = self.places.get(equation) else { return String::new() };
        let up = "../".repeat(self.page.path.matches('/').count());
        let link = |(index, place): (usize, &CodePlace)| {
            let (words, target) = (place.words(), place.target());
            // What is heard begins with what is seen, so that who speaks can name the link.
            let (text, name) = match index {
                0 if places.len() == 1 => ("code".to_owned(), "code".to_owned()),
                0 => ("code 1".to_owned(), "code 1".to_owned()),
                _ => ((index + 1).to_string(), format!("code {}", index + 1)),
            };
            format!("<a href=\"{up}{target}\" title=\"{words}\" aria-label=\"{name}: {words}\">{text}</a>")
        };
        let links: Vec<String> = places.iter().enumerate().map(link).collect();
        format!("<span class=\"code\">{}</span>", links.join(", "))
    }
}

#[cfg(test)]
mod tests {
    use crate::print::render::tests::printed;

    #[test]
    fn the_marks_of_a_quotation_are_no_part_of_its_formula() {
        let quoted = "# A\n\n> [!NOTE]\n> So\n>\n> $$\n> a > b\n> = c\n> $$ {#eq:x}\n>\n> and $d\n> e$.\n";
        let plain = "# A\n\n$$\na > b\n= c\n$$ {#eq:x}\n\nand $d\ne$.\n";
        let maths = |page: &str| -> Vec<String> {
            let printed = printed(page, false);
            let formulas = printed.split("<math").skip(1).filter_map(|rest| rest.split("</math>").next());
            formulas.map(str::to_owned).collect()
        };
        assert_eq!(maths(plain).len(), 2);
        assert_eq!(maths(quoted), maths(plain));
    }
}
