#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# usage: block.sh PAGE LANGUAGE [NUMBER]
# Prints a block of code of a page: the first one in this language, or the one with this number.
set -euo pipefail
awk -v fence="\`\`\`$2" -v wanted="${3:-1}" '
  /^```/ && inside { exit }
  inside { print; printed = 1 }
  $0 == fence && ++number == wanted { inside = 1 }
  END { if (!printed) exit 1 }
' "$1" || { echo "$1 has no block $2 ${3:-1}" >&2; exit 1; }
