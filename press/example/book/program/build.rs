fn main() -> std::process::ExitCode {
    figures::write(&[pendulum_pages::pendulum::figures::FIGURES], pendulum_pages::tables::TABLES)
}
