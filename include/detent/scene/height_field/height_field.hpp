// SPDX-License-Identifier: MIT
#pragma once

// A height field and its traversals, which every query on it needs to compile.

#include "detent/scene/height_field/view.hpp"
#include "detent/scene/height_field/walk.hpp"
