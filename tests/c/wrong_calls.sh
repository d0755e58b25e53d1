#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# usage: wrong_calls.sh LIBRARY
# Every function of the C interface returns an error for wrong contexts and handles, and returns for null.
set -euo pipefail
command -v python3 >/dev/null || { echo 'skipped: there is no python3'; exit 77; }
DETENT_LIBRARY=$(realpath "$1") PYTHONDONTWRITEBYTECODE=1 PYTHONPATH=bindings:bindings/python \
  python3 tests/c/wrong_calls.py
