//! Formulas: in a line, and on lines of their own with their numbers and with links to the code.

use super::Printer;
use crate::print::code_links::CodePlace;
use crate::read::items::EquationLabel;

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
        let (id, origin) = (label.id(), self.origin(&label.name, &number, source, *corrected));
        let anchors: String = source.iter().map(|n| format!("<span id=\"source-{n}\"></span>")).collect();
        Some(format!(
            "<div class=\"equation numbered\" id=\"{id}\">{anchors}<div class=\"formula\">{mathml}</div>\
             <div class=\"marks\">{origin}<a class=\"number\" href=\"#{id}\">({number})</a></div></div>"
        ))
    }

    /// Where an equation is from and where the library has it, folded behind a sign: the numbers that the source gives
    /// it, and links to the lines of the library that name it.
    fn origin(&self, equation: &str, number: &str, source: &[u32], corrected: bool) -> String {
        let up = "../".repeat(self.page.path.matches('/').count());
        let verb = if corrected { "corrects" } else { "is" };
        let numbers: Vec<String> = source.iter().map(|n| format!("({n})")).collect();
        let mut words = Vec::new();
        if !numbers.is_empty() {
            words.push(format!("<span class=\"source\">{verb} {} of the source</span>", numbers.join(", ")));
        }
        let link = |place: &CodePlace| {
            let (item, title, target) = (place.item(), place.words(), place.target());
            format!("<a href=\"{up}{target}\" title=\"{title}\"><code>{item}</code></a>")
        };
        let links: Vec<String> = self.places.get(equation).into_iter().flatten().map(link).collect();
        if !links.is_empty() {
            words.push(format!("<span class=\"code\">in the library: {}</span>", links.join(", ")));
        }
        if words.is_empty() {
            return String::new();
        }
        format!(
            "<details class=\"origin\"><summary aria-label=\"Where ({number}) is from\"></summary><p>{}</p></details>",
            words.join(" ")
        )
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
