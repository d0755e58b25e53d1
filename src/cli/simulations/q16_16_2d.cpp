// SPDX-License-Identifier: MIT
#include "scalar_simulation.hpp"

template std::unique_ptr<detent::cli::Simulation> detent::cli::make_simulation<detent::q16_16, 2>(
    const WorldModel&, const Move&);
