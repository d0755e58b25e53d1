#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Package files whose formats need their own version have the one of version.hpp.
set -euo pipefail
version=$(sed -n 's/#define DETENT_VERSION_[A-Z]* //p' include/detent/version.hpp | paste -sd .)
[[ $version =~ ^[0-9]+\.[0-9]+\.[0-9]+$ ]] || { echo "version.hpp has $version"; exit 1; }
bad=0
check() {  # check FILE PATTERN
  local said
  said=$(sed -nE "s/$2/\1/p" "$1" | head -n 1)
  [[ $said == "$version" ]] || { echo "$1 has version '$said', version.hpp has $version"; bad=1; }
}
check bindings/js/package.json '^ *"version": "([^"]*)",?'
check bindings/rust/Cargo.toml '^version = "([^"]*)"'
check packages/vcpkg/detent/vcpkg.json '^ *"version": "([^"]*)",?'
check CHANGELOG.md '^## [A-Za-z]* ?\(?([0-9.]+).*'
if [[ $bad -eq 0 ]]; then echo "all files have version $version"; fi
exit "$bad"
