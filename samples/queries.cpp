// SPDX-License-Identifier: MIT
//
// The 3D samples without bodies: see gallery.cpp.
#include "cloth.cpp"
#include "culling.cpp"
#include "rays.cpp"
