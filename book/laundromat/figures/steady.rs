//! Steady motion against the spin: circles, the floor, the motor.

use super::{NATURAL, Values, over_spin, washing_machine};
use drawing::kit::Marker;
use drawing::{Drawing, Fill, Hue, Rect, Role, Side, Stroke};
use figures::{Axis, Cause, Outcome, Plot, Room, in_both, linear_steps, log_steps};
use mechanics::InvalidQuantity;
use mechanics::scenes::laundromat::{Machine, MachineParameters};
use std::f64::consts::SQRT_2;

/// The dampings Γ/ω₀ that the plots compare, each with its hue.
const DAMPINGS: [(f64, Hue); 4] = [(0.2, Hue::Blue), (0.4, Hue::Orange), (0.7, Hue::Green), (1.4, Hue::Pink)];

/// Radius of the shaft’s circle and lead of the load against spin.
pub(crate) fn steady(id: &str) -> Outcome {
    in_both(|room: Room| {
        let mut drawing = Drawing::new(id, room.of(660.0, 400.0), 560.0).titled(
            "Steady motion against spin",
            "Two plots against the spin in natural frequencies, from 0 to 3, for four dampings Gamma over omega zero: 0.2, 0.4, 0.7 and \
             1.4. Above, the radius of the shaft’s circle over b: it begins at zero, has a peak near the natural \
             frequency, of height \
             5 for the smallest damping, with no peak within the plot for the largest, and tends to one for all. Below, the angle by which the \
             load leads: \
             it rises from 0 to 180 degrees, steeply for small damping, and all four curves pass 90 degrees at the natural \
             frequency.",
        );
        let spin = Axis::linear(0.0, 3.0, room.of(0.5, 1.0)).minor(0.1);
        let width = room.of(580.0, 316.0);
        let upper = Rect::new(58.0, 34.0, width, 262.0);
        let lower = Rect::new(58.0, 356.0, width, 152.0);

        let radius = Axis::linear(0.0, 5.5, 1.0).minor(0.5).titled(r"radius of the shaft’s circle $r_0/b$");
        let mut plot = Plot::new(&mut drawing, upper, spin.unlabelled(), radius)?;
        if room == Room::Wide {
            plot.upright(1.0, Stroke::Dotted); // on a phone two labels stand there
        }
        plot.level(1.0, Stroke::Reference);
        for (damping, hue) in DAMPINGS {
            let values =
                over_spin(damping, 0.0, 3.0, |machine| Ok(machine.steady()?.radius() / machine.offset()))?;
            plot.curve(&format!("radius-{damping}"), values, Stroke::Curve, hue);
        }
        plot.label((1.06, 4.9), Side::Right, r"$\Gamma/\omega_0 = 0.2$", Hue::Blue)?;
        plot.label((room.of(1.125, 1.035), 2.76), Side::Over, "$0.4$", Hue::Orange)?;
        plot.label((room.of(1.2, 1.04), 1.53), Side::Above, "$0.7$", Hue::Green)?;
        plot.label((1.75, 0.9), Side::Below, "$1.4$", Hue::Pink)?;
        plot.label((0.03, 1.0), Side::AboveRight, "$r_0 = b$", Hue::Muted)?;

        let lead =
            Axis::linear(0.0, 180.0, 90.0).minor(30.0).marked(&[(0.0, "0°"), (90.0, "90°"), (180.0, "180°")]);
        let lead = lead.titled(r"lead of the load $\phi_0$");
        let mut plot = Plot::new(&mut drawing, lower, spin.titled(r"spin $\Omega/\omega_0$"), lead)?;
        plot.upright(1.0, Stroke::Dotted);
        plot.level(90.0, Stroke::Dotted);
        for (damping, hue) in DAMPINGS {
            let values = over_spin(damping, 0.0, 3.0, |machine| Ok(machine.steady()?.phase().to_degrees()))?;
            plot.curve(&format!("lead-{damping}"), values, Stroke::Curve, hue);
        }
        plot.label((room.of(1.2, 1.26), 162.0), Side::AboveLeft, "$0.2$", Hue::Blue)?;
        plot.label((2.0, 137.0), Side::BelowRight, "$1.4$", Hue::Pink)?;
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
        let mut drawing = Drawing::new(id, room.of(660.0, 400.0), 604.0).titled(
            "Radius of the centre of mass against spin",
            "Two plots. Above, the radius of the centre of mass over b for spins up to three natural frequencies and four dampings. \
             All curves begin at one and cross in a single point, at the square root of two times the natural frequency, where the \
             radius is b; beyond it a larger damping gives a larger radius. Dashed in grey, what the force of the spring alone would give for \
             the dampings 0.4 and 1.4, which lies below the true curve and misses the point. Below, both scales logarithmic, up to a \
             thousand natural frequencies: the true radius falls as one over the spin, that of the spring alone as one over its square.",
        );
        let width = room.of(580.0, 316.0);
        let spin = Axis::linear(0.0, 3.0, room.of(0.5, 1.0)).minor(0.1).titled(r"spin $\Omega/\omega_0$");
        let radius =
            Axis::linear(0.0, 3.4, 1.0).minor(0.5).titled(r"radius of the centre of mass $r_\text{cm}/b$");
        let mut plot = Plot::new(&mut drawing, Rect::new(58.0, 34.0, width, 230.0), spin, radius)?;
        plot.upright(SQRT_2, Stroke::Dotted);
        for (damping, _) in [DAMPINGS[1], DAMPINGS[3]] {
            let values = over_spin(damping, 0.01, 3.0, spring_alone)?;
            plot.curve(&format!("spring-{damping}"), values, Stroke::DashedCurve, Hue::Muted);
        }
        for (damping, hue) in DAMPINGS {
            let values = over_spin(damping, 0.0, 3.0, true_radius)?;
            plot.curve(&format!("radius-{damping}"), values, Stroke::Curve, hue);
        }
        let common = plot.at((SQRT_2, 1.0));
        plot.drawing().circle(common, 4.5, Role::Area(Fill::Solid, Hue::Ink));
        plot.label((SQRT_2, 1.05), Side::AboveRight, r"one point for every damping", Hue::Ink)?;
        plot.label(
            (room.of(0.78, 0.76), 2.6),
            Side::Left,
            room.of(r"$\Gamma/\omega_0 = 0.2$", "$0.2$"),
            Hue::Blue,
        )?;
        plot.label((room.of(0.96, 0.97), 2.74), Side::Above, "$0.4$", Hue::Orange)?;
        plot.label((0.91, 1.8), Side::Above, "$0.7$", Hue::Green)?;
        plot.label((2.6, 0.56), Side::Above, "$1.4$", Hue::Pink)?;
        plot.label((0.62, 0.4), Side::Over, "spring alone", Hue::Muted)?;

        let spin = Axis::log(1.0, 1000.0, 1).titled(r"spin $\Omega/\omega_0$");
        let radius = Axis::log(1e-6, 10.0, 2).titled(r"$r_\text{cm}/b$ at high spin");
        let mut plot = Plot::new(&mut drawing, Rect::new(58.0, 348.0, width, 204.0), spin, radius)?;
        let high = |damping: f64, quantity: &dyn Fn(&Machine) -> Result<f64, InvalidQuantity>| {
            log_steps(1.0, 1000.0, 900)
                .map(|ratio| Ok((ratio, quantity(&washing_machine(damping, ratio)?)?)))
                .collect::<Result<Vec<_>, Cause>>()
        };
        plot.curve("spring-high", high(0.4, &spring_alone)?, Stroke::DashedCurve, Hue::Muted);
        for (damping, hue) in DAMPINGS {
            plot.curve(&format!("high-{damping}"), high(damping, &true_radius)?, Stroke::Curve, hue);
        }
        plot.label((60.0, 1.4 / 60.0), Side::AboveRight, r"falls as $\Gamma/\Omega$", Hue::Ink)?;
        plot.label(
            (60.0, 1.0 / 3600.0),
            Side::BelowLeft,
            r"spring alone: $\omega_0^2/\Omega^2$",
            Hue::Muted,
        )?;
        Ok(drawing)
    })
}

/// What the floor feels against spin.
pub(crate) fn floor_force(id: &str) -> Outcome {
    let force = |machine: &Machine| -> Result<f64, InvalidQuantity> {
        Ok(machine.total_mass() * machine.spin().powi(2) * machine.steady()?.centre_of_mass_radius())
    };
    let rad_per_second =
        |damping: f64, from: f64| over_spin(damping, from, 12.5, force).map(|values| scaled(values, NATURAL));
    let dampings = [(0.1, Hue::Blue), (0.3, Hue::Green), (1.0, Hue::Pink)];
    let mut curves = Vec::new();
    for (damping, _) in dampings {
        curves.push(rad_per_second(damping, 0.0)?);
    }
    let quietest = |values: &Values| {
        let beyond = values.iter().copied().filter(|value| value.0 > 1.2 * NATURAL);
        beyond.min_by(|a, b| a.1.total_cmp(&b.1)).ok_or("no values")
    };
    let MachineParameters { load_mass, load_radius, .. } = washing_machine(0.0, 0.0)?.parameters();
    let rigid = linear_steps(0.0, 125.0, 500).map(|spin| (spin, load_mass * load_radius * spin * spin));
    let rigid: Values = rigid.collect();
    in_both(|room: Room| {
        let mut drawing = Drawing::new(id, room.of(660.0, 400.0), 360.0).titled(
            "The force on the floor against spin",
            "The force with which the machine shakes the floor, in newtons, against the spin from 0 to 125 radians a second. A dashed curve, a \
             drum on rigid bearings, leaves the plot at 28 radians a second. For a damping of a tenth of the natural frequency the force has \
             a peak of 510 newtons at the natural frequency, out of the plot, falls to 55 and hardly rises again. For the chapter’s machine, \
             three tenths, it has a peak of 176, is least with 74 newtons at 25 radians a second, marked by a dot, and climbs back to 197. \
             For a damping of one the peak is lowest and the climb steepest.",
        );
        let spin = Axis::linear(0.0, 125.0, room.of(25.0, 25.0)).minor(5.0).titled(r"spin $\Omega$, rad/s");
        let newtons = Axis::linear(0.0, 400.0, 100.0).minor(20.0).titled("force on the floor, N");
        let frame = Rect::new(58.0, 34.0, room.of(580.0, 316.0), 272.0);
        let mut plot = Plot::new(&mut drawing, frame, spin, newtons)?;
        plot.upright(NATURAL, Stroke::Dotted);
        plot.curve("rigid", rigid.iter().copied(), Stroke::Reference, Hue::Muted);
        for ((damping, hue), values) in dampings.into_iter().zip(&curves) {
            plot.curve(&format!("force-{damping}"), values.iter().copied(), Stroke::Curve, hue);
        }
        let rest = quietest(&curves[1])?;
        plot.markers(&[rest], Marker::Disc, Hue::Green);
        plot.label((28.5, 384.0), Side::Right, room.of("on rigid bearings", "rigid bearings"), Hue::Muted)?;
        let place = (room.of(27.0, 30.0), 24.0);
        plot.label(place, Side::Over, &format!(r"quietest, ${:.0}$ N", rest.1), Hue::Green)?;
        plot.label((57.0, 305.0), Side::AboveLeft, r"$\Gamma = \omega_0$", Hue::Pink)?;
        plot.label((100.0, 161.0), Side::AboveLeft, r"$0.3\,\omega_0$", Hue::Green)?;
        plot.label((122.0, 70.0), Side::BelowLeft, r"$0.1\,\omega_0$", Hue::Blue)?;
        Ok(drawing)
    })
}

/// The values with their x in other units.
fn scaled(values: Values, unit: f64) -> Values {
    values.into_iter().map(|(x, y)| (x * unit, y)).collect()
}

/// What the motor must give to keep the spin constant.
pub(crate) fn torque(id: &str) -> Outcome {
    in_both(|room: Room| {
        let mut drawing = Drawing::new(id, room.of(660.0, 400.0), 330.0).titled(
            "Torque of the motor against spin",
            "The torque, in newton metres, that keeps the spin of the chapter’s machine constant, for spins up to three natural \
             frequencies and four dampings. For the damping 0.2 it has a narrow peak of 4.3 near the natural frequency \
             and falls below 0.6 beyond it. For larger dampings the peak is lower and broader, and for the largest there \
             is none: the torque keeps \
             growing with the spin.",
        );
        let spin = Axis::linear(0.0, 3.0, room.of(0.5, 1.0)).minor(0.1).titled(r"spin $\Omega/\omega_0$");
        let torque = Axis::linear(0.0, 4.5, 1.0).minor(0.5).titled(r"torque of the motor $\tau$, N·m");
        let frame = Rect::new(58.0, 34.0, room.of(580.0, 316.0), 244.0);
        let mut plot = Plot::new(&mut drawing, frame, spin, torque)?;
        for (damping, hue) in DAMPINGS {
            let values = over_spin(damping, 0.0, 3.0, |machine| Ok(machine.steady()?.motor_torque()))?;
            plot.curve(&format!("torque-{damping}"), values, Stroke::Curve, hue);
        }
        plot.label((1.1, 3.9), Side::Right, r"$\Gamma/\omega_0 = 0.2$", Hue::Blue)?;
        plot.label((2.85, 1.2), Side::Below, "$0.4$", Hue::Orange)?;
        plot.label((2.85, 2.0), Side::Above, "$0.7$", Hue::Green)?;
        plot.label((2.4, 2.9), Side::AboveLeft, "$1.4$", Hue::Pink)?;
        Ok(drawing)
    })
}
