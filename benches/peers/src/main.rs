//! Other people's solvers on the problems of the report, and the runner that measures them beside the library.
//!
//! `cargo book measure` runs it; so does
//! `cargo run --release --manifest-path benches/peers/Cargo.toml -- [OPTION …]`. With `serve` it is a
//! contestant itself: the peers that are written in Rust.

mod card;
#[path = "../../speed/contest.rs"]
mod contest;
mod engine;
#[allow(dead_code, reason = "shared with the tests, which read what is written here")]
#[path = "../../speed/measured.rs"]
mod measured;
#[path = "../../speed/problems.rs"]
mod problems;
mod runner;
mod solvers;
#[path = "../../speed/tables.rs"]
mod tables;

fn main() -> Result<(), contest::Cause> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    if arguments == ["serve"] {
        let (mut entries, notes) = solvers::entries();
        entries.extend(engine::entries());
        contest::serve(&entries, &notes, &[])?;
        return Ok(());
    }
    runner::run(&arguments)
}
