//! The pinned hoop, the rolling wheel and the spinning coin: formulas and equations of motion written out here.

use crate::{PIXELS, curve, lies_on};
use std::f64::consts::PI;

/// One Runge-Kutta step.
pub(crate) fn step<const N: usize>(
    rates: impl Fn(f64, [f64; N]) -> [f64; N],
    t: f64,
    y: [f64; N],
    h: f64,
) -> [f64; N] {
    let along = |k: [f64; N], h: f64| std::array::from_fn(|n| y[n] + h * k[n]);
    let k1 = rates(t, y);
    let k2 = rates(t + 0.5 * h, along(k1, 0.5 * h));
    let k3 = rates(t + 0.5 * h, along(k2, 0.5 * h));
    let k4 = rates(t + h, along(k3, h));
    std::array::from_fn(|n| y[n] + h / 6.0 * (k1[n] + 2.0 * k2[n] + 2.0 * k3[n] + k4[n]))
}

#[test]
fn the_speeds_of_b_are_a_difference_a_sum_and_a_root() {
    let parts = |degrees: f64| (degrees.to_radians().sin() / 3.0, degrees.to_radians().cos());
    lies_on("speed-of-b", "plus", |degrees| (parts(degrees).0 - parts(degrees).1).abs());
    lies_on("speed-of-b", "minus", |degrees| parts(degrees).0 + parts(degrees).1);
    lies_on("speed-of-b", "stated", |degrees| parts(degrees).0.hypot(parts(degrees).1));
}

#[test]
fn the_hoop_flips_as_eulers_equations_say() {
    // Moments 3/2, 1/2 and 2 about the pin.
    let rates = |_: f64, [a, b, c]: [f64; 3]| [-b * c, c * a, 0.5 * a * b];
    let angle = 89.9_f64.to_radians();
    let h = 0.005;
    let mut motion = vec![[angle.sin() / 3.0, -angle.cos(), 0.0]];
    for n in 0..30_000 {
        motion.push(step(rates, 0.0, motion[n], h));
    }
    for (axis, name) in [(0, "tangent"), (1, "diameter")] {
        lies_on("flip", name, |time| {
            let n = (time / h) as usize;
            step(rates, 0.0, motion[n], time - h * n as f64)[axis]
        });
    }
}

#[test]
fn the_portrait_is_that_of_a_pendulum_let_go_at_the_angle_of_each_pin() {
    // χ̈ = ¼ W² sin 2χ, with time in 1/W.
    let rates = |_: f64, [angle, rate]: [f64; 2]| [rate, 0.25 * (2.0 * angle).sin()];
    for theta in [60.0_f64, 80.0, 89.0] {
        let drawn = curve("hoop-pendulum", &format!("pin-{theta}"));
        let mut state = [(3.0 / theta.to_radians().tan()).atan(), 0.0];
        let mut widest: f64 = 0.0;
        for _ in 0..4000 {
            state = step(rates, 0.0, state, 0.005);
            let off = drawn.distance((state[0].to_degrees(), state[1]));
            assert!(off < PIXELS, "{theta}: {state:?}: {off}");
            widest = widest.max(state[0]);
        }
        let other_end = 180.0 - (3.0 / theta.to_radians().tan()).atan().to_degrees();
        assert!((widest.to_degrees() - other_end).abs() < 0.01, "{theta}: it swings to {widest}");
    }
    // Energies: that of the balance, and that of a start at χ = 0 with a rate of 0.45 W.
    for (name, sign, start) in [("above", 1.0, 0.45_f64), ("below", -1.0, 0.45)] {
        let rate = |degrees: f64, start: f64| {
            sign * (start * start + 0.25 * (1.0 - (2.0 * degrees.to_radians()).cos())).sqrt()
        };
        lies_on("hoop-pendulum", &format!("over-{name}"), |degrees| rate(degrees, start));
        let outside = |degrees: f64| if (0.0..180.0).contains(&degrees) { 1.0 } else { -1.0 };
        lies_on("hoop-pendulum", &format!("separatrix-{name}"), |degrees| {
            outside(degrees) * rate(degrees, 0.0)
        });
    }
}

#[test]
fn the_turn_rate_of_a_disc_follows_its_formula() {
    let square = |lean: f64, b: f64| 2.0 * lean.tan() / (3.0 * b + 0.5 * lean.sin());
    for degrees in [20.0_f64, 45.0, 70.0] {
        lies_on("turn-rate", &format!("lean-{degrees}"), |b| square(degrees.to_radians(), b));
    }
}

#[test]
fn waits_are_integrals_of_the_pendulum_and_of_a_steady_turn() {
    // The time from χ₀ to 90°, of χ̇² = λ²(cos²χ₀ − cos²χ): with cos χ = cos χ₀ sin ξ and tan ξ = e^ζ/√k′ an integral
    // over a plateau, which equal steps add up at once.
    let wait = |survival: f64, growth: f64, gap: f64| {
        let (tangent, diameter) = (survival * (1.0 - gap * gap).sqrt(), gap);
        let plane = tangent.hypot(diameter);
        let k1 = diameter / plane; // k′ = sin χ₀
        let step = 0.05;
        let reach = (0.5 * (1.0 / k1).ln() + 40.0) / step;
        let values = (-(reach as i32)..=reach as i32)
            .map(|n| 1.0 / (1.0 + k1 * k1 + 2.0 * k1 * (2.0 * step * f64::from(n)).cosh()).sqrt());
        step * values.sum::<f64>() / (plane * growth)
    };
    lies_on("waits", "hoop", |gap| wait(1.0 / 3.0, 0.5_f64.sqrt(), gap));
    lies_on("waits", "disc", |gap| wait(0.2, (2.0_f64 / 3.0).sqrt(), gap));
    let ball = curve("waits", "ball");
    for step in 0..200 {
        let gap = 0.0076 * 120_f64.powf(f64::from(step) / 200.0);
        assert!(ball.distance((gap, 0.7 * PI / gap)) < PIXELS, "{gap}");
    }
}

#[test]
fn the_potential_is_the_energy_of_spin_and_height() {
    // Across and along spin as functions of the lean, from the motion of the text: 0.45 and 0.9 at 0.3.
    let rates = |lean: f64, [across, along]: [f64; 2]| [across * lean.tan() + 2.0 * along, across / 1.5];
    lies_on("potential", "potential", |degrees| {
        let (start, lean) = (0.3, degrees.to_radians());
        let h = (lean - start) / 200.0;
        let end = (0..200).fold([0.45, 0.9], |spins, n| step(rates, start + h * f64::from(n), spins, h));
        0.5 * (0.25 * end[0] * end[0] + 1.5 * end[1] * end[1]) + lean.cos()
    });
}

#[test]
fn the_tilt_goes_to_zero_like_a_power_of_the_time_left() {
    for power in [2.0_f64, 1.25, 1.0, 0.5] {
        // The energy goes like sin α: d(sin α)/dt ∝ −1/sinᵖ α.
        let tilt = |part: f64| (0.1_f64.sin() * part.powf(1.0 / (power + 1.0))).asin();
        lies_on("spin-down", &format!("law-{power}"), |time| tilt(1.0 - time / 100.0));
        lies_on("spin-down", &format!("end-{power}"), |left| tilt(left / 100.0));
    }
}

#[test]
fn the_circle_of_the_centre_opens_as_the_film_has_it() {
    lies_on("circle-opens", "law", |tilt| 4000.0 / 9.0 * (0.1_f64.powf(1.5) * tilt.sqrt() - tilt * tilt));
    let (mass, radius, gravity) = (0.4_f64, 0.0375_f64, 9.81_f64);
    let film = std::f64::consts::PI * 1.78e-5 * radius / (4.0 * mass) * (radius / gravity).sqrt();
    // The lean from lying flat, its rate, and the other two angular velocities, in units of a and √(a/g).
    let rates = |_: f64, [tilt, sink, across, along]: [f64; 4]| {
        let (sin, cos) = tilt.sin_cos();
        let (frame, damping) = (across * cos / sin, film / sin.powi(3));
        [
            -sink,
            (cos - 1.5 * along * across - 0.25 * frame * across - damping * sink) / 1.25,
            sink * (frame + 2.0 * along) - 4.0 * damping * across,
            sink * across / 1.5,
        ]
    };
    let drawn = curve("circle-opens", "motion");
    let mut state = [0.1_f64, 0.0, 2.0 * 0.1_f64.sin().sqrt(), 0.0];
    let end = 95.0 / (radius / gravity).sqrt();
    let h = 0.002;
    for n in 1..=(end / h) as u32 {
        state = step(rates, 0.0, state, h);
        if n % 7919 == 0 {
            let pair = (state[0], 1e3 * state[3] * state[0].sin() / state[2]);
            let off = drawn.distance(pair);
            assert!(off < 0.3, "{pair:?}: {off}"); // the wobbles on the way are narrower than the line
        }
    }
    assert!(state[0] < 0.02, "only sunk to {}", state[0]);
}

/// The second difference of the energy at a lean near a steady one, with the spins that the motion has there.
fn curvature([i1, i3]: [f64; 2], b: f64, steady: f64) -> f64 {
    let rate = (steady.tan() / ((1.0 + i3) * b + i1 * steady.sin())).sqrt();
    let rates =
        |lean: f64, [across, along]: [f64; 2]| [across * lean.tan() + i3 / i1 * along, across / (1.0 + i3)];
    let energy = |lean: f64| {
        let h = (lean - steady) / 10.0;
        let [across, along] = (0..10).fold([rate * steady.cos(), rate * b], |spins, n| {
            step(rates, steady + h * f64::from(n), spins, h)
        });
        0.5 * (i1 * across * across + (1.0 + i3) * along * along) + lean.cos()
    };
    let h = 1e-3;
    energy(steady + h) - 2.0 * energy(steady) + energy(steady - h)
}

#[test]
fn the_tongues_end_where_the_well_of_the_potential_becomes_flat() {
    for (figure, name, moments) in [
        ("tongue", "hoop", [0.5, 1.0]),
        ("tongue", "disc", [0.25, 0.5]),
        ("tongue-tips", "hoop", [0.5, 1.0]),
        ("tongue-tips", "disc", [0.25, 0.5]),
        ("tongue-tips", "weights", [2.0, 0.5]),
        ("tongue-tips", "beads", [0.1, 0.002]),
    ] {
        let values = curve(figure, name).values();
        assert!(values.len() > 50);
        let mut checked = 0;
        // Not below half a degree, where the step of the difference is no longer small.
        for &(b, degrees) in values.iter().filter(|value| value.1 > 0.5) {
            let [below, above] =
                [-0.05, 0.05].map(|off: f64| curvature(moments, b, (degrees + off).to_radians()));
            assert!(
                below < 0.0 && above > 0.0,
                "{figure}, {name}: b = {b}, {degrees}°: {below:e}, {above:e}"
            );
            checked += 1;
        }
        assert!(checked > 40, "{figure}, {name}: only {checked}");
    }
}

#[test]
fn the_contact_of_a_wheel_that_is_almost_flat_runs_round_as_its_equations_say() {
    for (i1, name) in [(0.25, "disc"), (0.5, "hoop")] {
        // Tilt, its rate, the other two angular velocities and the heading, in units of a and √(a/g).
        let rates = |_: f64, [tilt, rise, across, along, _]: [f64; 5]| {
            let (sin, cos) = tilt.sin_cos();
            let frame = across * cos / sin;
            [
                rise,
                -(cos - (1.0 + 2.0 * i1) * along * across - i1 * frame * across) / (1.0 + i1),
                -rise * (frame + 2.0 * along),
                -rise * across / (1.0 + 2.0 * i1),
                across / sin,
            ]
        };
        lies_on("near-flat-turn", name, |part| {
            let tilt = 0.05_f64;
            let mut state = [tilt, 0.0, part * (tilt.sin() / i1).sqrt(), 0.0, 0.0];
            // Down, and up until it turns back; steps become shorter with the tilt.
            let mut was_rising = false;
            loop {
                let next = step(rates, 0.0, state, 0.05 * state[0]);
                if was_rising && next[1] <= 0.0 {
                    let share = state[1] / (state[1] - next[1]);
                    return (state[4] + share * (next[4] - state[4])).to_degrees();
                }
                was_rising = next[1] > 0.0;
                state = next;
            }
        });
    }
}

#[test]
fn the_rosette_is_drawn_by_eulers_equations() {
    // Moments 3/2, 1/2 and 2 about the pin, attitude w, x, y, z, and ω along the body's axes.
    let rates = |_: f64, [w, x, y, z, a, b, c]: [f64; 7]| {
        [
            -0.5 * (x * a + y * b + z * c),
            0.5 * (w * a + y * c - z * b),
            0.5 * (w * b + z * a - x * c),
            0.5 * (w * c + x * b - y * a),
            -b * c,
            c * a,
            0.5 * a * b,
        ]
    };
    let cross = |[a, b, c]: [f64; 3], [x, y, z]: [f64; 3]| [b * z - c * y, c * x - a * z, a * y - b * x];
    let add =
        |a: [f64; 3], b: [f64; 3], factor: f64| -> [f64; 3] { std::array::from_fn(|n| a[n] + factor * b[n]) };
    let (sin, cos) = 60_f64.to_radians().sin_cos();
    let start = [1.0, 0.0, 0.0, 0.0, sin / 3.0, -cos, 0.0];
    let length = (0.25 * sin * sin + 0.25 * cos * cos).sqrt();
    let momentum = [0.5 * sin / length, -0.5 * cos / length, 0.0];
    // The shortest turn that takes the momentum upright.
    let axis = cross(momentum, [0.0, 0.0, 1.0]);
    let [late, first] = ["rosette", "first-period"].map(|name| curve("herpolhode", name));
    let [omega, about_pin] = ["omega-in-hoop", "momentum-in-hoop"].map(|name| curve("herpolhode", name));
    let (h, mut state) = (0.005, start);
    for n in 1..16_000 {
        state = step(rates, 0.0, state, h);
        if n % 37 != 0 {
            continue;
        }
        let in_the_hoop =
            [omega.distance((state[4], state[6])), about_pin.distance((1.5 * state[4], 2.0 * state[6]))];
        assert!(in_the_hoop.iter().all(|off| *off < PIXELS), "{state:?}: {in_the_hoop:?}");
        let [w, x, y, z, a, b, c] = state;
        let twice = cross([x, y, z], [a, b, c]).map(|part| 2.0 * part);
        let room = add(add([a, b, c], twice, w), cross([x, y, z], twice), 1.0);
        let turned = add(add(room, cross(axis, room), 1.0), cross(axis, cross(axis, room)), 1.0);
        let off = late.distance((turned[0], turned[1])).min(first.distance((turned[0], turned[1])));
        assert!(off < PIXELS, "{turned:?}: {off}");
    }
    // In its first period ω goes round by 279°, as the page says: in which sense, and over the top, a reader sees.
    let ends = [0, first.points.len() - 1].map(|n| first.values()[n]).map(|(x, y)| y.atan2(x).to_degrees());
    assert!(((ends[1] - ends[0]).rem_euclid(360.0) - 278.59).abs() < 0.1, "{ends:?}");
}

#[test]
fn the_track_of_the_contact_is_that_of_all_wobbles_integrated() {
    // A disc: lean, its rate, the other two angular velocities, heading, and the centre.
    let rates = |_: f64, [lean, rate, across, along, heading, _, _]: [f64; 7]| {
        let (sin, cos) = lean.sin_cos();
        let frame = across * sin / cos;
        let (s, c) = heading.sin_cos();
        [
            rate,
            (sin - 1.5 * along * across - 0.25 * frame * across) / 1.25,
            rate * (frame + 2.0 * along),
            rate * across / 1.5,
            across / cos,
            -along * c + rate * cos * s,
            -along * s - rate * cos * c,
        ]
    };
    let contact = |[lean, _, _, _, heading, x, y]: [f64; 7]| {
        let (s, c) = heading.sin_cos();
        (x - s * lean.sin(), y + c * lean.sin())
    };
    let lean: f64 = 0.55;
    let turn = (2.0 * lean.tan() / (3.0 * 1.6 + 0.5 * lean.sin())).sqrt();
    let mut state = [lean, 0.3, turn * lean.cos(), turn * 1.6, 0.0, 0.0, 1.6];
    let [all, half] = ["all", "half"].map(|name| curve("contact-track", name));
    let (h, mut turns) = (0.002, 0);
    for n in 0.. {
        let next = step(rates, 0.0, state, h);
        if (next[1] > 0.0) != (state[1] > 0.0) {
            turns += 1;
            if turns <= 2 {
                let end = half.points[if turns == 1 { 0 } else { half.points.len() - 1 }];
                let found = half.axes.point(contact(next));
                let off = (found.x - end.0).hypot(found.y - end.1);
                assert!(off < 0.2, "{turns}: {off}"); // a step is 0.1 px
            }
        }
        state = next;
        if turns > 22 {
            break;
        }
        if turns > 0 && n % 50 == 0 {
            let off = all.distance(contact(state));
            assert!(off < PIXELS, "{turns} turns: {off}");
        }
    }
}

#[test]
fn wheels_are_joined_whose_worst_circle_just_lasts() {
    for degrees in [20.0_f64, 25.0, 30.0] {
        let values = curve("tip-of-shape", &format!("tip-{degrees}")).values();
        assert!(values.len() > 8, "{degrees}: {}", values.len());
        for (i1, i3) in values {
            // The brace of eq:nutation, and its least value over all radii, by halving between its slopes.
            let brace = |b: f64, lean: f64| {
                let (sin, cos) = lean.sin_cos();
                cos * cos
                    + 3.0 * i1 * sin * sin
                    + b / sin * ((1.0 + 3.0 * i3) * sin * sin - (1.0 + i3) * cos * cos)
                    + (1.0 + i3) * i3 / i1 * b * b
            };
            let least = |lean: f64| {
                let (mut low, mut high) = (0.0, 1e3);
                for _ in 0..60 {
                    let middle = 0.5 * (low + high);
                    let falls = brace(middle + 1e-6, lean) < brace(middle - 1e-6, lean);
                    *(if falls { &mut low } else { &mut high }) = middle;
                }
                brace(low, lean)
            };
            let [below, above] = [-0.1, 0.1].map(|off| least((degrees + off).to_radians()));
            assert!(below < 0.0 && above > 0.0, "{degrees}: {i1}, {i3}: {below}, {above}");
        }
    }
}

#[test]
fn the_ways_down_are_those_of_a_disc_with_a_very_weak_brake() {
    // Lean, its rate and the other two angular velocities, in units of a and √(a/g), with the torque −Γω.
    let slowing = 5e-4;
    let rates = |_: f64, [lean, sink, across, along]: [f64; 4]| {
        let (sin, cos) = lean.sin_cos();
        let frame = across * sin / cos;
        [
            sink,
            (sin - 1.5 * along * across - 0.25 * frame * across - slowing * sink) / 1.25,
            sink * (frame + 2.0 * along) - 4.0 * slowing * across,
            (sink * across - slowing * along) / 1.5,
        ]
    };
    for name in [
        "straight-1",
        "straight-3",
        "straight-10",
        "spin-1",
        "spin-10",
        "spin-30",
        "edge-10",
        "edge-13",
        "edge-15",
        "edge-18",
    ] {
        let drawn = curve("ways-down", name);
        // Well above the edge, where a wobble is quick beside the loss.
        let values = drawn.values();
        let higher = values[0].1 + 9.0;
        let &(b, degrees) = values.iter().find(|value| value.1 > higher).expect("a way up");
        let lean = degrees.to_radians();
        let rate = (lean.tan() / (1.5 * b + 0.25 * lean.sin())).sqrt();
        let mut state = [lean, 0.0, rate * lean.cos(), rate * b];
        let (mut count, mut highest) = (0_u32, lean);
        while state[0] < 1.3 && count < 400_000 {
            state = step(rates, 0.0, state, 0.03);
            count += 1;
            highest = highest.max(state[0]);
            if count % 997 == 0 {
                let pair = (state[3] * state[0].cos() / state[2], state[0].to_degrees());
                let off = drawn.distance(pair);
                assert!(off < 0.7, "{name}: {pair:?}: {off}");
            }
        }
        assert!(highest > 1.25, "{name}: only to {highest}");
    }
}
/// The toy on its way down by a law of loss with which it lives for 100 s: tilt, its rate, ω₂ and ω₃ in units of a and
/// √(a/g), one after the other, and the times.
struct Followed {
    power: f64,
    strength: f64,
    states: Vec<(f64, [f64; 4])>,
}

impl Followed {
    fn new(power: f64, last: f64) -> Self {
        // The energy 3/2 sin α is lost with 4B/sinᵖ α.
        let life = 100.0 / (0.0375_f64 / 9.81).sqrt();
        let strength = 1.5 * 0.1_f64.sin().powf(power + 1.0) / (4.0 * (power + 1.0) * life);
        let mut followed = Self { power, strength, states: Vec::new() };
        let sinking = -0.1_f64.tan() / ((power + 1.0) * life);
        let (mut time, mut state) = (0.0, [0.1, sinking, 2.0 * 0.1_f64.sin().sqrt(), 0.0]);
        while state[0] > last {
            followed.states.push((time, state));
            let held = 4.0 * strength / state[0].powf(power + 1.0);
            let h = (0.03 * state[0].sqrt()).min(0.2 / held);
            (time, state) = (time + h, step(|_, y| followed.rates(y), 0.0, state, h));
        }
        followed
    }

    fn rates(&self, [tilt, rising, across, axle]: [f64; 4]) -> [f64; 4] {
        let (sin, cos) = tilt.sin_cos();
        let drag = self.strength / sin.powf(self.power + 1.0);
        let frame = 0.25 * across * cos / sin;
        [
            rising,
            (-cos + 1.5 * axle * across + frame * across - drag * rising) / 1.25,
            -4.0 * (rising * (frame + 0.5 * axle) + drag * across),
            -rising * across / 1.5,
        ]
    }

    /// Time and state at a tilt.
    fn at(&self, tilt: f64) -> (f64, [f64; 4]) {
        let next = self.states.partition_point(|(_, state)| state[0] > tilt);
        let ((before, state), (after, _)) = (self.states[next - 1], self.states[next]);
        let (mut from, mut to) = (0.0, after - before);
        for _ in 0..40 {
            let middle = 0.5 * (from + to);
            let there = step(|_, y| self.rates(y), 0.0, state, middle);
            if there[0] > tilt { from = middle } else { to = middle }
        }
        (before + from, step(|_, y| self.rates(y), 0.0, state, from))
    }
}

#[test]
fn the_disk_ends_as_its_equations_have_it() {
    for power in [2.0_f64, 1.25, 1.0, 0.5] {
        let s = 1.0 / (power + 1.0);
        // Where the law falls with g: s(1 − s) a α = g (t₀ − t)².
        let (sin, fall) = (0.1_f64.sin(), s * (1.0 - s) * 0.0375 / 9.81);
        let left = (fall * sin * 100_f64.powf(-s)).powf(1.0 / (2.0 - s));
        let last = (sin * (left / 100.0).powf(s)).asin();
        let followed = Followed::new(power, 0.2 * last);
        let time = |tilt: f64| followed.at(tilt).0;
        lies_on("four-exponents", &format!("exponent-{power}"), |tilt| {
            if tilt > 0.0645 || tilt < 0.3 * last {
                return f64::NAN; // no curve there
            }
            let root = 2_f64.sqrt();
            let [high, middle, low] = [root * tilt, tilt, tilt / root].map(time);
            let exponent = root.ln() / ((middle - high) / (low - middle)).ln();
            if exponent < 0.85 { exponent } else { f64::NAN }
        });
        let carried = |state: [f64; 4]| {
            1.0 + followed.rates(state)[1] * state[0].cos() - state[1] * state[1] * state[0].sin()
        };
        lies_on("table-holds", &format!("support-{power}"), |part| {
            let is_drawn = part > 0.46 && part * last < 0.089;
            if is_drawn { carried(followed.at(part * last).1) } else { f64::NAN }
        });
        lies_on("table-holds", &format!("law-support-{power}"), |part| 1.0 - part.powf(-2.0 * power - 1.0));
        let speed = (0.0375_f64 * 9.81).sqrt() / 343.0;
        lies_on("table-holds", &format!("contact-{power}"), |tilt| {
            let is_drawn = tilt > 0.36 * last && tilt < 0.089;
            if is_drawn { speed * followed.at(tilt).1[2] / tilt.tan() } else { f64::NAN }
        });
    }
    lies_on("table-holds", "steady", |tilt| {
        2.0 * (0.0375_f64 * 9.81).sqrt() * tilt.cos() / tilt.sin().sqrt() / 343.0
    });
}
