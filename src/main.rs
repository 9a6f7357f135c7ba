//! The command-line tool. Everything it does is in [`tissue::cli`].

fn main() -> std::process::ExitCode {
    tissue::cli::main()
}
