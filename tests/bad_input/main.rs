//! Every input that is not of this world gives the documented error, whose message holds the value, the unit
//! and the rule broken.

mod free_tops;
mod laundromat;
mod methods;
mod spinning_coin;
mod wobble_plate;
