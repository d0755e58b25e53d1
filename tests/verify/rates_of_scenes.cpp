// SPDX-License-Identifier: MIT
#include "rates.hpp"

std::size_t detent::verify::rates_of_scenes() {
  return check_rates<SceneAnswers, SceneContacts, Snapshots>();
}
