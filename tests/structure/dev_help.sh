#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# `./dev COMMAND --help` explains every command of ./dev, and neither builds nor installs anything.
# Every package that ./dev lists has a check.
set -euo pipefail

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
tools=(apt-get sudo cmake ctest ninja g++ clang++ clang-format clang-tidy cppcheck doxygen npm)
for tool in "${tools[@]}"; do
  printf '#!/bin/sh\necho "%s $*" >>"%s"\nexit 1\n' "$tool" "$work/called" >"$work/$tool"
  chmod +x "$work/$tool"
done

# The commands are the cases of the last `case` in ./dev.
commands=$(sed -n '/^case \${1:-help} in$/,$p' dev | sed -n 's/^  \([a-z| ]*\)).*/\1/p' | tr -d '|')
count=0
for command in $commands; do
  [[ $command != help ]] || continue
  for arguments in --help -h '--seed 2 --help'; do
    # shellcheck disable=SC2086
    text=$(PATH=$work:$PATH ./dev "$command" $arguments </dev/null) ||
      { echo "./dev $command $arguments: exit status $?"; exit 1; }
    [[ $text == "usage: ./dev $command"* ]] ||
      { echo "./dev $command $arguments says: $text"; exit 1; }
    [[ ! -e $work/called ]] || { echo "./dev $command $arguments calls:"; cat "$work/called"; exit 1; }
  done
  count=$((count + 1))
done
[[ $count -ge 11 ]] || { echo "found only these commands: $commands"; exit 1; }

# Without its check, a package would never be installed, nor would those listed with it.
for package in $(sed -n 's/^[a-z]*_packages=(\([^)]*\)).*/\1/p' dev); do
  grep -qE "^    ([^)]* )?${package//+/\\+}( [^)]*)?\\)" dev ||
    { echo "./dev does not check for the package $package"; exit 1; }
done
echo "$count commands only print their help with --help"
