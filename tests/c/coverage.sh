#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# usage: coverage.sh LIBRARY
# The C interface answers every query of every shape that C++ has, or docs/bindings.md says that it does not.
set -euo pipefail
command -v python3 >/dev/null || { echo 'skipped: there is no python3'; exit 77; }
DETENT_LIBRARY=$(realpath "$1") PYTHONDONTWRITEBYTECODE=1 PYTHONPATH=bindings:bindings/python \
  python3 tests/c/coverage.py
