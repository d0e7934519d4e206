//! The modules of the pages, which move the live scenes and run the snippets with live numbers: built for
//! WebAssembly where a compiler can do that, and packed into scripts, since a page that is read from a folder
//! may load nothing else.
//!
//! Each chapter has a module of its own, with what its pages need. One for the whole book would be three
//! times as large, and a reader of one chapter would wait for all of it. They are the book's crate of snippets,
//! compiled once for each chapter.
//!
//! `BOOK_LIVE=static` prints stills, `BOOK_LIVE=require` makes a missing compiler an error, and `auto` (or
//! nothing) builds the module if it can. `BOOK_WASM_RUSTC` names a compiler other than `rustc`, which may lack the
//! target: then rustup is asked for it.

use crate::Book;
use crate::assets::chapter_of;
use crate::book::{Page, script};
use crate::mdbook::For;
use crate::site::package::cargo;
use anyhow::{Context as _, Result, anyhow, bail, ensure};
use base64::prelude::{BASE64_STANDARD, Engine as _};
use dialect::live_numbers;
use std::collections::{BTreeMap, BTreeSet};
use std::hash::{DefaultHasher, Hash, Hasher};
use std::panic::resume_unwind;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::sync::OnceLock;
use std::time::{Duration, Instant};
use std::{env, fs, io, thread};

/// Where the scripts lie, beside what the compiler leaves.
const FOLDER: &str = "target/live";
const TARGET: &str = "wasm32-unknown-unknown";
/// How long rustup is waited for, which fetches 20 MB.
const PATIENCE: Duration = Duration::from_secs(300);

/// What is said of what has failed.
const CANNOT: &str = "the module of the pages cannot be made";

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

/// The modules of a book: what they are made of.
#[derive(Debug, Clone)]
pub(crate) struct Modules {
    root: PathBuf,
    /// The package that is compiled.
    package: &'static str,
    /// The folders of the chapters that have a scene, or snippets with live numbers, and the text of these.
    chapters: BTreeMap<String, String>,
}

impl Modules {
    /// Those that `pages` of the project in `root` need.
    pub(crate) fn of(root: &Path, book: &Book, pages: &[Page]) -> Self {
        let mut chapters: BTreeMap<String, String> = BTreeMap::new();
        for page in pages {
            if let Some((folder, _)) = page.path.split_once('/') {
                *chapters.entry(folder.to_owned()).or_default() += &live_numbers::matter([&*page.text]);
            }
        }
        let has_scene = |folder: &str| book.scenes.iter().any(|(page, _)| chapter_of(page) == folder);
        chapters.retain(|folder, text| !text.is_empty() || has_scene(folder));
        Self { root: root.to_owned(), package: book.snippets, chapters }
    }

    /// What there is once `most` of those modules are compiled of which something has changed that they are made of.
    /// With none to compile, only who publishes the site waits until rustup has been asked for what the compiler lacks.
    ///
    /// # Errors
    /// If modules are required and there is no compiler for them; if one does not compile.
    pub(crate) fn made(&self, for_whom: For, most: usize) -> Result<Module> {
        let wish = env::var("BOOK_LIVE").unwrap_or_else(|_| "auto".to_owned());
        match wish.as_str() {
            _ if for_whom == For::Paper => return Ok(Module::Missing(None)),
            "static" => return Ok(Module::Missing(None)),
            "auto" | "require" => {}
            other => bail!("BOOK_LIVE is auto, static or require, not `{other}`"),
        }
        if self.chapters.is_empty() {
            return Ok(Module::Missing(None));
        }
        let may_ask = most > 0 || for_whom == For::Readers;
        let compiler = match compiler(may_ask) {
            Ok(compiler) => compiler,
            Err(error) if env::var_os("BOOK_WASM_RUSTC").is_some() => return Err(error),
            Err(_) if wish == "require" && !may_ask => return Ok(Module::Stale),
            Err(error) if wish == "require" => return Err(error),
            Err(error) => return Ok(Module::Missing(Some(error.to_string()))),
        };
        let version = Command::new(&compiler).arg("-vV").stdin(Stdio::null()).output().context(CANNOT)?;
        // While one is packed the next is compiled: each takes a few seconds, and most of the time one core.
        thread::scope(|scope| {
            let mut packing = Vec::new();
            let all = self.compiled(&compiler, &version.stdout, most, |own| {
                packing.push(scope.spawn(move || own.pack().context(CANNOT)));
            });
            for own in packing {
                own.join().unwrap_or_else(|panic| resume_unwind(panic))?;
            }
            Ok(if all? { Module::Built } else { Module::Stale })
        })
    }

    /// Compiles at most `most` of the modules that are not what they are made of, and gives each away to be packed. Whether
    /// that were all.
    fn compiled(
        &self,
        compiler: &Path,
        version: &[u8],
        most: usize,
        mut done: impl FnMut(Compiled),
    ) -> Result<bool> {
        let folder = self.root.join(FOLDER);
        let mut files = BTreeMap::new();
        let mut compiled = 0;
        for (chapter, live_text) in &self.chapters {
            let script = folder.join(script(chapter));
            let stamp = script.with_extension("stamp");
            let known = fs::read_to_string(&stamp).unwrap_or_default();
            let mut seen = |sources: &str| {
                let mut hasher = DefaultHasher::new();
                (version, live_text).hash(&mut hasher);
                for source in sources.lines() {
                    let read = || fs::read(self.root.join(source)).unwrap_or_default();
                    (source, files.entry(source.to_owned()).or_insert_with(read)).hash(&mut hasher);
                }
                format!("{:016x}", hasher.finish())
            };
            let is_current = known.split_once('\n').is_some_and(|(stamp, sources)| stamp == seen(sources));
            if script.is_file() && is_current {
                continue;
            }
            if compiled == most {
                return Ok(false);
            }
            compiled += 1;
            let wasm = self.compile(&folder, compiler, chapter)?;
            let sources = self.sources(&wasm).context(CANNOT)?;
            let made_of = format!("{}\n{sources}", seen(&sources));
            let wasm = fs::read(wasm).context(CANNOT)?;
            done(Compiled { wasm, script, made_of });
        }
        Ok(true)
    }

    /// What a module was compiled from, by the list that Cargo leaves beside it, and the manifests above: one a line,
    /// relative to the project's root. Of pages only the snippets count.
    fn sources(&self, wasm: &Path) -> Result<String> {
        let list = fs::read_to_string(wasm.with_extension("d"))?;
        let (_, files) = list.split_once(": ").context("Cargo has left no list")?;
        let files = files.replace("\\ ", "\0"); // a blank within a name
        let mut sources = BTreeSet::from([self.root.join("Cargo.lock")]);
        for file in files.split_whitespace().map(|file| PathBuf::from(file.replace('\0', " "))) {
            sources.extend(file.ancestors().skip(1).map(|above| above.join("Cargo.toml")));
            if file.extension().is_none_or(|ending| ending != "md") {
                sources.insert(file);
            }
        }
        let relative = |file: &PathBuf| file.strip_prefix(&self.root).unwrap_or(file).display().to_string();
        let lines: Vec<String> = sources.iter().filter(|file| file.is_file()).map(relative).collect();
        Ok(lines.join("\n"))
    }

    /// Compiles the module of a chapter; where it is.
    fn compile(&self, folder: &Path, compiler: &Path, chapter: &str) -> Result<PathBuf> {
        eprintln!("Compiling what moves in the chapter {chapter} for browsers");
        // What the module says when it gives up names files, and no folder of this machine.
        let home = env::var_os("CARGO_HOME").map(PathBuf::from);
        let home = home.or_else(|| Some(PathBuf::from(env::var_os("HOME")?).join(".cargo")));
        let folders = [(Some(self.root.clone()), "."), (home, "cargo")];
        let flags = folders.iter().filter_map(|(folder, name)| {
            Some(format!("\"--remap-path-prefix={}={name}\"", folder.as_ref()?.to_str()?))
        });
        let flags = flags.collect::<Vec<_>>().join(", ");
        let run = cargo(&self.root)
            .args(["rustc", "--quiet", "--package", self.package, "--lib", "--crate-type", "cdylib"])
            .args(["--profile", "live", "--target", TARGET, "--ignore-rust-version"])
            .args(["--config", &format!("target.{TARGET}.rustflags=[{flags}]")])
            .arg("--target-dir")
            .arg(folder)
            .env("RUSTC", compiler)
            .env("BOOK_CHAPTER", chapter)
            .env_remove("RUSTFLAGS")
            .env_remove("CARGO_ENCODED_RUSTFLAGS")
            .output()
            .context("cargo cannot be run")?;
        let said = String::from_utf8_lossy(&run.stderr);
        ensure!(run.status.success(), "the module of the pages does not compile:\n{}", said.trim_end());
        Ok(folder.join(TARGET).join(format!("live/{}.wasm", self.package.replace('-', "_"))))
    }
}

/// A module that is to be packed into a script, and what it was made of.
struct Compiled {
    wasm: Vec<u8>,
    script: PathBuf,
    made_of: String,
}

impl Compiled {
    fn pack(self) -> io::Result<()> {
        let Self { wasm, script, made_of } = self;
        let fresh = script.with_extension("new");
        fs::write(&fresh, packed(&wasm)?)?;
        fs::rename(fresh, &script)?;
        fs::write(script.with_extension("stamp"), made_of)
    }
}

/// A compiler that has the core library for WebAssembly. If the usual one lacks it, rustup is asked for it, once in a
/// run of the press, where one `may_ask`.
fn compiler(may_ask: bool) -> Result<PathBuf> {
    if let Some(named) = env::var_os("BOOK_WASM_RUSTC").map(PathBuf::from) {
        ensure!(has_target(&named), "BOOK_WASM_RUSTC is {}, which has no {TARGET}", named.display());
        return Ok(named);
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
    Err(anyhow!("the scenes of the pages stand still, because the compiler lacks the target {TARGET}: {why}"))
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

/// The module as a script: a call of `spin` with what it is when deflated, in base64.
fn packed(wasm: &[u8]) -> io::Result<String> {
    let mut deflated = Vec::new();
    zopfli::compress(zopfli::Options::default(), zopfli::Format::Deflate, wasm, &mut deflated)?;
    Ok(format!("spin(\"{}\");\n", BASE64_STANDARD.encode(&deflated)))
}

#[cfg(test)]
mod tests {
    use super::*;

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
}
