//! What scenes say of settings that are extremes, and of what has no answer.

use crate::hand::{Hand, Settings, number_behind};
use std::f64::consts::FRAC_PI_3;

/// A scene, settings, and words that it says, or behind a dash does not say.
const SAYS: &[(&str, Settings, &str)] = &[
    ("air-drag", &[("lean", 0.0), ("ratio", 0.0024)], "exactly about its axis"),
    ("air-drag", &[("lean", 90.0), ("ratio", 2.0)], "exactly across"),
    ("air-drag", &[("ratio", 1.0), ("drag", 1.0), ("lean", 20.0)], "stays at 20°"),
    ("ball", &[("roll", 3.0)], "rolls at once"),
    ("ball", &[("roll", -7.5)], "stops dead"),
    ("ball", &[("roll", -9.0)], "comes back"),
    ("ball", &[("place", 1.0), ("rate", 0.0)], "at rest"),
    ("ball", &[("place", 2.0), ("speed", 2.0)], "and not higher"),
    ("clocks", &[("ratio", 0.33)], "halved every 6.6\u{a0}s"),
    ("coin-toss", &[("toss", 0.0), ("hand", 1.0)], "too sure of itself"),
    ("coin-toss", &[("toss", 0.0)], "as chance will have it"),
    ("coin-toss", &[("toss", 0.0), ("hand", 2.0)], "no chance in it"),
    ("coin-toss", &[("twist", 144.0)], "heads shows all the time"),
    ("coin-toss", &[("twist", 120.0)], "stands on edge for an instant"),
    ("coin-toss", &[("twist", 144.0), ("ratio", 1.0)], "less than 1.00 times"),
    ("coin-toss", &[("tumble", 0.0)], "the circle is a point"),
    ("coin-toss", &[("tumble", 0.0), ("twist", 0.0), ("toss", 0.0)], "does not turn at all"),
    ("edge", &[("thickness", 0.577)], "fair coin for three"),
    ("edge", &[("thickness", 0.092), ("twist", 0.55)], "turns back within the belt"),
    ("edge", &[("thickness", 0.02), ("twist", 1.5)], "never gets down to the belt"),
    ("knob", &[], "By this way it comes to 9.7"),
    ("knob", &[("first", 6.0), ("turn", -1.0)], "By this way it comes to 36.5"),
    ("knob", &[("torque", 8.0)], "37.3\u{a0}rad/s only"),
    ("laundromat", &[("spin", 0.0)], "stands still"),
    ("laundromat", &[("damping", 0.0)], "no steady motion"),
    ("laundromat", &[("damping", 0.0), ("damper", 1.0)], "strikes its housing"),
    ("laundromat", &[("spin", 30.0)], "resonance 25\u{a0}rad/s would be quietest, with 74\u{a0}N"),
    ("laundromat", &[("spin", 50.0)], "would be quietest, with 74\u{a0}N"),
    ("laundromat", &[("spin", 24.9)], "beyond the resonance no spin is quieter"),
    ("laundromat", &[("spin", 24.9)], "–would be"),
    ("laundromat", &[("damping", 2.5), ("spin", 60.0)], "–quietest"),
    (
        "laundromat",
        &[("spin", 30.0), ("damping", 0.2), ("board", 0.2), ("motor", 1.0), ("damper", 1.0)],
        "No friction here",
    ),
    ("laundromat", &[("motor", 2.0), ("torque", 0.3), ("spin", 40.0), ("damping", 0.15)], "rad/s only"),
    ("methods", &[("step", 0.05)], "does not triple"),
    ("near-flat", &[("wheel", 1.0)], "slightest turn by 311.8°"),
    ("pinned-hoop", &[("exact", 1.0)], "for ever"),
    ("pinned-hoop", &[("gap", 90.0)], "as if nothing had happened"),
    ("pinned-hoop", &[("shape", 2.0)], "it never turns over"),
    // The ball's centre goes round the momentum at two sevenths of ω₀.
    ("pinned-hoop", &[("shape", 2.0)], "once in 22\u{a0}s"),
    ("pinned-hoop", &[("gap", 70.0)], "only nods"),
    // The tongue of a disc has its tip at 18.62°, that of weights on the axle, I₁ = 2, at 25.8°.
    ("rolling-wheel", &[("lean", 18.0), ("circle", 0.6)], "unstable"),
    ("rolling-wheel", &[("lean", 1.0), ("circle", 0.1)], "unstable"),
    ("rolling-wheel", &[("lean", 1.0), ("circle", 4.0)], "unstable"),
    ("rolling-wheel", &[("lean", 19.0), ("circle", 0.1)], "–unstable"),
    ("rolling-wheel", &[("lean", 19.0), ("circle", 0.6)], "–unstable"),
    ("rolling-wheel", &[("lean", 19.0), ("circle", 4.0)], "–unstable"),
    ("rolling-wheel", &[("wheel", 2.0), ("reach", 1.87), ("lean", 24.0), ("circle", 1.5)], "unstable"),
    ("rolling-wheel", &[("wheel", 2.0), ("reach", 1.87), ("lean", 27.0), ("circle", 1.5)], "–unstable"),
    ("rolling-wheel", &[("lean", 20.0), ("circle", 0.6), ("push", 1.0)], "too strong"),
    ("rolling-wheel", &[("lean", 30.0), ("circle", 1.6), ("push", 0.1)], "–too strong"),
    ("rolling-wheel", &[("lean", 0.0)], "no circle"),
    ("rolling-wheel", &[("push", 0.0)], "for ever"),
    // Beyond what a circle can be, eq:existence.
    ("rolling-wheel", &[("lean", 60.0), ("circle", -0.2)], "No rate of turning"),
    ("rolling-wheel", &[("lean", 60.0), ("circle", -0.2)], "0.144"),
    ("rolling-wheel", &[("lean", 30.0), ("push", 0.0), ("loss", 0.1)], "smaller circle"),
    ("rolling-wheel", &[("lean", 30.0), ("push", 0.0), ("loss", 0.1)], "With no loss it would be stable"),
    ("rolling-wheel", &[("lean", 30.0), ("push", 0.0), ("loss", 0.1)], "–stay small"),
    // A weight 1.87 radii out is below the table beyond a lean of arctan(1/1.87).
    (
        "rolling-wheel",
        &[("wheel", 2.0), ("reach", 1.87), ("lean", 22.0), ("circle", 4.0), ("push", 0.1)],
        "more than 28.1°, its lower weight is in a slot",
    ),
    ("rolling-wheel", &[("wheel", 2.0), ("reach", 0.5), ("push", 0.0)], "–slot"),
    ("rolling-wheel", &[("wheel", 1.0), ("reach", 1.87), ("lean", 60.0)], "–slot"),
    ("space-station", &[("impulse", 0.0)], "No blow"),
    ("space-station", &[("place", 0.0)], "drifts off at 4.50\u{a0}m/s"),
    ("space-station", &[("fire", 13.963)], "leaves no nod"),
    ("space-station", &[("fire", 13.963)], "2.8° away"),
    ("space-station", &[("fire", 6.846), ("thruster", 176.5)], "leaves nothing"),
    ("space-station", &[("fire", 7.0)], "a nod of 43.6°"), // at a wrong moment it makes things worse
    ("spinning-coin", &[("tilt", FRAC_PI_3)], "The 180° that are left over"),
    ("spinning-coin", &[("tilt", 0.01)], "314 µrad"), // π/10⁴
    ("spinning-coin", &[("tilt", 1.5)], "goes round 1.08 times"),
    ("spinning-coin", &[("tilt", 1e-5)], "20.0 billion times"), // 2/α²
    ("spinning-coin", &[("tilt", 1e-3)], "2.00 million times"),
    ("spinning-coin", &[("tilt", 1e-5), ("loss", 1.0)], "faster than falling"),
    ("top", &[], "cusps"),
    ("top", &[("push", 3.0)], "waves"),
    ("top", &[("push", -3.0)], "loops"),
    ("top", &[("push", 6.1)], "hardly nods"),
    ("top", &[("tilt", 0.0)], "it sleeps"),
    ("top", &[("tilt", 0.0), ("spin", 100.0)], "least push"),
    ("top", &[("tilt", 1.0), ("spin", 100.0)], "does not sleep"),
    ("top", &[("spin", 0.0), ("tilt", 120.0), ("push", 6.0)], "pendulum"),
    ("turning", &[("across", 0.0), ("spin", 0.0)], "Nothing turns"),
    ("turning", &[("across", 0.0)], "A perfect throw"),
    ("turning", &[("across", 0.0)], "nothing to wobble"),
    ("turning", &[("spin", 0.0)], "tumbles about a diameter"),
    ("turning", &[("camera", 1.0), ("ratio", 0.5)], "backwards"),
    ("turning", &[("camera", 1.0)], "forwards"),
    ("turning", &[("cones", 1.0)], "like a hula hoop"),
    (
        "turning",
        &[("ratio", 1.5)],
        "L/I₁ reaches 1.50 times as high along the axis as ω does, and lies between",
    ),
    ("turning", &[("ratio", 1.0)], "L lies along ω"),
    ("turning", &[("ratio", 0.5)], "ω has come between the axis and L"),
    ("wobble-plate", &[("spin", 0.0)], "At rest"),
    ("wobble-plate", &[("tilt", 0.0)], "flywheel"),
    ("wobble-plate", &[("mass", 0.0)], "The plate alone"),
    ("wobble-plate", &[("pistons", 2.0), ("mass", 1.676)], "backwards"),
    ("wobble-plate", &[("pistons", 3.0), ("mass", 1.676)], "Balanced"),
    ("wobble-plate", &[("mass", 1.676), ("tilt", 40.0)], "too heavy"),
    ("wobble-plate", &[("mass", 1.7)], "0.425\u{a0}kg each are too heavy"),
    ("wobble-plate", &[("mass", 1.7)], "with 0.419\u{a0}kg each"),
    ("wobble-plate", &[("mass", 0.0), ("thickness", 17.32)], "three equal moments"),
    ("wobble-plate", &[("mass", 0.0), ("thickness", 22.0)], "too thick"),
    ("wobble-plate", &[("thickness", 22.0)], "weights on its rim"),
];

#[test]
fn scenes_say_what_is_special() {
    for &(name, settings, expected) in SAYS {
        let said = Hand::with(name, settings).words();
        let (words, is_said) = expected.strip_prefix('–').map_or((expected, true), |words| (words, false));
        assert_eq!(said.contains(words), is_said, "{name}, {settings:?}, `{words}`: {said}");
    }
}

#[test]
fn a_weak_motor_is_refused_where_it_has_no_answer() {
    for other in [("damper", 1.0), ("board", 0.1), ("spin", 0.0), ("damping", 0.0)] {
        let settings = [("motor", 2.0), ("spin", 40.0), ("damping", 0.3), other];
        assert!(!Hand::refusal("laundromat", &settings).is_empty());
    }
    let said = Hand::refusal("laundromat", &[("spin", 0.0), ("motor", 2.0)]);
    assert!(said.contains("turns nothing") && !said.contains("must be"), "{said}");
}

#[test]
fn cones_say_how_long_their_rims_are() {
    // What of its rim each cone has rolled off while the axis goes round once is as long as the other's.
    let hand = Hand::with("turning", &[("cones", 1.0), ("across", 6.0), ("spin", 9.0), ("ratio", 1.6)]);
    let [to_momentum, to_omega] =
        [r"angle of axis and $\boldsymbol{L}$", r"angle of axis and $\boldsymbol{\omega}$"]
            .map(|words| hand.reading(0.0, words).to_radians());
    let rims = to_omega.sin() / (to_omega - to_momentum).sin();
    assert!((number_behind(&hand.words(), "Its rim is ") - rims).abs() < 0.03, "{}: {rims}", hand.words());
}
