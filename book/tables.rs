//! The tables that the library gives, one function each: `table:methods`.

use figures::{Table, tables};
use mechanics::integrate::METHODS;
use mechanics::integrate::methods::Method;

/// All tables.
pub const TABLES: &[Table] = tables![methods];

/// The table of the stepping methods.
pub(crate) fn methods() -> String {
    let row = |method: &Method| {
        let Method { name, order, dense_order, cost, adaptive, keeps } = method;
        let dense = dense_order.map_or("–".to_owned(), |order| order.to_string());
        let adapts = if *adaptive { "yes" } else { "no" };
        let kept: Vec<String> = keeps.iter().map(ToString::to_string).collect();
        let kept = if kept.is_empty() { "nothing".to_owned() } else { kept.join(", ") };
        format!("| {name} | {order} | {kept} | {cost} | {adapts} | {dense} |\n")
    };
    "| method | order | keeps, of a free body | a step costs | adapts | dense output |\n|---|---|---|---|---|---|\n"
        .to_owned()
        + &METHODS.iter().map(row).collect::<String>()
}
