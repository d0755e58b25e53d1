#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# usage: msvc_integers.sh COMPILER
# If _MSC_VER is defined, we use our own 128-bit integers: Microsoft's runtime library lacks the
# division functions of the compiler's, although clang-cl defines __SIZEOF_INT128__.
set -euo pipefail

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
source=tests/structure/msvc_integers.cpp
"$1" -std=c++20 -fsyntax-only -Iinclude -D_MSC_VER=1930 "$source"
echo "with _MSC_VER the portable integers are chosen"

# Builds the object that clang-cl would build, but with the GNU standard library. Its headers accept
# a 32-bit `long` if they believe that the processor is in 32-bit mode.
if ! command -v clang++ >/dev/null; then
echo "clang is not installed, so no object for Windows was checked"
exit 0
fi
mkdir "$work/gnu"
touch "$work/gnu/stubs-x32.h"
flags=(-std=c++20 -O1 -w --target=x86_64-pc-windows-msvc -ffreestanding -fno-exceptions -fno-rtti
-D__STRICT_ANSI__ -D_GNU_SOURCE -D__ILP32__ -isystem "$work"
-isystem "$(clang++ -print-resource-dir)/include")
while read -r folder; do
flags+=(-isystem "$folder")
done < <(clang++ -x c++ -E -v /dev/null 2>&1 | sed -n '/^#include </,/^End/s/^ //p')
printf '#include <algorithm>\n#include <optional>\n#include <string_view>\n' >"$work/empty.cpp"
if ! clang++ "${flags[@]}" -fsyntax-only "$work/empty.cpp" 2>"$work/errors"; then
echo "these standard headers do not compile for Windows, so no object was checked"
exit 0
fi
clang++ "${flags[@]}" -Iinclude -c "$source" -o "$work/windows.o"
if nm --undefined-only "$work/windows.o" | grep 'ti[0-9]$'; then
echo "an object for Windows needs a function that Microsoft's runtime library lacks"
exit 1
fi
echo "an object for Windows needs:" $(nm --undefined-only --format=just-symbols "$work/windows.o")
