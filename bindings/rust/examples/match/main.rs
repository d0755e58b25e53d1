// SPDX-License-Identifier: MIT
//! Prints the digest of the scripted match, equal to that of tests/c/match.cpp.

include!("play.rs");

fn main() -> detent::Result<()> {
    println!("{:016x}", play()?);
    Ok(())
}
