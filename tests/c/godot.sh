#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# usage: godot.sh MATCH_IN_CPP LIBRARY
# The GDNative library compiles without a warning. Debian's headless Godot 3 plays the match with a
# scene's collision nodes, and calls every procedure.
set -euo pipefail
command -v godot3-server >/dev/null || { echo 'skipped: godot3-server is not installed'; exit 77; }
compiler=$(command -v gcc || command -v cc) || { echo 'skipped: no C compiler is installed'; exit 77; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
project=$work/project said=$work/said
mkdir "$project" "$work/home"
cp bindings/godot3/*.{gd,gdnlib,godot,tscn} tests/c/godot.gd "$project"
"$compiler" -std=c99 -pedantic -Wall -Wextra -Wconversion -Wshadow -Werror -fPIC -shared -fvisibility=hidden \
  -Iinclude bindings/godot3/detent_godot.c -L"$(dirname "$2")" -ldetent \
  -Wl,-rpath,"$(dirname "$(realpath "$2")")" -o "$project/libdetent_godot.so"

# play LINE OPTION...: the engine, with these options, prints this line and no failure.
play() {
  HOME=$work/home timeout 120 godot3-server --path "$project" "${@:2}" >"$said" 2>&1 &&
    grep -qx "$1" "$said" && ! grep -qE 'SCRIPT ERROR|failed:' "$said" && return
  grep -v -e 'wrong arguments' -e 'detent_godot.c:0' "$said"
  echo "it does not print $1, or a check fails"
  exit 1
}

expected=$("$1")
play "$expected"
procedures=$(nm -D --defined-only "$project/libdetent_godot.so" | sed -n 's/.* T detent_godot_//p')
for procedure in $procedures; do
  grep -q "\"$procedure\"" "$project"/*.gd || { echo "no script calls $procedure"; exit 1; }
done
PROCEDURES=$(echo $procedures) play 'all checks hold' --script godot.gd
for error in 'set_friction: wrong arguments: it takes [world, body, friction]; numbers are integers' \
    'step: a handle of another type, or of something destroyed'; do
  grep -qF "$error" "$said" || { echo "it does not print: $error"; exit 1; }
done
echo "the match ends with $expected"
