//! The `snellius` command.

fn main() {}
