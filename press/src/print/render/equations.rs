//! Formulas: in a line, and on lines of their own with their numbers and with links to the code.

use super::Printer;
use crate::print::code_links::CodePlace;
use crate::read::items::EquationLabel;
use crate::read::label_syntax;

impl Printer<'_, '_> {
    pub(super) fn inline(&mut self, tex: &str, offset: usize) -> Option<String> {
        self.maths
            .inline(tex, &self.folder(offset - 1))
            .map_err(|fault| self.fault(offset + fault.offset, fault.message))
            .ok()
    }

    /// The folder of the chapter whose letters a formula uses. On a page of no chapter that is the chapter to which its
    /// paragraph, or its row of a table, refers first.
    pub(super) fn folder(&self, offset: usize) -> String {
        let (path, text) = (&self.page.path, &self.page.text);
        let own = self.maths.folder(path, offset);
        if self.page.chapter.is_some() || own != path {
            return own.to_owned();
        }
        let line = text[..offset].rfind('\n').map_or(0, |at| at + 1);
        let (above, below) = if text[line..].starts_with('|') { ("\n", "\n") } else { ("\n\n", "\n\n") };
        let start = text[..offset].rfind(above).map_or(0, |at| at + above.len());
        let end = text[offset..].find(below).map_or(text.len(), |at| offset + at);
        let block = &text[start..end];
        let labels =
            label_syntax::named(block).into_iter().map(|(at, label)| (at, self.registry.find(&label)));
        let numbers = block.match_indices("@source:").map(|(at, mark)| {
            let digits = block[at + mark.len()..].split(|c: char| !c.is_ascii_digit()).next();
            (at, self.registry.find_source(digits.and_then(|digits| digits.parse().ok()).unwrap_or(0)))
        });
        let known = labels.chain(numbers).filter_map(|(at, entry)| Some((at, &entry.ok()?.page)));
        let pages = known.filter(|(_, page)| page.contains('/'));
        pages.min().map_or(own, |(_, page)| self.maths.folder(page, usize::MAX)).to_owned()
    }

    pub(super) fn display(
        &mut self,
        tex: &str,
        label: Option<&EquationLabel>,
        offset: usize,
    ) -> Option<String> {
        let converted = self.maths.display(tex, &self.folder(offset));
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
    use crate::assets::Rendered;
    use crate::book::Page;
    use crate::print::render::render;
    use crate::print::render::tests::printed;

    #[test]
    fn outside_of_the_chapters_a_letter_has_the_colour_of_the_chapter_that_is_referred_to() {
        let tables = "# C\n\n| quantity | colour | letters |\n|---|---|---|\n| momentum | green | $L$ |\n\nTable: Q.\n\n\
                      | chapter | letters | meaning | colour |\n|---|---|---|---|\n| [One](one/index.md) | $L$ | a length | none |\n\nTable: L.\n";
        let errata = "# E\n\nAn $L$ by @eq:one\nand $L$.\n\nAn $L$.\n\n| a | b |\n|---|---|\n| $L$ | @source:7 |\n| $L$ | @eq:two |\n\nTable: T.\n";
        let page = |path: &str, chapter, text: &str| {
            Page::new("book", path.to_owned(), chapter, None, text.to_owned())
        };
        let pages = [
            page("conventions.md", None, tables),
            page("one/index.md", Some(1), "# O\n\n$$\na\n$$ {#eq:one source=7}\n"),
            page("two/index.md", Some(2), "# T\n\n$$\nb\n$$ {#eq:two}\n"),
            page("errata.md", None, errata),
        ];
        let printed = render(&pages, &Rendered::default(), "", &[]);
        let printed = printed.unwrap_or_else(|faults| panic!("{:?}", faults.sorted()));
        let coloured: Vec<bool> = printed[3]
            .split("<math")
            .skip(1)
            .map(|rest| rest.split("</math>").next().unwrap().contains("q-momentum"))
            .collect();
        assert_eq!(coloured, [false, false, true, false, true]);
    }

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
