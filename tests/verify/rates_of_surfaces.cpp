// SPDX-License-Identifier: MIT
#include "rates.hpp"

std::size_t detent::verify::rates_of_surfaces() { return check_rates<MeshAnswers, FieldAnswers>(); }
