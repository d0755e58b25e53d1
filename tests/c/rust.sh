#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# usage: rust.sh MATCH_IN_CPP LIBRARY
# The crate compiles without a network and without a warning; its tests and the page's example pass.
set -euo pipefail
command -v cargo >/dev/null || { echo 'skipped: cargo is not installed'; exit 77; }
DETENT_LIBRARY_DIR=$(dirname "$(realpath "$2")") DETENT_MATCH=$("$1")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cp -r bindings/rust "$work/crate"
bash tests/docs/block.sh docs/bindings.md rust >"$work/crate/examples/page.rs"
export DETENT_LIBRARY_DIR DETENT_MATCH LD_LIBRARY_PATH=$DETENT_LIBRARY_DIR RUSTFLAGS='-D warnings'
cd "$work/crate"
cargo test --offline --quiet
cargo run --offline --quiet --example page
