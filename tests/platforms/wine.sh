#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# usage: wine.sh PROGRAM
# Runs the 64-bit PROGRAM.exe (the compiler adds the extension) in a separate Wine home.
set -eu
export WINEPREFIX=$DETENT_PLATFORMS_WORK/wine WINEDEBUG=-all WINEDLLOVERRIDES='mscoree,mshtml='
PATH=$PATH:/usr/lib/wine

mkdir -p "$WINEPREFIX"
# Two programs must not create the home at once, and Wine's background processes must not hold the
# lock.
exec {lock}>"$WINEPREFIX/lock"
flock "$lock"
[[ -e $WINEPREFIX/system.reg ]] || wine64 wineboot --init >/dev/null 2>&1 {lock}>&-
exec {lock}>&-
exec wine64 "$1.exe"
