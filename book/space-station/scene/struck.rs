//! The station as it turns: before a blow, after it, and after later ones.

use live::prelude::*;
use mechanics::euler::Turning;
use mechanics::free_rotation::FreeSymmetricTop;
use mechanics::inertia::Body;
use mechanics::scenes::space_station::{Blow, LaterBlow, Station, StationParameters, StruckStation};
use nalgebra::{UnitQuaternion, Vector3};

/// The chapter's ring: mass, kg, radius, m, spin, rad/s.
pub(super) const MASS: f64 = 4e5;
pub(super) const RADIUS: f64 = 50.0;
pub(super) const SPIN: f64 = 0.45;
/// A motion whose axis is no further from its angular momentum than this, rad, does not nod.
pub(super) const STILL: f64 = 2e-3;

/// The blows: the first, those of the thruster, and the last of them, or the one to come.
#[derive(Clone)]
pub(super) struct Blows {
    pub(super) first: Blow,
    pub(super) between: Vec<LaterBlow>,
    pub(super) second: LaterBlow,
    pub(super) is_fired: bool,
}

/// The station, struck once or more often: the time of each later blow, the motion since, and the drift.
pub(super) struct Struck {
    pub(super) first: StruckStation,
    pub(super) later: Vec<(f64, FreeSymmetricTop, Vector3<f64>)>,
}

impl Struck {
    pub(super) fn new(blows: &Blows) -> Result<Self, Cause> {
        let station = Station::new(StationParameters { body: Body::hoop(MASS, RADIUS)?, spin: SPIN })?;
        let first = station.struck(blows.first)?;
        let mut struck = Self { first, later: Vec::new() };
        for blow in blows.between.iter().chain(Some(&blows.second).filter(|_| blows.is_fired)) {
            let push = struck.at(blow.time)?.axis_3_world() * (blow.blow.impulse / MASS); // eq:drift
            let (top, velocity) = match struck.later.last() {
                Some((from, top, velocity)) => {
                    (LaterBlow { time: blow.time - from, ..*blow }.on(top)?, *velocity)
                }
                None => (first.struck_again(*blow)?, first.centre_velocity()),
            };
            struck.later.push((blow.time, top, velocity + push));
        }
        Ok(struck)
    }

    /// The blow of which the station is turning at a time: when it came, and the motion since.
    pub(super) fn last(&self, time: f64) -> Option<&(f64, FreeSymmetricTop, Vector3<f64>)> {
        self.later.iter().rev().find(|(fired, ..)| time >= *fired)
    }

    /// Attitude and angular velocity; before the first blow the station turns about its axis.
    pub(super) fn at(&self, time: f64) -> Result<Turning, Cause> {
        if time < 0.0 {
            let world_from_body = UnitQuaternion::from_axis_angle(&Vector3::z_axis(), SPIN * time);
            return Ok(Turning { world_from_body, omega_body: Vector3::z() * SPIN });
        }
        Ok(match self.last(time) {
            Some((fired, top, _)) => top.at(time - fired)?,
            None => self.first.at(time)?,
        })
    }

    pub(super) fn momentum(&self, time: f64) -> Vector3<f64> {
        self.last(time)
            .map_or(self.first.angular_momentum_world(), |(_, top, _)| top.angular_momentum_world())
    }

    /// How far axis 3 is to one side of the first angular momentum in the room, and how far the axis of rotation is to
    /// one side of axis 3 on board: sines.
    pub(super) fn aside(&self, time: f64) -> Result<[f64; 2], Cause> {
        let now = self.at(time)?;
        let momentum = self.first.angular_momentum_world().normalize();
        let aside = Vector3::new(momentum.z, 0.0, -momentum.x);
        Ok([-now.axis_3_world().dot(&aside), now.omega_body.x / now.omega_body.norm()])
    }

    /// Counts until a time, in turns: nods, turns of a mark on the rim, turns of the axis of rotation on board.
    pub(super) fn counts(&self, time: f64) -> [f64; 3] {
        let first = rates(self.first.momentum_angle(), self.first.nodding_rate(), self.first.body_rate());
        let later = self.later.iter().map(|(fired, top, _)| {
            (*fired, rates(top.momentum_angle(), top.precession_rate(), top.body_rate()))
        });
        let parts: Vec<_> = std::iter::once((0.0, first)).chain(later).collect();
        [0, 1, 2].map(|index| {
            let turned = parts.iter().enumerate().map(|(part, (from, rates))| {
                let end = parts.get(part + 1).map_or(time, |next| next.0.min(time));
                rates[index] * (end - from).max(0.0)
            });
            turned.sum::<f64>() / TAU
        })
    }
}

/// Rates of nodding, of a mark, and of the axis of rotation on board; without a nod only the mark goes round.
fn rates(lean: f64, nodding: f64, on_board: f64) -> [f64; 3] {
    let mark = nodding - on_board;
    if lean > STILL { [nodding, mark, on_board] } else { [0.0, mark, 0.0] }
}
