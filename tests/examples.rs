//! The programs in `examples` print what their first lines say.

use std::path::Path;
use std::process::Command;
use std::{env, fs};

#[test]
fn every_example_prints_what_its_first_lines_say() {
    let root = env::var_os("CARGO_MANIFEST_DIR").expect("Cargo sets it");
    let mut run = 0;
    for entry in fs::read_dir(Path::new(&root).join("examples")).unwrap() {
        let file = entry.unwrap().path();
        let text = fs::read_to_string(&file).unwrap();
        let said = text.split_once("//! ```text\n").and_then(|(_, rest)| rest.split_once("//! ```\n"));
        let said: Vec<&str> = said.unwrap().0.lines().map(|line| &line["//! ".len()..]).collect();
        let example = file.file_stem().unwrap();
        let cargo = ["run", "--quiet", "--locked", "--offline", "--example"];
        let ran = Command::new(env!("CARGO")).current_dir(&root).args(cargo).arg(example).output().unwrap();
        let printed = String::from_utf8(ran.stdout).unwrap();
        assert!(ran.status.success(), "{example:?}: {}", String::from_utf8_lossy(&ran.stderr));
        assert_eq!(printed.lines().collect::<Vec<_>>(), said, "{example:?}");
        run += 1;
    }
    assert_eq!(run, 7);
}
