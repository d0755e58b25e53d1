// SPDX-License-Identifier: MIT
#include "scalar_casts.hpp"

template detent::cli::CastReport detent::cli::cast_throws<detent::q16_16>(
    const Scene&, const Move&, const std::vector<Throw>&, bool, const detent::cli::Workers&);
template detent::cli::ContactReport detent::cli::contacts_of<detent::q16_16>(
    const Scene&, const Move&, const std::vector<Throw>&, bool, const detent::cli::Workers&);
