//! `cargo book`: the press with the figures, tables and scenes of this book. It is a package of its own, so that a
//! figure which is drawn again compiles only this file.

mod measure;

use press::{Book, Command};
use std::process::ExitCode;

fn main() -> ExitCode {
    press::main(&Book {
        library: "mechanics",
        code: &["src", "tests", "benches", "book"],
        drawn: env!("OUT_DIR"),
        scenes: pages::scenes::SCENES,
        snippets: "snippets",
        commands: &[Command {
            name: "measure",
            help: "Runs the library beside its peers, for the report \"Speed and accuracy\"; --help says more",
            run: measure::measure,
        }],
    })
}
