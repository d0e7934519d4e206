fn main() -> std::process::ExitCode {
    press::main(&press::Book::new("pendulum", env!("OUT_DIR"), pendulum_pages::SCENES, "pendulum-snippets"))
}
