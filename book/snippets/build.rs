//! Makes documentation tests of the pages and of the README, and functions of the snippets with live numbers.

fn main() -> std::process::ExitCode {
    dialect::write_snippets("..", &["../../README.md"])
}
