#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# usage: python.sh MATCH_IN_CPP LIBRARY
# Runs the tests of the Python binding and the page's programs, with Debian's python3 if it has
# numpy.
set -euo pipefail
python='' number=0
for name in python3 /usr/bin/python3; do
  command -v "$name" >/dev/null || continue
  python=${python:-$name}
  if "$name" -c 'import numpy' 2>/dev/null; then python=$name; fi
done
[[ $python ]] || { echo 'skipped: python3 is not installed'; exit 77; }
DETENT_LIBRARY=$(realpath "$2") DETENT_MATCH=$("$1")
export DETENT_LIBRARY DETENT_MATCH PYTHONDONTWRITEBYTECODE=1 PYTHONPATH=bindings/python
"$python" bindings/python/tests/test_detent.py
falls=$(bash tests/c/falls.sh)
for wanted in "$falls" 'True 9.0'; do
  number=$((number + 1))
  said=$(bash tests/docs/block.sh docs/bindings.md python $number | "$python" -)
  [[ $said == "$wanted" ]] || { echo "program $number of the page prints $said"; exit 1; }
done
