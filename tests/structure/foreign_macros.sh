#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# usage: foreign_macros.sh COMPILER
# Every header compiles after the macros of windows.h, Arduino.h and similar headers. The standard
# headers come before the macros, because many of them do not survive those.
set -euo pipefail

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
{
  grep -rhoE '^#include <[a-z_.0-9]+>' include | sort -u
  echo '#include "tests/structure/foreign_macros.hpp"'
  find include -name '*.hpp' -printf '#include "%P"\n' | sort
} >"$work/headers.cpp"

"$1" -std=c++20 -fsyntax-only -Wall -Wextra -Werror -I. -Iinclude "$work/headers.cpp"
echo "$(grep -c '^#include "detent' "$work/headers.cpp") headers compile after foreign macros"
