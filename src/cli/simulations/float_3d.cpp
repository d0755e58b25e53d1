// SPDX-License-Identifier: MIT
#include "scalar_simulation.hpp"

template std::unique_ptr<detent::cli::Simulation> detent::cli::make_simulation<float, 3>(
    const WorldModel&, const Move&);
