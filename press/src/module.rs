//! The modules of the pages, which move the live scenes and run the snippets with live numbers: built for
//! WebAssembly where a compiler can do that, and packed into scripts, since a page that is read from a folder
//! may load nothing else.
//!
//! Each chapter has a module of its own, with what its pages need. One for the whole book would be three
//! times as large, and a reader of one chapter would wait for all of it. They are the crate `module`, linked
//! once for each chapter.
//!
//! `BOOK_LIVE=static` prints stills, `BOOK_LIVE=require` makes a missing compiler an error, and `auto` (or
//! nothing) builds the module if it can. `BOOK_WASM_RUSTC` names a compiler other than `rustc`, which may lack the
//! target: then rustup is asked for it.

use crate::answers;
use crate::book::script;
use crate::mdbook::For;
use std::collections::BTreeMap;
use std::hash::{DefaultHasher, Hash, Hasher};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::sync::OnceLock;
use std::time::{Duration, Instant};
use std::{env, fs, io, thread};

/// Where the scripts lie, beside what the compiler leaves.
const FOLDER: &str = "target/live";
const TARGET: &str = "wasm32-unknown-unknown";
const CRATE: &str = "press/live/module";
/// How long rustup is waited for, which fetches 20 MB.
const PATIENCE: Duration = Duration::from_secs(300);

/// What there is for a book.
#[derive(Debug)]
pub(crate) enum Module {
    /// All scripts.
    Built,
    /// None; perhaps there is something to say about that.
    Missing(Option<String>),
    /// Some have to be compiled.
    Stale,
}

/// Copies into the site what its `pages` load.
pub(crate) fn add(site: &Path, root: &Path, pages: &BTreeMap<String, String>) -> io::Result<()> {
    for entry in fs::read_dir(root.join(FOLDER)).into_iter().flatten() {
        let script = entry?.file_name();
        let name = script.to_string_lossy();
        if name.ends_with(".js") && pages.values().any(|page| page.contains(&*name)) {
            fs::copy(root.join(FOLDER).join(&script), site.join(&script))?;
        }
    }
    Ok(())
}

/// What there is now. Whoever publishes the site waits until rustup has been asked for what the compiler lacks.
///
/// # Errors
/// If modules are required and there is no compiler for them.
pub(crate) fn found(root: &Path, for_whom: For) -> Result<Module, String> {
    modules(root, for_whom, 0)
}

/// What there is once those modules are compiled of which something has changed that they are made of.
///
/// # Errors
/// Those of [`found`]; if one does not compile, with the words of the compiler.
pub(crate) fn build(root: &Path, for_whom: For) -> Result<Module, String> {
    modules(root, for_whom, usize::MAX)
}

/// The same, but of one of them at most.
///
/// # Errors
/// Those of [`build`].
pub(crate) fn build_one(root: &Path, for_whom: For) -> Result<Module, String> {
    modules(root, for_whom, 1)
}

/// What there is once `most` modules are compiled.
fn modules(root: &Path, for_whom: For, most: usize) -> Result<Module, String> {
    let wish = env::var("BOOK_LIVE").unwrap_or_else(|_| "auto".to_owned());
    match wish.as_str() {
        _ if for_whom == For::Paper => return Ok(Module::Missing(None)),
        "static" => return Ok(Module::Missing(None)),
        "auto" | "require" => {}
        other => return Err(format!("BOOK_LIVE is auto, static or require, not `{other}`")),
    }
    if !root.join(CRATE).is_dir() {
        return Ok(Module::Missing(None)); // a book without the library
    }
    let may_ask = most > 0 || for_whom == For::Readers;
    let compiler = match compiler(may_ask) {
        Ok(compiler) => compiler,
        Err(message) if env::var_os("BOOK_WASM_RUSTC").is_some() => return Err(message),
        Err(_) if wish == "require" && !may_ask => return Ok(Module::Stale),
        Err(message) if wish == "require" => return Err(message),
        Err(message) => return Ok(Module::Missing(Some(message))),
    };
    let cannot = |error: io::Error| format!("the module of the pages cannot be made: {error}");
    let folder = root.join(FOLDER);
    let shared = shared(root, &compiler).map_err(cannot)?;
    let mut compiled = 0;
    for chapter in chapters(root).map_err(cannot)? {
        let script = folder.join(script(&chapter));
        let stamp = script.with_extension("stamp");
        let wanted = made_of(root, shared.clone(), &chapter).map_err(cannot)?;
        if !script.is_file() || fs::read_to_string(&stamp).map_or(true, |stamp| stamp != wanted) {
            if compiled == most {
                return Ok(Module::Stale);
            }
            compiled += 1;
            let wasm = compile(root, &folder, &compiler, &chapter)?;
            let packed = packed(&fs::read(wasm).map_err(cannot)?).map_err(cannot)?;
            let fresh = script.with_extension("new");
            fs::write(&fresh, packed)
                .and_then(|()| fs::rename(fresh, &script))
                .and_then(|()| fs::write(stamp, wanted))
                .map_err(cannot)?;
        }
    }
    Ok(Module::Built)
}

/// The folders of the chapters that have a scene, or snippets with live numbers.
fn chapters(root: &Path) -> io::Result<Vec<String>> {
    let mut found = Vec::new();
    for entry in fs::read_dir(root.join("book"))? {
        let folder = entry?.path();
        if folder.is_dir() && (folder.join("scene.rs").is_file() || !live_text(&folder)?.is_empty()) {
            found.extend(folder.file_name().map(|name| name.to_string_lossy().into_owned()));
        }
    }
    found.sort();
    Ok(found)
}

/// What a module holds of the pages of a folder.
fn live_text(folder: &Path) -> io::Result<String> {
    let mut files = Vec::new();
    walk(folder, &mut files)?;
    files.sort();
    let mut text = String::new();
    for page in files.iter().filter(|path| path.extension().is_some_and(|ending| ending == "md")) {
        text += &answers::matter([&*fs::read_to_string(page)?]);
    }
    Ok(text)
}

/// A compiler that has the core library for WebAssembly. If the usual one lacks it, rustup is asked for it, once in a
/// run of the press, where one `may_ask`.
fn compiler(may_ask: bool) -> Result<PathBuf, String> {
    if let Some(named) = env::var_os("BOOK_WASM_RUSTC").map(PathBuf::from) {
        let lacks = || format!("BOOK_WASM_RUSTC is {}, which has no {TARGET}", named.display());
        return if has_target(&named) { Ok(named) } else { Err(lacks()) };
    }
    let own = env::var_os("RUSTC").map_or_else(|| "rustc".into(), PathBuf::from);
    if has_target(&own) {
        return Ok(own);
    }
    static ASKED: OnceLock<Result<(), String>> = OnceLock::new();
    let why = match may_ask.then(|| ASKED.get_or_init(|| ask(Path::new("rustup"), PATIENCE))) {
        Some(Ok(())) if has_target(&own) => return Ok(own),
        Some(Ok(())) => format!("rustup has it now, but {} is not rustup's", own.display()),
        Some(Err(why)) => why.clone(),
        None => format!("`rustup target add {TARGET}` fetches it"),
    };
    Err(format!("the scenes of the pages stand still, because the compiler lacks the target {TARGET}: {why}"))
}

/// Whether a compiler has the core library for WebAssembly.
fn has_target(compiler: &Path) -> bool {
    let said = Command::new(compiler)
        .args(["--print", "target-libdir", "--target", TARGET])
        .stdin(Stdio::null())
        .stderr(Stdio::null())
        .output();
    let folder = said.ok().map(|said| PathBuf::from(String::from_utf8_lossy(&said.stdout).trim()));
    let mut files = folder.and_then(|folder| fs::read_dir(folder).ok()).into_iter().flatten().flatten();
    files.any(|file| file.file_name().to_string_lossy().starts_with("libcore-"))
}

/// Asks rustup for the target, and waits for it no longer than `patience`; why there is none.
fn ask(rustup: &Path, patience: Duration) -> Result<(), String> {
    let mut asked = Command::new(rustup)
        .args(["target", "add", TARGET])
        .stdin(Stdio::null())
        .stdout(Stdio::null()) // which belongs to mdBook's protocol; rustup writes what it does to the other
        .spawn()
        .map_err(|error| format!("rustup, which could fetch it, cannot be run ({error})"))?;
    eprintln!(
        "Scenes that move need a part of the compiler: asking rustup for {TARGET} (with BOOK_LIVE=static nothing is asked)"
    );
    let begin = Instant::now();
    loop {
        match asked.try_wait() {
            Ok(Some(status)) if status.success() => return Ok(()),
            Ok(Some(status)) => {
                return Err(format!("`rustup target add {TARGET}` has failed ({status})"));
            }
            Ok(None) if begin.elapsed() < patience => thread::sleep(Duration::from_millis(50)),
            waited => {
                let _ = asked.kill();
                let _ = asked.wait();
                let why = waited.map_or_else(
                    |error| error.to_string(),
                    |_| format!("nothing after {} s", patience.as_secs_f64()),
                );
                return Err(format!("`rustup target add {TARGET}` was stopped ({why})"));
            }
        }
    }
}

/// A hasher that has seen what all modules are made of.
fn shared(root: &Path, compiler: &Path) -> io::Result<DefaultHasher> {
    let mut hasher = DefaultHasher::new();
    let version = Command::new(compiler).arg("-vV").stdin(Stdio::null()).output()?;
    version.stdout.hash(&mut hasher);
    let mut files = Vec::new();
    for path in [
        "Cargo.toml",
        "Cargo.lock",
        "src",
        "press/drawing",
        "press/live",
        "press/snippets/src/printable.rs",
        "press/src/answers.rs",
        "press/src/library.rs",
        "press/src/markdown.rs",
        "press/src/module.rs",
        "press/src/pages.rs",
        "press/src/printed.rs",
        "book/SUMMARY.md",
    ] {
        walk(&root.join(path), &mut files)?;
    }
    see(root, files, &mut hasher)?;
    Ok(hasher)
}

/// A number that changes with everything that the module of a chapter is made of.
fn made_of(root: &Path, mut hasher: DefaultHasher, chapter: &str) -> io::Result<String> {
    let own = root.join("book").join(chapter);
    live_text(&own)?.hash(&mut hasher);
    let mut files = Vec::new();
    for part in ["scene.rs", "scene"].map(|part| own.join(part)) {
        if part.exists() {
            walk(&part, &mut files)?;
        }
    }
    see(root, files, &mut hasher)?;
    Ok(format!("{:016x}", hasher.finish()))
}

/// Shows files with their names to a hasher.
fn see(root: &Path, mut files: Vec<PathBuf>, hasher: &mut DefaultHasher) -> io::Result<()> {
    files.sort();
    for file in files {
        (file.strip_prefix(root).unwrap_or(&file), fs::read(&file)?).hash(hasher);
    }
    Ok(())
}

/// A file, or all files in a folder but those of tests and examples.
fn walk(path: &Path, files: &mut Vec<PathBuf>) -> io::Result<()> {
    if path.is_symlink() && path.is_dir() {
        return Ok(()); // perhaps back to where it stands
    } else if !path.is_dir() {
        files.push(path.to_owned());
        return Ok(());
    }
    for entry in fs::read_dir(path)? {
        let entry = entry?;
        if !["tests", "examples"].iter().any(|name| entry.file_name() == *name) {
            walk(&entry.path(), files)?;
        }
    }
    Ok(())
}

/// Compiles the module of a chapter; where it is.
fn compile(root: &Path, folder: &Path, compiler: &Path, chapter: &str) -> Result<PathBuf, String> {
    eprintln!("Compiling what moves in the chapter {chapter} for browsers");
    // What the module says when it gives up names files, and no folder of this machine.
    let home = env::var_os("CARGO_HOME").map(PathBuf::from);
    let home = home.or_else(|| Some(PathBuf::from(env::var_os("HOME")?).join(".cargo")));
    let folders = [(Some(root.to_owned()), "."), (home, "cargo")];
    let flags = folders.iter().filter_map(|(folder, name)| {
        Some(format!("\"--remap-path-prefix={}={name}\"", folder.as_ref()?.to_str()?))
    });
    let flags = flags.collect::<Vec<_>>().join(", ");
    let run = Command::new(env::var_os("CARGO").unwrap_or_else(|| "cargo".into()))
        .args(["build", "--quiet", "--package", "module", "--profile", "live", "--target", TARGET])
        .args(["--ignore-rust-version", "--config", &format!("target.{TARGET}.rustflags=[{flags}]")])
        .arg("--target-dir")
        .arg(folder)
        .current_dir(root)
        .env("RUSTC", compiler)
        .env("BOOK_CHAPTER", chapter)
        .env_remove("RUSTFLAGS")
        .env_remove("CARGO_ENCODED_RUSTFLAGS")
        .stdin(Stdio::null())
        .output()
        .map_err(|error| format!("cargo cannot be run: {error}"))?;
    if !run.status.success() {
        let said = String::from_utf8_lossy(&run.stderr);
        return Err(format!("the module of the pages does not compile:\n{}", said.trim_end()));
    }
    Ok(folder.join(TARGET).join("live/module.wasm"))
}

/// The module as a script: a call of `spin` with what it is when deflated, in base64.
fn packed(wasm: &[u8]) -> io::Result<String> {
    let mut deflated = Vec::new();
    zopfli::compress(zopfli::Options::default(), zopfli::Format::Deflate, wasm, &mut deflated)?;
    Ok(format!("spin(\"{}\");\n", base64(&deflated)))
}

fn base64(bytes: &[u8]) -> String {
    const SIGNS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    let mut out = String::with_capacity(bytes.len().div_ceil(3) * 4);
    for three in bytes.chunks(3) {
        let bits =
            (0..3).fold(0_usize, |bits, n| bits << 8 | usize::from(three.get(n).copied().unwrap_or(0)));
        let sign =
            |n: usize| if n <= three.len() { char::from(SIGNS[bits >> (18 - 6 * n) & 63]) } else { '=' };
        out.extend((0..4).map(sign));
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::io::Read as _;

    #[test]
    fn bytes_are_written_in_base_64() {
        // From RFC 4648.
        let known = [
            ("", ""),
            ("f", "Zg=="),
            ("fo", "Zm8="),
            ("foo", "Zm9v"),
            ("foob", "Zm9vYg=="),
            ("fooba", "Zm9vYmE="),
        ];
        for (bytes, written) in known {
            assert_eq!(base64(bytes.as_bytes()), written);
        }
        assert_eq!(base64(&[0xfb, 0xff, 0xbf]), "+/+/");
    }

    #[cfg(unix)]
    #[test]
    fn rustup_is_asked_for_the_target_and_given_up_when_it_fails_or_hangs() {
        let folder = env::temp_dir().join(format!("press-rustup-{}", std::process::id()));
        fs::create_dir_all(&folder).unwrap();
        let program = |name: &str, text: &str| {
            let file = folder.join(name);
            // By another process: what this one writes cannot be run while some thread starts a third.
            let write = "printf '#!/bin/sh\\n%s\\n' \"$1\" > \"$0\" && chmod 755 \"$0\"";
            let written = Command::new("sh").args(["-c", write]).arg(&file).arg(text).status();
            assert!(written.unwrap().success());
            file
        };
        let rustc = program("rustc", &format!("echo '{}'", folder.join("lib").display()));
        assert!(!has_target(&rustc));
        let fetches = format!(
            "[ \"$*\" = 'target add {TARGET}' ] && mkdir {0} && touch {0}/libcore-1.rlib",
            folder.join("lib").display()
        );
        assert_eq!(ask(&program("good", &fetches), PATIENCE), Ok(()));
        assert!(has_target(&rustc));

        let said = |rustup: &Path| ask(rustup, Duration::from_millis(300)).unwrap_err();
        assert!(said(&program("bad", "exit 3")).contains("has failed (exit status: 3)"));
        let begin = Instant::now();
        assert!(said(&program("slow", "exec sleep 60")).contains("was stopped (nothing after 0.3 s)"));
        assert!(begin.elapsed() < Duration::from_secs(20));
        assert!(said(&folder.join("none")).contains("cannot be run"));
        fs::remove_dir_all(folder).unwrap();
    }

    #[test]
    fn the_script_holds_the_module_deflated() {
        let wasm: Vec<u8> = (0..3000_u32).map(|n| (n * n % 251) as u8).collect();
        let script = packed(&wasm).unwrap();
        let text = script.strip_prefix("spin(\"").and_then(|rest| rest.strip_suffix("\");\n")).unwrap();
        let value = |sign: u8| match sign {
            b'A'..=b'Z' => sign - b'A',
            b'a'..=b'z' => sign - b'a' + 26,
            b'0'..=b'9' => sign - b'0' + 52,
            b'+' => 62,
            _ => 63,
        };
        let mut bytes = Vec::new();
        for four in text.trim_end_matches('=').as_bytes().chunks(4) {
            let bits = four.iter().fold(0_u32, |bits, sign| bits << 6 | u32::from(value(*sign)));
            let bits = bits << (6 * (4 - four.len()));
            bytes.extend(&bits.to_be_bytes()[1..four.len()]);
        }
        let mut unpacked = Vec::new();
        flate2::read::DeflateDecoder::new(&bytes[..]).read_to_end(&mut unpacked).unwrap();
        assert!(unpacked == wasm);
    }
}
