// SPDX-License-Identifier: MIT
//! Finds libdetent.so in the folder named by DETENT_LIBRARY_DIR, or on the linker's path.

fn main() {
    println!("cargo:rerun-if-env-changed=DETENT_LIBRARY_DIR");
    if let Ok(folder) = std::env::var("DETENT_LIBRARY_DIR") {
        println!("cargo:rustc-link-search=native={}", folder);
    }
}
