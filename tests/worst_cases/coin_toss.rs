//! A tossed coin, against its height and its angles in 32 digits, and at and next to the threshold where it just keeps
//! its face.

use crate::long::{Long, PI, long};
use crate::search::{Case, Draw, keeps_its_promise, worse};
use mechanics::inertia::{Cylinder, PrincipalMoments};
use mechanics::scenes::coin_toss::{
    Face, Flight, FlightParameters, Toss, TossParameters, angle_for_probability, ratio_for_probability,
};

const EPS: f64 = f64::EPSILON;

/// A coin and its two spins.
fn coin(draw: &mut Draw<'_>) -> Option<(Toss, [Long; 4])> {
    let across = draw.one_of(&[1.0, 0.3]) * draw.binary_unit(150);
    let ratio = if draw.below(2) == 0 { 2.0 } else { draw.decades(1e-4, 2.0) };
    let tumble = draw.signed(1e-6, 1e3);
    // At the threshold I₃ω₃ = I₁ω₁, next to it, and anywhere.
    let spin = if draw.below(2) == 0 { draw.beside(tumble / ratio) } else { draw.signed(1e-6, 1e3) };
    let spin = if draw.below(2) == 0 { -spin } else { spin };
    let along = across * ratio;
    let moments = PrincipalMoments::symmetric(across, along).ok()?;
    let toss = Toss::new(TossParameters { moments, omega_1: tumble, omega_3: spin }).ok()?;
    Some((toss, [across, along, tumble, spin].map(long)))
}

#[test]
fn the_lowest_height_and_what_follows_from_it_have_all_their_digits() {
    let ways = ["just keeps its face", "keeps its face", "just goes over", "goes over"];
    keeps_its_promise("coin toss", 4000, &ways, |draw| {
        let (toss, [a, c, tumble, spin]) = coin(draw)?;
        let (across, along) = (a * tumble, c * spin);
        let square = across * across + along * along;
        let lowest = (along - across) * (along + across) / square;
        let keeps = lowest >= long(0.0);
        let rate = square.sqrt() / a;
        let mut error = worse(lowest.off(toss.lowest_normal()), rate.off(toss.precession_rate()));
        if keeps != toss.keeps_its_face() || keeps != toss.first_edge().is_none() {
            error = f64::INFINITY;
        }
        let mut probability = 1.0;
        if let (false, Some(edge)) = (keeps, toss.first_edge()) {
            // At that time Λt/2 = atan2(1, √−cos 2θ_L): the sine of twice the rest of the angle over there.
            let half = rate * edge * 0.5;
            let (sin, cos) = half.sin_cos();
            error = worse(error, ((sin * (-lowest).sqrt() - cos) / half).abs().rounded());
            probability = toss.same_face_probability();
            error = worse(error, (half * 2.0 / PI).off(probability));
        }
        let way = match (keeps, lowest.abs() < long(1e-3)) {
            (true, true) => "just keeps its face",
            (true, false) => "keeps its face",
            (false, true) => "just goes over",
            (false, false) => "goes over",
        };
        let said = format!("{toss:?}: probability {probability:?}, off {error:e}");
        Some(Case { ratio: error / (4.0 * EPS), way, said })
    });
}

#[test]
fn the_height_of_the_normal_is_good_to_a_few_units_for_a_hundred_million_million_radians() {
    keeps_its_promise("height of the normal", 4000, &["any"], |draw| {
        let (toss, [a, c, tumble, spin]) = coin(draw)?;
        let (across, along) = (a * tumble, c * spin);
        let square = across * across + along * along;
        let rate = square.sqrt() / a;
        let time = draw.signed(1e-3, 1e14) / rate.rounded();
        let cos = (rate * time).sin_cos().1;
        let height = (along * along + across * across * cos) / square;
        let found = toss.normal_height(time).ok()?;
        let error = (height - found).abs().rounded();
        let face = toss.face(time).ok()?;
        let seen = match found {
            h if h > 0.0 => Face::Same,
            h if h < 0.0 => Face::Other,
            _ => Face::Edge,
        };
        let keeps_its_word = face == seen && (face != Face::Other || !toss.keeps_its_face());
        let normal = (toss.normal(time).ok()?.z - found).abs();
        let error = if keeps_its_word { worse(error, normal / 3.0) } else { f64::INFINITY };
        let said = format!("{toss:?} at {time:e}: {found:?}, off {error:e}");
        Some(Case { ratio: error / 2e-15, way: "any", said })
    });
}

#[test]
fn shares_of_landings_keep_the_digits_that_the_distance_to_a_border_leaves() {
    keeps_its_promise("landings", 4000, &["anywhere", "next to a border"], |draw| {
        let (toss, [a, c, tumble, spin]) = coin(draw)?;
        let (across, along) = (a * tumble, c * spin);
        let (lowest, square) = ((along - across) * (along + across), across * across + along * along);
        let lowest = lowest / square;
        // Any edge, or one whose border is next to the lowest height.
        let height = match draw.below(2) {
            0 => draw.signed(1e-9, 1e3).abs(),
            _ => {
                let sine = draw.beside(lowest.abs().rounded());
                2.0 * sine / ((1.0 - sine) * (1.0 + sine)).max(1e-9).sqrt()
            }
        };
        let found = toss.landings(Cylinder { radius: 1.0, height }).ok()?;
        let ratio = long(height) * 0.5;
        let diagonal = (ratio * ratio + 1.0).sqrt();
        let (sine, rest) = (ratio / diagonal, long(1.0) / (diagonal * (diagonal + ratio)));
        let root = |square: Long| if square > long(0.0) { square.sqrt() } else { long(0.0) };
        // How far a share is from the angle with this tangent, over a right angle.
        let off = |share: f64, opposite: Long, adjacent: Long| {
            let (sin, cos) = (PI * 0.5 * share).sin_cos();
            (sin * adjacent - cos * opposite)
                / (opposite * opposite + adjacent * adjacent).sqrt()
                / (PI * 0.5)
        };
        let same = off(found.same, rest.sqrt(), root(sine - lowest));
        let other = off(found.other, root(-sine - lowest), (sine + 1.0).sqrt());
        let edge = long(found.same) + found.edge + found.other - 1.0 - same - other;
        let error = [same, edge, other].map(|error| error.abs().rounded()).into_iter().fold(0.0, worse);
        let [near, far] = [sine - lowest, sine + lowest].map(|gap| gap.abs().rounded());
        let gap = near.min(far).max(0.1 * EPS);
        let promise = (2e-16 / (rest.rounded() * gap).sqrt()).max(2e-15);
        let way = if gap < 1e-3 { "next to a border" } else { "anywhere" };
        let said = format!("{toss:?}, height {height:?}: {found:?}, off {error:e}, promised {promise:e}");
        Some(Case { ratio: error / promise, way, said })
    });
}

#[test]
fn ratio_and_angle_for_a_probability_have_all_their_digits() {
    keeps_its_promise("ratio for a probability", 2000, &["towards one half", "towards one"], |draw| {
        let probability = match draw.below(3) {
            0 => 0.5 + draw.decades(1e-16, 0.4),
            1 => 1.0 - draw.decades(1e-16, 0.4),
            _ => draw.between(0.5, 1.0),
        };
        let ratio = draw.decades(1e-3, 2.0);
        let moments = PrincipalMoments::symmetric(1.0, ratio).ok()?;
        // The cotangent of θ_L, √(−cos πp) = √(sin π(p − ½)).
        let cotangent = (PI * (long(probability) - 0.5)).sin_cos().0.sqrt();
        let found = ratio_for_probability(moments, probability).ok()?;
        let off_ratio = if found == 0.0 { cotangent.rounded() } else { (cotangent / ratio).off(found) };
        let angle = angle_for_probability(probability).ok()?;
        let (sin, cos) = long(angle).sin_cos();
        let off_angle = ((sin * cotangent - cos) / angle).abs().rounded();
        let way = if probability < 0.75 { "towards one half" } else { "towards one" };
        let error = worse(off_ratio, off_angle);
        let said = format!("p {probability:?}: {found:?} {angle:?}, off {error:e}");
        Some(Case { ratio: error / (4.0 * EPS), way, said })
    });
}

#[test]
fn a_flight_is_as_long_as_the_height_of_the_catch_can_say() {
    keeps_its_promise("flight", 2000, &["caught at the top", "caught anywhere"], |draw| {
        let [speed, gravity] = std::array::from_fn(|_| draw.unit(20));
        let highest = 0.5 * speed * speed / gravity;
        let catch = if draw.below(2) == 0 {
            highest * (1.0 - draw.decades(1e-16, 1.0))
        } else {
            -highest * draw.decades(1e-6, 1e6)
        };
        let flight = Flight::new(FlightParameters { speed, gravity, catch_height: catch }).ok()?;
        let (v, g) = (long(speed), long(gravity));
        let square = v * v - g * catch * 2.0;
        if square <= long(0.0) {
            return None;
        }
        let truth = (v + square.sqrt()) / g;
        let error = truth.off(flight.duration());
        // What a rounding of the height of the catch is worth: near the top its root counts.
        let steep = (v * v / square).rounded();
        let ratio = error / (4.0 * EPS + 1.5 * EPS * if catch > 0.0 { steep.sqrt() } else { 0.0 });
        let way = if steep > 1e4 { "caught at the top" } else { "caught anywhere" };
        Some(Case { ratio, way, said: format!("v {speed:?} g {gravity:?} h {catch:?}: off {error:e}") })
    });
}
