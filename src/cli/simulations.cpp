// SPDX-License-Identifier: MIT
#include <stdexcept>

#include "simulation.hpp"

namespace detent::cli {

std::unique_ptr<Simulation> make_simulation(std::string_view scalar, const WorldModel& model,
                                            const Move& move) {
  if (scalar == "q16_16") return make_simulation<q16_16>(model, move);
  if (scalar == "float") return make_simulation<float>(model, move);
  if (scalar == "double") return make_simulation<double>(model, move);
  throw std::invalid_argument("no scalar of this name");
}

}  // namespace detent::cli
