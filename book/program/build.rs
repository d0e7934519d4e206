//! Renders the figures of the book as SVG, and its tables as Markdown.

fn main() -> std::process::ExitCode {
    figures::write(pages::figures::FIGURES, pages::tables::TABLES)
}
