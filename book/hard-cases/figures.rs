//! The figures of the chapter "Hard cases".

use drawing::kit::{self, Marker};
use drawing::{Drawing, Fill, Hue, Label, Rect, Role, Shape, Side, Stroke, at};
use figures::{Axis, Cause, Figure, Look, Outcome, Plot, Room, figures, in_both, log_steps};
use mechanics::InvalidQuantity;
use mechanics::attitude::rotation_between;
use mechanics::elliptic::quarter_period;
use mechanics::euler::{self, Turning};
use mechanics::free_rotation::FreeTop;
use mechanics::inertia::PrincipalMoments;
use mechanics::integrate::{Dop853, Taylor, rk4, rk4_step};
use mechanics::rolling::{DiskParameters, MomentFactors, Rolling};
use mechanics::scenes::laundromat::{Machine, MachineParameters, Polar, Shaft};
use mechanics::scenes::rolling_wheel::Wheel;
use mechanics::scenes::spinning_coin::{Loss, SpinDown, SpinningCoin};
use mechanics::scenes::top::{Top, TopParameters};
use nalgebra::{Complex, Quaternion, UnitQuaternion, Vector3};
use std::f64::consts::{FRAC_PI_2, SQRT_2, TAU};

/// All figures of this chapter.
pub(crate) const FIGURES: &[Figure] = figures![
    hard_losses,
    hard_cancellation,
    hard_critical,
    hard_phase,
    hard_drift,
    hard_separatrix,
    hard_rounding,
    hard_stiff,
    hard_end
];

/// The unit roundoff u, and the least error that a plot shows.
const ROUNDOFF: f64 = f64::EPSILON / 2.0;
const LEAST: f64 = 1e-17;

/// The frame of a plot that stands in the margin, and of a panel.
const FRAME: Rect = Rect::new(50.0, 34.0, 264.0, 210.0);
const PANEL: Rect = Rect::new(52.0, 34.0, 206.0, 190.0);
/// The size of the drawing of the first, px.
const WIDTH: f64 = 334.0;
const HEIGHT: f64 = 296.0;

/// A band from the foot of a plot up to the most that the library is off: it is flat, and of its rounding there is
/// nothing more to see. That no value lies above it is part of the drawing.
fn band(plot: &mut Plot<'_>, values: &[(f64, f64)], most: f64, words: &str) -> Result<(), Cause> {
    if let Some((x, y)) = values.iter().find(|value| value.1 > most) {
        return Err(format!("{words}: {y:e} at {x:e} lies above the band, which ends at {most:e}").into());
    }
    let frame = plot.frame();
    let top = plot.at((values[0].0, most)).y;
    let corners =
        [(frame.left, frame.bottom), (frame.right, frame.bottom), (frame.right, top), (frame.left, top)];
    plot.drawing().polygon(corners.map(|(x, y)| at(x, y)).to_vec(), Fill::Ground, Hue::Muted);
    plot.drawing().line(at(frame.left, top), at(frame.right, top), Stroke::Outline, Hue::Ink);
    let middle = at(frame.left + 2.0, 0.5 * (top + frame.bottom));
    plot.drawing().label_on_face(middle, Side::Right, words, Hue::Ink)?;
    Ok(())
}

/// ω₀ = 1 rad/s and b = 1 m.
fn machine(damping: f64, spin: f64) -> Result<Machine, InvalidQuantity> {
    let [drum_mass, load_mass, load_radius, stiffness] = [0.0, 1.0, 1.0, 1.0];
    Machine::new(MachineParameters { drum_mass, load_mass, load_radius, stiffness, damping, spin })
}

/// A hoop about its pin, and a start about the tangent and the diameter.
fn hoop(tangent: f64, diameter: f64) -> Result<(PrincipalMoments, Turning), InvalidQuantity> {
    let omega_body = Vector3::new(tangent, -diameter, 0.0);
    let start = Turning { world_from_body: UnitQuaternion::identity(), omega_body };
    Ok((PrincipalMoments::new(1.5, 0.5, 2.0)?, start))
}

fn relative(found: f64, exact: f64) -> f64 {
    (found / exact - 1.0).abs().max(LEAST)
}

/// A steel disc of 0.4 kg and 37.5 mm.
const TOY: DiskParameters =
    DiskParameters { mass: 0.4, radius: 0.0375, moments: MomentFactors::DISK, gravity: 9.81 };

/// The relative errors of a program that is obvious, and of the library.
struct Pair {
    obvious: f64,
    library: f64,
}

impl Pair {
    fn new(obvious: f64, library: f64, exact: f64) -> Self {
        Self { obvious: relative(obvious, exact), library: relative(library, exact) }
    }
}

/// The rate of the head of a coin at a small tilt, by one less the sine.
fn flat_coin(tilt: f64) -> Result<Pair, Cause> {
    let flat = SpinningCoin::new(TOY, tilt)?;
    let obvious = flat.turn_rate() * (1.0 - (FRAC_PI_2 - tilt).sin());
    let exact = flat.turn_rate() * (0.5 * tilt).tan() * tilt.sin(); // 1 − cos α, without a difference
    Ok(Pair::new(obvious, flat.figure_rate(), exact))
}

/// The radius of the centre of mass of a drum that spins 1/`small` times as fast as it swings, by the law of cosines.
fn high_spin(small: f64) -> Result<Pair, Cause> {
    let steady = machine(0.3, 1.0 / small)?.steady()?;
    let (r, cosine) = (steady.radius(), steady.phase().cos());
    let obvious = (r * r + 1.0 + 2.0 * r * cosine).max(0.0).sqrt();
    // eq:centre-of-mass-radius over Ω²
    let exact =
        small * (small * small + 0.09).sqrt() / ((1.0 - small * small).powi(2) + 0.09 * small * small).sqrt();
    Ok(Pair::new(obvious, steady.centre_of_mass_radius(), exact))
}

/// The slow root at the damping 1/`small`, by the textbook.
fn slow_root(small: f64) -> Pair {
    let half = 0.5 / small;
    let gap = (half * half - 1.0).max(0.0).sqrt();
    // λ = ε(1 + ε² + 2ε⁴ + 5ε⁶ + 14ε⁸ …) where that converges at once, else 1/λ_fast.
    let square = small * small;
    let exact = if small < 0.01 {
        small * (1.0 + square * (1.0 + square * (2.0 + square * 5.0)))
    } else {
        2.0 * small / (1.0 + ((1.0 - 2.0 * small) * (1.0 + 2.0 * small)).max(0.0).sqrt())
    };
    Pair::new(half - gap, 1.0 / (half + gap), exact)
}

/// The period of a hoop at a small complementary modulus, by the parameter of its elliptic functions; none on the
/// separatrix.
fn near_separatrix(small: f64) -> Result<Option<Pair>, Cause> {
    let (sin, cos) = (small, ((1.0 - small) * (1.0 + small)).sqrt());
    let (moments, start) = hoop(cos, sin)?;
    let w = cos.hypot(sin);
    let by = |square: f64| 4.0 * SQRT_2 / w * quarter_period(square);
    let obvious = by((1.0 - (cos / w).powi(2)).clamp(0.0, 1.0));
    let found = FreeTop::new(moments, start)?.period();
    Ok(found.map(|found| Pair::new(obvious, found, by((sin / w).powi(2)))))
}

/// The position 1.7 s after a push, by the difference of exponentials, and how far beyond critical the rounded damping is.
fn near_critical(beyond: f64) -> Result<(f64, Pair), Cause> {
    let t = 1.7;
    let damping = 2.0 * (1.0 + beyond);
    let half = 0.5 * damping;
    let beyond = half - 1.0; // of the rounded damping, exactly
    let gap = (beyond * (2.0 + beyond)).sqrt();
    let exact = (-half * t).exp() * (gap * t).sinh() / gap;
    let root = (half * half - 1.0).sqrt();
    let (slow, fast) = (half - root, half + root);
    let obvious = ((-slow * t).exp() - (-fast * t).exp()) / (fast - slow);
    let pushed = machine(damping, 0.0)?.transient(Shaft { velocity: 1.0.into(), ..Shaft::AT_REST })?;
    Ok((beyond, Pair::new(obvious, pushed.at(t)?.position.re, exact)))
}

/// A case of the chapter at an input of its own: what the obvious program loses there, if a number comes back, and the
/// library.
struct Case {
    name: &'static str,
    obvious: Option<f64>,
    library: f64,
    /// Evaluations of the obvious program, where they are what it loses.
    evaluations: Option<f64>,
}

impl Case {
    fn new(name: &'static str, obvious: Option<f64>, library: f64) -> Self {
        Self { name, obvious, library, evaluations: None }
    }

    fn of(name: &'static str, pair: &Pair) -> Self {
        Self::new(name, Some(pair.obvious), pair.library)
    }
}

/// The attitude of the heavy top of Brüls and Cardona after a second, by RK4 on Euler's angles with ten thousand steps.
fn top_past_its_pole() -> Result<Case, Cause> {
    let (mass, arm, transverse, axial, gravity) = (15.0, 1.0, 15.234375, 0.46875, 9.81);
    let top = Top::new(TopParameters { mass, arm, transverse, axial, gravity })?;
    let (spin, precession) = (150.0, -4.61538);
    let (a, half_beta) = (axial * spin / transverse, top.weight_torque() / transverse);
    let by_angles = |_: f64, &[tilt, fall, _, swing, _]: &[f64; 5]| {
        let (sin, cos) = tilt.sin_cos();
        let falls = sin * (swing * swing * cos - a * swing + half_beta);
        [fall, falls, swing, fall * (a - 2.0 * swing * cos) / sin, spin - swing * cos]
    };
    // By Taylor series with sixty digits.
    let known = UnitQuaternion::new_unchecked(Quaternion::new(
        0.321_491_939_717_449_8,
        0.715_047_378_219_454_4,
        -0.602_455_510_779_240_2,
        0.149_658_067_373_332_6,
    ));
    let off = |found: &UnitQuaternion<f64>| rotation_between(found, &known).max(LEAST);
    let about = |axis, angle| UnitQuaternion::from_axis_angle(&axis, angle);
    let [upright, level] = [Vector3::z_axis(), Vector3::x_axis()];
    let end = rk4(by_angles, 0.0, [FRAC_PI_2, 0.0, 0.0, precession, 0.0], 1.0, 10_000).ok();
    let obvious = end.map(|[tilt, _, azimuth, _, own_turn]| {
        off(&(about(upright, azimuth) * about(level, tilt) * about(upright, own_turn)))
    });
    let omega_body = Vector3::new(0.0, precession, spin);
    let motion = top.motion(&Turning { world_from_body: about(level, FRAC_PI_2), omega_body })?;
    Ok(Case::new(r"top, $10^{-6}$ from its pole", obvious, off(&motion.at(1.0)?.world_from_body)))
}

/// All cases under their causes.
fn cases() -> Result<Vec<(&'static str, Vec<Case>)>, Cause> {
    let separatrix = near_separatrix(1e-6)?.ok_or("the hoop tumbles")?;
    let differences = vec![
        Case::of(r"flat coin, $\alpha = 10^{-6}$", &flat_coin(1e-6)?),
        Case::of(r"high spin, $\Omega = 10^6\,\omega_0$", &high_spin(1e-6)?),
        Case::of(r"slow root, $\Gamma = 10^6\,\omega_0$", &slow_root(1e-6)),
        Case::of(r"separatrix, $k' = 10^{-6}$", &separatrix),
        Case::of(r"critical, $\delta = 10^{-12}$", &near_critical(1e-12)?.1),
    ];
    let drum = Load::new()?;
    let (years, day) = (950_000_000, 86_400);
    let late = Case::new("phase in thirty years", Some(drum.product(years)), drum.parts(years));
    let added = Case::new("phase added up, a day", Some(drum.added(day)), drum.parts(day));

    let drift = Drift::new()?.after(1e4)?;
    let hoop = Case::new("attitude, $10^4$ periods", Some(drift.attitude), drift.closed);
    let turn = |[x, v]: [f64; 2]| (x - TAU.cos()).hypot(v + TAU.sin()).max(LEAST);
    let best = Dop853::new(1e-15)?.solve(oscillator, 0.0, [1.0, 0.0], TAU)?.state;
    let small_steps = Case::new(
        "five million steps",
        Some(turn(rk4(oscillator, 0.0, [1.0, 0.0], TAU, 5_000_000)?)),
        turn(best),
    );

    // The shaft passes O in the middle of a step that is ten times as long as the distance.
    let (machine, step) = (machine(0.3, 3.0)?, 1e-3);
    let pass = Shaft { position: Complex::new(0.0, 1e-4), velocity: 1.0.into() };
    let motion = machine.transient(pass)?;
    let (before, after) = (-50.3 * step, 49.7 * step);
    let [start, end] = [motion.at(before)?, motion.at(after)?];
    let off = |found: Shaft| ((found.position - end.position).norm() / end.position.norm()).max(LEAST);
    let by_polar =
        rk4(|t, y: &[f64; 4]| machine.polar_rates(t, y), before, start.to_polar().to_array(), after, 100);
    let by_x_and_y = Dop853::new(1e-15)?.solve(
        |t, y: &[f64; 4]| machine.cartesian_rates(t, y),
        before,
        start.to_array(),
        after,
    )?;
    let polar = Case::new(
        r"polar, $10^{-4}$ from $O$",
        by_polar.ok().map(|end| off(Shaft::from_polar(Polar::from_array(end)))),
        off(Shaft::from_array(by_x_and_y.state)),
    );

    let wheel = Wheel::new(DiskParameters { mass: 1.0, radius: 1.0, gravity: 1.0, ..TOY })?;
    let (q, time) = (1e-8, 1.0018);
    let start = Rolling { tilt: 0.1, omega_2: q, ..Rolling::UPRIGHT };
    let by_lean = |t: f64, &[lean, ref rest @ ..]: &[f64; 8]| {
        let mut state = [FRAC_PI_2 - lean; 8];
        state[1..].copy_from_slice(rest);
        let mut rates = wheel.rates(t, &state);
        rates[0] = -rates[0];
        rates
    };
    let mut lean = start.to_array();
    lean[0] = start.lean();
    let turned = wheel.wobble(start, &Taylor::new(1e-16)?)?.heading_advance();
    let heading = |state: [f64; 8]| relative(state[4], turned);
    let solver = Dop853::with_tolerances(1e-13, 1e-13 * q)?.with_max_evaluations(400_000);
    let flat = Case::new(
        "wheel almost flat",
        solver.solve(by_lean, 0.0, lean, time).ok().map(|end| heading(end.state)),
        relative(wheel.wobble(start, &Taylor::new(1e-15)?)?.heading_advance(), turned),
    );

    let top = top_past_its_pole()?;

    let end = CoinsEnd::new()?;
    let coin = Case::new("coin, $10^{-9}$ of its life left", end.adaptive(1e-9), end.law(1e-9)?);
    let drum = heavy_damping(1e3, 1e-14)?;
    let stiff = Case {
        evaluations: Some(drum.0),
        ..Case::new(r"heavy damping, $10^3\,\omega_0$", Some(drum.1), ROUNDOFF)
    };
    Ok(vec![
        ("a difference of nearly equal numbers", differences),
        ("a large argument", vec![late]),
        ("accumulation", vec![added, hoop, small_steps]),
        ("division by what vanishes", vec![polar, flat, top]),
        ("the model has ended", vec![coin]),
        ("only time", vec![stiff]),
    ])
}

/// All cases of the chapter, with the digits that the obvious program loses and that the library loses.
pub(crate) fn hard_losses(id: &str) -> Outcome {
    let groups = cases()?;
    let lost = |error: f64| (error / ROUNDOFF).log10().clamp(0.0, 16.0);
    let mut text = String::from(
        "A row for each of fourteen cases, in groups by their cause. A grey bar has the digits that the obvious program loses, of sixteen, and a diamond those of the library.",
    );
    let mut marks = Vec::new();
    let mut heads = Vec::new();
    let mut row = -1.0;
    for (cause, group) in &groups {
        heads.push((row, *cause));
        text += &format!(" {cause}:");
        for case in group {
            row -= 1.0;
            marks.push((row, case.name));
            let obvious = case.obvious.map_or("all".to_owned(), |error| format!("{:.0}", lost(error)));
            text += &format!(" {obvious} and {:.0};", lost(case.library));
        }
        row -= 1.4;
    }
    let height = -row - 1.0;
    in_both(|room: Room| {
        let wide = room.of(580.0, 396.0);
        let mut drawing =
            Drawing::new(id, wide, 80.0 + 19.0 * height).titled("What fourteen obvious programs lose", &text);
        let frame = Rect::new(204.0, 20.0, wide - 220.0, 19.0 * height);
        let digits = Axis::linear(0.0, 16.0, 4.0).minor(1.0).titled("digits lost, of sixteen");
        let rows = Axis::linear(-0.6 - height, -0.6, 1.0).marked(&marks).minor(1e3);
        let mut plot = Plot::new(&mut drawing, frame, digits, rows)?;
        for (row, cause) in &heads {
            let label = Label::new(cause, 13.0)?.placed(plot.at((0.0, *row)), Side::Right, 4.0);
            plot.drawing().push(Role::Text(Hue::Muted), Shape::Label(label));
        }
        for (case, (row, _)) in groups.iter().flat_map(|(_, group)| group).zip(&marks) {
            let end = case.obvious.map_or(16.0, lost);
            let corners = [(0.0, 0.4), (end, 0.4), (end, -0.4), (0.0, -0.4)];
            let corners = corners.map(|(x, up)| plot.at((x, row + up)));
            plot.drawing().polygon(corners.to_vec(), Fill::Side, Hue::Muted);
            plot.drawing().polyline(&corners, Stroke::Outline, Hue::Muted); // seen in dark themes too
            if let Some(evaluations) = case.evaluations {
                let words = format!("{:.0} 000 evaluations", evaluations / 1e3);
                plot.label((end, *row), Side::Right, &words, Hue::Muted)?;
            }
            if case.obvious.is_none() {
                let middle = plot.at((8.0, *row));
                plot.drawing().label_set(
                    middle,
                    Side::Over,
                    0.0,
                    13.0,
                    "no answer",
                    Role::PlainText(Hue::Ink),
                )?;
            }
            let place = plot.at((lost(case.library), *row));
            kit::marker(plot.drawing(), place, Look::EXACT.marker, Look::EXACT.hue);
        }
        Ok(drawing)
    })
}

/// Four differences of nearly equal numbers.
pub(crate) fn hard_cancellation(id: &str) -> Outcome {
    let (mut coin, mut spin, mut root, mut period) = (Vec::new(), Vec::new(), Vec::new(), Vec::new());
    for small in log_steps(1e-10, 1.0, 30) {
        coin.push((small, flat_coin(small)?));
        spin.push((small, high_spin(small)?));
        if small < 0.5 {
            root.push((small, slow_root(small)));
        }
        if let Some(pair) = near_separatrix(small)? {
            period.push((small, pair));
        }
    }
    let mut drawing = Drawing::new(id, WIDTH, HEIGHT + 20.0).titled(
        "Four differences of nearly equal numbers",
        "Both scales are logarithmic: along x a small parameter from 1e-10 to 1, along y the relative error. The rate of the head by one minus the sine, the centre of mass by the law of \
         cosines, the slow root by a difference, and the period by the parameter m all rise with the power minus two from 1e-16 to one or to nothing, along the same dashed line. \
         A band at the foot, under 1e-15, is the library.",
    );
    let small = Axis::log(1e-10, 1.0, 2).titled("the number that is small");
    let error = Axis::log(LEAST, 1e4, 4).titled("relative error");
    let mut plot = Plot::new(&mut drawing, Rect { bottom: FRAME.bottom + 20.0, ..FRAME }, small, error)?;
    plot.reference((1e-10, ROUNDOFF * 1e20), (1.0, ROUNDOFF), Stroke::Reference);
    let cured = [&coin, &spin, &root, &period].into_iter().flatten().map(|(x, pair)| (*x, pair.library));
    band(&mut plot, &cured.collect::<Vec<_>>(), 1e-15, "the library")?;
    let kinds = [
        (coin, r"flat coin, $\alpha$", Marker::Disc, Hue::Ink),
        (spin, r"high spin, $\omega_0/\Omega$", Marker::Ring, Hue::Ink),
        (root, r"slow root, $\omega_0/\Gamma$", Marker::Triangle, Hue::Muted),
        (period, r"separatrix, $k'$", Marker::Plus, Hue::Muted),
    ];
    for ((values, name, marker, hue), row) in kinds.into_iter().zip([0.0, 1.0, 2.0, 3.0]) {
        let values: Vec<_> = values
            .iter()
            .map(|(x, pair)| (*x, pair.obvious))
            .filter(|(_, error)| error.is_finite() && *error > 1e-15)
            .collect();
        plot.markers(&values, marker, hue);
        // The four lie on one line, so that no name can stand beside its own.
        let place = at(plot.frame().right - 132.0, plot.frame().top + 6.0 + 20.0 * row);
        kit::marker(plot.drawing(), place, marker, hue);
        plot.drawing().label_set(place, Side::Right, 10.0, 13.0, name, Role::Text(hue))?;
    }
    plot.label((2e-9, 1.5e3), Side::Right, "slope −2", Hue::Muted)?;
    Ok(drawing)
}

/// The difference of two exponentials near critical damping.
pub(crate) fn hard_critical(id: &str) -> Outcome {
    let mut drawing = Drawing::new(id, WIDTH, HEIGHT).titled(
        "Error of the difference of exponentials near critical damping",
        "Both scales are logarithmic: along x how far the damping is beyond critical, from 1e-15 to 1, along y the relative error of the position after 1.7 s. By the difference of two exponentials its points \
         rise from 1e-16 along a dashed line with the power minus one half to 1e-9. A band at the foot, under 1e-15, is the library.",
    );
    let pairs = log_steps(1e-15, 1.0, 45).map(near_critical).collect::<Result<Vec<_>, Cause>>()?;
    let beyond = Axis::log(1e-15, 1.0, 3).titled(r"$\delta = \Gamma/(2\omega_0) - 1$");
    let error = Axis::log(LEAST, 1e-6, 2).titled("relative error of the position");
    let mut plot = Plot::new(&mut drawing, FRAME, beyond, error)?;
    plot.reference((1e-15, ROUNDOFF / 8e-15_f64.sqrt()), (1.0, ROUNDOFF / 8_f64.sqrt()), Stroke::Reference);
    let cured: Vec<_> = pairs.iter().map(|(beyond, pair)| (*beyond, pair.library)).collect();
    band(&mut plot, &cured, 1e-15, "the library")?;
    let naive = pairs.iter().map(|(beyond, pair)| (*beyond, pair.obvious)).filter(|pair| pair.1 > 1e-15);
    plot.markers(&naive.collect::<Vec<_>>(), Marker::Disc, Hue::Ink);
    plot.label((2e-12, 2e-8), Side::Right, "difference of exponentials", Hue::Ink)?;
    plot.label((3e-6, 4e-14), Side::AboveRight, r"$u/\sqrt{8\delta}$", Hue::Muted)?;
    Ok(drawing)
}

/// The angle m·2⁻⁶⁰ · t modulo 2π for integers m and t, in integers, with 2π to 88 binary places.
fn exact_phase(m: u128, t: u128) -> f64 {
    const TWO_PI: u128 = 1_944_551_666_501_805_353_363_452_692;
    (((m * t) << 28) % TWO_PI) as f64 / 2_f64.powi(88)
}

/// A drum whose spin is a whole number of 2⁻⁶⁰ rad/s, for the direction of its load.
struct Load {
    drum: Machine,
    parts: u128,
}

impl Load {
    fn new() -> Result<Self, Cause> {
        let spin = 11.503_217;
        Ok(Self { drum: machine(0.3, spin)?, parts: (spin * 2_f64.powi(60)) as u128 })
    }

    fn exact(&self, t: u64) -> Complex<f64> {
        Complex::from_polar(1.0, exact_phase(self.parts, u128::from(t)))
    }

    /// How far the direction is off that has this phase at a time.
    fn off(&self, phase: f64, t: u64) -> f64 {
        (Complex::from_polar(1.0, phase) - self.exact(t)).norm().max(LEAST)
    }

    /// The rounded product with the time.
    fn product(&self, t: u64) -> f64 {
        self.off(self.drum.spin() * t as f64, t)
    }

    /// The phase added up in steps of 1/128 s.
    fn added(&self, t: u64) -> f64 {
        let step = self.drum.spin() / 128.0;
        self.off((0..128 * t).fold(0.0, |phase, _| phase + step), t)
    }

    /// The library's product in two parts.
    fn parts(&self, t: u64) -> f64 {
        (self.drum.load_direction(t as f64) - self.exact(t)).norm().max(LEAST)
    }
}

/// The phase of the drum at late times.
pub(crate) fn hard_phase(id: &str) -> Outcome {
    let mut drawing = Drawing::new(id, WIDTH, HEIGHT).titled(
        "Error of the direction of the load at late times",
        "Both scales are logarithmic: along x the time from one to 1e9 seconds, along y the error of the direction. Added up in steps of 1/128 s it grows with the square of the time, to 0.01 after 1e6 \
         seconds; from one rounded product with the time, to 1e-6 after 1e9 seconds. A band at the foot, under 1e-15, is the product in two parts.",
    );
    let load = Load::new()?;
    let (mut added, mut product, mut parts) = (Vec::new(), Vec::new(), Vec::new());
    for t in log_steps(1.0, 1e9, 36).map(f64::round) {
        let whole = t as u64;
        if t < 1.5e6 {
            added.push((t, load.added(whole)));
        }
        product.push((t, load.product(whole)));
        parts.push((t, load.parts(whole)));
    }
    let time = Axis::log(1.0, 1e9, 3).titled("time, s");
    let error = Axis::log(LEAST, 1.0, 4).titled("error of the direction");
    let mut plot = Plot::new(&mut drawing, FRAME, time, error)?;
    band(&mut plot, &parts, 1e-15, r"$\Omega t$ in two parts")?;
    for (values, marker, hue) in [(added, Marker::Disc, Hue::Ink), (product, Marker::Triangle, Hue::Muted)] {
        let values: Vec<_> = values.into_iter().filter(|value| value.1 > 1e-15).collect();
        plot.markers(&values, marker, hue);
    }
    plot.label((3e3, 2e-4), Side::Left, r"$\phi$ added up", Hue::Ink)?;
    plot.label((2e5, 3e-12), Side::BelowRight, r"$\sin(\Omega t)$", Hue::Muted)?;
    Ok(drawing)
}

/// A hoop pinned at 60° that tumbles, followed by RK4 with eighty steps a period and in closed form.
struct Drift {
    moments: PrincipalMoments,
    top: FreeTop,
    period: f64,
    start: Turning,
    state: [f64; 7],
    done: u64,
}

/// Its errors after a time.
struct Drifted {
    periods: f64,
    length: f64,
    energy: f64,
    attitude: f64,
    /// The larger of those of length and energy in closed form.
    closed: f64,
}

impl Drift {
    fn new() -> Result<Self, Cause> {
        let (moments, start) = hoop(60_f64.to_radians().sin() / 3.0, 0.5)?;
        let top = FreeTop::new(moments, start)?;
        let period = top.period().ok_or("the hoop tumbles")?;
        Ok(Self { moments, top, period, start, state: start.to_array(), done: 0 })
    }

    /// The errors after so many periods, no fewer than before.
    fn after(&mut self, periods: f64) -> Result<Drifted, Cause> {
        let mut rates = euler::turning_rates(self.moments, |_, _| Vector3::zeros());
        let h = self.period / 80.0;
        let steps = (80.0 * periods).round() as u64;
        while self.done < steps {
            self.state = rk4_step(&mut rates, 0.0, &self.state, h);
            self.done += 1;
        }
        let time = steps as f64 * h;
        let exact = self.top.at(time)?;
        let [w, x, y, z, ..] = self.state;
        let found = Turning::from_array(self.state);
        let [a, b] = [found.world_from_body, exact.world_from_body].map(UnitQuaternion::into_inner);
        let energy = |omega: &Vector3<f64>| {
            relative(self.moments.kinetic_energy(omega), self.moments.kinetic_energy(&self.start.omega_body))
        };
        Ok(Drifted {
            periods: time / self.period,
            length: (Quaternion::new(w, x, y, z).norm() - 1.0).abs(),
            energy: energy(&found.omega_body),
            attitude: (a - b).norm().min((a + b).norm()),
            closed: energy(&exact.omega_body).max((b.norm() - 1.0).abs()),
        })
    }
}

/// Length, energy and attitude over many periods by the classical method.
pub(crate) fn hard_drift(id: &str) -> Outcome {
    let mut drawing = Drawing::new(id, WIDTH, HEIGHT).titled(
        "Length, energy and attitude of a tumbling hoop over ten thousand periods",
        "Both scales are logarithmic: along x the time from one to ten thousand periods, along y errors. By the Runge-Kutta method with eighty steps a period the length of the quaternion falls short by 1e-7 \
         a period and the energy by 1e-7 a period, both in proportion to the time; the error of the attitude grows faster, with the square of the time, and is complete after five thousand periods. \
         A band at the foot, under 2e-15, is the closed form, its length and its energy.",
    );
    let mut drift = Drift::new()?;
    let all =
        log_steps(1.0, 1e4, 24).map(|periods| drift.after(periods)).collect::<Result<Vec<_>, Cause>>()?;
    let of = |error: fn(&Drifted) -> f64| all.iter().map(move |one| (one.periods, error(one)));
    let time = Axis::log(1.0, 1e4, 1).titled("time, periods");
    let error = Axis::log(LEAST, 10.0, 2).titled("error");
    let mut plot = Plot::new(&mut drawing, FRAME, time, error)?;
    band(&mut plot, &of(|one| one.closed).collect::<Vec<_>>(), 2e-15, "closed form: length, energy")?;
    let attitude = of(|one| one.attitude).take_while(|one| one.1 < 1.0);
    plot.curve("attitude", attitude, Stroke::Heavy, Hue::Ink);
    plot.curve("energy", of(|one| one.energy), Stroke::Curve, Hue::Muted);
    plot.curve("length", of(|one| one.length), Stroke::Orbit, Hue::Muted);
    plot.label((4e2, 2e-1), Side::Left, "attitude", Hue::Ink)?;
    plot.label((7e3, 6e-3), Side::Left, "energy", Hue::Muted)?;
    plot.label((1e2, 5e-6), Side::BelowRight, r"$1 - \lvert q\rvert$", Hue::Muted)?;
    Ok(drawing)
}

/// A hoop that has passed the separatrix twice, by stepping and in closed form.
pub(crate) fn hard_separatrix(id: &str) -> Outcome {
    let mut drawing = Drawing::new(id, WIDTH, HEIGHT).titled(
        "Error of the angular velocity after passing near the separatrix twice",
        "Both scales are logarithmic: along x the complementary modulus from 1e-9 to 0.1, along y the error of the angular velocity after five quarters of a period. By DOP853 at 1e-13, and by the Runge-Kutta \
         method, it rises with the power minus two from 1e-11 to one at 1e-8. A band at the foot, under 2e-14, is the closed form.",
    );
    let (mut adaptive, mut classical, mut closed) = (Vec::new(), Vec::new(), Vec::new());
    for modulus in log_steps(1e-9, 1e-1, 32) {
        let (moments, start) = hoop(1.0 / 3.0, modulus / 3.0)?;
        let top = FreeTop::new(moments, start)?;
        let time = 1.25 * top.period().ok_or("the hoop tumbles")?;
        // eq:hoop-jacobi at u = 6K: sn = 0, dn = 1, cn = −1.
        let [tangent, diameter] = [start.omega_body.x, start.omega_body.y];
        let exact = Vector3::new(0.0, -tangent.hypot(diameter), -tangent / SQRT_2);
        let error = |omega: Vector3<f64>| (omega - exact).norm().max(LEAST);
        let rates = || euler::turning_rates(moments, |_, _| Vector3::zeros());
        let end = Dop853::new(1e-13)?.solve(rates(), 0.0, start.to_array(), time)?;
        adaptive.push((modulus, error(Turning::from_array(end.state).omega_body)));
        let end = rk4(rates(), 0.0, start.to_array(), time, (50.0 * time) as usize)?;
        classical.push((modulus, error(Turning::from_array(end).omega_body)));
        closed.push((modulus, error(top.at(time)?.omega_body)));
    }
    let modulus = Axis::log(1e-9, 1e-1, 2).titled(r"complementary modulus $k'$");
    let error = Axis::log(1e-17, 10.0, 2).titled(r"error of $\boldsymbol\omega$, rad/s");
    let mut plot = Plot::new(&mut drawing, FRAME, modulus, error)?;
    plot.series("rk4", &classical, Look::RK4.marker, Look::RK4.hue);
    plot.series("dop853", &adaptive, Look::DOP853.marker, Look::DOP853.hue);
    band(&mut plot, &closed, 2e-14, "closed form")?;
    plot.label((1e-4, 1e-3), Side::Right, "RK4", Look::RK4.hue)?;
    plot.label((3e-9, 1e-4), Side::Right, "DOP853", Look::DOP853.hue)?;
    Ok(drawing)
}

/// The rates of an oscillator.
fn oscillator(_: f64, &[x, v]: &[f64; 2]) -> [f64; 2] {
    [v, -x]
}

/// More work and no more digits.
pub(crate) fn hard_rounding(id: &str) -> Outcome {
    let error = |[x, v]: [f64; 2]| (x - TAU.cos()).hypot(v + TAU.sin()).max(LEAST);
    let (mut classical, mut adaptive) = (Vec::new(), Vec::new());
    for steps in log_steps(10.0, 5e6, 40).map(f64::round) {
        classical.push((4.0 * steps, error(rk4(oscillator, 0.0, [1.0, 0.0], TAU, steps as usize)?)));
    }
    for tolerance in log_steps(1e-15, 1e-3, 12) {
        let end = Dop853::new(tolerance)?.solve(oscillator, 0.0, [1.0, 0.0], TAU)?;
        adaptive.push((end.work.evaluations as f64, error(end.state)));
    }
    let work = Axis::log(1.0, 1e8, 2).titled("evaluations");
    let axis = Axis::log(1e-16, 1.0, 4).titled("(a) error after one turn");
    let mut left = Drawing::new("", 280.0, 280.0);
    let mut plot = Plot::new(&mut left, PANEL, work, axis)?;
    plot.series("rk4", &classical, Look::RK4.marker, Look::RK4.hue);
    plot.series("dop853", &adaptive, Look::DOP853.marker, Look::DOP853.hue);
    plot.label((3e3, 1e-7), Side::Right, "RK4", Look::RK4.hue)?;
    plot.label((5e2, 1e-14), Side::Left, "DOP853", Look::DOP853.hue)?;

    let drum = machine(0.01, 3.0)?;
    let time = 200.0 * TAU / 3.0;
    let exact = drum.transient(Shaft::AT_REST)?.at(time)?.position;
    let mut floor = Vec::new();
    for tolerance in log_steps(1e-15, 1e-3, 36) {
        let end = Dop853::new(tolerance)?.solve(
            |t, y: &[f64; 4]| drum.cartesian_rates(t, y),
            0.0,
            [0.0; 4],
            time,
        )?;
        floor.push((tolerance, (Shaft::from_array(end.state).position - exact).norm().max(LEAST)));
    }
    let tolerance = Axis::log(1e-15, 1e-3, 3).titled("tolerance");
    let axis = Axis::log(1e-16, 1.0, 4).titled("(b) error after 200 turns, m");
    let mut right = Drawing::new("", 280.0, 280.0);
    let mut plot = Plot::new(&mut right, PANEL, tolerance, axis)?;
    plot.reference((1e-15, 3.5e-15), (1e-3, 3.5e-3), Stroke::Reference);
    plot.series("tolerance", &floor, Look::DOP853.marker, Look::DOP853.hue);
    plot.label((1e-12, 3e-8), Side::Over, "DOP853", Look::DOP853.hue)?;
    Ok(Drawing::panels(id, vec![left, right]).titled(
        "Smaller steps and tighter tolerances, down to rounding and below",
        "Two plots with logarithmic scales. First, the error of one turn of an oscillator against the evaluations: by the Runge-Kutta method it falls with the power minus four to 1e-15 at thirty thousand \
         evaluations and rises again to 1e-13; DOP853 gets to 1e-15 with some hundred evaluations. Second, the error of two hundred turns of a washing machine by DOP853 against the tolerance: in \
         proportion to it down to 1e-12, and from there on it stays between 1e-12 and 1e-11.",
    ))
}

/// The evaluations of DOP853 for a hundred seconds of a drum that comes back slowly, and the relative error of its end.
fn heavy_damping(damping: f64, tolerance: f64) -> Result<(f64, f64), Cause> {
    let drum = machine(damping, 0.0)?;
    let start = Shaft { position: 1.0.into(), ..Shaft::AT_REST };
    let rates = |t: f64, y: &[f64; 4]| drum.cartesian_rates(t, y);
    let end = Dop853::new(tolerance)?.solve(rates, 0.0, start.to_array(), 100.0)?;
    let exact = drum.transient(start)?.at(100.0)?.position.re;
    Ok((end.work.evaluations as f64, relative(end.state[0], exact)))
}

/// Work against damping.
pub(crate) fn hard_stiff(id: &str) -> Outcome {
    let mut drawing = Drawing::new(id, WIDTH, HEIGHT).titled(
        "Evaluations for a hundred seconds against the damping",
        "Both scales are logarithmic: along x the damping rate from 1 to 1e4, along y the evaluations of the rates. At a tolerance of 1e-8 and at 1e-4 DOP853 needs nearly the same number above a damping \
         of ten, in proportion to the damping: two million at 1e4. The closed form is evaluated once.",
    );
    let damping = Axis::log(1.0, 1e4, 1).titled(r"damping rate $\Gamma/\omega_0$");
    let work = Axis::log(0.5, 1e7, 1).titled("evaluations");
    let mut plot = Plot::new(&mut drawing, FRAME, damping, work)?;
    for (name, tolerance, form) in [("coarse", 1e-4, Marker::Ring), ("fine", 1e-8, Look::DOP853.marker)] {
        let values = log_steps(1.0, 1e4, 16)
            .map(|damping| Ok((damping, heavy_damping(damping, tolerance)?.0)))
            .collect::<Result<Vec<_>, Cause>>()?;
        plot.series(name, &values, form, Look::DOP853.hue);
    }
    plot.curve("closed", [(1.0, 1.0), (1e4, 1.0)], Look::EXACT.stroke, Look::EXACT.hue);
    plot.label((1.2, 4e4), Side::Right, "DOP853 at $10^{-8}$", Look::DOP853.hue)?;
    plot.label((3.0, 1e2), Side::Right, "DOP853 at $10^{-4}$", Look::DOP853.hue)?;
    plot.label((1e2, 1.2), Side::Above, "closed form", Look::EXACT.hue)?;
    Ok(drawing)
}

/// A coin on a film of air in units of its tilt and its life, which ends at time one.
struct CoinsEnd {
    spin_down: SpinDown,
}

impl CoinsEnd {
    fn new() -> Result<Self, Cause> {
        let start = SpinningCoin::new(TOY, 0.1)?;
        Ok(Self { spin_down: SpinDown::new(start, Loss::air_film(&start, 1.78e-5)?)? })
    }

    fn film(_: f64, &[tilt]: &[f64; 1]) -> [f64; 1] {
        [-1.0 / (3.0 * tilt * tilt)]
    }

    /// The time at which a part of the life is left, and the relative error of a tilt then.
    fn stop(left: f64) -> (f64, impl Fn(f64) -> f64) {
        let stop = 1.0 - left;
        let rest = 1.0 - stop; // what is left of the rounded time, exactly
        (stop, move |tilt: f64| relative(tilt, rest.cbrt()))
    }

    /// The error by RK4 with ten thousand equal steps, if a number comes back.
    fn classical(left: f64) -> Option<f64> {
        let (stop, error) = Self::stop(left);
        rk4(Self::film, 0.0, [1.0], stop, 10_000).ok().map(|[tilt]| error(tilt))
    }

    /// The error by DOP853 at 1e-9, if a number comes back.
    fn adaptive(&self, left: f64) -> Option<f64> {
        let (stop, error) = Self::stop(left);
        let end = Dop853::new(1e-9).ok()?.solve(Self::film, 0.0, [1.0], stop).ok()?;
        Some(error(end.state[0]))
    }

    /// The error by the law in the time that is left.
    fn law(&self, left: f64) -> Result<f64, Cause> {
        let sine = self.spin_down.with_time_left(left * self.spin_down.life())?.tilt().sin();
        Ok(relative(sine / 0.1_f64.sin(), left.cbrt()))
    }
}

/// The tilt of a spinning coin towards the end.
pub(crate) fn hard_end(id: &str) -> Outcome {
    let mut drawing = Drawing::new(id, WIDTH, HEIGHT).titled(
        "Error of the tilt towards the end of the motion",
        "Both scales are logarithmic: along x the part of the time that is left, from 1e-12 to 0.1, along y the relative error of the tilt. By the Runge-Kutta method with ten thousand steps it rises with the power minus \
         four; by DOP853 at 1e-9 with the power minus one, until the integration fails at 1e-10. A band at the foot, under 1e-15, is the law in the time that is left.",
    );
    let coin = CoinsEnd::new()?;
    let (mut classical, mut adaptive, mut law) = (Vec::new(), Vec::new(), Vec::new());
    for left in log_steps(1e-12, 1e-1, 44) {
        classical.extend(CoinsEnd::classical(left).map(|error| (left, error)));
        adaptive.extend(coin.adaptive(left).map(|error| (left, error)));
        law.push((left, coin.law(left)?));
    }
    let left = Axis::log(1e-12, 1e-1, 4).titled(r"part of the life that is left, $(t_0 - t)/t_0$");
    let error = Axis::log(LEAST, 10.0, 4).titled("relative error of the tilt");
    let mut plot = Plot::new(&mut drawing, FRAME, left, error)?;
    plot.series("rk4", &classical, Look::RK4.marker, Look::RK4.hue);
    plot.series("dop853", &adaptive, Look::DOP853.marker, Look::DOP853.hue);
    band(&mut plot, &law, 1e-15, r"$\sin^3\alpha$ against the time left")?;
    plot.label((3e-5, 1e-1), Side::Right, "RK4", Look::RK4.hue)?;
    plot.label((3e-7, 1e-6), Side::Left, "DOP853", Look::DOP853.hue)?;
    Ok(drawing)
}
