#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# usage: operations_include_kernels.sh [INCLUDE]
# In query/, the headers of an operation include kernels and each other but no other operation, and
# kernels include no operation. Umbrellas, which only include, are for users; the only other header
# that includes them is scene/scene.hpp, whose shapes support every query.
set -euo pipefail
cd "${1:-include}"

bad=0
# refuse HEADER INCLUDED RULE
refuse() {
  echo "$1 includes $2: $3"
  bad=1
}

# Prints the operation of a header such as detent/query/raycast/sphere.hpp or detent/query/on.hpp,
# `kernel` for a kernel, and nothing outside query/.
operation() {
  local path=${1#detent/query/}
  if [[ $1 == detent/query/* ]]; then echo "${path%%[/.]*}"; fi
}

umbrellas=$(grep -rL '^namespace' detent --include='*.hpp' | xargs grep -l '^#include "detent/')
is_umbrella() { [[ $'\n'$umbrellas$'\n' == *$'\n'"$1"$'\n'* ]]; }

count=0
while IFS=: read -r header included; do
  count=$((count + 1))
  if is_umbrella "$included" && ! is_umbrella "$header" && [[ $header != detent/scene/scene.hpp ]]
  then
    refuse "$header" "$included" 'only umbrellas include umbrellas'
  fi
  if [[ $header == detent/query/query.hpp ]]; then continue; fi
  from=$(operation "$header") to=$(operation "$included")
  case $to in
    '' | "$from" | kernel | wrong_call) ;;
    *) if [[ $from == kernel ]]; then
         refuse "$header" "$included" 'a kernel includes no operation'
       elif [[ -n $from ]]; then
         refuse "$header" "$included" 'what two operations share is a kernel'
       fi ;;
  esac
done < <(grep -rE '^#include "detent/' detent/*/ | sed 's/#include "\(.*\)"/\1/')

if [[ $bad -eq 0 ]]; then echo "$count includes lead to kernels and single headers"; fi
exit "$bad"
