//! The figures of the chapter "Hard cases".

use drawing::kit::Marker;
use drawing::{Drawing, Hue, Rect, Side, Stroke};
use figures::{Axis, Cause, Figure, Look, Outcome, Plot, figures, log_steps};
use mechanics::InvalidQuantity;
use mechanics::elliptic::quarter_period;
use mechanics::euler::{self, Turning};
use mechanics::free_rotation::FreeTop;
use mechanics::inertia::PrincipalMoments;
use mechanics::integrate::{Dop853, rk4, rk4_step};
use mechanics::rolling::{DiskParameters, MomentFactors, Rolling};
use mechanics::scenes::laundromat::{Machine, MachineParameters, Shaft};
use mechanics::scenes::rolling_wheel::Wheel;
use mechanics::scenes::spinning_coin::{Loss, SpinDown, SpinningCoin};
use nalgebra::{Complex, Quaternion, UnitQuaternion, Vector3};
use std::f64::consts::{FRAC_PI_2, SQRT_2, TAU};

/// All figures of this chapter.
pub(crate) const FIGURES: &[Figure] = figures![
    hard_cancellation,
    hard_critical,
    hard_phase,
    hard_almost_flat,
    hard_drift,
    hard_separatrix,
    hard_rounding,
    hard_stiff,
    hard_end
];

/// The unit roundoff u, and the least error that a plot shows.
const ROUNDOFF: f64 = f64::EPSILON / 2.0;
const LEAST: f64 = 1e-17;

/// The frame of a plot that stands alone, and of a panel; a phone shows both in full size.
const FRAME: Rect = Rect::new(52.0, 34.0, 320.0, 236.0);
const PANEL: Rect = Rect::new(52.0, 34.0, 236.0, 200.0);

/// What goes wrong, and what is done about it.
const NAIVE: (Marker, Hue) = (Marker::Disc, Hue::Orange);
const CURED: (Marker, Hue) = (Marker::Diamond, Hue::Blue);

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

/// Four differences of nearly equal numbers.
pub(crate) fn hard_cancellation(id: &str) -> Outcome {
    let (mut coin, mut spin, mut root, mut period) = (Vec::new(), Vec::new(), Vec::new(), Vec::new());
    for small in log_steps(1e-10, 1.0, 60) {
        let flat = SpinningCoin::new(TOY, small)?;
        let naive = flat.turn_rate() * (1.0 - (FRAC_PI_2 - small).sin());
        let exact = flat.turn_rate() * (0.5 * small).tan() * small.sin(); // 1 − cos α, without a difference
        coin.push((small, relative(naive, exact), relative(flat.figure_rate(), exact)));

        let steady = machine(0.3, 1.0 / small)?.steady()?;
        let (r, cosine) = (steady.radius(), steady.phase().cos());
        let naive = (r * r + 1.0 + 2.0 * r * cosine).max(0.0).sqrt();
        // eq:centre-of-mass-radius over Ω²
        let exact = small * (small * small + 0.09).sqrt()
            / ((1.0 - small * small).powi(2) + 0.09 * small * small).sqrt();
        spin.push((small, relative(naive, exact), relative(steady.centre_of_mass_radius(), exact)));

        let half = 0.5 / small;
        let gap = (half * half - 1.0).max(0.0).sqrt();
        // λ = ε(1 + ε² + 2ε⁴ + 5ε⁶ + 14ε⁸ …) where that converges at once, else 1/λ_fast.
        let square = small * small;
        let exact = if small < 0.01 {
            small * (1.0 + square * (1.0 + square * (2.0 + square * 5.0)))
        } else {
            2.0 * small / (1.0 + ((1.0 - 2.0 * small) * (1.0 + 2.0 * small)).max(0.0).sqrt())
        };
        if small < 0.5 {
            root.push((small, relative(half - gap, exact), relative(1.0 / (half + gap), exact)));
        }

        let (sin, cos) = (small, ((1.0 - small) * (1.0 + small)).sqrt());
        let (moments, start) = hoop(cos, sin)?;
        if let Some(found) = FreeTop::new(moments, start)?.period() {
            let w = cos.hypot(sin);
            let exact = 4.0 * SQRT_2 / w * quarter_period((sin / w).powi(2));
            let naive = 4.0 * SQRT_2 / w * quarter_period((1.0 - (cos / w).powi(2)).clamp(0.0, 1.0));
            period.push((small, relative(naive, exact), relative(found, exact)));
        }
    }
    let panels = [
        ("coin", coin, "flat coin: tilt $\\alpha$", "$\\Omega\\,(1 - \\sin\\theta)$"),
        ("spin", spin, "high spin: $\\omega_0/\\Omega$", "law of cosines"),
        (
            "root",
            root,
            "heavy damping: $\\omega_0/\\Gamma$",
            "$\\Gamma/2 - \\sqrt{\\Gamma^2/4 - \\omega_0^2}$",
        ),
        ("period", period, "separatrix: $k'$", "$K(m)$ with $1 - m$"),
    ];
    let panels = panels.map(|(name, values, title, formula)| -> Outcome {
        let mut drawing = Drawing::new("", 374.0, 270.0);
        let small = Axis::log(1e-10, 1.0, 2).titled(title);
        let error = Axis::log(1e-17, 1e2, 4).titled("relative error");
        let mut plot = Plot::new(&mut drawing, Rect::new(52.0, 34.0, 300.0, 180.0), small, error)?;
        plot.reference((1e-10, ROUNDOFF * 1e20), (1.0, ROUNDOFF), Stroke::Reference);
        let naive: Vec<_> =
            values.iter().map(|value| (value.0, value.1)).filter(|value| value.1.is_finite()).collect();
        let cured: Vec<_> = values.iter().map(|value| (value.0, value.2)).collect();
        plot.series(&format!("{name}-naive"), &naive, NAIVE.0, NAIVE.1);
        plot.series(&format!("{name}-cured"), &cured, CURED.0, CURED.1);
        plot.label((1.6e-6, 1e-1), Side::Right, formula, Hue::Orange)?;
        plot.label((1e-9, 2e-14), Side::Right, "library", Hue::Blue)?;
        Ok(drawing)
    });
    let panels = panels.into_iter().collect::<Result<Vec<_>, Cause>>()?;
    Ok(Drawing::panels(id, panels).titled(
        "Four differences of nearly equal numbers",
        "Four plots with logarithmic scales: along x a small parameter from 1e-10 to 1, along y the relative error. The rate of the figure by one minus the sine, the centre of mass by the law of \
         cosines, the slow root by a difference, and the period by the parameter m all rise with the power minus two from 1e-16 to one or to nothing, along the same dashed line, \
         and the formulas of the library stay near 1e-16.",
    ))
}

/// The difference of two exponentials near critical damping.
pub(crate) fn hard_critical(id: &str) -> Outcome {
    let mut drawing = Drawing::new(id, 390.0, 320.0).titled(
        "Error of the difference of exponentials near critical damping",
        "Both scales are logarithmic: along x how far the damping is beyond critical, from 1e-15 to 1, along y the relative error of the position after 1.7 s. By the difference of two exponentials it \
         rises from 1e-16 with the power minus one half to 1e-9. By the library it stays near 1e-16.",
    );
    let (mut naive, mut cured) = (Vec::new(), Vec::new());
    let t = 1.7;
    for beyond in log_steps(1e-15, 1.0, 60) {
        let damping = 2.0 * (1.0 + beyond);
        let half = 0.5 * damping;
        let beyond = half - 1.0; // of the rounded damping, exactly
        let gap = (beyond * (2.0 + beyond)).sqrt();
        let exact = (-half * t).exp() * (gap * t).sinh() / gap;
        let root = (half * half - 1.0).sqrt();
        let (slow, fast) = (half - root, half + root);
        naive.push((beyond, relative(((-slow * t).exp() - (-fast * t).exp()) / (fast - slow), exact)));
        let pushed = machine(damping, 0.0)?.transient(Shaft { velocity: 1.0.into(), ..Shaft::AT_REST })?;
        cured.push((beyond, relative(pushed.at(t)?.position.re, exact)));
    }
    let beyond = Axis::log(1e-15, 1.0, 3).titled(r"$\delta = \Gamma/(2\omega_0) - 1$");
    let error = Axis::log(1e-17, 1e-6, 2).titled("relative error of the position");
    let mut plot = Plot::new(&mut drawing, FRAME, beyond, error)?;
    plot.reference((1e-15, ROUNDOFF / 8e-15_f64.sqrt()), (1.0, ROUNDOFF / 8_f64.sqrt()), Stroke::Reference);
    plot.series("naive", &naive, NAIVE.0, NAIVE.1);
    plot.series("cured", &cured, CURED.0, CURED.1);
    plot.label((5e-11, 2e-8), Side::Right, "difference of exponentials", Hue::Orange)?;
    plot.label((1e-12, 6e-15), Side::Right, "library", Hue::Blue)?;
    Ok(drawing)
}

/// The angle m·2⁻⁶⁰ · t modulo 2π for integers m and t, in integers, with 2π to 88 binary places.
fn exact_phase(m: u128, t: u128) -> f64 {
    const TWO_PI: u128 = 1_944_551_666_501_805_353_363_452_692;
    (((m * t) << 28) % TWO_PI) as f64 / 2_f64.powi(88)
}

/// The phase of the drum at late times.
pub(crate) fn hard_phase(id: &str) -> Outcome {
    let mut drawing = Drawing::new(id, 390.0, 320.0).titled(
        "Error of the direction of the load at late times",
        "Both scales are logarithmic: along x the time from one to 1e9 seconds, along y the error of the direction. Added up in steps of 1/128 s it grows with the square of the time, to 0.01 after 1e6 \
         seconds; from one rounded product with the time, to 1e-6 after 1e9 seconds; from the product in two parts it stays at 1e-16.",
    );
    let spin = 11.503_217;
    let drum = machine(0.3, spin)?;
    let m = (spin * 2_f64.powi(60)) as u128;
    let (mut added, mut product, mut parts) = (Vec::new(), Vec::new(), Vec::new());
    let (mut phase, mut steps) = (0.0, 0_u64);
    for t in log_steps(1.0, 1e9, 54).map(f64::round) {
        let exact = Complex::from_polar(1.0, exact_phase(m, t as u128));
        let error = |phase: f64| (Complex::from_polar(1.0, phase) - exact).norm().max(LEAST);
        if t < 1.5e6 {
            while steps < 128 * t as u64 {
                phase += spin / 128.0;
                steps += 1;
            }
            added.push((t, error(phase)));
        }
        product.push((t, error(spin * t)));
        parts.push((t, (drum.load_direction(t) - exact).norm().max(LEAST)));
    }
    let time = Axis::log(1.0, 1e9, 1).titled("time, s");
    let error = Axis::log(1e-17, 1.0, 2).titled("error of the direction");
    let mut plot = Plot::new(&mut drawing, FRAME, time, error)?;
    plot.series("added", &added, NAIVE.0, NAIVE.1);
    plot.series("product", &product, Marker::Triangle, Hue::Pink);
    plot.series("parts", &parts, CURED.0, CURED.1);
    plot.label((4e3, 2e-4), Side::Left, r"$\phi$ added up", Hue::Orange)?;
    plot.label((3e4, 3e-6), Side::Right, r"$\sin(\Omega t)$ as it stands", Hue::Pink)?;
    plot.label((3e4, 2e-14), Side::Right, r"$\Omega t$ in two parts", Hue::Blue)?;
    Ok(drawing)
}

/// The work for a wheel that almost falls flat, by its lean and by its tilt.
pub(crate) fn hard_almost_flat(id: &str) -> Outcome {
    let mut drawing = Drawing::new(id, 390.0, 320.0).titled(
        "Evaluations for a wheel that almost falls flat",
        "Both scales are logarithmic: along x the rate with which the wheel is let go, from 1e-10 to 0.1, along y the evaluations that DOP853 needs. By the lean they are the same as by the tilt down to \
         1e-5, then explode, and the curve ends; by the tilt they grow by a thousand with every decade.",
    );
    let (mut by_lean, mut by_tilt) = (Vec::new(), Vec::new());
    let wheel = Wheel::new(DiskParameters { mass: 1.0, radius: 1.0, gravity: 1.0, ..TOY })?;
    let time = 1.0; // it is up again by then
    let rates = |t: f64, state: &[f64; 8]| wheel.rates(t, state);
    let rates_by_lean = |t: f64, &[lean, ref rest @ ..]: &[f64; 8]| {
        let mut state = [FRAC_PI_2 - lean; 8];
        state[1..].copy_from_slice(rest);
        let mut rates = wheel.rates(t, &state);
        rates[0] = -rates[0];
        rates
    };
    for q in log_steps(1e-10, 1e-1, 27) {
        let start = Rolling { tilt: 0.1, omega_2: q, ..Rolling::UPRIGHT };
        let solver = Dop853::with_tolerances(1e-13, 1e-13 * q)?.with_max_evaluations(400_000);
        let mut lean = start.to_array();
        lean[0] = start.lean();
        if let Ok(end) = solver.solve(rates_by_lean, 0.0, lean, time) {
            by_lean.push((q, end.work.evaluations as f64));
        }
        let end = solver.solve(rates, 0.0, start.to_array(), time)?;
        by_tilt.push((q, end.work.evaluations as f64));
    }
    let rate = Axis::log(1e-10, 1e-1, 3).titled(r"rate at the start, in $\sqrt{g/a}$");
    let work = Axis::log(1e2, 1e6, 1).titled("evaluations");
    let mut plot = Plot::new(&mut drawing, FRAME, rate, work)?;
    plot.series("tilt", &by_tilt, CURED.0, CURED.1);
    plot.series("lean", &by_lean, Marker::Ring, Hue::Orange);
    plot.label((3e-5, 1e5), Side::Right, "by the lean", Hue::Orange)?;
    plot.label((1e-7, 3e3), Side::Below, r"by the tilt", Hue::Blue)?;
    Ok(drawing)
}

/// Length, energy and attitude over many periods by the classical method.
pub(crate) fn hard_drift(id: &str) -> Outcome {
    let mut drawing = Drawing::new(id, 390.0, 320.0).titled(
        "Length, energy and attitude of a tumbling hoop over ten thousand periods",
        "Both scales are logarithmic: along x the time from one to ten thousand periods, along y errors. By the Runge-Kutta method with eighty steps a period the length of the quaternion falls short by 1e-7 \
         a period and the energy by 1e-7 a period, both in proportion to the time; the error of the attitude grows faster, with the square of the time, and is complete after five thousand periods. \
         Length and energy of the closed form stay at 1e-16.",
    );
    let (moments, start) = hoop(60_f64.to_radians().sin() / 3.0, 0.5)?;
    let top = FreeTop::new(moments, start)?;
    let period = top.period().ok_or("the hoop tumbles")?;
    let mut rates = euler::turning_rates(moments, |_, _| Vector3::zeros());
    let energy = |omega: &Vector3<f64>| omega.dot(&moments.angular_momentum(omega));
    let first = energy(&start.omega_body);
    let (mut lengths, mut energies, mut attitudes, mut closed) =
        (Vec::new(), Vec::new(), Vec::new(), Vec::new());
    let (mut state, mut done) = (start.to_array(), 0_u64);
    let h = period / 80.0;
    for periods in log_steps(1.0, 1e4, 24) {
        let steps = (80.0 * periods).round() as u64;
        while done < steps {
            state = rk4_step(&mut rates, 0.0, &state, h);
            done += 1;
        }
        let time = steps as f64 * h;
        let exact = top.at(time)?;
        let [w, x, y, z, ..] = state;
        let length = Quaternion::new(w, x, y, z).norm();
        let found = Turning::from_array(state);
        let [a, b] = [found.world_from_body, exact.world_from_body].map(UnitQuaternion::into_inner);
        let periods = time / period;
        lengths.push((periods, (length - 1.0).abs()));
        energies.push((periods, relative(energy(&found.omega_body), first)));
        attitudes.push((periods, (a - b).norm().min((a + b).norm())));
        let kept = relative(energy(&exact.omega_body), first).max((b.norm() - 1.0).abs());
        closed.push((periods, kept));
    }
    let time = Axis::log(1.0, 1e4, 1).titled("time, periods");
    let error = Axis::log(1e-17, 10.0, 2).titled("error");
    let mut plot = Plot::new(&mut drawing, FRAME, time, error)?;
    plot.series("attitude", &attitudes, Marker::Disc, Hue::Orange);
    plot.series("length", &lengths, Marker::Triangle, Hue::Pink);
    plot.series("energy", &energies, Marker::Diamond, Hue::Purple);
    plot.series("closed", &closed, Look::EXACT.marker, Look::EXACT.hue);
    plot.label((1e2, 6e-2), Side::Left, "attitude", Hue::Orange)?;
    plot.label((7.0, 6e-9), Side::Right, r"$1 - \lvert q\rvert$", Hue::Pink)?;
    plot.label((1.2e2, 2e-8), Side::Right, "energy", Hue::Purple)?;
    plot.label((1e2, 4e-15), Side::Above, "closed form: length and energy", Hue::Blue)?;
    Ok(drawing)
}

/// A hoop that has passed the separatrix twice, by stepping and in closed form.
pub(crate) fn hard_separatrix(id: &str) -> Outcome {
    let mut drawing = Drawing::new(id, 390.0, 320.0).titled(
        "Error of the angular velocity after passing near the separatrix twice",
        "Both scales are logarithmic: along x the complementary modulus from 1e-9 to 0.1, along y the error of the angular velocity after five quarters of a period. By DOP853 at 1e-13, and by the Runge-Kutta \
         method, it rises with the power minus two from 1e-11 to one at 1e-8. By the closed form it stays near 1e-15.",
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
    let modulus = Axis::log(1e-9, 1e-1, 1).titled(r"complementary modulus $k'$");
    let error = Axis::log(1e-17, 10.0, 2).titled(r"error of $\boldsymbol\omega$, rad/s");
    let mut plot = Plot::new(&mut drawing, FRAME, modulus, error)?;
    plot.series("rk4", &classical, Look::RK4.marker, Look::RK4.hue);
    plot.series("dop853", &adaptive, Look::DOP853.marker, Look::DOP853.hue);
    plot.series("closed", &closed, Look::EXACT.marker, Look::EXACT.hue);
    plot.label((1e-4, 1e-3), Side::Right, "RK4", Look::RK4.hue)?;
    plot.label((3e-9, 1e-4), Side::Right, "DOP853", Look::DOP853.hue)?;
    plot.label((1e-6, 2e-13), Side::Right, "closed form", Hue::Blue)?;
    Ok(drawing)
}

/// More work and no more digits.
pub(crate) fn hard_rounding(id: &str) -> Outcome {
    let oscillator = |_: f64, &[x, v]: &[f64; 2]| [v, -x];
    let error = |[x, v]: [f64; 2]| (x - TAU.cos()).hypot(v + TAU.sin()).max(LEAST);
    let (mut classical, mut adaptive) = (Vec::new(), Vec::new());
    for steps in log_steps(10.0, 5e6, 40).map(f64::round) {
        classical.push((4.0 * steps, error(rk4(oscillator, 0.0, [1.0, 0.0], TAU, steps as usize)?)));
    }
    for tolerance in log_steps(1e-15, 1e-3, 12) {
        let end = Dop853::new(tolerance)?.solve(oscillator, 0.0, [1.0, 0.0], TAU)?;
        adaptive.push((end.work.evaluations as f64, error(end.state)));
    }
    let work = Axis::log(10.0, 1e8, 1).titled("evaluations");
    let axis = Axis::log(1e-16, 1.0, 4).titled("error after one turn");
    let mut left = Drawing::new("", 310.0, 290.0);
    let mut plot = Plot::new(&mut left, PANEL, work, axis)?;
    plot.series("rk4", &classical, Look::RK4.marker, Look::RK4.hue);
    plot.series("dop853", &adaptive, Look::DOP853.marker, Look::DOP853.hue);
    plot.label((3e3, 1e-7), Side::Right, "RK4", Look::RK4.hue)?;
    plot.label((8e2, 1e-15), Side::Left, "DOP853", Look::DOP853.hue)?;

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
    let axis = Axis::log(1e-16, 1.0, 4).titled("error after 200 turns, m");
    let mut right = Drawing::new("", 310.0, 290.0);
    let mut plot = Plot::new(&mut right, PANEL, tolerance, axis)?;
    plot.reference((1e-15, 3.5e-15), (1e-3, 3.5e-3), Stroke::Reference);
    plot.series("tolerance", &floor, Look::DOP853.marker, Look::DOP853.hue);
    plot.label((1e-12, 1e-9), Side::Over, "DOP853", Look::DOP853.hue)?;
    Ok(Drawing::panels(id, vec![left, right]).titled(
        "Smaller steps and tighter tolerances, down to rounding and below",
        "Two plots with logarithmic scales. First, the error of one turn of an oscillator against the evaluations: by the Runge-Kutta method it falls with the power minus four to 1e-15 at thirty thousand \
         evaluations and rises again to 1e-13; DOP853 gets to 1e-15 with some hundred evaluations. Second, the error of two hundred turns of a washing machine by DOP853 against the tolerance: in \
         proportion to it down to 1e-12, and from there on it stays between 1e-12 and 1e-11.",
    ))
}

/// Work against damping.
pub(crate) fn hard_stiff(id: &str) -> Outcome {
    let mut drawing = Drawing::new(id, 390.0, 320.0).titled(
        "Evaluations for a hundred seconds against the damping",
        "Both scales are logarithmic: along x the damping rate from 1 to 1e4, along y the evaluations of the rates. At a tolerance of 1e-8 and at 1e-4 DOP853 needs nearly the same number above a damping \
         of ten, in proportion to the damping: two million at 1e4. The closed form is evaluated once.",
    );
    let damping = Axis::log(1.0, 1e4, 1).titled(r"damping rate $\Gamma/\omega_0$");
    let work = Axis::log(0.5, 1e7, 1).titled("evaluations");
    let mut plot = Plot::new(&mut drawing, FRAME, damping, work)?;
    for (name, tolerance, form, hue) in [
        ("coarse", 1e-4, Marker::Ring, Look::DOP853.hue),
        ("fine", 1e-8, Look::DOP853.marker, Look::DOP853.hue),
    ] {
        let mut values = Vec::new();
        for damping in log_steps(1.0, 1e4, 16) {
            let drum = machine(damping, 0.0)?;
            let rates = |t: f64, y: &[f64; 4]| drum.cartesian_rates(t, y);
            let end = Dop853::new(tolerance)?.solve(rates, 0.0, [1.0, 0.0, 0.0, 0.0], 100.0)?;
            values.push((damping, end.work.evaluations as f64));
        }
        plot.series(name, &values, form, hue);
    }
    plot.series(
        "closed",
        &log_steps(1.0, 1e4, 16).map(|damping| (damping, 1.0)).collect::<Vec<_>>(),
        Look::EXACT.marker,
        Look::EXACT.hue,
    );
    plot.label((1.2, 4e4), Side::Right, "DOP853 at $10^{-8}$", Look::DOP853.hue)?;
    plot.label((2.0, 7e1), Side::Right, "DOP853 at $10^{-4}$", Look::DOP853.hue)?;
    plot.label((1e2, 1.5), Side::Above, "closed form", Hue::Blue)?;
    Ok(drawing)
}

/// The tilt of a spinning coin towards the end.
pub(crate) fn hard_end(id: &str) -> Outcome {
    let mut drawing = Drawing::new(id, 390.0, 320.0).titled(
        "Error of the tilt towards the end of the motion",
        "Both scales are logarithmic: along x the part of the time that is left, from 1e-12 to 0.1, along y the relative error of the tilt. By the Runge-Kutta method with ten thousand steps it rises with the power minus \
         four; by DOP853 at 1e-9 with the power minus one, until the integration fails at 1e-10. By the time that is left it stays near 1e-16.",
    );
    let start = SpinningCoin::new(TOY, 0.1)?;
    let spin_down = SpinDown::new(start, Loss::air_film(&start, 1.78e-5)?)?;
    let film = |_: f64, &[tilt]: &[f64; 1]| [-1.0 / (3.0 * tilt * tilt)];
    let (mut classical, mut adaptive, mut law) = (Vec::new(), Vec::new(), Vec::new());
    for left in log_steps(1e-12, 1e-1, 44) {
        let stop = 1.0 - left;
        let rest = 1.0 - stop; // what is left of the rounded time, exactly
        let error = |tilt: f64| relative(tilt, rest.cbrt());
        if let Ok([tilt]) = rk4(film, 0.0, [1.0], stop, 10_000) {
            classical.push((left, error(tilt)));
        }
        if let Ok(end) = Dop853::new(1e-9)?.solve(film, 0.0, [1.0], stop) {
            adaptive.push((left, error(end.state[0])));
        }
        let sine = spin_down.with_time_left(left * spin_down.life())?.tilt().sin();
        law.push((left, relative(sine / 0.1_f64.sin(), left.cbrt())));
    }
    let left = Axis::log(1e-12, 1e-1, 2).titled(r"part of the life that is left, $(t_0 - t)/t_0$");
    let error = Axis::log(1e-17, 10.0, 2).titled("relative error of the tilt");
    let mut plot = Plot::new(&mut drawing, FRAME, left, error)?;
    plot.series("rk4", &classical, Look::RK4.marker, Look::RK4.hue);
    plot.series("dop853", &adaptive, Look::DOP853.marker, Look::DOP853.hue);
    plot.series("law", &law, Look::EXACT.marker, Look::EXACT.hue);
    plot.label((3e-5, 1e-2), Side::Right, "RK4, equal steps", Look::RK4.hue)?;
    plot.label((3e-7, 1e-6), Side::Left, "DOP853, step control", Look::DOP853.hue)?;
    plot.label((1e-11, 3e-14), Side::Right, r"$\sin^3\alpha$ against the time left", Hue::Blue)?;
    Ok(drawing)
}
