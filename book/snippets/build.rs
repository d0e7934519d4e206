//! Makes documentation tests of the pages, and functions of the snippets with live numbers.

fn main() -> std::process::ExitCode {
    dialect::write_snippets("..")
}
