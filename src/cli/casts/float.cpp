// SPDX-License-Identifier: MIT
#include "scalar_casts.hpp"

template detent::cli::CastReport detent::cli::cast_throws<float>(const Scene&, const Move&,
                                                                 const std::vector<Throw>&, bool,
                                                                 const detent::cli::Workers&);
template detent::cli::ContactReport detent::cli::contacts_of<float>(const Scene&, const Move&,
                                                                    const std::vector<Throw>&, bool,
                                                                    const detent::cli::Workers&);
