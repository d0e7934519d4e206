//! What the pages run: functions that a script calls with numbers, and which give back numbers and texts.
//!
//! One instance of the module plays one scene, or runs the snippets of a page. Numbers go in through
//! [`input`], texts come out of [`text`], where a call that gives a length has left them. A length below zero
//! is that of an error, in words for the reader.
//!
//! A page loads what it needs: there is a module for each chapter, built with the name of its folder in
//! `BOOK_CHAPTER`. It holds the scene and the snippets of that chapter and what they use of the library.
//! Built without a name it holds all.

pub mod snippets;

use drawing::{Room, at};
use live::{Cause, Moment, Player};
use std::cell::{Cell, RefCell};
use std::panic;

/// As many values as a scene or a snippet can have.
const MOST: usize = 64;

thread_local! {
    static INPUT: [Cell<f64>; MOST] = const { [const { Cell::new(0.0) }; MOST] };
    static TEXT: RefCell<String> = const { RefCell::new(String::new()) };
    /// What the program said when it gave up.
    static LAST_WORDS: RefCell<String> = const { RefCell::new(String::new()) };
    static PLAYER: RefCell<Option<Player>> = const { RefCell::new(None) };
}

/// Where numbers go in: 64 of them.
#[unsafe(no_mangle)]
pub extern "C" fn input() -> *const f64 {
    INPUT.with(|input| input.as_ptr().cast())
}

/// Where texts come out, in UTF-8.
#[unsafe(no_mangle)]
pub extern "C" fn text() -> *const u8 {
    TEXT.with(|text| text.borrow().as_ptr())
}

/// Begins or changes a scene: its place in the book, and how many values of its controls stand in [`input`]. With
/// none it begins with its own.
#[unsafe(no_mangle)]
pub extern "C" fn start(scene: usize, count: usize) -> isize {
    listen();
    answer(|| {
        let entry = snippets::scenes().iter().find(|entry| entry.place == scene);
        let scene = entry.unwrap_or_else(|| panic!("this module has no scene {scene}")).scene;
        let mut player = if count == 0 { Player::new(scene)? } else { Player::with(scene, values(count))? };
        PLAYER.with(|own| {
            let mut own = own.borrow_mut();
            if let Some(before) = &*own {
                player.keep(before);
            }
            *own = Some(player);
        });
        Ok(String::new())
    })
}

/// Runs a snippet: its place among those with live numbers, and how many of them stand in [`input`]. A line
/// for each number that it prints, in its order: `=` and the number, or nothing if it was not reached; for
/// each assertion: `+` if it holds, `-` if not, `?` if it was not reached; then `!` and the words of an error
/// if it gave up.
#[unsafe(no_mangle)]
pub extern "C" fn run(snippet: usize, count: usize) -> isize {
    listen();
    let found = snippets::SNIPPETS.iter().find(|own| own.number == snippet);
    let snippet = found.unwrap_or_else(|| panic!("this module has no snippet {snippet}"));
    answer(|| Ok(snippet.run(&values(count)).join("\n")))
}

/// What the program said when it gave up: its length in [`text`].
#[unsafe(no_mangle)]
pub extern "C" fn last_words() -> isize {
    answer(|| Ok(LAST_WORDS.with(|words| words.borrow().clone())))
}

/// How long the motion runs, s of the scene.
#[unsafe(no_mangle)]
pub extern "C" fn duration() -> f64 {
    running().map_or(0.0, |run| run.duration)
}

/// Seconds of the scene in a second of the reader.
#[unsafe(no_mangle)]
pub extern "C" fn pace() -> f64 {
    running().map_or(1.0, |run| run.pace)
}

/// Whether the motion begins again at its end.
#[unsafe(no_mangle)]
pub extern "C" fn repeats() -> bool {
    running().is_some_and(|run| run.repeats)
}

/// Draws a moment: the elements of the SVG, one a line.
#[unsafe(no_mangle)]
pub extern "C" fn draw(time: f64, azimuth: f64, elevation: f64, is_narrow: bool) -> isize {
    let room = if is_narrow { Room::Narrow } else { Room::Wide };
    with(|player| Ok(player.draw(Moment { time, azimuth, elevation, room })?.to_elements()?))
}

/// The numbers beside the picture, as HTML, one a line.
#[unsafe(no_mangle)]
pub extern "C" fn readings(time: f64) -> isize {
    with(|player| Ok(player.readings(time)?.join("\n")))
}

/// What happens, in words.
#[unsafe(no_mangle)]
pub extern "C" fn words(time: f64) -> isize {
    with(|player| Ok(player.words(time)))
}

/// Which grip of the picture a hand takes hold of at a point, not further from it than `reach`, px; −1 for none.
#[unsafe(no_mangle)]
pub extern "C" fn grip(x: f64, y: f64, reach: f64) -> i32 {
    let mut found = -1;
    with(|player| {
        let distances = player.grips().into_iter().map(|grip| (grip.x - x).hypot(grip.y - y));
        let near = (0..).zip(distances).filter(|(_, distance)| *distance <= reach);
        found = near.min_by(|one, other| one.1.total_cmp(&other.1)).map_or(-1, |(index, _)| index);
        Ok(String::new())
    });
    found
}

/// Draws a grip to a point: how many values of controls stand in [`input`] then.
#[unsafe(no_mangle)]
pub extern "C" fn drag(grip: usize, x: f64, y: f64) -> usize {
    let mut count = 0;
    with(|player| {
        let values = player.drag(grip, at(x, y))?;
        count = values.len().min(MOST);
        INPUT.with(|input| input.iter().zip(values).for_each(|(slot, value)| slot.set(value)));
        Ok(String::new())
    });
    count
}

/// Keeps what the program says when it gives up.
fn listen() {
    panic::set_hook(Box::new(|info| LAST_WORDS.with(|words| *words.borrow_mut() = info.to_string())));
}

/// The first values of the input.
fn values(count: usize) -> Vec<f64> {
    INPUT.with(|input| input.iter().take(count).map(Cell::get).collect())
}

fn running() -> Option<live::Run> {
    PLAYER.with(|player| player.borrow().as_ref().map(Player::run))
}

/// Asks the scene in use.
fn with(ask: impl FnOnce(&mut Player) -> Result<String, Cause>) -> isize {
    answer(|| PLAYER.with(|player| ask(player.borrow_mut().as_mut().ok_or("no scene has begun")?)))
}

/// Leaves a text, or the words of an error, in [`text`].
fn answer(ask: impl FnOnce() -> Result<String, Cause>) -> isize {
    let (said, sign) = match ask() {
        Ok(said) => (said, 1),
        Err(cause) => (cause.to_string(), -1),
    };
    let length = sign * said.len() as isize;
    TEXT.with(|text| *text.borrow_mut() = said);
    length
}
