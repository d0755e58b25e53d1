// SPDX-License-Identifier: MIT
#pragma once

// Includes src/support/ where only tests/ is searched.
#include "../../src/support/shapes.hpp"
