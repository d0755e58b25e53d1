// SPDX-License-Identifier: MIT
//
// The samples in 3D without bodies: see gallery.cpp.
#include "cloth.cpp"
#include "culling.cpp"
#include "rays.cpp"
