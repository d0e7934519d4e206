//! A motor of limited torque: where its line meets the torque of shaking, and what a slowly turned knob does.

use super::{NATURAL, Values, washing_machine};
use drawing::kit::{self, Marker};
use drawing::{Drawing, Hue, Rect, Side, Stroke};
use figures::{Axis, Cause, Outcome, Plot, Room, in_both, linear_steps};
use mechanics::integrate::Dop853;
use mechanics::scenes::laundromat::{DrivenMachine, DrivenState, Folds, Motor};

/// The motor's idle spin, rad/s.
const IDLE: f64 = 40.0;

/// The chapter's machine with half its damper, turned by a motor of this stall torque, N·m.
fn driven(stall_torque: f64) -> Result<DrivenMachine, Cause> {
    let motor = Motor { stall_torque, idle_spin: IDLE, drum_inertia: 0.5 };
    Ok(washing_machine(0.15, 0.0)?.driven(motor)?)
}

fn folds(drive: &DrivenMachine) -> Result<Folds, Cause> {
    drive.folds().ok_or_else(|| "no folds".into())
}

/// Torque against spin: the hill of shaking and three lines of the motor.
pub(crate) fn motor_line(id: &str) -> Outcome {
    let drive = driven(4.0)?;
    let folds = folds(&drive)?;
    let shaking = linear_steps(0.2, IDLE, 2000)
        .map(|spin| Ok((spin, washing_machine(0.15, spin / 10.0)?.steady()?.motor_torque())))
        .collect::<Result<Values, Cause>>()?;
    let meetings: Values =
        drive.steady_spins().into_iter().map(|spin| (spin, drive.motor_torque(spin))).collect();
    in_both(|room: Room| {
        let mut drawing = Drawing::new(id, room.of(580.0, 400.0), 390.0).titled(
            "Where the motor meets the shaking",
            "Torque in newton metres against spin in radians a second. The torque that shaking takes is a steep hill of height 5.6 at a spin of \
             10, then a long valley below one. A straight line falls from 4 at standstill to nothing at 40, the torque of the motor, and \
             cuts the hill on both of its sides, at 9.5 and 11, and the valley at 35: full discs mark the outer two, a ring the middle one. \
             Arrows along the axis of the spin point towards the outer two and away from the middle one. \
             Two more lines, thin, end at 40 too. The upper starts at 7.5 and touches the hill at its top, the lower \
             starts at 0.84 and touches the floor of the valley at 18.",
        );
        let spin = Axis::linear(0.0, IDLE, 10.0).minor(2.0).titled(r"spin $\dot\phi$, rad/s");
        let torque = Axis::linear(-0.8, 8.0, 2.0).minor(0.5).titled("torque, N·m");
        let frame = Rect::new(58.0, 34.0, room.of(508.0, 316.0), 302.0);
        let mut plot = Plot::new(&mut drawing, frame, spin, torque)?;
        plot.level(0.0, Stroke::Outline);
        for (name, fold) in [("line-up", folds.up), ("line-down", folds.down)] {
            let touching = driven(fold.stall_torque)?;
            let line = [0.0, IDLE].map(|spin| (spin, touching.motor_torque(spin)));
            plot.curve(name, line, Stroke::Outline, Hue::Purple);
        }
        plot.curve("shaking", shaking.iter().copied(), Stroke::Heavy, Hue::Purple);
        let line = [0.0, IDLE].map(|spin| (spin, drive.motor_torque(spin)));
        plot.curve("line", line, Stroke::Curve, Hue::Purple);
        for (place, &meeting) in meetings.iter().enumerate() {
            let lasts = place != 1;
            plot.reference(meeting, (meeting.0, -0.8), Stroke::Dotted);
            plot.markers(&[meeting], if lasts { Marker::Disc } else { Marker::Ring }, Hue::Ink);
        }
        // Along the axis, which way the spin goes: up where the motor gives more than the shaking takes.
        let mut ends: Vec<f64> =
            [0.0, IDLE].into_iter().chain(meetings.iter().map(|meeting| meeting.0)).collect();
        ends.sort_by(f64::total_cmp);
        for pair in ends.windows(2) {
            let [low, high] = [pair[0], pair[1]];
            let middle = 0.5 * (low + high);
            let taken = washing_machine(0.15, middle / NATURAL)?.steady()?.motor_torque();
            let [from, to] = if drive.motor_torque(middle) > taken { [low, high] } else { [high, low] };
            let [from, to] = [from, to].map(|spin| plot.at((spin, -0.4)));
            let inset = (to - from).unit() * 3.0;
            kit::arrow(plot.drawing(), from + inset, to - inset, Hue::Orange);
        }
        for (torque, text, aside) in [
            (folds.up.stall_torque, "$7.5$", 0.1),
            (drive.motor().stall_torque, "$4$", 0.1),
            (folds.down.stall_torque, "$0.84$", 0.0),
        ] {
            plot.label((0.2, torque + aside), Side::AboveRight, text, Hue::Purple)?;
        }
        plot.label((9.0, 2.3), Side::Left, "stuck", Hue::Ink)?;
        plot.label((34.8, 0.8), Side::AboveRight, "fast", Hue::Ink)?;
        plot.label(
            (room.of(20.0, 18.0), room.of(2.0, 2.3)),
            Side::AboveRight,
            room.of("the motor", "motor"),
            Hue::Purple,
        )?;
        plot.label((13.0, 1.4), Side::Right, "the shaking", Hue::Purple)?;
        Ok(drawing)
    })
}

/// The spin against a stall torque that is slowly raised and lowered.
pub(crate) fn motor_hysteresis(id: &str) -> Outcome {
    let drive = driven(1.0)?;
    let folds = folds(&drive)?;
    let branch = |from: f64, to: f64| -> Result<Values, Cause> {
        let spins = linear_steps(from, to, 600);
        spins.map(|spin| Ok((drive.required_stall_torque(spin)?, spin))).collect()
    };
    let stuck = branch(4.0, folds.up.spin)?;
    let middle = branch(folds.up.spin, folds.down.spin)?;
    let fast = branch(folds.down.spin, 37.6)?;

    // A knob that is turned by a notch a minute.
    let solver = Dop853::new(1e-8)?;
    let mut state = DrivenState::AT_REST.to_array();
    let mut turned = |torques: &[f64]| -> Result<Values, Cause> {
        let mut values = Values::new();
        for &torque in torques {
            let drive = drive.with_stall_torque(torque)?;
            state = solver.solve(|time, state: &[f64; 5]| drive.rates(time, state), 0.0, state, 60.0)?.state;
            values.push((torque, state[4]));
        }
        Ok(values)
    };
    let raised: Vec<f64> = (1..=22).map(|notch| 0.4 * f64::from(notch)).collect();
    let lowered: Vec<f64> = (1..=22).rev().map(|notch| 0.4 * f64::from(notch) - 0.2).collect();
    let up = turned(&raised)?;
    let down = turned(&lowered)?;
    in_both(|room: Room| {
        let mut drawing = Drawing::new(id, room.of(580.0, 400.0), 400.0).titled(
            "The spin while the motor’s knob is slowly turned",
            "Spin in radians a second against the stall torque in newton metres, from 0 to 9. The curve of steady speeds has the shape of an S: it rises to 10 \
             at once and hardly further as the torque grows to 7.5, turns back, pale, to a torque of 0.84 at a spin of 18, and from there runs \
             to the right again, up to 37. Rings, from a simulation of a torque that is raised in steps, lie on the \
             lower branch to its end and then on the upper. Crosses, while it is lowered, lie on the upper branch back to 1, and then on the lower.",
        );
        let torque =
            Axis::linear(0.0, 9.0, 1.0).titled(r"stall torque of the motor $\tau_\text{stall}$, N·m");
        let spin = Axis::linear(0.0, 40.0, 10.0).minor(2.0).titled(r"spin $\dot\phi$, rad/s");
        let frame = Rect::new(58.0, 34.0, room.of(508.0, 316.0), 312.0);
        let mut plot = Plot::new(&mut drawing, frame, torque, spin)?;
        plot.curve("stuck", stuck.iter().copied(), Stroke::Outline, Hue::Muted);
        plot.curve("middle", middle.iter().copied(), Stroke::Curve, Hue::Faint);
        plot.curve("fast", fast.iter().copied(), Stroke::Outline, Hue::Muted);
        plot.curve("up", up.iter().copied(), Stroke::Dotted, Hue::Ink);
        plot.curve("down", down.iter().copied(), Stroke::Dotted, Hue::Ink);
        plot.markers(&up, Marker::Ring, Hue::Ink);
        plot.markers(&down, Marker::Cross, Hue::Ink);
        plot.label((4.4, 9.0), Side::Below, "raised", Hue::Ink)?;
        plot.label((2.3, 35.0), Side::Above, "lowered", Hue::Ink)?;
        plot.label((3.0, 13.6), Side::AboveRight, "no drum stays here", Hue::Muted)?;
        Ok(drawing)
    })
}
