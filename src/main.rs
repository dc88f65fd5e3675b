//! The `snellius` command.

use std::process::ExitCode;

fn main() -> ExitCode {
    snellius::cli::main()
}
