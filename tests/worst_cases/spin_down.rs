//! A coin that sinks, against its law in 32 digits: sin α = sin α₀ (τ/t₀)^{1/(p+1)}.

use crate::long::{Long, PI, long, off_angle};
use crate::search::{Case, Draw, keeps_its_promise, worse};
use mechanics::rolling::{DiskParameters, MomentFactors};
use mechanics::scenes::spinning_coin::{Loss, SpinDown, SpinningCoin};
use std::f64::consts::FRAC_PI_2;

const EPS: f64 = f64::EPSILON;

/// A coin on its way down, and the exponent of its loss.
fn spin_down(draw: &mut Draw<'_>) -> Option<(SpinDown, f64)> {
    let tilt = match draw.below(3) {
        // Upright but for a hair.
        0 => FRAC_PI_2 - draw.decades(1e-16, 1.0),
        1 => draw.decades(1e-45, 1.0),
        _ => draw.between(0.01, 1.57),
    };
    let exponent = match draw.below(3) {
        0 => draw.one_of(&[0.0, 1e-50, 1e-10, 1.0, 1.25, 2.0, 10.0]),
        1 => draw.decades(1e-20, 10.0),
        _ => draw.between(0.0, 10.0),
    };
    let (radius, mass) = (draw.decades(1e-3, 1e3), draw.decades(1e-9, 1e9));
    let coin =
        SpinningCoin::new(DiskParameters { mass, radius, moments: MomentFactors::DISK, gravity: 9.81 }, tilt)
            .ok()?;
    let coefficient = draw.one_of(&[1e-6, 1e-50, 1e20, 3.7]);
    Some((SpinDown::new(coin, Loss::new(coefficient, exponent).ok()?).ok()?, exponent))
}

fn said(down: &SpinDown, exponent: f64, more: &str) -> String {
    format!("α₀ {:?}, p {exponent:?}, t₀ {:?}: {more}", down.start().tilt(), down.life())
}

/// Sine and cosine when a part of the life is left.
fn law(down: &SpinDown, exponent: f64, part: Long, gone: Long) -> (Long, Long) {
    let (sin, cos) = long(down.start().tilt()).sin_cos();
    let power = long(1.0) / (long(exponent) + 1.0);
    // 1 − part^{2/(p+1)} without a difference, where little is gone.
    let lost = if gone.rounded() < 0.1 {
        let x = -gone;
        let mut sum = long(0.0);
        let mut term = long(1.0);
        for n in 0..60 {
            term = term * (power * 2.0 - f64::from(n)) * x / f64::from(n + 1);
            sum = sum + term;
        }
        -sum
    } else {
        long(1.0) - (part.ln() * power * 2.0).exp()
    };
    let sine = sin * (part.ln() * power).exp();
    (sine, (cos * cos + sin * sin * lost).sqrt())
}

#[test]
fn the_tilt_is_good_to_a_few_units_by_the_time_that_is_left_and_by_that_since_the_start() {
    keeps_its_promise("tilt", 4000, &["near the start", "far", "early", "near the end"], |draw| {
        let (down, exponent) = spin_down(draw)?;
        let part =
            if draw.below(2) == 0 { draw.decades(1e-300, 1.0) } else { 1.0 - draw.decades(1e-16, 1.0) };
        let (time, life) = (part * down.life(), long(down.life()));
        // The difference of two times is exact, but each of the two is rounded.
        let (given, rest) = (long(time) / life, (life - time) / life);
        let is_left = draw.below(2) == 0;
        let (left, gone, way, answer) = if is_left {
            let way = if rest.rounded() < 0.1 { "near the start" } else { "far" };
            (given, rest, way, down.with_time_left(time))
        } else {
            let way = if rest.rounded() < 0.1 { "near the end" } else { "early" };
            (rest, given, way, down.at(time))
        };
        let truth = law(&down, exponent, left, gone);
        let found = match answer {
            Ok(coin) => coin.tilt(),
            // A tilt below 1e-50 is refused, and a time that is no time.
            Err(_) if truth.0.rounded() < 1.0001e-50 || left <= long(0.0) || gone < long(0.0) => return None,
            Err(error) => return Case::refused(way, said(&down, exponent, &error.to_string())),
        };
        let error = off_angle(truth, found);
        let said = said(&down, exponent, &format!("{time:e} s: {found:?}, off {error:e}"));
        Some(Case { ratio: error / (4.0 * EPS), way, said })
    });
}

#[test]
fn times_of_a_tilt_are_good_to_a_few_units_at_any_tilt() {
    keeps_its_promise("time of a tilt", 4000, &["above", "far above", "below", "far below"], |draw| {
        let (down, exponent) = spin_down(draw)?;
        let start = down.start().tilt();
        let tilt = match draw.below(4) {
            0 => draw.beside(start),
            1 => start * draw.between(0.2, 0.8),
            2 => FRAC_PI_2 - draw.decades(1e-16, 1.0),
            _ => draw.decades(1e-50, 1.0),
        };
        if tilt >= FRAC_PI_2 {
            return None;
        }
        let order = long(exponent) + 1.0;
        let [sin, sin_start] = [tilt, start].map(|angle| long(angle).sin_cos().0);
        // The difference of the sines over that at the start, and so the logarithm of their ratio, with all its digits.
        let mid = (long(tilt) + start) * 0.5;
        let half = (long(tilt) - start) * 0.5;
        let change = mid.sin_cos().1 * half.sin_cos().0 * 2.0 / sin_start;
        let logarithm = if change.abs() < long(0.1) {
            let s = change / (change + 2.0);
            (0..30).rev().fold(long(0.0), |sum, n| sum * s * s + long(1.0) / f64::from(2 * n + 1)) * s * 2.0
        } else {
            (sin / sin_start).ln()
        };
        let x = order * logarithm;
        let life = long(down.life());
        let part = x.exp();
        let time = if x.abs() < long(0.1) {
            x * (2..30).rev().fold(long(1.0), |sum, n| long(1.0) + x * sum / f64::from(n)) * -life.rounded()
        } else {
            life * (long(1.0) - part)
        };
        let left = life * part;
        let way = match (tilt > start, change.abs() < long(0.5)) {
            (true, _) if tilt > 2.0 * start => "far above",
            (true, _) => "above",
            (false, true) => "below",
            (false, false) => "far below",
        };
        let mut ratio: f64 = 0.0;
        let mut said_times = String::new();
        // To the tilt: relative, but for what the two tilts' own difference cannot say.
        match down.time_to(tilt) {
            Ok(found) => {
                let error = (time - found).abs().rounded();
                let size = time.abs().rounded() * (1.0 + order.rounded() * logarithm.rounded().max(0.0));
                ratio =
                    worse(ratio, if size == 0.0 && found == 0.0 { 0.0 } else { error / (6.0 * EPS * size) });
                said_times += &format!("to {tilt:?} in {found:?} s, off {error:e}; ");
            }
            Err(error) if time.abs().rounded() < 1e300 => {
                return Case::refused(way, said(&down, exponent, &error.to_string()));
            }
            Err(_) => {}
        }
        match down.time_left(tilt) {
            Ok(_) if part < long(1e-280) => {} // the judge has no such small numbers
            Ok(found) => {
                let error = (left - found).abs().rounded();
                // The life itself is good to as much.
                ratio = worse(ratio, error / (left.rounded() * (8.0 + order.rounded()) * EPS));
                said_times += &format!("{found:?} s left, off {error:e}");
            }
            Err(error) if (1e-290..1e290).contains(&left.rounded()) => {
                return Case::refused(way, said(&down, exponent, &error.to_string()));
            }
            Err(_) => {}
        }
        Some(Case { ratio, way, said: said(&down, exponent, &said_times) })
    });
}

#[test]
fn the_rates_of_a_coin_and_the_tilt_for_a_speed_have_their_digits_at_any_tilt() {
    keeps_its_promise("rates of a coin", 4000, &["slow", "between", "fast beyond all bounds"], |draw| {
        let tilt = match draw.below(3) {
            0 => FRAC_PI_2 - draw.decades(1e-16, 1.0),
            1 => draw.decades(1e-50, 1.0),
            _ => draw.between(0.01, 1.57),
        };
        let [radius, gravity] = std::array::from_fn(|_| draw.decades(1e-30, 1e30));
        let transverse = if draw.below(2) == 0 { draw.decades(1e-10, 10.0) } else { 0.25 };
        let moments = MomentFactors { transverse, axial: transverse };
        let coin = SpinningCoin::new(DiskParameters { mass: 1.0, radius, moments, gravity }, tilt).ok()?;
        let (sin, cos) = long(tilt).sin_cos();
        let half = (long(tilt) * 0.5).sin_cos().0;
        let [a, i1, g] = [radius, transverse, gravity].map(long);
        let turn = (g / (i1 * a * sin)).sqrt();
        let square = sin * sin + i1 * 3.0 * cos * cos;
        let truths = [
            turn,
            turn * cos,
            turn * half * half * 2.0,
            turn * sin * sin,
            a * turn * cos,
            turn * (square / (i1 + 1.0)).sqrt(),
        ];
        let found = [
            coin.turn_rate(),
            coin.relative_spin(),
            coin.figure_rate(),
            coin.vertical_rate(),
            coin.contact_speed(),
            coin.wobble_rate(),
        ];
        let off_rates = truths.iter().zip(found).map(|(truth, found)| truth.off(found)).fold(0.0, worse);
        // The tilt at which the contact runs so fast: I₁ c² sin α = g a cos² α.
        let speed = draw.decades(1e-50, 1e50);
        let fast = coin.tilt_for_contact_speed(speed).ok()?;
        let s = i1 * speed * speed / (g * a);
        let sine = long(2.0) / (s + (s * s + 4.0).sqrt());
        let off_tilt = if s.rounded() < 1e140 {
            off_angle((sine, (s * sine).sqrt()), fast)
        } else {
            (1.0 - (s * fast).rounded()).abs()
        };
        let ratio = worse(off_rates, off_tilt) / (4.0 * EPS);
        let way = match s.rounded() {
            s if s < 1e-8 => "slow",
            s if s > 1e140 => "fast beyond all bounds",
            _ => "between",
        };
        let said = format!(
            "a {radius:?} I₁ {transverse:?} g {gravity:?} α {tilt:?} c {speed:?}: rates {off_rates:e}, tilt {fast:e} off {off_tilt:e}"
        );
        Some(Case { ratio, way, said })
    });
}

#[test]
fn the_attitude_of_a_coin_takes_whole_turns_off_exactly() {
    keeps_its_promise("attitude of a coin", 1000, &["any"], |draw| {
        let tilt = if draw.below(2) == 0 { draw.decades(1e-20, 1.5) } else { draw.between(0.01, 1.57) };
        let parameters =
            DiskParameters { mass: 1.0, radius: 0.03, moments: MomentFactors::DISK, gravity: 9.81 };
        let coin = SpinningCoin::new(parameters, tilt).ok()?;
        let turns = draw.signed(1e-3, 1e12);
        let lost = coin.attitude(turns * 1e290);
        if !(lost.coords.norm() - 1.0).abs().lt(&1e-14) {
            return Case::refused("any", format!("{lost} after {turns:?}e290"));
        }
        let half = |angle: Long| (angle * 0.5).sin_cos();
        let turn = PI * 2.0 * turns;
        let ((s1, c1), (s2, c2)) = (half(turn), half(long(tilt)));
        let (s3, c3) = half(-(turn * long(tilt).sin_cos().1));
        // About z, then x, then z.
        let truth = [
            c2 * (c1 * c3 - s1 * s3),
            s2 * (c1 * c3 + s1 * s3),
            s2 * (s1 * c3 - c1 * s3),
            c2 * (s1 * c3 + c1 * s3),
        ];
        let q = coin.attitude(turns);
        let found = [q.w, q.i, q.j, q.k];
        let far = |sign: f64| {
            truth.iter().zip(found).map(|(&t, f)| (t * sign - f).abs().rounded()).fold(0.0, worse)
        };
        let error = far(1.0).min(far(-1.0));
        let figure = coin.figure_rate() / coin.turn_rate() * std::f64::consts::TAU * turns.abs();
        let ratio = error / ((2.0 + figure) * 2.0 * EPS);
        let said = format!("α {tilt:?}, {turns:?} turns: {error:e}, the figure {figure:e} rad");
        Some(Case { ratio, way: "any", said })
    });
}
