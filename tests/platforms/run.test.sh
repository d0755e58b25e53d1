#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Checks what `run` reports for platforms that are right, wrong, silent, endless, broken or missing.
set -euo pipefail
source=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)

# A project whose program's results depend on its flags.
project=$(mktemp -d)
trap 'rm -rf "$project"' EXIT
cd "$project"
unset DETENT_PLATFORMS_WORK
mkdir -p tests/platforms src/verify include
sed 's/^build_limit=.*/build_limit=60 run_limit=2/' "$source/run" >tests/platforms/run
chmod +x tests/platforms/run

cat >tests/platforms/expected.cpp <<'END'
#include <cstdio>
int main(int, char** argv) {
  const char size = argv[1][0];
  if (size == 'n') return std::puts(argv[1][6] == 'p' ? "Near\nFar" : "Corpus") < 0;
  std::puts("first 0000000000000001 ok");
  if (size == 'p') std::puts("Near 0000000000000005 ok");
  std::puts("second 0000000000000002 ok");
  if (size == 'p') return std::puts("Far 0000000000000006 ok") < 0;
  std::printf("all 000000000000000%c ok\n", size == 's' ? '4' : '3');
}
END
cat >src/verify/main_bare.cpp <<'END'
#include <cstdio>
#include <cstdlib>
#ifndef STATUS
#define STATUS 0
#endif
#ifdef DETENT_VERIFY_SMALL
#define LAST "4"
#else
#define LAST "3"
#endif
#define Near 1
#define Far 2
#define Corpus 3
#if defined(ADMITTED)
#define SECOND "9 DIFFERENT (q8_8 3D)"
#elif defined(DENIED)
#define SECOND "9 ok"
#else
#define SECOND "2 ok"
#endif
int main() {
#ifdef ENDLESS
  for (volatile int i = 0;; i = 1) {
  }
#endif
#ifndef SILENT
  std::puts("first line of the emulator");
#if DETENT_VERIFY_PART != Far
  std::puts("first 0000000000000001 ok\r");
#endif
#ifdef HALF
  std::exit(STATUS);
#endif
#if DETENT_VERIFY_PART == Near
  std::puts("Near 0000000000000005 ok");
#else
  std::puts("second 000000000000000" SECOND);
#endif
#if DETENT_VERIFY_PART == Far
  std::puts("Far 0000000000000006 ok");
#elif DETENT_VERIFY_PART == Corpus
  std::puts("all 000000000000000" LAST " ok");
#endif
#endif
  return STATUS;
}
END
cat >src/verify/main_float.cpp <<'END'
#include <cstdio>
#ifndef DRIFT
#define DRIFT "2"
#endif
int main() {
  std::puts("first 0000000000000001");
  std::puts("second 000000000000000" DRIFT);
  std::puts("all 000000000000000" DRIFT);
}
END
echo 'static_assert(sizeof(int) >= LEAST);' >src/verify/constant.cpp

cat >tests/platforms/targets <<'END'
right    | | c++ | -O0         |     | full  | good
small    | | c++ | -DDRIFT="7" | env | small | good
parts    | | c++ | -O0         |     | parts | good
constant | | c++ | -DLEAST=2   | -   | -     | good
admitted | | c++ | -DADMITTED -DSTATUS=1 | | full |
denied   | | c++ | -DDENIED    |     | full  |
silent   | | c++ | -DSILENT    |     | full  |
oddpart  | | c++ | -DADMITTED -DSTATUS=1 | | parts |
half     | | c++ | -DHALF -DSTATUS=3 |     | full  |
unhappy  | | c++ | -DSTATUS=4  |     | full  |
endless  | | c++ | -DENDLESS   |     | full  |
broken   | | c++ | -no-such-flag |   | full  |
refused  | | c++ | -DLEAST=9   | -   | -     |
absent   | | no-such-compiler | |    | full  |
lost     | no-such-package | c++ | | | full  |
END

failures=0
complain() {
  echo "$*"
  failures=$((failures + 1))
}

# run STATUS ARGUMENT...; `says` checks the output.
run() {
  local status=0
  tests/platforms/run "${@:2}" >printed 2>&1 || status=$?
  cat printed
  [[ $status -eq $1 ]] || complain "run ${*:2}: the status is $status, not $1"
}
says() { grep -qE "$1" printed || complain "run does not say: $1"; }

run 0 --no-install good
says '^right .* equal$'
says '^small .* equal$'
says '^parts .* equal$'
says '^constant .* compiles$'
says ': 3 equal, 0 different, 0 did not run, 0 not installed, 1 compiled only;'
says 'float: 3 builds, 2 different digests; they first differ at second \(right against small\)\.'

run 0 --no-install --only Far parts
says '^parts .* equal$'
[[ $(wc -l <build/platforms/parts/lines) -eq 2 ]] || complain 'run --only Far runs more'
run 1 --no-install --only Far,Nowhere parts
says '^parts .* has no such programs: Far,Nowhere$'

run 1 --no-install
says '^admitted .* DIFFERENT at second \(q8_8 3D\)$'
says '^denied .* DIFFERENT at second$'
says '^silent .* did not run: status 0 before first$'
says '^oddpart .* did not run: status 1 before second$'
says '^half .* did not run: status 3 before second$'
says '^unhappy .* did not run: status 4 at the end$'
says '^endless .* did not run: over 2 s at first$'
says '^broken .* does not compile: .*/broken/program.log$'
says '^refused .* does not compile: .*/refused/program.o.log$'
says '^absent .* not installed: no-such-compiler$'
if command -v dpkg-query >/dev/null; then says '^lost .* not installed: no-such-package$'; fi
says ': 3 equal, 2 different, 7 did not run, 2 not installed, 1 compiled only;'

run 0 --markdown --no-install right
# shellcheck disable=SC2016  # the backquotes are Markdown's
says '^\| right \| (gcc|clang) [0-9.]+ \| `-O0` \| (32|64) \| (little|big) \|.* equal \| [0-9.]+ \|$'

run 0 --test right
run 1 --test denied
says '^second 0000000000000009 ok$'
run 77 --test absent
says '^skipped, not installed: no-such-compiler$'

# Of the recorded results only those of the named platforms change.
mkdir -p include/detent
echo 'constexpr int results_version = 7;' >include/detent/version.hpp
printf '#!/bin/sh\n' >tests/platforms/claims.sh
chmod +x tests/platforms/claims.sh
printf '%s\n' 'float|as before' 'row||right|as before' 'row||small|as before' >tests/platforms/results
run 0 --no-install --record right
recorded=$(grep -v '^#' tests/platforms/results)
[[ $recorded =~ ^'float|as before'$'\n''row||right|'[^$'\n']*'|equal|'[^$'\n']*'|7'$'\n''row||small|as before'$ ]] ||
  complain "run --record right writes: $recorded"
# A part adds to what was recorded, and replaces what it asks again; one that fails marks the row.
whole='row||parts|c|64|little|ours|none||equal|1.0|parts|2|2026-01-01|6'
printf '%s\n' 'float|as before' "$whole|first second|2026-01-02|6" 'row||small|as before' >tests/platforms/results
run 0 --no-install --record --only Far parts
recorded=$(grep parts tests/platforms/results)
[[ $recorded == "$whole|first|2026-01-02|6|second|$(date -u +%F)|7" ]] || complain "run --record --only writes: $recorded"
printf '%s\n' 'float|as before' "${whole/parts/oddpart}" >tests/platforms/results
run 1 --no-install --record --only Far oddpart
recorded=$(grep oddpart tests/platforms/results)
marked=${whole/parts/oddpart}
[[ $recorded == "${marked/|equal|/|DIFFERENT at second (q8_8 3D)|}|"*"|7" ]] ||
  complain "run --record --only of a part that differs writes: $recorded"
run 1 --no-install --record broken
grep -qF '|does not compile: broken/program.log|' tests/platforms/results ||
  complain "run --record broken writes: $(grep broken tests/platforms/results)"

run 0 --list good
[[ $(cat printed) == $'right\nsmall\nparts\nconstant' ]] || complain "run --list lists something else"
run 0 --packages
[[ $(cat printed) == no-such-package ]] || complain "run --packages prints something else"
run 2 right nowhere
says "^platforms: no platform 'nowhere'; there are: .* right small parts constant"
run 2 --loud
says "^platforms: unknown option '--loud'"

[[ $failures -eq 0 ]]
