#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# usage: assertions.sh COMPILER
# Assertions are on in debug builds and with DETENT_ASSERTIONS=1. A failed assertion ends the
# program with its text.
set -euo pipefail

compiler=$1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cat >"$work/promise.cpp" <<'END'
#ifdef OWN_HANDLER
#include <cstdlib>
#define DETENT_ASSERT(...) ((__VA_ARGS__) ? static_cast<void>(0) : std::_Exit(7))
#endif
#include "detent/number/rounding.hpp"
int main(int argc, char**) {
  const auto wide = detent::Fixed<40, 0>(argc) * detent::Fixed<20, 0>(1000);
  return detent::narrow<5>(wide) == 0 ? 0 : 1;
}
END

# run STATUS FLAG...: the program compiled with these flags must exit with STATUS.
run() {
  "$compiler" -std=c++20 -Iinclude "${@:2}" "$work/promise.cpp" -o "$work/promise"
  local status=0
  said=$(ulimit -c 0 && exec "$work/promise" 2>&1) || status=$?
  if [[ $status -ne $1 ]]; then
    echo "with '${*:2}' a failed assertion ends with status $status, not $1: $said"
    exit 1
  fi
}

# expect VALUE FLAG...
expect() {
  "$compiler" -std=c++20 -Iinclude -fsyntax-only "${@:2}" -x c++ - <<END || {
#include "detent/number/assert.hpp"
static_assert(DETENT_ASSERTIONS == $1);
END
    echo "with '${*:2}' DETENT_ASSERTIONS is not $1"
    exit 1
  }
}
expect 1 -O0
expect 0 -O1
expect 0 -O2
expect 0 -O0 -DNDEBUG
expect 0 -O0 -ffreestanding
expect 0 -O0 -DDETENT_ASSERTIONS=0
expect 1 -O2 -DDETENT_ASSERTIONS=1
expect 1 -O2 -DNDEBUG -DDETENT_ASSERTIONS=1
expect 1 -O2 -ffreestanding -DDETENT_ASSERTIONS=1

run 1 -O1
run 134 -O1 -DNDEBUG -DDETENT_ASSERTIONS=1
if [[ $said != *rounding.hpp:*:\ detent:\ assertion\ failed:* ]]; then
  echo "a failed assertion prints only: $said"
  exit 1
fi
run 7 -O1 -DOWN_HANDLER
echo "assertions are on in debug builds and on request"
