// SPDX-License-Identifier: MIT
#include "oracle/crossing.hpp"

#include "oracle/crossing_parts.hpp"

namespace detent::oracle {

template <int N>
bool StoredNormal<N>::allows(const Raw<N>& given) const {
  return widen(given) == direction;
}
template <int N>
std::string StoredNormal<N>::text() const {
  std::string out;
  for (const auto& component : direction) out += (out.empty() ? "{" : ", ") + component.str();
  return out + "}";
}

template <int N>
bool NormalizedNormal<N>::allows(const Raw<N>& given) const {
  const Integer length_squared = dot(along, along);
  for (std::size_t i = 0; i < given.size(); ++i) {
    const int sign = along[i].sign();
    const Integer magnitude = sign < 0 ? Integer(-given[i]) : Integer(given[i]);
    if (magnitude < 0 || (sign == 0 && magnitude != 0)) return false;
    const Integer twice = 4 * along[i] * along[i] * one * one;
    const Integer above = 2 * magnitude + 1;
    const Integer below = 2 * magnitude - 1;
    if (twice > above * above * length_squared) return false;
    if (magnitude > 0 && twice < below * below * length_squared) return false;
  }
  return true;
}
template <int N>
std::string NormalizedNormal<N>::text() const {
  std::string out = "along";
  for (const auto& component : along) out += " " + component.str();
  return out;
}

template struct StoredNormal<2>;
template struct StoredNormal<3>;
template struct NormalizedNormal<2>;
template struct NormalizedNormal<3>;

std::optional<Crossing<2>> crossing(const Line<2>& line, const Solid<2>& solid) {
  if (line.max < 0) return {};
  return std::visit([&](const auto& shape) { return crossing_of(line, shape); }, solid);
}
std::optional<Crossing<3>> crossing(const Line<3>& line, const Solid<3>& solid) {
  if (line.max < 0) return {};
  return std::visit([&](const auto& shape) { return crossing_of(line, shape); }, solid);
}

}  // namespace detent::oracle
