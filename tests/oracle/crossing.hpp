// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "oracle/solid.hpp"

namespace detent::oracle {

/// The set of right normals.
template <int N>
struct Normal {
  virtual ~Normal() = default;
  [[nodiscard]] virtual bool allows(const Raw<N>& given) const = 0;
  [[nodiscard]] virtual std::string text() const = 0;
};
template <int N>
using NormalPointer = std::shared_ptr<const Normal<N>>;

/// A normal that is one of the stored directions.
template <int N>
struct StoredNormal final : Normal<N> {
  Vector<N> direction;

  explicit StoredNormal(const Vector<N>& exact) : direction(exact) {}
  [[nodiscard]] bool allows(const Raw<N>& given) const override;
  [[nodiscard]] std::string text() const override;
};

/// A normal along an integer vector: every component rounded to nearest. There are no ties: a tie
/// would need a vector of even length whose components have no common factor, which squares modulo
/// 4 rule out.
template <int N>
struct NormalizedNormal final : Normal<N> {
  Vector<N> along;
  Integer one;

  NormalizedNormal(const Vector<N>& exact, const Integer& length) : along(exact), one(length) {}
  [[nodiscard]] bool allows(const Raw<N>& given) const override;
  [[nodiscard]] std::string text() const override;
};

/// The interval of a line in a shape: the first and the last time, rounded down, and the normal at
/// the first.
template <int N>
struct Crossing {
  Integer enter, exit;
  NormalPointer<N> normal;
};

[[nodiscard]] std::optional<Crossing<2>> crossing(const Line<2>& line, const Solid<2>& solid);
[[nodiscard]] std::optional<Crossing<3>> crossing(const Line<3>& line, const Solid<3>& solid);

}  // namespace detent::oracle
