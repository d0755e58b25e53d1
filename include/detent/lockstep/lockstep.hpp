// SPDX-License-Identifier: MIT
#pragma once

// Matches over a network, without networking code: `Session` takes and produces packets;
// `ReplayWriter` and `check_replay` record a match and simulate it again.

#include "detent/lockstep/config.hpp"
#include "detent/lockstep/event.hpp"
#include "detent/lockstep/input_codec.hpp"
#include "detent/lockstep/replay.hpp"
#include "detent/lockstep/replay_totals.hpp"
#include "detent/lockstep/session.hpp"
