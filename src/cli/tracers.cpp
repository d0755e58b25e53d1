// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <stdexcept>

#include "numbers.hpp"
#include "tracer.hpp"

namespace detent::cli {

std::unique_ptr<Tracer> make_tracer(std::string_view scalar, const Scene& scene, const Move& move) {
  using Maker = std::unique_ptr<Tracer> (*)(const Scene&, const Move&);
  constexpr auto makers = []<class... S>(support::ScalarList<S...>) {
    return std::array<Maker, sizeof...(S)>{make_tracer<S>...};
  }(support::AllScalars());
  const auto at = std::find(scalar_names.begin(), scalar_names.end(), scalar);
  if (at == scalar_names.end()) throw std::invalid_argument("no scalar of this name");
  return makers[static_cast<std::size_t>(at - scalar_names.begin())](scene, move);
}

}  // namespace detent::cli
