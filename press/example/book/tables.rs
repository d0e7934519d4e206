//! The tables that the library gives, one function each: `table:lateness`.

use figures::{Table, tables};
use pendulum::Pendulum;

/// All tables.
pub const TABLES: &[Table] = tables![lateness];

/// What a clock loses in a day, by its amplitude.
pub(crate) fn lateness() -> String {
    let clock = Pendulum { length: 0.994, gravity: 9.81 };
    let row = |degrees: f64| {
        let kept = clock.period(0.0) / clock.period(degrees.to_radians());
        format!("| {degrees} | {:.1} |\n", 86400.0 * (1.0 - kept))
    };
    let rows: String = [1.0, 2.0, 3.0, 5.0, 10.0].map(row).concat();
    format!("| amplitude, degrees | lost in a day, s |\n|---|---|\n{rows}")
}
