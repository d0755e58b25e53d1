#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# What bindings/generate writes is committed, and the library has every function of the description.
set -euo pipefail
command -v python3 >/dev/null || { echo 'skipped: there is no python3'; exit 77; }
bindings/generate --check
