//! `cargo book`: the press with the figures, tables and scenes of this book. It is a package of its own, so that a
//! figure which is drawn again compiles only this file.

use press::Book;
use std::process::ExitCode;

fn main() -> ExitCode {
    press::main(&Book {
        library: "mechanics",
        code: &["src", "tests", "benches", "book"],
        drawn: env!("OUT_DIR"),
        scenes: pages::scenes::SCENES,
        snippets: "snippets",
    })
}
