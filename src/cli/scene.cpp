// SPDX-License-Identifier: MIT
#include "scene.hpp"

namespace detent::cli {

Point point_of(const char* x, const char* y, const char* z) {
  return {Literal{Decimal::parse(x).value(), {}}, Literal{Decimal::parse(y).value(), {}},
          Literal{Decimal::parse(z).value(), {}}};
}

std::string name_of(const std::optional<std::string>& id, std::size_t index) {
  return id ? *id : std::to_string(index);
}

Colour default_colour(std::size_t index) {
  static constexpr std::array<Colour, 8> palette{{{0x8d, 0xa1, 0x78},
                                                  {0xc9, 0x6f, 0x4a},
                                                  {0x4f, 0x86, 0xb0},
                                                  {0xd9, 0xb3, 0x52},
                                                  {0x7e, 0x69, 0xa8},
                                                  {0x5c, 0xa8, 0x98},
                                                  {0xb8, 0x5a, 0x7a},
                                                  {0x9a, 0x9a, 0x9a}}};
  return palette[index % palette.size()];
}

}  // namespace detent::cli
