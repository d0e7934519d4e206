//! `cargo book`: the press with the figures, tables and scenes of this book.

fn main() -> std::process::ExitCode {
    press::main(&press::Book {
        library: "pendulum",
        code: &["src", "book"],
        drawn: env!("OUT_DIR"),
        scenes: pendulum_pages::scenes::SCENES,
        snippets: "pendulum-snippets",
        commands: &[],
    })
}
