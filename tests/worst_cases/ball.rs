//! A ball that slides, on a turning table and in a hole: judged in 32 digits by the balance of forces.

use crate::linear::carried;
use crate::long::{Long, long};
use crate::search::{Case, Draw, keeps_its_promise, worse};
use mechanics::scenes::ball::{
    Ball, BallParameters, BallState, Cloth, ClothParameters, Hole, HoleParameters, HoleStart, ShotStart,
    Turntable, TurntableParameters, TurntableStart,
};
use nalgebra::Vector3;

fn ball(draw: &mut Draw<'_>, radius: f64) -> Option<Ball> {
    let moment_factor = match draw.below(4) {
        0 => Ball::SOLID,
        1 => Ball::SHELL,
        2 => draw.decades(1e-6, 0.66),
        _ => draw.between(0.1, 0.66),
    };
    Ball::new(BallParameters { radius, moment_factor }).ok()
}

/// The largest distance of components from what they should be, over a size.
fn off(truth: &[Long], found: &[f64], size: f64) -> f64 {
    let distances = truth
        .iter()
        .zip(found)
        .map(|(truth, found)| (*truth - *found).abs().rounded() / size.max(f64::MIN_POSITIVE));
    distances.fold(0.0, worse)
}

#[test]
fn a_ball_that_slides_keeps_the_digits_of_its_slip() {
    let ways = ["slides", "nearly rolls", "last instant", "rolls"];
    keeps_its_promise("ball on a cloth", 4000, &ways, |draw| {
        let (length, second) = (draw.unit(12), draw.unit(12));
        let ball = ball(draw, length * 0.03)?;
        let (a, k) = (ball.radius(), ball.moment_factor());
        let friction = draw.decades(1e-4, 10.0);
        let gravity = 9.81 * length / (second * second);
        let cloth = Cloth::new(ClothParameters { ball, friction, gravity }).ok()?;
        let spin = [draw.signed(1e-3, 1e3), draw.signed(1e-3, 1e3), 3.0].map(|rate| rate / second);
        let nearly = draw.below(2) == 0;
        let velocity = [a * spin[1], -a * spin[0]]
            .map(|rolls| if nearly { draw.beside(rolls) } else { draw.signed(1e-4, 1e2) * length / second });
        let shot = cloth.shot(ShotStart { velocity, omega: spin }).ok()?;
        // Newton and Euler, forwards from the start: F = −μmg û, and what it does to the spin.
        let spun = [long(a) * spin[1], long(-a) * spin[0]];
        let slip = [0, 1].map(|n| long(velocity[n]) - spun[n]);
        let speed = (slip[0] * slip[0] + slip[1] * slip[1]).sqrt();
        if speed.rounded() < 1e-130 {
            return None;
        }
        let brake = long(friction) * gravity;
        let slowing = brake * (long(1.0) + long(1.0) / k);
        let ends = speed / slowing;
        let (time, way) = match draw.below(3) {
            0 => (ends.rounded() * draw.between(0.0, 0.999), if nearly { "nearly rolls" } else { "slides" }),
            1 => (ends.rounded().next_down(), "last instant"),
            _ => (ends.rounded().next_up() * draw.decades(1.0, 1e3), "rolls"),
        };
        let slides = if long(time) < ends { long(time) } else { ends };
        let direction = slip.map(|component| component / speed);
        let moves = [0, 1].map(|n| long(velocity[n]) - direction[n] * brake * slides);
        let turns = [0, 1].map(|n| spun[n] + direction[n] * brake * slides / k);
        let places = [0, 1].map(|n| {
            long(velocity[n]) * slides - direction[n] * brake * slides * slides * 0.5
                + moves[n] * (long(time) - slides)
        });
        let BallState { centre, velocity: found, omega } = shot.at(time).ok()?;
        let size = velocity[0].hypot(velocity[1]) + a * spin[0].hypot(spin[1]);
        let error_velocity = off(&moves, &[found.x, found.y], size);
        let error_spin = off(&turns, &[a * omega.y, -a * omega.x], size);
        let error_place = off(&places, &[centre.x, centre.y], size * time);
        let left = (ends - long(time)) / ends;
        let found = shot.slip(time).ok()?;
        let error_slip = if left > long(0.0) {
            let truth = slip.map(|component| component * left);
            off(&truth, &[found.x, found.y], (speed * left).rounded())
        } else if found == Vector3::zeros() {
            0.0
        } else {
            f64::INFINITY
        };
        let final_velocity = [0, 1].map(|n| (long(velocity[n]) + spun[n] * k) / (long(1.0) + k));
        let rolling = shot.rolling_velocity();
        let error_rolling = [(final_velocity[0], rolling.x), (final_velocity[1], rolling.y)]
            .map(|(truth, found)| {
                let distance = (truth - found).abs().rounded();
                distance / (9e-16 * truth.abs().rounded() + 1e-31 * size).max(f64::MIN_POSITIVE)
            })
            .into_iter()
            .fold(0.0, worse);
        let error_time = ends.off(shot.sliding_time()) / 9e-16;
        let states = [error_velocity, error_spin, error_place, error_slip].into_iter().fold(0.0, worse);
        let ratio = [states / 2e-15, error_rolling, error_time].into_iter().fold(0.0, worse);
        let said = format!(
            "{shot:?} at {time:e}: velocity {error_velocity:e}, spin {error_spin:e}, place {error_place:e}, slip \
             {error_slip:e}, at the end {error_rolling:e}, time {error_time:e}"
        );
        Some(Case { ratio, way, said })
    });
}

#[test]
fn a_ball_on_a_turning_table_stays_on_its_circle() {
    let ways = ["level", "slope", "slope, hardly turns", "at rest"];
    keeps_its_promise("ball on a table", 3000, &ways, |draw| {
        let (length, second) = (draw.unit(12), draw.unit(12));
        let ball = ball(draw, length * 0.03)?;
        let k = ball.moment_factor();
        let rests = draw.below(8) == 0;
        let rate = if rests { 0.0 } else { draw.one_of(&[-1.0, 1.0]) * draw.decades(1e-6, 1e3) / second };
        let slope: f64 = draw.signed(1e-12, 1.5);
        let gravity = 9.81 * length / (second * second);
        let table = Turntable::new(TurntableParameters { ball, rate, slope, gravity }).ok()?;
        let place = [0, 1].map(|_| draw.signed(1e-3, 1e3) * length);
        let velocity = [0, 1].map(|_| draw.signed(1e-4, 1e2) * length / second);
        let roll = table.roll(TurntableStart { place, velocity, pivot: 1.0 }).ok()?;
        let time = draw.one_of(&[-1.0, 1.0]) * draw.decades(1e-6, 1e8) * second;
        let lambda = long(rate) * k / (long(1.0) + k);
        let (sin_slope, _) = long(slope).sin_cos();
        let down = long(gravity) * sin_slope / (long(1.0) + k);
        // In units in which all numbers are of one size: the matrix of v̇ = λ ẑ × v + γ.
        let unit = if rests { time.abs() } else { time.abs().min(1.0 / lambda.abs().rounded()) };
        let [zero, one] = [long(0.0), long(1.0)];
        let lambda_unit = lambda * unit;
        let matrix = [
            [zero, zero, one, zero, zero],
            [zero, zero, zero, one, zero],
            [zero, zero, zero, -lambda_unit, one],
            [zero, zero, lambda_unit, zero, zero],
            [zero; 5],
        ];
        let start = [
            long(place[0]),
            long(place[1]),
            long(velocity[0]) * unit,
            long(velocity[1]) * unit,
            down * unit * unit,
        ];
        let end = carried(&matrix, &start, long(time) / unit);
        let found = roll.at(time).ok()?;
        let reach = if rests { time.abs() } else { time.abs().min((long(2.0) / lambda.abs()).rounded()) };
        let speed = velocity[0].hypot(velocity[1]);
        let gained = down.abs().rounded() * reach;
        let error_place = off(
            &end[..2],
            &[found.centre.x, found.centre.y],
            place[0].hypot(place[1]) + speed * reach + gained * time.abs(),
        );
        let error_velocity =
            off(&[end[2] / unit, end[3] / unit], &[found.velocity.x, found.velocity.y], speed + gained);
        let way = match (rests, slope == 0.0, time.abs() * lambda.abs().rounded() < 1.0) {
            (true, _, _) => "at rest",
            (_, true, _) => "level",
            (_, _, true) => "slope, hardly turns",
            _ => "slope",
        };
        let said = format!("{roll:?} at {time:e}: place {error_place:e}, velocity {error_velocity:e}");
        let ratio = worse(error_place, error_velocity) / 2e-15;
        Some(Case { ratio, way, said })
    });
}

#[test]
fn a_ball_in_a_hole_swings_in_time() {
    let ways = ["from level", "with a push", "weight carried"];
    keeps_its_promise("ball in a hole", 3000, &ways, |draw| {
        let (length, second) = (draw.unit(12), draw.unit(12));
        let ball = ball(draw, length * 0.03)?;
        let (a, k) = (ball.radius(), ball.moment_factor());
        let gravity = 9.81 * length / (second * second);
        let hole = Hole::new(HoleParameters { ball, radius: draw.beside(a) + a, gravity }).ok()?;
        let rate = draw.one_of(&[-1.0, 1.0]) * draw.decades(1e-3, 1e4) / second;
        // The spin that carries the weight where the ball is.
        let carries = -gravity / (k * a * rate);
        let (rise, pivot, way) = match draw.below(3) {
            0 => (0.0, 0.0, "from level"),
            1 => (draw.signed(1e-6, 1e2) * length / second, draw.signed(1e-3, 1e4) / second, "with a push"),
            _ => (draw.signed(1e-12, 1e-2) * length / second, draw.beside(carries), "weight carried"),
        };
        let roll = hole.roll(HoleStart { rate, rise, pivot }).ok()?;
        let time = draw.one_of(&[-1.0, 1.0]) * draw.decades(1e-6, 1e8) * second;
        let unit = long(1.0) / rate.abs();
        // The tangential spin turns into the normal one, and what turns that costs friction:
        // with y = aω + g/kΩ: ẏ = Ωż, (1 + k) z̈ = −kΩy.
        let sign = rate.signum();
        let [zero, one] = [long(0.0), long(1.0)];
        let share = long(k) / (one + k);
        let matrix = [[zero, one, zero], [zero, zero, -(share * sign)], [zero, long(sign), zero]];
        let parts = long(gravity) / (long(rate) * k);
        let start = [zero, unit * rise, (long(a) * pivot + parts) * unit];
        let end = carried(&matrix, &start, long(time) / unit);
        let round = carried(&[[zero, long(-sign)], [long(sign), zero]], &[one, zero], long(time) / unit);
        let found = roll.at(time).ok()?;
        let swing = share.sqrt() * rate.abs();
        let above = long(gravity) / (long(rate) * rate * k) + long(a) * pivot / rate;
        // Of parts that cancel 32 digits are known.
        let parts = (parts / rate).abs().rounded();
        let size = (above.abs() + (long(rise) / swing).abs()).rounded() + 1e-16 * parts;
        let error_height = off(&end[..1], &[found.centre.z], size);
        let error_rise = off(&[end[1] / unit], &[found.velocity.z], size * swing.rounded());
        let gap = hole.gap();
        let error_place = off(&round.map(|part| part * gap), &[found.centre.x, found.centre.y], gap);
        let speed = gap * rate;
        let moves = [-(round[1] * speed), round[0] * speed];
        let error_velocity = off(&moves, &[found.velocity.x, found.velocity.y], speed.abs());
        let low = -(above + (above * above + long(rise) / swing * rise / swing).sqrt());
        let error_low = if low.abs().rounded() > 1e-6 * size && size > 1e-14 * parts {
            low.off(roll.lowest())
        } else {
            0.0
        };
        let error = [error_height, error_rise, error_place, error_velocity, error_low];
        let said = format!("{roll:?} at {time:e}: {error:?}");
        Some(Case { ratio: error.into_iter().fold(0.0, worse) / 2e-15, way, said })
    });
}
