//! What a browser calls: functions that a script calls with numbers, and which give back numbers and texts.
//!
//! One instance of the module plays one scene, or runs the snippets of a page. Numbers go in through
//! [`input`], texts come out of [`text`], where a call that gives a length has left them. A length below zero
//! is that of an error, in words for the reader.
//!
//! A page loads what it needs: there is a module for each chapter, built with the name of its folder in
//! `BOOK_CHAPTER`. It holds the scenes and the snippets of that chapter and what they use of the library.
//! Built without a name it holds all. [`pages!`](crate::pages) gives these functions the names that scripts call.

use crate::scene::{Run, Scene, Sound};
use crate::snippet::Snippet;
use crate::{Cause, Moment, Player};
use drawing::{Room, at};
use std::cell::{Cell, RefCell};
use std::panic;

/// As many values as a scene, with its earlier presses and what is kept to compare, or a snippet can have.
const MOST: usize = 320;

thread_local! {
    static INPUT: [Cell<f64>; MOST] = const { [const { Cell::new(0.0) }; MOST] };
    static TEXT: RefCell<String> = const { RefCell::new(String::new()) };
    /// What the program said when it gave up.
    static LAST_WORDS: RefCell<String> = const { RefCell::new(String::new()) };
    static PLAYER: RefCell<Option<Player>> = const { RefCell::new(None) };
}

/// Where numbers go in: 320 of them.
pub fn input() -> *const f64 {
    INPUT.with(|input| input.as_ptr().cast())
}

/// Where texts come out, in UTF-8.
pub fn text() -> *const u8 {
    TEXT.with(|text| text.borrow().as_ptr())
}

/// The scenes of a book that a module holds, each at its place among all: those on the pages of a chapter, or all.
/// They are found while the module is compiled, so that it holds no other.
pub const fn held<const COUNT: usize>(
    all: &[(&'static str, &'static Scene)],
    chapter: Option<&str>,
) -> [Option<&'static Scene>; COUNT] {
    let mut held = [None; COUNT];
    let mut place = 0;
    while place < COUNT {
        let (page, scene) = all[place];
        let is_held = match chapter {
            Some(chapter) => lies_in(page.as_bytes(), chapter.as_bytes()),
            None => true,
        };
        if is_held {
            held[place] = Some(scene);
        }
        place += 1;
    }
    held
}

/// Whether a page, `turning/middle-axis` or `turning` for the first one, lies in the folder of a chapter.
const fn lies_in(page: &[u8], chapter: &[u8]) -> bool {
    let mut at = 0;
    while at < page.len() && at < chapter.len() && page[at] == chapter[at] {
        at += 1;
    }
    at == chapter.len() && (at == page.len() || page[at] == b'/')
}

/// Begins or changes a scene: its place in the book, and how many values of its controls, and of earlier presses, stand
/// in [`input`]. With none it begins with its own. From a time on it goes on from the motion before, and leaves in
/// [`input`] what the controls have come to; below zero it begins anew.
///
/// # Panics
/// If the module has no such scene.
pub fn start(scenes: &[Option<&'static Scene>], scene: usize, count: usize, time: f64) -> isize {
    listen();
    answer(|| {
        let held = scenes.get(scene).copied().flatten();
        let scene = held.unwrap_or_else(|| panic!("this module has no scene {scene}"));
        PLAYER.with(|own| {
            let mut own = own.borrow_mut();
            let before = own.as_ref().filter(|before| before.scene().name == scene.name);
            let mut player = match before {
                _ if count == 0 => Player::new(scene)?,
                Some(before) if time >= 0.0 => before.continued(values(count), time)?,
                _ => Player::with(scene, values(count))?,
            };
            if let Some(before) = before {
                player.keep(before);
            }
            leave(player.values());
            *own = Some(player);
            Ok(String::new())
        })
    })
}

/// Runs a snippet: its place among those with live numbers, and how many of them stand in [`input`]. The lines of the
/// answer are those of [`Snippet::run`].
///
/// # Panics
/// If the module has no such snippet.
pub fn run(snippets: &[Snippet], snippet: usize, count: usize) -> isize {
    listen();
    let found = snippets.iter().find(|own| own.number == snippet);
    let snippet = found.unwrap_or_else(|| panic!("this module has no snippet {snippet}"));
    answer(|| Ok(snippet.run(&values(count)).join("\n")))
}

/// What the program said when it gave up: its length in [`text`].
pub fn last_words() -> isize {
    answer(|| Ok(LAST_WORDS.with(|words| words.borrow().clone())))
}

/// How long the motion runs, s of the scene.
pub fn duration() -> f64 {
    running().map_or(0.0, |run| run.duration)
}

/// Seconds of the scene in a second of the reader.
pub fn pace() -> f64 {
    running().map_or(1.0, |run| run.pace)
}

/// Whether the motion begins again at its end.
pub fn repeats() -> bool {
    running().is_some_and(|run| run.repeats)
}

/// Draws what stands behind every moment: elements of the SVG, one a line.
pub fn behind(is_narrow: bool) -> isize {
    with(|player| player.behind(room(is_narrow)))
}

/// Draws a moment: the elements before those of [`behind`], one a line.
pub fn draw(time: f64, azimuth: f64, elevation: f64, is_narrow: bool) -> isize {
    with(|player| player.elements(Moment { time, azimuth, elevation, room: room(is_narrow) }))
}

fn room(is_narrow: bool) -> Room {
    if is_narrow { Room::Narrow } else { Room::Wide }
}

/// The numbers beside the picture, as HTML, one a line.
pub fn readings(time: f64) -> isize {
    with(|player| Ok(player.readings(time)?.join("\n")))
}

/// What happens, in words.
pub fn words(time: f64) -> isize {
    with(|player| Ok(player.words(time)))
}

/// What is heard at a time: how many numbers stand in [`input`] then, none or the frequency, Hz, and the loudness.
pub fn sound(time: f64) -> usize {
    let mut count = 0;
    with(|player| {
        if let Some(Sound { frequency, loudness }) = player.sound(time) {
            leave(&[frequency, loudness]);
            count = 2;
        }
        Ok(String::new())
    });
    count
}

/// Which grip of the picture, from 0 on, or which body, from −2 down, a hand takes hold of at a point, a grip not further
/// from it than `reach`, px; −1 for none.
pub fn grip(x: f64, y: f64, reach: f64) -> i32 {
    let mut found = -1;
    with(|player| {
        let grips = player.grips().len() as i32;
        found = player.hold(at(x, y), reach).map_or(-1, |index| {
            let index = index as i32;
            if index < grips { index } else { grips - index - 2 }
        });
        Ok(String::new())
    });
    found
}

/// Draws a grip or a body, see [`grip`](fn@grip), to a point: how many values of controls stand in [`input`] then.
pub fn drag(grip: i32, x: f64, y: f64) -> usize {
    let mut count = 0;
    with(|player| {
        let index = if grip < 0 { player.grips().len() as i32 - grip - 2 } else { grip };
        let values = player.drag(index as usize, at(x, y))?;
        count = values.len();
        leave(&values);
        Ok(String::new())
    });
    count
}

/// Keeps what the program says when it gives up.
fn listen() {
    panic::set_hook(Box::new(|info| LAST_WORDS.with(|words| *words.borrow_mut() = info.to_string())));
}

/// Leaves values where numbers go in.
fn leave(values: &[f64]) {
    INPUT.with(|input| input.iter().zip(values).for_each(|(slot, value)| slot.set(*value)));
}

/// The first values of the input.
fn values(count: usize) -> Vec<f64> {
    INPUT.with(|input| input.iter().take(count).map(Cell::get).collect())
}

fn running() -> Option<Run> {
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

/// The crate of a book's pages: the documentation tests of its snippets, those with live numbers as `SNIPPETS`, and
/// what scripts call for them and for the scenes. The build script of the crate has written the snippets.
#[macro_export]
macro_rules! pages {
    ($scenes:expr) => {
        #[cfg(doctest)]
        mod tested {
            include!(concat!(env!("OUT_DIR"), "/tested.rs"));
        }

        /// The text of the pages.
        #[allow(unused, clippy::all, reason = "it is written for a reader, who may leave a value unused")]
        mod written {
            use $crate::snippet::record::assertions::{approx, assert, assert_eq, assert_ne};
            use $crate::snippet::{Live, Snippet, record};

            include!(concat!(env!("OUT_DIR"), "/live.rs"));
        }

        pub use written::SNIPPETS;

        static SCENES: [Option<&'static $crate::Scene>; $scenes.len()] =
            $crate::module::held($scenes, option_env!("BOOK_CHAPTER"));

        $crate::exported! {
            input() -> *const f64;
            text() -> *const u8;
            last_words() -> isize;
            duration() -> f64;
            pace() -> f64;
            repeats() -> bool;
            behind(is_narrow: bool) -> isize;
            draw(time: f64, azimuth: f64, elevation: f64, is_narrow: bool) -> isize;
            readings(time: f64) -> isize;
            words(time: f64) -> isize;
            sound(time: f64) -> usize;
            grip(x: f64, y: f64, reach: f64) -> i32;
            drag(grip: i32, x: f64, y: f64) -> usize;
        }

        /// Begins or changes a scene.
        #[unsafe(no_mangle)]
        pub extern "C" fn start(scene: usize, count: usize, time: f64) -> isize {
            $crate::module::start(&SCENES, scene, count, time)
        }

        /// Runs a snippet.
        #[unsafe(no_mangle)]
        pub extern "C" fn run(snippet: usize, count: usize) -> isize {
            $crate::module::run(&SNIPPETS, snippet, count)
        }
    };
}

#[doc(hidden)]
#[macro_export]
macro_rules! exported {
    ($($name:ident($($argument:ident: $of:ty),*) -> $gives:ty;)*) => {$(
        #[doc = concat!("See `live::module::", stringify!($name), "`.")]
        #[unsafe(no_mangle)]
        pub extern "C" fn $name($($argument: $of),*) -> $gives {
            $crate::module::$name($($argument),*)
        }
    )*};
}
