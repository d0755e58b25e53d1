// SPDX-License-Identifier: MIT
//
// The samples in the plane, which share worlds: see gallery.cpp.
#include "microcontroller.cpp"
#include "replay.cpp"
#include "rollback.cpp"
