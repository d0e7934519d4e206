//! The live scenes, used as a reader would use them, against simulations and what the library says.

mod air_drag;
mod ball;
mod cap;
mod clocks;
mod coin_toss;
mod disk_end;
mod edge;
mod every;
mod grips;
mod hand;
mod hill;
mod knob;
mod laundromat;
mod methods;
mod middle_axis;
mod near_flat;
mod pinned_hoop;
mod rolling_wheel;
mod small_wheels;
mod space_station;
mod speeds;
mod spinning_coin;
mod star;
mod top;
mod turning;

mod wobble_plate;
mod words;
