fn main() -> std::process::ExitCode {
    dialect::write_snippets("..")
}
