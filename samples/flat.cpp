// SPDX-License-Identifier: MIT
//
// The 2D samples, which share worlds: see gallery.cpp.
#include "microcontroller.cpp"
#include "replay.cpp"
#include "rollback.cpp"
