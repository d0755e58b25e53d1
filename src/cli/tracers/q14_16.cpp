// SPDX-License-Identifier: MIT
#include "scalar_tracer.hpp"

template std::unique_ptr<detent::cli::Tracer> detent::cli::make_tracer<detent::q14_16>(const Scene&,
                                                                                       const Move&);
