//! An end for what runs for ever: a snippet, a figure, a live snippet at some setting.

use std::sync::mpsc::{RecvTimeoutError, Sender, channel};
use std::time::Duration;
use std::{env, process, thread};

/// How many seconds each may take, if `BOOK_LIMIT` does not say.
const SECONDS: u64 = 300;

/// Ends the program, and says `what` runs for ever, if what comes back is not dropped in time.
///
/// # Panics
/// If `BOOK_LIMIT` is no whole number of seconds.
#[must_use]
pub fn watch(what: String) -> Sender<()> {
    let seconds = env::var("BOOK_LIMIT").map_or(SECONDS, |limit| {
        limit.parse().unwrap_or_else(|_| panic!("BOOK_LIMIT is a whole number of seconds, not `{limit}`"))
    });
    let (done, waits) = channel();
    thread::spawn(move || {
        if waits.recv_timeout(Duration::from_secs(seconds)) == Err(RecvTimeoutError::Timeout) {
            eprintln!(
                "error: {what} still runs after {seconds} s: if it only takes long, BOOK_LIMIT={} gives it more",
                10 * seconds
            );
            process::exit(1);
        }
    });
    done
}
