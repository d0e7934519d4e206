//! Many cases at once give what one after the other gives, with and without the feature `parallel`.

use mechanics::scenes::laundromat::{Machine, MachineParameters, Shaft};
use mechanics::sweep::sweep;

fn machine(damping: f64) -> Machine {
    Machine::new(MachineParameters {
        drum_mass: 28.0,
        load_mass: 2.0,
        load_radius: 0.25,
        stiffness: 3000.0,
        damping,
        spin: 30.0,
    })
    .expect("a machine")
}

#[test]
fn answers_come_in_the_order_of_the_cases_and_to_the_last_bit() {
    let dampings: Vec<f64> = (0..5000).map(|n| 0.13 * f64::from(n)).collect();
    let answer =
        |damping: &f64| machine(*damping).transient(Shaft::AT_REST).unwrap().at(2.0).unwrap().to_array();
    let together = sweep(&dampings, answer);
    let one_by_one: Vec<[f64; 4]> = dampings.iter().map(answer).collect();
    assert_eq!(together, one_by_one);
    assert_ne!(together[0], together[4999]);
    assert_eq!(sweep(&[] as &[f64], answer), Vec::<[f64; 4]>::new());
}

#[test]
fn an_answer_may_be_an_error_of_its_own() {
    let answers = sweep(&[1.0, -1.0, 2.0], |&damping: &f64| {
        Machine::new(MachineParameters { damping, ..machine(1.0).parameters() })
    });
    assert!(answers[0].is_ok() && answers[1].is_err() && answers[2].is_ok());
}

#[cfg(feature = "parallel")]
#[test]
fn more_than_one_thread_takes_part() {
    use std::collections::HashSet;
    use std::time::Duration;
    if std::thread::available_parallelism().map_or(1, usize::from) == 1 {
        return; // a single core has nobody to share with
    }
    let threads: HashSet<_> = sweep(&[0; 200], |_| {
        std::thread::sleep(Duration::from_millis(1));
        std::thread::current().id()
    })
    .into_iter()
    .collect();
    assert!(threads.len() > 1);
}
