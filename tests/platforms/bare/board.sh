#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# usage: board.sh EMULATOR [OPTION...] PROGRAM
# Runs a bare-metal program on an emulated board and passes on its semihosting output.
set -eu
exec "$1" "${@:2:$#-2}" -kernel "${@: -1}" \
  -display none -monitor none -serial none -chardev stdio,id=console \
  -semihosting-config enable=on,target=native,chardev=console
