//! A physics engine for games and robots, on the pinned hoop.
//!
//! The engine is given a free body with the moments about the pin, which is the same motion without a joint
//! to hold: a kindness. No colliders, no gravity, no damping, no sleep.

use crate::contest::{Cause, Entry};
use crate::problems::{self, Problem};
use rapier3d_f64::prelude::*;
use std::rc::Rc;

/// The entries of the engine, by steps a sample.
pub fn entries() -> Vec<Entry> {
    let problem = Rc::new(problems::hoop());
    let entry = |steps: usize| {
        let solve = move |problem: &Problem<7>, samples: &mut Vec<[f64; 7]>| tumble(problem, steps, samples);
        let names = ["rapier3d-f64", "engine"];
        Entry::new(&problem, names, format!("{steps} steps a sample"), solve, |y| *y)
    };
    [100, 400, 1600].into_iter().map(entry).collect()
}

fn tumble(problem: &Problem<7>, steps: usize, samples: &mut Vec<[f64; 7]>) -> Result<Option<usize>, Cause> {
    let [w1, w2, w3, ..] = problem.start;
    let mut bodies = RigidBodySet::new();
    let moments = MassProperties::new(Vector::ZERO, 1.0, AngVector::new(1.5, 0.5, 2.0));
    let body = RigidBodyBuilder::dynamic()
        .additional_mass_properties(moments)
        .angvel(AngVector::new(w1, w2, w3))
        .can_sleep(false);
    let handle = bodies.insert(body);
    let parameters = IntegrationParameters { dt: problem.dt() / steps as f64, ..Default::default() };
    let mut pipeline = PhysicsPipeline::new();
    let mut islands = IslandManager::new();
    let mut broad_phase = BroadPhaseBvh::new();
    let mut narrow_phase = NarrowPhase::new();
    let mut colliders = ColliderSet::new();
    let mut joints = ImpulseJointSet::new();
    let mut multibody_joints = MultibodyJointSet::new();
    let mut soft_bodies = SoftBodySet::new();
    let mut ccd = CCDSolver::new();
    samples.clear();
    samples.push(problem.start);
    for _ in 1..problem.times.len() {
        for _ in 0..steps {
            pipeline.step(
                Vector::ZERO,
                &parameters,
                &mut islands,
                &mut broad_phase,
                &mut narrow_phase,
                &mut bodies,
                &mut colliders,
                &mut joints,
                &mut multibody_joints,
                &mut soft_bodies,
                &mut ccd,
                &(),
                &(),
            );
        }
        let body = &bodies[handle];
        let q = *body.rotation();
        let w = q.inverse() * body.angvel();
        samples.push([w.x, w.y, w.z, q.w, q.x, q.y, q.z]);
    }
    Ok(None)
}
