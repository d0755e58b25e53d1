#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# usage: files_are_listed.sh FOLDER PATTERN FILE...
# CMake lists exactly the files in FOLDER whose names match PATTERN (passed as absolute paths).
set -euo pipefail

folder=$1 pattern=$2
shift 2

if difference=$(diff <(printf '%s\n' "$@" | sort) \
                     <(find "$PWD/$folder" -name "$pattern" | sort)); then
  echo "all $# files in $folder are listed"
else
  echo "the lists for CMake (<) and $folder/ (>) name different files:"
  grep '^[<>]' <<<"$difference"
  exit 1
fi
