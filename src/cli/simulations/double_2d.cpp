// SPDX-License-Identifier: MIT
#include "scalar_simulation.hpp"

template std::unique_ptr<detent::cli::Simulation> detent::cli::make_simulation<double, 2>(
    const WorldModel&, const Move&);
