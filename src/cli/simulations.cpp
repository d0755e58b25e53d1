// SPDX-License-Identifier: MIT
#include <stdexcept>

#include "simulation.hpp"

namespace detent::cli {
namespace {

template <Scalar S>
std::unique_ptr<Simulation> of_scalar(const WorldModel& model, const Move& move) {
  return model.dimension == 2 ? make_simulation<S, 2>(model, move)
                              : make_simulation<S, 3>(model, move);
}

}  // namespace

std::unique_ptr<Simulation> make_simulation(std::string_view scalar, const WorldModel& model,
                                            const Move& move) {
  if (scalar == "q16_16") return of_scalar<q16_16>(model, move);
  if (scalar == "float") return of_scalar<float>(model, move);
  if (scalar == "double") return of_scalar<double>(model, move);
  throw std::invalid_argument("no scalar of this name");
}

}  // namespace detent::cli
