#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# usage: godot.sh MATCH_IN_CPP LIBRARY
# The GDNative library compiles without a warning, and Debian's headless Godot 3 plays the match
# with a scene's collision nodes.
set -euo pipefail
command -v godot3-server >/dev/null || { echo 'skipped: godot3-server is not installed'; exit 77; }
compiler=$(command -v gcc || command -v cc) || { echo 'skipped: no C compiler is installed'; exit 77; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir "$work/project" "$work/home"
cp bindings/godot3/*.{gd,gdnlib,godot,tscn} "$work/project"
"$compiler" -std=c99 -pedantic -Wall -Wextra -Wconversion -Wshadow -Werror -fPIC -shared -fvisibility=hidden \
  -Iinclude bindings/godot3/detent_godot.c -L"$(dirname "$2")" -ldetent \
  -Wl,-rpath,"$(dirname "$(realpath "$2")")" -o "$work/project/libdetent_godot.so"
HOME=$work/home timeout 120 godot3-server --path "$work/project" >"$work/said" 2>&1 ||
  { cat "$work/said"; exit 1; }
expected=$("$1")
grep -qx "$expected" "$work/said" || { cat "$work/said"; echo "it does not print $expected"; exit 1; }
if grep -E 'SCRIPT ERROR|failed:' "$work/said"; then exit 1; fi
echo "the match ends with $expected"
