//! Steady motion against the spin: circles, the floor, the motor.

use super::{NATURAL, Values, over_spin, washing_machine};
use drawing::kit::Marker;
use drawing::{Drawing, Fill, Hue, Rect, Role, Side, Stroke};
use figures::{Axis, Cause, Outcome, Plot, Room, in_both, linear_steps, log_steps};
use mechanics::InvalidQuantity;
use mechanics::scenes::laundromat::{Machine, MachineParameters};
use std::f64::consts::SQRT_2;

/// The dampings Γ/ω₀ that all four figures compare: the stronger the damper, the heavier the line. The middle one is
/// the chapter's machine.
const DAMPINGS: [(f64, Stroke); 3] = [(0.1, Stroke::Outline), (0.3, Stroke::Curve), (1.0, Stroke::Heavy)];
/// How far their axis of the spin goes, Ω/ω₀.
const FASTEST: f64 = 4.0;

/// The axis of the spin that the figures share.
fn spin_axis(room: Room) -> Axis<'static> {
    Axis::linear(0.0, FASTEST, room.of(0.5, 1.0)).minor(0.1).titled(r"spin $\Omega/\omega_0$")
}

/// A quantity of the chapter's machine over that axis.
fn over_all(
    damping: f64,
    quantity: impl Fn(&Machine) -> Result<f64, InvalidQuantity>,
) -> Result<Values, Cause> {
    over_spin(damping, 0.0, FASTEST, quantity)
}

/// Radius of the shaft’s circle and lead of the load against spin.
pub(crate) fn steady(id: &str) -> Outcome {
    in_both(|room: Room| {
        let mut drawing = Drawing::new(id, room.of(580.0, 400.0), 530.0).titled(
            "Steady motion against spin",
            "Two plots against the spin in natural frequencies, from 0 to 4, for three dampings Gamma over omega zero: 0.1, 0.3 and 1, \
             the stronger the heavier the line. Above, the radius of the shaft’s circle over b: it begins at zero, has a peak near the natural \
             frequency, of height 10 for the weakest damper, 3.4 for the middle one, and hardly more than one for the strongest, and tends to \
             one for all. Below, the angle by which the load leads: it rises from 0 to 180 degrees, steeply for weak damping, and all three \
             curves pass 90 degrees at the natural frequency.",
        );
        let spin = spin_axis(room);
        let width = room.of(508.0, 316.0);
        let upper = Rect::new(58.0, 34.0, width, 262.0);
        let lower = Rect::new(58.0, 350.0, width, 132.0);

        let radius = Axis::linear(0.0, 10.5, 2.0).minor(0.5).titled(r"radius of the shaft’s circle $r_0/b$");
        let mut plot = Plot::new(&mut drawing, upper, spin.titled("").unlabelled(), radius)?;
        plot.upright(1.0, Stroke::Dotted);
        plot.level(1.0, Stroke::Reference);
        for (damping, stroke) in DAMPINGS {
            let values = over_all(damping, |machine| Ok(machine.steady()?.radius() / machine.offset()))?;
            plot.curve(&format!("radius-{damping}"), values, stroke, Hue::Ink);
        }
        plot.label((1.06, 9.0), Side::Right, r"$\Gamma/\omega_0 = 0.1$", Hue::Ink)?;
        let own = room.of("$0.3$, the chapter’s machine", "$0.3$");
        plot.label((1.34, 3.4), Side::Right, own, Hue::Ink)?;
        plot.label((1.5, 0.9), Side::Below, "$1$", Hue::Ink)?;
        plot.label((3.96, 1.0), Side::AboveLeft, "$r_0 = b$", Hue::Muted)?;

        let lead =
            Axis::linear(0.0, 180.0, 90.0).minor(30.0).marked(&[(0.0, "0°"), (90.0, "90°"), (180.0, "180°")]);
        let lead = lead.titled(r"lead of the load $\phi_0$");
        let mut plot = Plot::new(&mut drawing, lower, spin, lead)?;
        plot.upright(1.0, Stroke::Dotted);
        plot.level(90.0, Stroke::Dotted);
        for (damping, stroke) in DAMPINGS {
            let values = over_all(damping, |machine| Ok(machine.steady()?.phase().to_degrees()))?;
            plot.curve(&format!("lead-{damping}"), values, stroke, Hue::Ink);
        }
        plot.label((0.5, 48.0), Side::Above, "$1$", Hue::Ink)?;
        Ok(drawing)
    })
}

/// Radius of the centre of mass: the common point, and the rate of self-centring.
pub(crate) fn centring(id: &str) -> Outcome {
    // What the spring's force alone would do: b ω₀²/D, the source's (20), is the shaft's radius times ω₀²/Ω².
    let spring_alone = |machine: &Machine| -> Result<f64, InvalidQuantity> {
        let ratio = machine.natural_frequency() / machine.spin();
        Ok(machine.steady()?.radius() * ratio * ratio / machine.offset())
    };
    let true_radius = |machine: &Machine| -> Result<f64, InvalidQuantity> {
        Ok(machine.steady()?.centre_of_mass_radius() / machine.offset())
    };
    in_both(|room: Room| {
        let mut drawing = Drawing::new(id, room.of(580.0, 400.0), room.of(340.0, 560.0)).titled(
            "Radius of the centre of mass against spin",
            "The radius of the centre of mass over b for spins up to four natural frequencies and three dampings, the stronger the heavier the \
             line. All curves begin at one and cross in a single point, at the square root of two times the natural frequency, where the \
             radius is b; beyond it a larger damping gives a larger radius. A dashed curve, what the force of the spring alone would give for \
             the strongest damper, lies below the true curve and misses the point. A second plot, both scales logarithmic, goes up to a \
             thousand natural frequencies: with the damper of the chapter’s machine the radius falls as one over the spin, without a \
             damper as one over its square.",
        );
        let radius =
            Axis::linear(0.0, 3.6, 1.0).minor(0.5).titled(r"radius of the centre of mass $r_\text{cm}/b$");
        let frame = Rect::new(58.0, 34.0, room.of(508.0, 316.0), 250.0);
        let mut plot = Plot::new(&mut drawing, frame, spin_axis(room), radius)?;
        plot.upright(1.0, Stroke::Dotted);
        plot.upright(SQRT_2, Stroke::Dotted);
        let (strongest, _) = DAMPINGS[2];
        let values = over_spin(strongest, 0.01, FASTEST, spring_alone)?;
        plot.curve("spring", values, Stroke::DashedCurve, Hue::Muted);
        for (damping, stroke) in DAMPINGS {
            plot.curve(&format!("radius-{damping}"), over_all(damping, true_radius)?, stroke, Hue::Ink);
        }
        let common = plot.at((SQRT_2, 1.0));
        plot.drawing().circle(common, 4.5, Role::Area(Fill::Solid, Hue::Ink));
        plot.label((SQRT_2, 1.0), Side::AboveRight, "one point for every damping", Hue::Ink)?;
        plot.label((0.84, 3.3), Side::Left, room.of(r"$\Gamma/\omega_0 = 0.1$", "$0.1$"), Hue::Ink)?;
        let (beside, side) = room.of(((0.87, 2.05), Side::Over), ((0.74, 2.3), Side::Left));
        plot.label(beside, side, "$0.3$", Hue::Ink)?;
        plot.label((0.4, 1.28), Side::Above, "$1$", Hue::Ink)?;
        plot.label((0.5, 0.5), Side::Over, room.of("spring alone", "spring"), Hue::Muted)?;

        let spin = Axis::log(1.0, 1000.0, 1).titled(r"spin $\Omega/\omega_0$");
        let radius = Axis::log(1e-6, 1.0, 2).titled(r"$r_\text{cm}/b$ at high spin");
        let inset = room.of(Rect::new(330.0, 44.0, 226.0, 96.0), Rect::new(58.0, 364.0, 316.0, 150.0));
        let mut plot = Plot::new(&mut drawing, inset, spin, radius)?;
        let high = |damping: f64| {
            log_steps(SQRT_2, 1000.0, 900)
                .map(|ratio| Ok((ratio, true_radius(&washing_machine(damping, ratio)?)?)))
                .collect::<Result<Vec<_>, Cause>>()
        };
        plot.curve("high-none", high(0.0)?, Stroke::Outline, Hue::Muted);
        let (own, stroke) = DAMPINGS[1];
        plot.curve("high-0.3", high(own)?, stroke, Hue::Ink);
        plot.label((80.0, 0.3 / 60.0), Side::AboveRight, r"falls as $1/\Omega$", Hue::Ink)?;
        plot.label((20.0, 1e-5), Side::Over, "undamped", Hue::Muted)?;
        Ok(drawing)
    })
}

/// What the floor feels against spin.
pub(crate) fn floor_force(id: &str) -> Outcome {
    let force = |machine: &Machine| -> Result<f64, InvalidQuantity> {
        Ok(machine.total_mass() * machine.spin().powi(2) * machine.steady()?.centre_of_mass_radius())
    };
    let mut curves = Vec::new();
    for (damping, _) in DAMPINGS {
        let values = over_spin(damping, 0.0, 12.5, force)?;
        curves.push(values.into_iter().map(|(ratio, force)| (ratio * NATURAL, force)).collect::<Values>());
    }
    let quietest = |values: &Values| {
        let beyond = values.iter().copied().filter(|value| value.0 > 1.2 * NATURAL);
        beyond.min_by(|a, b| a.1.total_cmp(&b.1)).ok_or("no values")
    };
    let MachineParameters { load_mass, load_radius, .. } = washing_machine(0.0, 0.0)?.parameters();
    let rigid = linear_steps(0.0, 125.0, 500).map(|spin| (spin, load_mass * load_radius * spin * spin));
    let rigid: Values = rigid.collect();
    in_both(|room: Room| {
        let mut drawing = Drawing::new(id, room.of(580.0, 400.0), 380.0).titled(
            "The force on the floor against spin",
            "The force with which the machine shakes the floor, in newtons, against the spin from 0 to 125 radians a second, for three dampers, \
             the stronger the heavier the line. A dashed curve, a drum on rigid bearings, leaves the plot at 32 radians a second. For a damping \
             of a tenth of the natural frequency the force has a peak of 510 newtons at the natural frequency, falls to 55 and hardly rises \
             again. For the chapter’s machine, three tenths, it has a peak of 176, is least with 74 newtons at 25 radians a second, marked by a \
             dot, and climbs back to 195. For a damping of one the peak is lowest and the climb steepest. All four curves cross at 14 radians a \
             second.",
        );
        let spin = Axis::linear(0.0, 125.0, 25.0).minor(5.0).titled(r"spin $\Omega$, rad/s");
        let newtons = Axis::linear(0.0, 525.0, 100.0).minor(20.0).titled("force on the floor, N");
        let frame = Rect::new(58.0, 34.0, room.of(508.0, 316.0), 294.0);
        let mut plot = Plot::new(&mut drawing, frame, spin, newtons)?;
        plot.upright(NATURAL, Stroke::Dotted);
        plot.upright(SQRT_2 * NATURAL, Stroke::Dotted);
        plot.curve("rigid", rigid.iter().copied(), Stroke::Reference, Hue::Muted);
        for ((damping, stroke), values) in DAMPINGS.into_iter().zip(&curves) {
            plot.curve(&format!("force-{damping}"), values.iter().copied(), stroke, Hue::Purple);
        }
        let rest = quietest(&curves[1])?;
        plot.reference(rest, (rest.0, 42.0), Stroke::Dotted);
        plot.markers(&[rest], Marker::Disc, Hue::Purple);
        plot.label((31.5, 500.0), Side::Right, room.of("on rigid bearings", "rigid bearings"), Hue::Muted)?;
        let place = (room.of(27.5, 34.5), 20.0);
        plot.label(place, Side::Over, &format!(r"quietest, ${:.0}$ N", rest.1), Hue::Purple)?;
        plot.label((70.0, 368.0), Side::AboveLeft, r"$\Gamma = \omega_0$", Hue::Purple)?;
        plot.label((100.0, 164.0), Side::AboveLeft, r"$0.3\,\omega_0$", Hue::Purple)?;
        plot.label((122.0, 72.0), Side::BelowLeft, r"$0.1\,\omega_0$", Hue::Purple)?;
        Ok(drawing)
    })
}

/// What the motor must give to keep the spin constant.
pub(crate) fn torque(id: &str) -> Outcome {
    in_both(|room: Room| {
        let mut drawing = Drawing::new(id, room.of(580.0, 400.0), 340.0).titled(
            "Torque of the motor against spin",
            "The torque, in newton metres, that keeps the spin of the chapter’s machine constant, for spins up to four natural \
             frequencies and three dampings, the stronger the heavier the line. For the damping 0.1 it has a narrow peak of 8.4 near the \
             natural frequency and stays below one half from 1.6 on. For the damping 0.3 the peak has a height of 2.9, \
             and for the largest there is none: the torque keeps growing with the spin.",
        );
        let torque = Axis::linear(0.0, 9.0, 2.0).minor(0.5).titled(r"torque of the motor $\tau$, N·m");
        let frame = Rect::new(58.0, 34.0, room.of(508.0, 316.0), 254.0);
        let mut plot = Plot::new(&mut drawing, frame, spin_axis(room), torque)?;
        plot.upright(1.0, Stroke::Dotted);
        for (damping, stroke) in DAMPINGS {
            let values = over_all(damping, |machine| Ok(machine.steady()?.motor_torque()))?;
            plot.curve(&format!("torque-{damping}"), values, stroke, Hue::Purple);
        }
        plot.label((1.06, 7.6), Side::Right, r"$\Gamma/\omega_0 = 0.1$", Hue::Purple)?;
        let own = room.of("$0.3$, the chapter’s machine", "$0.3$");
        plot.label((1.14, 3.4), Side::Right, own, Hue::Purple)?;
        plot.label((3.3, 3.2), Side::Above, "$1$", Hue::Purple)?;
        Ok(drawing)
    })
}
