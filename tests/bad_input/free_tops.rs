//! Bodies, free tops and their scenes: coin, station, drag.

use super::Sign::{Any, NotNegative, NotZero, Positive};
use super::{Setter, brick, every_number_is_checked, message, turning};
use mechanics::euler::Turning;
use mechanics::free_rotation::{FreeSymmetricTop, FreeTop};
use mechanics::inertia::{Body, Cylinder, InertiaTensor, PrincipalMoments, Ring, Spheroid};
use mechanics::integrate::{Dop853, Failure};
use mechanics::scenes::air_drag::{Drag, DraggedTop, DraggedTopParameters};
use mechanics::scenes::coin_toss::{
    Flight, FlightParameters, Toss, TossParameters, angle_for_probability, edge_at_random,
    ratio_for_probability, steady_face_ratio,
};
use mechanics::scenes::pinned_hoop::{Pin, Pinning, PinningParameters, Shape};
use mechanics::scenes::space_station::{Blow, Station, StationParameters};
use mechanics::{Error, InvalidQuantity, Rule};
use nalgebra::{Matrix3, Quaternion, Rotation3, UnitQuaternion, Vector3};

fn disc() -> PrincipalMoments {
    Body::thin_disk(1.0, 1.0).expect("a disc").moments()
}

fn toss(moments: PrincipalMoments, omega_1: f64, omega_3: f64) -> Result<Toss, InvalidQuantity> {
    Toss::new(TossParameters { moments, omega_1, omega_3 })
}

/// What is said of a body without an axis of symmetry.
const UNEVEN: &str = "transverse moment I₂ 1.5 kg·m² is not 1 kg·m²";

#[test]
fn moments_must_be_those_of_a_body() {
    let numbers: [Setter<[f64; 3]>; 3] = [
        (|p| &mut p[0], "principal moment", "kg·m²", Positive),
        (|p| &mut p[1], "principal moment", "kg·m²", Positive),
        (|p| &mut p[2], "principal moment", "kg·m²", Positive),
    ];
    every_number_is_checked([1.0; 3], &numbers, |[a, b, c]| PrincipalMoments::new(a, b, c));
    let rule = Rule::NotAbove { what: "the sum of the other two", limit: 5.0 };
    for [a, b, c] in [[2.0, 3.0, 9.0], [9.0, 3.0, 2.0]] {
        let refused = PrincipalMoments::new(a, b, c).unwrap_err();
        assert_eq!((refused.quantity, refused.value, refused.rule), ("largest principal moment", 9.0, rule));
        let said = "largest principal moment 9 kg·m² exceeds the sum of the other two, 5 kg·m²";
        assert_eq!(refused.to_string(), said);
    }
    assert!(PrincipalMoments::symmetric(1.0, 0.0).is_err());
    // A flat body's largest moment may exceed the sum of the others by a few roundings, and by no more.
    assert!(PrincipalMoments::new(1.0, 1.0, 2.0 * (1.0 + 4.0 * f64::EPSILON)).is_ok());
    assert!(PrincipalMoments::new(1.0, 1.0, 2.0 * (1.0 + 6.0 * f64::EPSILON)).is_err());
}

#[test]
fn a_number_is_shown_in_plain_digits_from_a_ten_thousandth_to_ten_million() {
    for (mass, shown) in [
        (-1e-4, "-0.0001"),
        (-9.5e-5, "-9.5e-5"),
        (-9999999.0, "-9999999"),
        (-1e7, "-1e7"),
        (-0.0, "-0"),
        (f64::NEG_INFINITY, "-inf"),
    ] {
        assert!(message(Body::hoop(mass, 1.0)).starts_with(&format!("mass {shown} kg is not")), "{mass:e}");
    }
}

#[test]
fn shapes_say_which_number_is_wrong() {
    let mass_and_radius: [Setter<[f64; 2]>; 2] =
        [(|p| &mut p[0], "mass", "kg", Positive), (|p| &mut p[1], "radius", "m", Positive)];
    for body in [Body::hoop, Body::thin_disk, Body::sphere, Body::shell] {
        every_number_is_checked([1.0; 2], &mass_and_radius, |[mass, radius]| body(mass, radius));
    }
    every_number_is_checked(
        Ring { inner_radius: 0.5, outer_radius: 1.0, height: 0.0 },
        &[
            (|p| &mut p.inner_radius, "inner radius", "m", NotNegative),
            (|p| &mut p.height, "height", "m", NotNegative),
        ],
        |ring| Body::ring(1.0, ring),
    );
    let closed = Ring { inner_radius: 1.0, outer_radius: 1.0, height: 0.0 };
    assert_eq!(message(Body::ring(1.0, closed)), "inner radius 1 m is too large; it must be less than 1 m");
    let cylinder: [Setter<Cylinder>; 2] =
        [(|p| &mut p.radius, "radius", "m", Positive), (|p| &mut p.height, "height", "m", NotNegative)];
    every_number_is_checked(Cylinder { radius: 1.0, height: 0.1 }, &cylinder, |it| Body::cylinder(1.0, it));
    let round = Cylinder { radius: 1.0, height: 1.0 };
    every_number_is_checked(round, &cylinder, edge_at_random);
    every_number_is_checked(round, &cylinder, |it| toss(disc(), 1.0, 0.0).unwrap().landings(it));
    let edges: [Setter<[f64; 3]>; 3] = [
        (|p| &mut p[0], "edge", "m", Positive),
        (|p| &mut p[1], "edge", "m", Positive),
        (|p| &mut p[2], "edge", "m", Positive),
    ];
    every_number_is_checked([1.0; 3], &edges, |edges| Body::cuboid(1.0, edges));
    let spheroid: [Setter<Spheroid>; 2] = [
        (|p| &mut p.equatorial_radius, "equatorial radius", "m", Positive),
        (|p| &mut p.polar_radius, "polar radius", "m", Positive),
    ];
    let ball = Spheroid { equatorial_radius: 1.0, polar_radius: 1.0 };
    every_number_is_checked(ball, &spheroid, |it| Body::spheroid(1.0, it));
    every_number_is_checked(ball, &spheroid, |it| Drag::of_spheroid(it, 1.0));
    let viscosity: [Setter<f64>; 1] = [(|p| p, "viscosity", "Pa·s", Positive)];
    every_number_is_checked(1.0, &viscosity, |viscosity| Drag::of_spheroid(ball, viscosity));
    let mass: [Setter<f64>; 1] = [(|p| p, "mass", "kg", Positive)];
    every_number_is_checked(1.0, &mass, |mass| Body::new(mass, disc()));
    let far = Body::hoop(1.0, 1.0).unwrap().about(&Vector3::new(0.0, 1e60, 0.0)).unwrap_err();
    assert_eq!((far.quantity, far.value, far.rule), ("displacement", 1e60, Rule::InRange));
    let tensor = Body::hoop(1.0, 1.0).unwrap().about(&Vector3::new(1e20, 0.0, 0.0)).unwrap();
    // So far away the moment about the displacement is lost in rounding, and what is left is not a body.
    assert!(
        tensor.principal_axes().is_ok_and(|axes| axes.moments.to_array()[0] > 0.0)
            || tensor.principal_axes().is_err()
    );
}

#[test]
fn a_free_symmetric_top_needs_an_axis_and_numbers() {
    let error = FreeSymmetricTop::new(brick(), turning(Vector3::z())).unwrap_err();
    assert_eq!((error.quantity, error.value, error.rule), ("transverse moment I₂", 1.5, Rule::EqualTo(1.0)));
    assert_eq!(error.to_string(), "transverse moment I₂ 1.5 kg·m² is not 1 kg·m² to rounding");
    assert_eq!(
        message(FreeSymmetricTop::new(disc(), turning(Vector3::new(0.0, f64::NAN, 1.0)))),
        "angular velocity NaN rad/s is not a finite number"
    );
    assert_eq!(
        message(FreeSymmetricTop::new(disc(), turning(Vector3::new(1e70, 0.0, 1.0)))),
        "angular velocity 1e70 rad/s is outside the range from 1e-50 to 1e50 rad/s in size that is computed with"
    );
    for (omega, said) in
        [(f64::INFINITY, "inf rad/s is not a finite number"), (1e-60, "1e-60 rad/s is outside the range")]
    {
        let refused = message(FreeTop::new(brick(), turning(Vector3::new(1.0, omega, 1.0))));
        assert!(refused.starts_with(&format!("angular velocity {said}")), "{refused}");
    }
    let nowhere = UnitQuaternion::new_unchecked(Quaternion::new(f64::NAN, 0.0, 0.0, 0.0));
    let start = Turning { world_from_body: nowhere, omega_body: Vector3::z() };
    assert_eq!(
        message(FreeSymmetricTop::new(disc(), start)),
        "component of the attitude NaN is not a finite number"
    );
    let top = FreeSymmetricTop::new(disc(), turning(Vector3::z())).unwrap();
    for time in [f64::NAN, f64::INFINITY, 1e60] {
        assert!(matches!(top.at(time), Err(InvalidQuantity { quantity: "time", unit: "s", .. })));
        assert!(top.axis_world(time).is_err());
    }
    assert!(top.at(1e-300).is_ok() && top.at(-1e50).is_ok());
}

/// What is not a rotation at all, or one only roughly.
fn no_attitudes() -> impl Iterator<Item = (UnitQuaternion<f64>, &'static str)> {
    [0.0, 0.5, 1.0 + 1e-11, 1e200]
        .into_iter()
        .zip(["0", "0.5", "1.00000000001", "inf"])
        .map(|(w, shown)| (UnitQuaternion::new_unchecked(Quaternion::new(w, 0.0, 0.0, 0.0)), shown))
}

#[test]
fn an_attitude_is_a_quaternion_of_length_one() {
    let omega_body = Vector3::new(0.1, 0.2, 0.3);
    let drag = dragged(Drag::isotropic(0.1), omega_body).unwrap();
    let solver = Dop853::new(1e-9).unwrap();
    for (world_from_body, shown) in no_attitudes() {
        let start = Turning { world_from_body, omega_body };
        let expected = format!("length of the quaternion of the attitude {shown} is not 1 to rounding");
        assert_eq!(message(FreeTop::new(brick(), start)), expected);
        assert_eq!(message(FreeTop::new(disc(), start)), expected);
        assert_eq!(message(FreeSymmetricTop::new(disc(), start)), expected);
        assert_eq!(message(drag.thrown(world_from_body, &solver)), expected);
    }
    // Thousands of products leave some roundings behind: that is no reason to refuse.
    let worn = UnitQuaternion::new_unchecked(Quaternion::new(1.0 - 1e-13, 0.0, 0.0, 0.0));
    let start = Turning { world_from_body: worn, omega_body };
    assert!(FreeTop::new(brick(), start).is_ok() && FreeTop::new(disc(), start).is_ok());
    assert!(drag.thrown(worn, &solver).is_ok());
}

#[test]
fn times_beyond_the_range_are_refused_however_slow_the_body_and_by_lists_as_well() {
    for moments in [brick(), disc()] {
        let top = FreeTop::new(moments, turning(Vector3::new(1e-50, 2e-50, 1e-50))).unwrap();
        for time in [1.1e50, -1e60, 1e300] {
            assert_eq!(top.sample(&[time; 40]).unwrap_err(), top.at(time).unwrap_err());
        }
        assert!(top.sample(&[1e50; 40]).is_ok());
    }
}

#[test]
fn a_drag_that_never_ends_is_integrated_up_to_a_limit() {
    // A spin of a million turns a second for an hour.
    let top = dragged(Drag::isotropic(0.0), Vector3::new(1.0, 0.0, 6e6)).unwrap();
    let solver = Dop853::new(1e-9).unwrap().with_max_evaluations(100);
    let thrown = top.thrown(UnitQuaternion::identity(), &solver).unwrap();
    for stopped in [message(thrown.sample(&[3600.0])), message(thrown.at(3600.0))] {
        assert!(stopped.starts_with("the limit of evaluations was reached after 1"), "{stopped}");
    }
    let solver = solver.with_max_evaluations(10_000_000);
    let found = top.thrown(UnitQuaternion::identity(), &solver).unwrap().at(1e-6).unwrap();
    assert_eq!(found.omega_body, top.at(1e-6).unwrap());
}

#[test]
fn a_toss_needs_a_coin_that_turns_and_a_catch_that_it_reaches() {
    let toss = |moments, omega_1, omega_3| message(toss(moments, omega_1, omega_3));
    assert_eq!(toss(disc(), 0.0, 0.0), "tumble 0 rad/s: the twist is zero as well, and a tossed coin turns");
    assert!(toss(brick(), 1.0, 1.0).starts_with(UNEVEN));
    assert!(message(steady_face_ratio(brick())).starts_with(UNEVEN));
    assert_eq!(toss(disc(), f64::INFINITY, 1.0), "angular velocity inf rad/s is not a finite number");
    assert_eq!(toss(disc(), f64::NAN, 0.0), "angular velocity NaN rad/s is not a finite number");
    for (probability, said) in [
        (0.499, "0.499 is too small; it must be at least 0.5"),
        (-1.0, "-1 is too small; it must be at least 0.5"),
        (1.001, "1.001 is too large; it must be at most 1"),
        (f64::NAN, "NaN is not a finite number"),
    ] {
        let refused = message(angle_for_probability(probability));
        assert_eq!(refused, format!("probability of the same face {said}"));
        assert!(ratio_for_probability(disc(), probability).is_err());
    }
    let flight = FlightParameters { speed: 2.0, gravity: 10.0, catch_height: 0.1 };
    every_number_is_checked(
        flight,
        &[
            (|p| &mut p.gravity, "gravity", "m/s²", Positive),
            (|p| &mut p.catch_height, "catch height", "m", Any),
        ],
        Flight::new,
    );
    let thrown_down = message(Flight::new(FlightParameters { speed: -1.0, ..flight }));
    assert_eq!(thrown_down, "speed -1 m/s is negative; it must be zero or more");
    let beyond = message(Flight::new(FlightParameters { catch_height: 0.3, ..flight }));
    assert_eq!(beyond, "catch height 0.3 m exceeds the highest point of the flight, 0.2 m");
}

#[test]
fn a_station_turns_and_a_blow_is_finite() {
    let station = |body: Body, spin: f64| Station::new(StationParameters { body, spin });
    let ring = Body::hoop(1.0, 1.0).unwrap();
    assert_eq!(message(station(ring, 0.0)), "spin 0 rad/s must not be zero");
    assert_eq!(message(station(ring, f64::NAN)), "spin NaN rad/s is not a finite number");
    let brick = Body::cuboid(1.0, [1.0, 2.0, 3.0]).unwrap();
    assert!(message(station(brick, 1.0)).starts_with("transverse moment I₂"));
    let station_turning = station(ring, 1.0).unwrap();
    let strike = |radius: f64, impulse: f64| station_turning.struck(Blow { radius, impulse });
    assert_eq!(message(strike(-1.0, 1.0)), "radius of the blow -1 m is negative; it must be zero or more");
    assert_eq!(message(strike(1.0, f64::INFINITY)), "impulse inf N·s is not a finite number");
    let light = station(Body::hoop(1e-10, 1.0).unwrap(), 1.0).unwrap();
    let strong = light.struck(Blow { radius: 1.0, impulse: 1e45 });
    assert!(message(strong).starts_with("impulse 1e45 N·s: for this station it gives"));
    assert!(strike(1.0, 0.0).is_ok() && strike(0.0, 1.0).is_ok());
    let struck = strike(1.0, 0.5).unwrap();
    assert_eq!(
        message(struck.position(&Vector3::new(0.0, f64::NAN, 0.0), 1.0)),
        "position of the point NaN m is not a finite number"
    );
    assert!(struck.position(&Vector3::x(), f64::INFINITY).is_err());
    assert_eq!(message(struck.sample(&[1.0, f64::NAN])), "time NaN s is not a finite number");
}

fn dragged(drag: Drag, omega_body: Vector3<f64>) -> Result<DraggedTop, InvalidQuantity> {
    DraggedTop::new(DraggedTopParameters { moments: disc(), drag, omega_body })
}

#[test]
fn drag_is_not_negative_and_a_slowing_body_spins() {
    let coefficients: [Setter<Drag>; 2] = [
        (|p| &mut p.transverse, "transverse drag coefficient", "N·m·s", NotNegative),
        (|p| &mut p.axial, "axial drag coefficient", "N·m·s", NotNegative),
    ];
    every_number_is_checked(Drag::isotropic(0.1), &coefficients, |drag| dragged(drag, Vector3::z()));
    let still = dragged(Drag::isotropic(0.1), Vector3::zeros());
    assert_eq!(message(still), "angular velocity 0 rad/s must not be zero");
    let (drag, omega_body) = (Drag::isotropic(0.1), Vector3::z());
    let uneven = DraggedTop::new(DraggedTopParameters { moments: brick(), drag, omega_body });
    assert!(message(uneven).starts_with(UNEVEN));
    let top = dragged(drag, Vector3::new(1.0, 0.0, 1.0)).unwrap();
    assert_eq!(message(top.at(-1.0)), "time -1 s is negative; it must be zero or more");
    assert_eq!(message(top.sample(&[1.0, -1.0])), "time -1 s is negative; it must be zero or more");
    assert!(top.axis_angle(f64::NAN).is_err());
    let thrown = top.thrown(UnitQuaternion::identity(), &Dop853::new(1e-9).unwrap()).unwrap();
    assert_eq!(message(thrown.sample(&[0.0, f64::NAN])), "time NaN s is not a finite number");
    assert_eq!(message(thrown.at(-1.0)), "time -1 s is negative; it must be zero or more");
    assert!(matches!(
        thrown.sample(&[2.0, 1.0]),
        Err(Error::Integration(Failure::SampleTime { index: 1, .. }))
    ));
    assert_eq!(thrown.sample(&[]), Ok(Vec::new()));
}

#[test]
fn decay_rates_are_of_a_size_that_is_computed_with() {
    let moments = PrincipalMoments::symmetric(1e-30, 1.5e-30).unwrap();
    for (drag, name) in [
        (Drag { transverse: 1e30, axial: 1.0 }, "transverse drag coefficient 1e30 N·m·s:"),
        (Drag { transverse: 1.0, axial: 1.5e30 }, "axial drag coefficient 1.5e30 N·m·s:"),
    ] {
        let omega_body = Vector3::new(1.0, 0.0, 1.0);
        let refused = message(DraggedTop::new(DraggedTopParameters { moments, drag, omega_body }));
        assert!(refused.starts_with(name), "{refused}");
    }
}

#[test]
fn a_message_names_what_was_given_and_not_what_follows_from_it() {
    let spheroid = |equatorial_radius: f64, polar_radius: f64, viscosity: f64| {
        Drag::of_spheroid(Spheroid { equatorial_radius, polar_radius }, viscosity)
    };
    let ratio = "over the equatorial radius it gives a ratio";
    assert!(message(spheroid(1e30, 1e-30, 1.0)).starts_with(&format!("polar radius 1e-30 m: {ratio}")));
    let drag = "with these radii it gives a drag";
    assert!(message(spheroid(1e20, 1e20, 1.0)).starts_with(&format!("viscosity 1 Pa·s: {drag}")));
    assert!(message(spheroid(1e-20, 1e-20, 1.0)).starts_with(&format!("viscosity 1 Pa·s: {drag}")));
    let thin = edge_at_random(Cylinder { radius: 1e40, height: 1e-40 });
    assert!(message(thin).starts_with("height 1e-40 m: over the diameter it gives a ratio"));
}

#[test]
fn principal_axes_belong_to_a_body() {
    let entered = |[xx, xy, yx, yy, zz]: [f64; 5]| {
        message(InertiaTensor::new(Matrix3::new(xx, xy, 0.0, yx, yy, 0.0, 0.0, 0.0, zz)))
    };
    assert_eq!(
        entered([2.0, 0.5, -0.5, 2.0, 3.0]),
        "product of inertia I₂₁ -0.5 kg·m² is not 0.5 kg·m² to rounding"
    );
    assert_eq!(
        entered([1.0, 3.0, 3.0, 1.0, 3.0]),
        "principal moment -2 kg·m² is not positive; it must be more than zero"
    );
    assert_eq!(
        entered([2.0, 0.0, 0.0, 2.0, 5.0]),
        "largest principal moment 5 kg·m² exceeds the sum of the other two, 4 kg·m²"
    );
    assert_eq!(
        entered([f64::NAN, 0.0, 0.0, 2.0, 5.0]),
        "entry of the inertia tensor NaN kg·m² is not a finite number"
    );
    for huge in [1e60, 1e200, 1e308, f64::MAX] {
        assert!(entered([huge, 0.5 * huge, 0.5 * huge, huge, huge]).contains("kg·m² is"), "{huge:e}");
    }
    // Rounding on both sides of the diagonal is no reason to refuse, nor is what it leaves off it.
    let rounded = Matrix3::new(2.0, 0.5 + 1e-14, 1e-70, 0.5, 2.0, 0.0, 0.0, 0.0, 3.0);
    assert!(InertiaTensor::new(rounded).is_ok());
    for (name, row, column) in [("I₂₁", 1, 0), ("I₃₁", 2, 0), ("I₃₂", 2, 1)] {
        let mut matrix = Matrix3::from_diagonal_element(1.0);
        matrix[(column, row)] = 3e-14;
        assert_eq!(
            message(InertiaTensor::new(matrix)),
            format!("product of inertia {name} 0 kg·m² is not 3e-14 kg·m² to rounding")
        );
    }
    let nowhere = Rotation3::from_matrix_unchecked(Matrix3::from_element(f64::NAN));
    let lost = InertiaTensor::principal(disc()).rotated(&nowhere);
    assert!(message(lost.principal_axes()).contains("is not a finite number"));
    // What is no rotation gives no body: here it stretches axis 3.
    let stretch = Rotation3::from_matrix_unchecked(Matrix3::from_diagonal(&Vector3::new(1.0, 1.0, 2.0)));
    let none = InertiaTensor::principal(disc()).rotated(&stretch);
    assert!(message(none.principal_axes()).contains("exceeds the sum of the other two"), "{none:?}");
    // A flat body's are those of a body to rounding, however small it is.
    let small = PrincipalMoments::new(1e-20, 2e-20, 3e-20).unwrap();
    let turned = InertiaTensor::principal(small).rotated(&Rotation3::new(Vector3::new(0.3, 1.0, 0.2)));
    assert!(turned.principal_axes().is_ok());
}

#[test]
fn a_pinned_body_spins_and_its_point_lies_on_it() {
    let hoop =
        PinningParameters { shape: Shape::Hoop, mass: 1.0, radius: 1.0, spin: 1.0, pin: Pin::Angle(1.0) };
    every_number_is_checked(
        hoop,
        &[
            (|p| &mut p.spin, "spin", "rad/s", NotZero),
            (|p| &mut p.mass, "mass", "kg", Positive),
            (|p| &mut p.radius, "radius", "m", Positive),
        ],
        Pinning::new,
    );
    let angle: [Setter<f64>; 1] = [(|p| p, "angle from the axis", "rad", NotNegative)];
    let at_angle = |angle| Pinning::new(PinningParameters { pin: Pin::Angle(angle), ..hoop });
    every_number_is_checked(1.0, &angle, at_angle);
    let beyond = "angle from the axis 3.2 rad is too large; it must be at most 3.14159";
    assert!(message(at_angle(3.2)).starts_with(beyond));
    let sphere = PinningParameters { shape: Shape::Sphere, ..hoop };
    let at = |from_axis: f64, height: f64| {
        Pinning::new(PinningParameters { pin: Pin::Point { from_axis, height }, ..sphere })
    };
    assert_eq!(message(at(0.0, 0.5)), "distance of the point from the centre 0.5 m is not 1 m to rounding");
    assert!(at(0.3, 0.3).is_err());
    assert_eq!(
        message(at(f64::INFINITY, 0.0)),
        "distance of the point from the axis inf m is not a finite number"
    );
    assert_eq!(message(at(1.0, f64::NAN)), "height of the point NaN m is not a finite number");
    assert_eq!(
        message(at(-0.6, 0.8)),
        "distance of the point from the axis -0.6 m is negative; it must be zero or more"
    );
    assert_eq!(at(0.6, -0.8).unwrap().angle(), f64::atan2(0.6, -0.8));
    let pin = Pin::Point { from_axis: 0.6, height: 0.8 };
    let inside_out = PinningParameters { radius: -1.0, pin, ..sphere };
    assert!(message(Pinning::new(inside_out)).starts_with("radius -1 m"));
    let pin = Pin::Point { from_axis: 0.0, height: 1.1e-9 };
    assert!(Pinning::new(PinningParameters { radius: 1e-9, pin, ..hoop }).is_err());
    // To rounding, and not beyond, on either side of the surface.
    for (distance, lies_on_it) in
        [(1.0 + 5e-13, true), (1.0 - 5e-13, true), (1.0 + 2e-12, false), (1.0 - 2e-12, false)]
    {
        assert_eq!(at(0.0, distance).is_ok(), lies_on_it, "{distance}");
    }
}
