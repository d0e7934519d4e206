//! Error against time and work for every scene with motion.
//!
//! `cargo bench --bench speed` prints a table. `-- work FILE` writes what does not depend on the machine:
//! errors and evaluations of the rates; `-- long FILE` what is left after a million periods of the hoop (a
//! minute or two). `-- limits` prints what a sample costs in long lists. `-- serve` makes the program a
//! contestant of `cargo book measure`, which compares it with others; `-- serve closed` of the race of closed forms.

mod contest;
mod limits;
mod long_run;
mod ours;
#[allow(dead_code, reason = "shared with the peers and the tests; each takes what it needs")]
mod problems;
mod work;

use contest::{Cause, SLICE};

/// How many rounds the printed median is taken over.
const ROUNDS: usize = 7;

fn main() -> Result<(), Cause> {
    let entries = ours::entries()?;
    let arguments: Vec<String> = std::env::args().skip(1).filter(|argument| argument != "--bench").collect();
    match arguments.iter().map(String::as_str).collect::<Vec<_>>()[..] {
        ["serve"] => contest::serve(&entries, &[], &[("mechanics", env!("CARGO_PKG_VERSION"))])?,
        ["serve", "closed"] => {
            contest::serve(&ours::closed_forms()?, &[], &[("mechanics", env!("CARGO_PKG_VERSION"))])?;
        }
        ["work", file] => std::fs::write(file, work::csv(&work::rows(&entries)?))?,
        ["long", file] => std::fs::write(file, long_run::csv(&long_run::rows(&long_run::PERIODS)?))?,
        ["limits"] => print!("{}", limits::csv(&limits::rows()?)),
        [] => {
            let mut seconds = vec![Vec::new(); entries.len()];
            for _ in 0..ROUNDS {
                for (entry, times) in entries.iter().zip(&mut seconds) {
                    times.push(entry.measure(SLICE)?.seconds);
                }
            }
            for (row, times) in work::rows(&entries)?.iter().zip(&mut seconds) {
                times.sort_by(f64::total_cmp);
                println!("{row} {:>12.5} ms", 1e3 * times[ROUNDS / 2]);
            }
        }
        _ => {
            return Err(
                "there are only `work FILE`, `long FILE`, `limits`, `serve` and `serve closed`".into()
            );
        }
    }
    Ok(())
}
