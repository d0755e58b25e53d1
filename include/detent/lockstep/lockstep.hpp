// SPDX-License-Identifier: MIT
#pragma once

// Matches over a network, without the network: `Session` takes packets and gives packets;
// `ReplayWriter` and `check_replay` keep a match and simulate it again.

#include "detent/lockstep/config.hpp"
#include "detent/lockstep/event.hpp"
#include "detent/lockstep/input_codec.hpp"
#include "detent/lockstep/replay.hpp"
#include "detent/lockstep/replay_totals.hpp"
#include "detent/lockstep/session.hpp"
