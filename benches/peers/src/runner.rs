//! Runs every contestant on every problem, in rounds, and writes what it finds.
//!
//! In each round every entry of every contestant has its turn of a few milliseconds, in an order that is
//! shuffled anew, so that what disturbs the machine disturbs all of them; what is reported is the median over
//! the rounds. Contestants are processes of their own and speak the lines of `benches/speed/contest.rs`.

use crate::card;
use crate::contest::Cause;
use crate::measured::{self, Measurement, NATIVE};
use crate::problems::NAMES;
use crate::tables;
use std::io::{BufRead, BufReader, Write};
use std::path::{Path, PathBuf};
use std::process::{Child, ChildStdin, ChildStdout, Command, Stdio};
use std::{env, fs};

const HELP: &str = "\
cargo book measure [OPTION …]     runs the library and its peers, and writes book/speed-and-accuracy

--rounds N       how many rounds the medians are taken over (31)
--problems A,B   only these problems; the others stay as they were measured
--no-contest     measures only what concerns the library alone, and makes the tables of the page again
--principia FOLDER
                 races Principia's closed form of a free body against the library's and nothing else, and writes
                 book/judged/closed-forms.csv; FOLDER has what benches/peers/principia/build.py made
--no-python      without heyoka, SciPy and MuJoCo
--python FILE    an interpreter that has them; by default one is set up under target/python with benches/peers/requirements.txt";

/// An entry that takes longer than this, s, has its turn in the first rounds only.
const SLOW: f64 = 0.2;
const ROUNDS_OF_THE_SLOW: usize = 3;

/// What the command was asked to do.
struct Options {
    rounds: usize,
    problems: Vec<String>,
    python: Option<PathBuf>,
    principia: Option<PathBuf>,
    no_python: bool,
    no_contest: bool,
}

/// A process, and what it can do.
struct Contestant {
    child: Child,
    to: ChildStdin,
    from: BufReader<ChildStdout>,
    entries: Vec<Entry>,
}

/// An entry, and what has been measured of it.
struct Entry {
    names: [String; 4],
    error: f64,
    evaluations: Option<usize>,
    seconds: Vec<f64>,
    failed: bool,
}

/// The whole command.
///
/// # Errors
/// A message for whoever typed it.
pub fn run(arguments: &[String]) -> Result<(), Cause> {
    let Some(options) = Options::read(arguments)? else {
        println!("{HELP}");
        return Ok(());
    };
    let root = fs::canonicalize(PathBuf::from(env::var("CARGO_MANIFEST_DIR")?).join("../.."))?;
    let folder = root.join("book/speed-and-accuracy");
    if options.no_contest {
        return finish(&root, &folder);
    }
    if let Some(programs) = &options.principia {
        return closed_forms(&root, programs, &options);
    }
    let (mut versions, mut notes) = (Vec::new(), Vec::new());
    let mut contestants = vec![
        Contestant::start(ours(&root, false).arg("serve"), "mechanics", &options, &mut versions, &mut notes)?,
        Contestant::start(ours(&root, true).arg("serve"), NATIVE, &options, &mut versions, &mut notes)?,
        Contestant::start(
            Command::new(env::current_exe()?).arg("serve"),
            "",
            &options,
            &mut versions,
            &mut notes,
        )?,
    ];
    if !options.no_python {
        match python(&root, &options) {
            Ok(mut command) => {
                contestants.push(Contestant::start(&mut command, "", &options, &mut versions, &mut notes)?);
            }
            Err(cause) => notes.push(format!("all: Python peers left out: {cause}")),
        }
    }
    contest(&mut contestants, options.rounds, &mut notes);
    let mut text = card::describe(options.rounds, &versions, &notes);
    for line in rows(&mut contestants).iter().map(Measurement::line) {
        text.push_str(&line);
        text.push('\n');
    }
    let rows = measured::parse(&text)?; // as rounded in the file, so that the tables are those of the file
    for contestant in contestants {
        contestant.end();
    }
    let problems: Vec<&str> = NAMES.into_iter().filter(|name| options.wants(name)).collect();
    for problem in &problems {
        println!("{}", measured::table(&rows, problem));
    }
    let file = folder.join("measured.csv");
    if problems.len() == NAMES.len() {
        fs::write(file, text)?;
        return finish(&root, &folder);
    }
    let all = measured_again(&fs::read_to_string(&file)?, &text, &problems);
    fs::write(file, all)?;
    rewrite_tables(&folder)
}

/// The race of the two closed forms of a free body, each with its compiler's default flags and for this processor.
fn closed_forms(root: &Path, programs: &Path, options: &Options) -> Result<(), Cause> {
    let (mut versions, mut notes) = (Vec::new(), Vec::new());
    let mut contestants = Vec::new();
    for (native, name, program) in [(false, "mechanics", "default"), (true, NATIVE, "native")] {
        let library = &mut ours(root, native);
        library.args(["serve", "closed"]);
        contestants.push(Contestant::start(library, name, options, &mut versions, &mut notes)?);
        let other = &mut Command::new(programs.join(program));
        contestants.push(Contestant::start(other, "", options, &mut versions, &mut notes)?);
    }
    contest(&mut contestants, options.rounds, &mut notes);
    let mut text = card::closed_forms(options.rounds, &versions, &notes);
    for line in rows(&mut contestants).iter().map(Measurement::line) {
        text.push_str(&line);
        text.push('\n');
    }
    contestants.into_iter().for_each(Contestant::end);
    let file = root.join("book/judged/closed-forms.csv");
    fs::write(&file, &text)?;
    println!("{text}\nwritten: {}", file.display());
    Ok(())
}

/// The data with some problems measured again: what is different of how, stands below the head of the others.
fn measured_again(old: &str, new: &str, problems: &[&str]) -> String {
    let names = problems.join(", ");
    let is_head = |line: &&str| line.starts_with('#');
    let is_new = |line: &str| line.split(',').next().is_some_and(|name| problems.contains(&name));
    let heads = old.lines().filter(is_head).filter(|line| !line.starts_with(&format!("# {names}: ")));
    let mut lines: Vec<String> = heads.map(str::to_owned).collect();
    let others = new.lines().filter(|line| is_head(line) && !old.lines().any(|known| known == *line));
    lines.extend(others.map(|line| format!("# {names}: {}", &line[2..])));
    lines.extend(old.lines().filter(|line| !is_head(line) && !is_new(line)).map(str::to_owned));
    lines.extend(new.lines().filter(|line| !is_head(line) && is_new(line)).map(str::to_owned));
    lines.join("\n") + "\n"
}

/// What the library does alone: its work, the long run and the limits; then the tables of the page.
fn finish(root: &Path, folder: &Path) -> Result<(), Cause> {
    for (order, file) in [("work", "work.csv"), ("long", "long-run.csv")] {
        let bench = ["bench", "--quiet", "--bench", "speed", "--", order];
        checked(cargo(root).args(bench).arg(folder.join(file)))?;
    }
    let bench = ["bench", "--quiet", "--features", "parallel", "--bench", "speed", "--", "limits"];
    let limits = cargo(root).args(bench).output()?;
    fs::write(folder.join("limits.csv"), card::head_of_limits() + &String::from_utf8(limits.stdout)?)?;
    rewrite_tables(folder)?;
    println!("written: the data and the tables of report.md in {}", folder.display());
    Ok(())
}

impl Options {
    fn read(arguments: &[String]) -> Result<Option<Self>, Cause> {
        let mut options = Self {
            rounds: 31,
            problems: Vec::new(),
            python: None,
            principia: None,
            no_python: false,
            no_contest: false,
        };
        let mut arguments = arguments.iter();
        while let Some(argument) = arguments.next() {
            let mut value = || arguments.next().ok_or_else(|| format!("{argument} needs a value\n\n{HELP}"));
            match argument.as_str() {
                "--rounds" => options.rounds = value()?.parse()?,
                "--problems" => options.problems = value()?.split(',').map(str::to_owned).collect(),
                "--python" => options.python = Some(value()?.into()),
                "--principia" => options.principia = Some(fs::canonicalize(value()?)?),
                "--no-python" => options.no_python = true,
                "--no-contest" => options.no_contest = true,
                "--help" | "-h" => return Ok(None),
                other => return Err(format!("there is no option {other}\n\n{HELP}").into()),
            }
        }
        if let Some(unknown) = options.problems.iter().find(|name| !NAMES.contains(&name.as_str())) {
            return Err(format!("there is no problem {unknown}, only {}", NAMES.join(", ")).into());
        }
        if options.rounds == 0 {
            return Err("no rounds, no medians".into());
        }
        Ok(Some(options))
    }

    fn wants(&self, problem: &str) -> bool {
        self.problems.is_empty() || self.problems.iter().any(|name| name == problem)
    }
}

/// Cargo in the project's root, without the flags of whoever runs this.
fn cargo(root: &Path) -> Command {
    let mut command = Command::new(env::var_os("CARGO").unwrap_or_else(|| "cargo".into()));
    command.current_dir(root).env_remove("RUSTFLAGS").env_remove("CARGO_ENCODED_RUSTFLAGS");
    command
}

/// The library's bench, with default flags or compiled for this processor.
fn ours(root: &Path, native: bool) -> Command {
    let mut command = cargo(root);
    command.args(["bench", "--quiet", "--bench", "speed"]);
    if native {
        command.env("RUSTFLAGS", card::NATIVE_FLAGS).arg("--target-dir").arg(root.join("target/native"));
    }
    command.arg("--");
    command
}

/// The Python peers; sets up their interpreter if there is none.
fn python(root: &Path, options: &Options) -> Result<Command, Cause> {
    let peers = root.join("benches/peers");
    let interpreter = match &options.python {
        Some(file) => file.clone(),
        None => {
            let folder = root.join("target/python");
            let interpreter = folder.join("bin/python");
            if !interpreter.exists() {
                println!("setting up Python peers in {}", folder.display());
                checked(Command::new("python3").args(["-m", "venv"]).arg(&folder))?;
                let requirements = peers.join("requirements.txt");
                checked(
                    Command::new(&interpreter)
                        .args(["-m", "pip", "install", "--quiet", "-r"])
                        .arg(requirements),
                )?;
            }
            interpreter
        }
    };
    let mut command = Command::new(interpreter);
    command.arg(peers.join("peers.py"));
    Ok(command)
}

fn checked(command: &mut Command) -> Result<(), Cause> {
    let status = command.status()?;
    if status.success() { Ok(()) } else { Err(format!("{command:?} ended with {status}").into()) }
}

impl Contestant {
    /// Starts a process and asks what it can do. A name that is not empty replaces the contestant's own.
    fn start(
        command: &mut Command,
        name: &str,
        options: &Options,
        versions: &mut Vec<String>,
        notes: &mut Vec<String>,
    ) -> Result<Self, Cause> {
        println!("starting {name} {:?}", command.get_program());
        let mut child = command.stdin(Stdio::piped()).stdout(Stdio::piped()).spawn()?;
        let (Some(mut to), Some(from)) = (child.stdin.take(), child.stdout.take()) else {
            return Err("no pipe to a contestant".into());
        };
        let mut from = BufReader::new(from);
        writeln!(to, "list")?;
        to.flush()?;
        let mut entries = Vec::new();
        loop {
            let mut line = String::new();
            if from.read_line(&mut line)? == 0 {
                return Err(format!("a contestant ended before it listed its entries: {command:?}").into());
            }
            match line.trim_end_matches('\n').split('\t').collect::<Vec<_>>()[..] {
                ["version", what, version] => {
                    let line = format!("{what} {version}");
                    if !versions.contains(&line) {
                        versions.push(line);
                    }
                }
                ["note", problem, who, text] => notes.push(format!("{problem}: {who}: {text}")),
                ["entry", problem, who, method, setting] => {
                    let who = if name.is_empty() { who } else { name };
                    let names = [problem, who, method, setting].map(str::to_owned);
                    // Indices are the contestant's: entries that nobody wants stay in the list.
                    let failed = !options.wants(problem);
                    entries.push(Entry {
                        names,
                        error: f64::NAN,
                        evaluations: None,
                        seconds: Vec::new(),
                        failed,
                    });
                }
                ["end"] => break,
                _ => return Err(format!("a contestant said `{}`", line.trim_end()).into()),
            }
        }
        Ok(Self { child, to, from, entries })
    }

    /// One turn of an entry.
    fn turn(&mut self, index: usize) -> Result<(), String> {
        let answer = (|| -> std::io::Result<String> {
            writeln!(self.to, "run {index}")?;
            self.to.flush()?;
            let mut line = String::new();
            self.from.read_line(&mut line)?;
            Ok(line)
        })()
        .map_err(|error| error.to_string())?;
        let entry = &mut self.entries[index];
        match answer.trim_end().split('\t').collect::<Vec<_>>()[..] {
            ["failed", why] => Err(why.to_owned()),
            [error, evaluations, seconds] => {
                let number = |text: &str| text.parse::<f64>().map_err(|_| format!("it said {text}"));
                entry.error = number(error)?;
                entry.evaluations = evaluations.parse().ok();
                entry.seconds.push(number(seconds)?);
                Ok(())
            }
            _ => Err("the process has ended".to_owned()),
        }
    }

    fn end(mut self) {
        drop(self.to); // its input ends, and so does it
        let _ = self.child.wait();
    }
}

/// All rounds. What fails is noted once and left out from then on.
fn contest(contestants: &mut [Contestant], rounds: usize, notes: &mut Vec<String>) {
    let mut random = fastrand::Rng::with_seed(1988);
    for round in 0..rounds {
        let mut turns: Vec<(usize, usize)> = Vec::new();
        for (who, contestant) in contestants.iter().enumerate() {
            for (index, entry) in contestant.entries.iter().enumerate() {
                let slow = entry.seconds.iter().any(|&seconds| seconds > SLOW);
                if !(entry.failed || slow && round >= ROUNDS_OF_THE_SLOW) {
                    turns.push((who, index));
                }
            }
        }
        random.shuffle(&mut turns);
        for (who, index) in turns {
            let contestant = &mut contestants[who];
            if let Err(why) = contestant.turn(index) {
                let entry = &mut contestant.entries[index];
                entry.failed = true;
                let [problem, name, method, setting] = &entry.names;
                notes.push(format!("{problem}: {name}: {method} with {setting} fails: {why}"));
            }
        }
        println!("round {} of {rounds}", round + 1);
    }
}

/// Medians and quartiles, problem by problem.
fn rows(contestants: &mut [Contestant]) -> Vec<Measurement> {
    let mut rows = Vec::new();
    for problem in NAMES {
        for entry in contestants.iter_mut().flat_map(|contestant| &mut contestant.entries) {
            let [name, contestant, method, setting] = &entry.names;
            if name != problem || entry.failed || entry.seconds.is_empty() {
                continue;
            }
            entry.seconds.sort_by(f64::total_cmp);
            let at = |part: f64| entry.seconds[((entry.seconds.len() - 1) as f64 * part).round() as usize];
            rows.push(Measurement {
                problem: name.clone(),
                contestant: contestant.clone(),
                method: method.clone(),
                setting: setting.clone(),
                error: entry.error,
                evaluations: entry.evaluations,
                seconds: at(0.5),
                quartiles: [at(0.25), at(0.75)],
            });
        }
    }
    rows
}

/// Puts the tables of the data in the place of those on the page.
fn rewrite_tables(folder: &Path) -> Result<(), Cause> {
    let data = |file: &str| fs::read_to_string(folder.join(file));
    let rows = &measured::parse(&data("measured.csv")?)?;
    let page = folder.join("report.md");
    let mut text = fs::read_to_string(&page)?;
    let mut tables: Vec<(String, String)> =
        NAMES.iter().map(|problem| (measured::table_head(problem), measured::table(rows, problem))).collect();
    tables.push((measured::AHEAD_HEAD.to_owned(), measured::ahead(rows, &NAMES)));
    for table in [tables::long_run(&data("long-run.csv")?), tables::limits(&data("limits.csv")?)] {
        tables.push((table.lines().next().unwrap_or_default().to_owned(), table));
    }
    for (head, table) in tables {
        let Some(start) = text.find(&head) else {
            return Err(format!("{} has no table that begins with `{head}`", page.display()).into());
        };
        let length: usize =
            text[start..].split_inclusive('\n').take_while(|line| line.starts_with('|')).map(str::len).sum();
        text.replace_range(start..start + length, &table);
    }
    let Some(start) = text.find(measured::FACTORS) else {
        return Err(
            format!("{} has no sentence that begins with `{}`", page.display(), measured::FACTORS).into()
        );
    };
    let length = text[start..].find(':').map_or(0, |colon| colon + 1);
    text.replace_range(start..start + length, &measured::factors(rows, &NAMES));
    fs::write(&page, text)?;
    Ok(())
}
