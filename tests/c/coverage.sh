#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# usage: coverage.sh LIBRARY
# The C interface has every query of every shape that C++ has, except those that docs/bindings.md
# lists.
set -euo pipefail
command -v python3 >/dev/null || { echo 'skipped: python3 is not installed'; exit 77; }
DETENT_LIBRARY=$(realpath "$1") PYTHONDONTWRITEBYTECODE=1 PYTHONPATH=bindings:bindings/python \
  python3 tests/c/coverage.py
