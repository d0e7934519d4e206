//! Differences of nearly equal numbers: the flat coin, high spin, the separatrix's parameter, heavy and
//! critical damping.

use super::{FEW_ULPS, ROUNDOFF, TOY, assert_level, assert_slope, machine, number, numbers, relative, rows};
use mechanics::elliptic::quarter_period;
use mechanics::euler::Turning;
use mechanics::free_rotation::FreeTop;
use mechanics::inertia::PrincipalMoments;
use mechanics::scenes::laundromat::Shaft;
use mechanics::scenes::spinning_coin::SpinningCoin;
use nalgebra::{Complex, UnitQuaternion};
use std::f64::consts::FRAC_PI_2;

#[test]
fn figure_of_a_flat_coin_keeps_its_digits_and_one_minus_the_sine_loses_two_a_decade() {
    let mut errors = Vec::new();
    for row in rows("flat") {
        let tilt = number(&row["tilt"]);
        let coin = SpinningCoin::new(TOY, tilt).unwrap();
        let exact = number(&row["figure"]);
        assert!(relative(coin.figure_rate(), exact) < FEW_ULPS, "α = {tilt:e}");
        assert!(relative(coin.turn_rate(), number(&row["turn"])) < FEW_ULPS, "α = {tilt:e}");
        assert!(relative(coin.vertical_rate(), number(&row["vertical"])) < FEW_ULPS, "α = {tilt:e}");
        let naive = coin.turn_rate() * (1.0 - (FRAC_PI_2 - tilt).sin());
        let error = relative(naive, exact);
        // The sine is rounded by u/2, just below one, and the angle, whose error it sees α-fold, by 2u.
        let bound = ROUNDOFF / tilt.powi(2) + 4.0 * ROUNDOFF / tilt;
        assert!(error < bound && (error > 0.02 * bound || error == 1.0), "α = {tilt:e}: {error:e}");
        if tilt <= 1.001e-8 {
            assert_eq!(naive, 0.0, "at {tilt:e} the naive figure stands still");
            // All that the rounded sine can tell is that the rate lies between zero and this.
            let most = coin.turn_rate() * ROUNDOFF;
            assert!(exact < most && (tilt < 9e-9 || relative(most, 3.6e-11) < 0.01), "{most:e}");
        }
        errors.push((tilt, error));
    }
    assert_slope("flat coin", &errors, -2.0, 0.2);
    errors.retain(|(tilt, _)| *tilt > 1.1e-8);
    assert_level("flat coin", &errors, |tilt| ROUNDOFF / tilt.powi(2), 0.1..0.6);
}

#[test]
fn centre_of_mass_at_high_spin_keeps_its_digits_and_the_law_of_cosines_loses_two_a_decade() {
    let mut errors = Vec::new();
    for row in rows("spins") {
        let spin = number(&row["spin"]);
        let machine = machine(0.3, spin);
        let steady = machine.steady().unwrap();
        let exact = number(&row["centre_of_mass"]);
        assert!(relative(steady.centre_of_mass_radius(), exact) < FEW_ULPS, "Ω = {spin:e}");
        assert!(relative(steady.radius(), number(&row["radius"])) < FEW_ULPS, "Ω = {spin:e}");
        // And on the way, two seconds after the shaft was let go at O.
        let way = Complex::new(number(&row["w_x"]), number(&row["w_y"]));
        let ours = machine.transient(Shaft::AT_REST).unwrap().centre_of_mass(2.0).unwrap();
        assert!((ours - way).norm() < FEW_ULPS * way.norm(), "Ω = {spin:e}: {ours} for {way}");

        let (r, cosine) = (steady.radius(), steady.phase().cos());
        let square = r * r + 1.0 + 2.0 * r * cosine; // b = 1
        let error = relative(square.max(0.0).sqrt(), exact);
        // A few roundings of numbers of size b², over twice the small square, (Γ/Ω)².
        let scale = ROUNDOFF * (spin / 0.3).powi(2);
        assert!(error < 4.0 * scale + FEW_ULPS || spin > 1e7, "Ω = {spin:e}: {error:e}, scale {scale:e}");
        if spin > 1.5e7 {
            assert_eq!(error, 1.0, "Ω = {spin:e}: no digit should be left, and the root is {square:e}");
        }
        if spin > 2.0 && spin < 5e6 {
            errors.push((spin, error));
        }
    }
    assert_slope("high spin", &errors, 2.0, 0.25);
    assert_level("high spin", &errors, |spin| ROUNDOFF * (spin / 0.3).powi(2), 0.2..2.0);
}

#[test]
fn period_near_the_separatrix_keeps_its_digits_and_the_parameter_loses_two_a_decade() {
    let moments = PrincipalMoments::new(1.5, 0.5, 2.0).unwrap();
    let mut errors = Vec::new();
    for row in rows("separatrix").iter().step_by(3) {
        let omega: [f64; 3] = numbers(&row["omega_start"]);
        let exact = number(&row["period"]);
        let start = Turning { world_from_body: UnitQuaternion::identity(), omega_body: omega.into() };
        let ours = FreeTop::new(moments, start).unwrap().period().unwrap();
        assert!(relative(ours, exact) < FEW_ULPS, "ω₂ = {:e}: {ours}", omega[1]);

        let complement = number(&row["complement"]);
        let parameter = omega[0].powi(2) / (omega[0].powi(2) + omega[1].powi(2)); // m = cos² α
        let naive = ours * quarter_period(1.0 - parameter) / quarter_period(complement);
        let error = relative(naive, exact);
        let modulus = complement.sqrt();
        assert!(error < ROUNDOFF / complement || modulus < 2e-8, "k' = {modulus:e}: {error:e}");
        if modulus < 5e-9 {
            assert!(error.is_infinite(), "k' = {modulus:e}: 1 − m should be zero");
        } else if modulus > 5e-8 {
            errors.push((modulus, error));
        }
    }
    assert_slope("parameter", &errors, -2.0, 0.3);
    // Of K = ln(4/k') the rounding of m changes 4/k' by u/2k'² of itself.
    let predicted = |modulus: f64| 0.5 * ROUNDOFF / modulus.powi(2) / (4.0 / modulus).ln();
    assert_level("parameter", &errors, predicted, 0.05..1.0);
}

#[test]
fn slow_decay_keeps_its_digits_and_the_difference_of_the_roots_loses_two_a_decade() {
    let mut errors = Vec::new();
    for row in rows("heavy") {
        let (damping, t) = (number(&row["damping"]), number(&row["t"]));
        let released =
            machine(damping, 0.0).transient(Shaft { position: 1.0.into(), ..Shaft::AT_REST }).unwrap();
        let now = released.at(t).unwrap();
        assert!(relative(now.position.re, number(&row["x"])) < FEW_ULPS, "Γ = {damping:e}, t = {t:e}");
        assert!(relative(now.velocity.re, number(&row["v"])) < FEW_ULPS, "Γ = {damping:e}, t = {t:e}");

        let half = damping / 2.0;
        let root = (half * half - 1.0).sqrt();
        let slow = number(&row["slow"]);
        assert!(relative(1.0 / (half + root), slow) < FEW_ULPS);
        let error = relative(half - root, slow);
        assert!(error < ROUNDOFF * damping * damping, "Γ = {damping:e}: {error:e}");
        errors.push((damping, error));
    }
    assert_slope("slow root", &errors, 2.0, 0.2);
    assert_level("slow root", &errors, |damping| ROUNDOFF * damping.powi(2), 0.06..0.6);
    assert!(errors[errors.len() - 1].1 > 0.1, "at Γ = 1e8 ω₀ the naive root should be wrong by a quarter");
}

#[test]
fn near_critical_damping_the_difference_of_exponentials_loses_half_a_digit_a_decade() {
    let mut errors = Vec::new();
    for row in rows("near_critical") {
        let (damping, t) = (number(&row["damping"]), number(&row["t"]));
        let pushed =
            machine(damping, 0.0).transient(Shaft { velocity: 1.0.into(), ..Shaft::AT_REST }).unwrap();
        let now = pushed.at(t).unwrap();
        let (exact, beyond) = (number(&row["x"]), damping / 2.0 - 1.0);
        assert!(relative(now.position.re, exact) < FEW_ULPS, "Γ/2ω₀ = 1 {beyond:+e}");
        assert!((now.velocity.re - number(&row["v"])).abs() < FEW_ULPS, "Γ/2ω₀ = 1 {beyond:+e}");
        // (e^{−st} − e^{−ft})/(f − s), with roots that are conjugate complex numbers below critical damping.
        let half_gap = Complex::new(damping * damping / 4.0 - 1.0, 0.0).sqrt();
        let (slow, fast) = (damping / 2.0 - half_gap, damping / 2.0 + half_gap);
        let naive = ((-slow * t).exp() - (-fast * t).exp()) / (fast - slow);
        let error = relative(naive.re, exact);
        if beyond < 0.0 {
            // Conjugate numbers share their real part exactly; nothing cancels in it.
            assert!(error < FEW_ULPS, "Γ/2ω₀ = 1 {beyond:+e}: {error:e}");
        } else {
            let gap = (8.0 * beyond).sqrt(); // f − s
            assert!(error < 4.0 * ROUNDOFF / gap + FEW_ULPS, "Γ/2ω₀ = 1 {beyond:+e}: {error:e}");
            if beyond < 1.1e-4 {
                errors.push((beyond, error));
            }
        }
    }
    assert_slope("critical damping", &errors, -0.5, 0.15);
    assert_level("critical damping", &errors, |beyond| ROUNDOFF / (8.0 * beyond).sqrt(), 0.1..0.7);
}

#[test]
fn heavy_damping_after_a_hard_push_keeps_the_digits_of_the_small_velocity() {
    // A push of 1 m/s at Γ = 1e6 moves the drum by 1e-6 m; it creeps back at λ_slow times that.
    let push = Shaft { velocity: 1.0.into(), ..Shaft::AT_REST };
    let late = machine(1e6, 0.0).transient(push).unwrap().at(1.0).unwrap();
    // With q = ω₀²/Γ² = 1e-12: λ_slow = (1 + q) ω₀²/Γ and 1/(λ_fast − λ_slow) = (1 + 2q)/Γ, both to 24 digits.
    let q = 1e-12_f64;
    let slow = 1e-6 * (1.0 + q);
    let position = 1e-6 * (1.0 + 2.0 * q) * (-slow).exp();
    assert!(relative(late.position.re, position) < FEW_ULPS);
    assert!(relative(late.velocity.re, -slow * position) < FEW_ULPS);
}

#[test]
fn motion_long_before_a_heavily_damped_start_is_found_if_it_can_be_written_down() {
    // Released at rest at 1e-40 m: fifteen seconds before, e^{−λt} alone is beyond the largest number, the motion is
    // not.
    let released = Shaft { position: 1e-40.into(), ..Shaft::AT_REST };
    let ours = machine(50.0, 0.0).transient(released).unwrap().at(-15.0).unwrap().position.re;
    let half_gap = 624.0_f64.sqrt();
    let (fast, slow) = (25.0 + half_gap, 1.0 / (25.0 + half_gap));
    let logarithm = (1e-40 * slow / (2.0 * half_gap)).ln() + 15.0 * fast;
    assert!(ours < 0.0 && relative(ours.abs().ln(), logarithm) < 1e-14, "{ours:e}, ln {logarithm}");
}
