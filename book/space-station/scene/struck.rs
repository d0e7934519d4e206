//! The station as it turns: before a blow, after it, and after a second one.

use live::Cause;
use mechanics::euler::Turning;
use mechanics::free_rotation::FreeSymmetricTop;
use mechanics::inertia::Body;
use mechanics::scenes::space_station::{Blow, LaterBlow, Station, StationParameters, StruckStation};
use nalgebra::{UnitQuaternion, Vector3};
use std::f64::consts::TAU;

/// The chapter's ring: mass, kg, radius, m, spin, rad/s.
pub(super) const MASS: f64 = 4e5;
pub(super) const RADIUS: f64 = 50.0;
pub(super) const SPIN: f64 = 0.45;
/// A motion whose axis is no further from its angular momentum than this, rad, does not nod.
pub(super) const STILL: f64 = 2e-3;

/// The two blows.
#[derive(Clone, Copy)]
pub(super) struct Blows {
    pub(super) first: Blow,
    pub(super) second: LaterBlow,
    pub(super) is_fired: bool,
}

/// The station, struck once or twice.
pub(super) struct Struck {
    pub(super) first: StruckStation,
    pub(super) second: Option<(f64, FreeSymmetricTop, Vector3<f64>)>,
}

impl Struck {
    pub(super) fn new(blows: &Blows) -> Result<Self, Cause> {
        let station = Station::new(StationParameters { body: Body::hoop(MASS, RADIUS)?, spin: SPIN })?;
        let first = station.struck(blows.first)?;
        let Blows { second, is_fired, .. } = *blows;
        let second = if is_fired {
            let push = first.at(second.time)?.axis_3_world() * (second.blow.impulse / MASS); // eq:drift
            Some((second.time, first.struck_again(second)?, first.centre_velocity() + push))
        } else {
            None
        };
        Ok(Self { first, second })
    }

    /// The blow of which the station is turning at a time: when it came, and the motion since.
    pub(super) fn last(&self, time: f64) -> Option<&(f64, FreeSymmetricTop, Vector3<f64>)> {
        self.second.as_ref().filter(|(fired, ..)| time >= *fired)
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
        let end = self.last(time).map_or(time, |(fired, ..)| *fired);
        let second = self.last(time).map_or([0.0; 3], |(_, top, _)| {
            rates(top.momentum_angle(), top.precession_rate(), top.body_rate())
        });
        [0, 1, 2].map(|index| (first[index] * end + second[index] * (time - end)) / TAU)
    }
}

/// Rates of nodding, of a mark, and of the axis of rotation on board; without a nod only the mark goes round.
fn rates(lean: f64, nodding: f64, on_board: f64) -> [f64; 3] {
    let mark = nodding - on_board;
    if lean > STILL { [nodding, mark, on_board] } else { [0.0, mark, 0.0] }
}
