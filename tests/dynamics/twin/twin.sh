#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# usage: twin.sh TWIN_STATES [--ticks N] [SCENE...]
# Runs run.py if Python 3 is installed.
set -euo pipefail
if ! python3 -c 'import sys; sys.exit(sys.version_info < (3, 8))' 2>/dev/null; then
  echo "skipped: python3 is not installed"
  exit 77
fi
exec python3 -B "$(dirname "${BASH_SOURCE[0]}")/run.py" "$@"
