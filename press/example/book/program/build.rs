//! Renders the figures of the book as SVG, and its tables as Markdown.

fn main() -> std::process::ExitCode {
    figures::write(pendulum_pages::figures::FIGURES, pendulum_pages::tables::TABLES)
}
