#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The files written by bindings/generate are committed and current.
set -euo pipefail
command -v python3 >/dev/null || { echo 'skipped: python3 is not installed'; exit 77; }
bindings/generate --check
