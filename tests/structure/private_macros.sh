#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# usage: private_macros.sh COMPILER [INCLUDE]
# After including all headers, only the documented macros are defined: options, choices and the
# version.
set -euo pipefail

documented='DETENT_ASSERT DETENT_ASSERTIONS DETENT_NATIVE_INT128 DETENT_PORTABLE_INT128
            DETENT_INLINE_UNOPTIMIZED DETENT_SHORT_WORDS DETENT_SMALL_CODE
            DETENT_VERSION_MAJOR DETENT_VERSION_MINOR DETENT_VERSION_PATCH'
compiler=$1 include=${2:-include}
system=$(grep -rhoE '^#include <[a-z_.0-9]+>' "$include" | sort -u)

# macros SOURCE: prints the names defined at its end.
macros() { "$compiler" -std=c++20 -I"$include" -E -dM -x c++ - <<<"$1" | cut -d ' ' -f 2 | sort -u; }

ours=$(comm -13 <(macros "$system") <(macros "$system
#include \"detent/detent.hpp\"
#include \"detent/instantiations.hpp\"
#include \"detent/scene/instantiations.hpp\"") | sed 's/(.*//')
bad=0
for macro in $ours; do
  if [[ " ${documented//$'\n'/ } " != *" $macro "* ]]; then
    echo "$macro is still defined after detent.hpp: #undef it after its last use"
    bad=1
  fi
done

if [[ $bad -eq 0 ]]; then echo 'only these macros remain:' $ours; fi
exit "$bad"
