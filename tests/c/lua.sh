#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# usage: lua.sh MATCH_IN_CPP LIBRARY
# The tests of the Lua binding pass in LuaJIT, and the page's example runs.
set -euo pipefail
command -v luajit >/dev/null || { echo 'skipped: luajit is not installed'; exit 77; }
DETENT_LIBRARY=$(realpath "$2") DETENT_MATCH=$("$1")
export DETENT_LIBRARY DETENT_MATCH LUA_PATH='bindings/lua/?.lua;bindings/lua/?/init.lua;;'
luajit bindings/lua/tests/test_detent.lua
said=$(luajit bindings/lua/examples/match.lua)
[[ $said == "$DETENT_MATCH" ]] || { echo "the example ends with $said"; exit 1; }
said=$(bash tests/docs/block.sh docs/bindings.md lua | luajit -)
[[ $said == 'true	9' ]] || { echo "the page prints $said"; exit 1; }
