//! The press prints another book, about another library: the example, as `cargo book new` writes it.

use press::rendered::Rendered;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::{env, fs};

/// A program in the folder of the new book, which shares what is compiled with this workspace and uses no network.
fn run(folder: &Path, program: &Path, arguments: &[&str]) -> String {
    let built = Path::new(env!("CARGO_BIN_EXE_book")).ancestors().nth(2).expect("the target folder");
    let output = Command::new(program)
        .args(arguments)
        .current_dir(folder)
        .env("CARGO_BUILD_BUILD_DIR", built)
        .env("CARGO_TARGET_DIR", folder.join("target"))
        .env("CARGO_NET_OFFLINE", "true")
        .env("BOOK_LIVE", "static")
        .stdin(Stdio::null())
        .output()
        .expect("it runs");
    let said =
        String::from_utf8_lossy(&output.stderr).into_owned() + &String::from_utf8_lossy(&output.stdout);
    assert!(output.status.success(), "{said}");
    said
}

#[test]
fn another_book_is_printed_with_all_that_the_press_can_do() {
    let package = PathBuf::from(env::var_os("CARGO_MANIFEST_DIR").expect("Cargo sets it"));
    let root = package.ancestors().nth(2).expect("two folders up");
    let folder = root.join("target/tests/example");
    let _ = fs::remove_dir_all(&folder);
    let new = ["new".to_owned(), folder.to_string_lossy().into_owned()];
    press::command::run(root, &new, &Rendered::default()).expect("a new book");
    let again = press::command::run(root, &new, &Rendered::default());
    assert!(again.is_err_and(|said| said.contains("the folder is not empty")));
    let within = root.join("press/x");
    let inside = ["new".to_owned(), within.to_string_lossy().into_owned()];
    let inside = press::command::run(root, &inside, &Rendered::default());
    assert!(inside.is_err_and(|said| said.contains("the folder lies in `press`")) && !within.exists());

    let cargo = PathBuf::from(env::var_os("CARGO").unwrap_or_else(|| "cargo".into()));
    run(&folder, &cargo, &["book", "build"]);
    let site = folder.join("target/book/html");
    let page = |name: &str| fs::read_to_string(site.join(name)).expect(name);
    let holds = |name: &str, wanted: &[&str]| {
        let html = page(name);
        for text in wanted {
            assert!(html.contains(text), "{name} lacks {text}");
        }
    };
    holds(
        "pendulum/index.html",
        &[
            "<math",
            "id=\"eq-pendulum-period\"",
            "(1.2)",
            "id=\"fig-period\"",
            "Figure 1.1",
            "class=\"note\"",
            "id=\"scene-pendulum\"",
            "// → 2.146 s",
            "api/pendulum/struct.Pendulum.html",
            "api/src/pendulum/lib.rs.html#",
        ],
    );
    holds("about.html", &["href=\"pendulum/index.html#eq-pendulum-period\"", "(1.2)", "The Pendulum"]);
    holds("clock/index.html", &["href=\"../pendulum/index.html#fig-period\"", "(2.1)", "41.1"]);
    assert!(site.join("api/pendulum/struct.Pendulum.html").is_file());
    for (name, html) in ["index.html", "about.html", "pendulum/index.html"].map(|name| (name, page(name))) {
        assert!(!html.contains("mechanics") && !html.contains("Things That Spin"), "{name}");
        let claims = ["Text and figures", "Creative Commons", "rel=\"license\""];
        assert!(!claims.iter().any(|claim| html.contains(claim)), "{name}: its book.toml names no licence");
    }

    // The number that the page prints is held by a test.
    let said = run(&folder, &cargo, &["test", "--doc", "-p", "snippets", "pendulum"]);
    assert!(said.contains("1 passed"), "{said}");
}
