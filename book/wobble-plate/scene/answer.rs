//! The answer to the chapter's question, in words.

use super::{PLATE_MASS, RADIUS, Shaking, torque_range};

/// What a number of pistons does to the frame.
pub(super) fn answer(shaking: &Shaking) -> String {
    let Shaking { engine, spin, mass, balancing, .. } = shaking;
    let count = shaking.count();
    if *spin == 0.0 {
        return "At rest nothing shakes, whatever the pistons weigh.".into();
    }
    if engine.plate().tilt() == 0.0 {
        return "Square to its shaft the plate is a flywheel: the pistons stand still, and nothing shakes."
            .into();
    }
    let alone = engine.plate().bearing_torque_rotating(*spin).norm();
    let own = engine.plate().bearing_torque_rotating(1.0).y;
    // As a part of what the same mass would ask for as a thin plate.
    let is_round = own.abs() < 1e-3 * (0.25 * PLATE_MASS * RADIUS * RADIUS);
    if is_round {
        let [_, most] = torque_range(engine, *spin);
        let end = if *mass == 0.0 {
            "at any tilt and speed. Every piston would spoil it.".into()
        } else {
            format!("at any tilt. The {most:.1} N·m that rock the frame come from the pistons.")
        };
        return format!(
            "√3 times as thick as its radius the plate has three equal moments and shakes nothing, {end}"
        );
    }
    if *mass == 0.0 {
        let advice = if balancing.is_some() {
            "Give the pistons mass."
        } else {
            "Pistons cannot help: it is too thick."
        };
        return format!(
            "The plate alone: a torque of {alone:.1} N·m goes round with the shaft and rocks the frame. {advice}"
        );
    }
    let [least, most] = torque_range(engine, *spin);
    let Some(balancing) = balancing else {
        return format!(
            "Thicker than √3 radii the body is long, and pulls itself steeper, as pistons do: each piston makes it worse, {most:.1} N·m at \
             most, against {alone:.1} N·m without. It asks for weights on its rim."
        );
    };
    let (each, needed, part) = (mass / f64::from(count), balancing / f64::from(count), mass / balancing);
    let number = ["One", "Two", "Three", "Four", "Five", "Six", "Seven"][count as usize - 1];
    if count < 3 {
        let they = if count == 1 { "One piston swings" } else { "Two pistons swing" };
        let hops = if count == 1 {
            " The frame hops as well: nothing answers the force along the shaft."
        } else {
            ""
        };
        if (part - 1.0).abs() < 0.01 {
            return format!(
                "{they} to and fro along a line. Half of that goes round with the plate and cancels it; the other half goes round \
                 backwards and is left: {alone:.1} N·m, as without pistons, all the time, turning the wrong way.{hops}"
            );
        }
        return format!(
            "{they} to and fro along a line, and no mass of that can cancel what goes round: the torque goes from {least:.1} to \
             {most:.1} N·m twice a turn. Whatever the mass, the greater of the two is no less than the plate's own {alone:.1} N·m.{hops}"
        );
    }
    if (part - 1.0).abs() < 0.01 {
        return format!(
            "Balanced. {number} pistons of {each:.3} kg each have as much momentum across the shaft as the plate, always the other way. \
             The frame stands still, at every speed; at another tilt it will not."
        );
    }
    let (what, way) = if part < 1.0 { ("light", "with the plate") } else { ("heavy", "opposite to it") };
    format!(
        "{number} pistons of {each:.3} kg each are too {what}: {most:.1} N·m go round {way} and rock the frame; without pistons it would be \
         {alone:.1} N·m. They would balance with {needed:.3} kg each, at any speed."
    )
}
