//! scratch, not committed
use std::fs;
use std::path::PathBuf;
const STYLE: &str = include_str!("../../../book/theme/figures.css");
fn main() {
    let args: Vec<String> = std::env::args().collect();
    let folder = PathBuf::from(&args[1]);
    fs::create_dir_all(&folder).unwrap();
    let mut page = format!(
        "<!doctype html><meta charset=\"utf-8\"><meta name=\"viewport\" content=\"width=device-width\"><title>Figures</title>\n\
         <style>:root {{ color-scheme: light dark; --bg: light-dark(#fff, hsl(226, 23%, 11%)); --fg: light-dark(#000, #bcbdd0); }}\n\
         body {{ background: var(--bg); color: var(--fg); font: 16px \"Open Sans\", sans-serif; max-width: 750px; margin: 0 auto; }}\n\
         svg {{max-width:100%; height:auto}} svg.drawn {{ outline: 1px dotted #8884; }} h2 {{font-size: 12px; margin: 4px}} figure {{ margin: 0.5em 0; container-type: inline-size}}\n{STYLE}</style>\n"
    );
    match figures::of(|c| args[2].split(',').any(|a| a == c)) {
        Err(f) => {
            for x in f {
                println!("{x}");
            }
            std::process::exit(1)
        }
        Ok(fs_) => {
            for figure in fs_ {
                if args.len() > 3 && !args[3].split(',').any(|a| figure.id.ends_with(a)) {
                    continue;
                }
                println!("{} {:.0} {}", figure.id, figure.drawing.room(), figure.wide);
                fs::write(folder.join(format!("{}.svg", figure.id.replace(':', "-"))), &figure.standalone)
                    .unwrap();
                page += &format!(
                    "<h2>{}</h2>\n<figure class=\"figure\" id=\"{}\"><div class=\"drawing\">\n{}\n</div></figure>\n",
                    figure.id, figure.id, figure.svg
                );
            }
        }
    }
    fs::write(folder.join("sheet.html"), page).unwrap();
}
