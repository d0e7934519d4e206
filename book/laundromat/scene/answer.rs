//! The answer to the chapter's question, in words.

use super::{Course, steady};
use mechanics::scenes::laundromat::{DrivenMachine, Folds, Motor, Rotor};

/// What the settings of a course lead to; with the quietest spin and its force on the floor, if there is one.
pub(super) fn answer(course: &Course, quietest: Option<(f64, f64)>) -> String {
    let (machine, spin) = (&course.machine, course.machine.spin());
    let [b, mass] = [machine.offset(), machine.total_mass()];
    if let Some(driven) = &course.driven {
        return with_weak_motor(course, driven);
    }
    if spin == 0.0 {
        return format!(
            "The drum stands still: the shaft rests at O, the centre of mass {:.0} mm beside it, and the floor feels nothing. {}",
            1e3 * b,
            fate_of_a_kick(course)
        );
    }
    let mut words = String::new();
    if let Some(steady) = steady(machine, course.is_radial) {
        let lead = steady.phase().to_degrees();
        let place = match lead {
            ..85.0 => "on the outside",
            ..95.0 => "a quarter turn ahead of the shaft",
            _ => "on the inside",
        };
        let [shaft, centre] = [steady.radius(), steady.centre_of_mass_radius()].map(|radius| 1e3 * radius);
        let [force, rigid] = [1e-3 * centre, b].map(|radius| mass * radius * spin * spin);
        words = format!(
            "At {spin:.1} rad/s the load is {place}, with a lead of {lead:.0}°: the shaft goes round O at {shaft:.1} mm, \
             the centre of mass at {centre:.1} mm. The floor feels {force:.0} N, where rigid bearings would give it \
             {rigid:.0} N"
        );
        if let Some((quiet, least)) = quietest {
            words += &if format!("{least:.0}") == format!("{force:.0}") {
                "; beyond the resonance no spin is quieter".into()
            } else {
                format!("; beyond the resonance {quiet:.0} rad/s would be quietest, with {least:.0} N")
            };
        }
        words += ". ";
        words += &fate_of_a_kick(course);
    } else {
        words += "At its natural frequency, with nothing to resist the way round, there is no steady motion: \
                  the swing grows at every turn.";
    }
    if course.speeds_up {
        let (time, distance) = course.widest;
        let spin = course.at(time).map_or(f64::NAN, |state| state.spin);
        words += &format!(
            " On its way from rest it swings out furthest, {:.0} mm, at {spin:.1} rad/s.",
            1e3 * distance
        );
    }
    words + &end(course)
}

/// How the course ends, if it does before its time.
fn end(course: &Course) -> String {
    if course.strikes {
        return format!(" After {:.1} s the tub strikes its housing, and the scene ends.", course.end);
    }
    String::new()
}

/// What a weak motor makes of it.
fn with_weak_motor(course: &Course, driven: &DrivenMachine) -> String {
    let Motor { stall_torque, idle_spin, .. } = driven.motor();
    let motor = format!("{stall_torque:.1} N·m at a standstill and none at {idle_spin:.0} rad/s");
    let last = course.at(course.end).map_or(f64::NAN, |state| state.spin);
    let words = match driven.steady_spins()[..] {
        [slow, middle, fast] => {
            let fate =
                if last < middle { "is caught at its resonance" } else { "gets through its resonance" };
            let frees = driven.folds().map_or(String::new(), |folds| {
                let Folds { up, down } = folds;
                format!(
                    " A knob that is turned up slowly would free it at {:.1} N·m, and down it would fall back at {:.1}.",
                    up.stall_torque, down.stall_torque
                )
            });
            format!(
                "With {motor} the drum can turn at {slow:.1} or at {fast:.1} rad/s ({middle:.1} would not last). From rest it \
                 {fate}.{frees}"
            )
        }
        [spin, ..] => format!("With {motor} the drum can turn at {spin:.1} rad/s only."),
        [] => format!("With {motor} no spin lasts."),
    };
    let (time, distance) = course.widest;
    words + &format!(" It swings out furthest, {:.0} mm, after {time:.1} s.", 1e3 * distance) + &end(course)
}

/// Whether a kick dies out or grows, and how fast.
fn fate_of_a_kick(course: &Course) -> String {
    let rotor = &course.rotor;
    let rate = match (rotor.whirl_spin(), course.is_radial) {
        (Some(_), true) => return at_rest_on_board_alone(course),
        (Some(limit), false) => return fate_of_a_whirl(rotor, limit),
        (None, true) => course.machine.radial_damping_growth(),
        (None, false) => {
            let rates = course.machine.modes().map(|mode| mode.frequency.im);
            -rates.into_iter().fold(f64::INFINITY, f64::min)
        }
    };
    let fate = match rate {
        1e-3.. => "Unstable: with this damper a kick grows",
        ..-1e-3 => "Stable: a kick dies out",
        _ => return "A kick neither dies out nor grows.".into(),
    };
    let why = if rate > 0.0 {
        " Seen on the drum the centrifugal force beats the springs: the shaft stands on a hill, and what slows it along \
         the radius lets it slide down."
    } else {
        ""
    };
    format!("{fate} by a factor e in {:.2} s.{why}", 1.0 / rate.abs())
}

/// The same with friction on board, which lets a kick grow beyond a limit.
fn fate_of_a_whirl(rotor: &Rotor, limit: f64) -> String {
    let (rate, natural) = (rotor.growth(), rotor.machine().natural_frequency());
    let time = 1.0 / rate.abs();
    match rate {
        1e-3.. => format!(
            "Unstable: the drum overtakes the whirl and drags it on, and a kick grows by a factor e in {time:.2} s, going \
             round at {:.1} rad/s. With these dampers every spin beyond {limit:.1} rad/s does that.",
            rotor.roots()[0].im
        ),
        ..-1e-3 => format!(
            "Stable: a kick dies out by a factor e in {time:.2} s. With these dampers it would grow beyond {limit:.1} rad/s."
        ),
        _ => format!(
            "At this spin floor and drum are a match: a whirl at {natural:.1} rad/s neither dies out nor grows."
        ),
    }
}

/// And if nothing but the springs is at rest in the room.
fn at_rest_on_board_alone(course: &Course) -> String {
    let natural = course.machine.natural_frequency();
    let fate =
        if course.machine.spin() > natural { "Unstable: a kick grows" } else { "Stable: a kick dies out" };
    format!("{fate}. No friction here is at rest in the room, so {natural:.1} rad/s is the limit.")
}
