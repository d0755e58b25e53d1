// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "detent/query/contact.hpp"
#include "oracle/contact_answer.hpp"
#include "oracle/hull.hpp"
#include "oracle/pair_exam.hpp"
#include "support/shapes.hpp"

namespace detent::oracle {

/// Compares the contacts of random pairs of shapes with the oracle's.
template <Scalar S, int N>
class ContactExam {
 public:
  explicit ContactExam(std::uint64_t seed) : draw_(seed) {}

  template <class A, class B>
  void examine(long count) {
    if constexpr (!(std::is_same_v<A, Plane<S, N>> && std::is_same_v<A, B>)) {
      const long met_before = met_;
      for (long i = 0; i < count; ++i) {
        const auto setting = any_setting(draw_, Kind::general, 70);
        const auto a = draw_shape<A>(draw_, setting);
        const auto b = draw_shape<B>(draw_, setting);
        if (!is_right(a, b)) return;
      }
      const long met = met_ - met_before;
      INFO(draw_.random << ", " << met << " of " << count);
      CHECK(met > 0);
      CHECK(met < count);
    }
  }

  /// Whether the contacts of a and b in both orders are the oracle's; otherwise also reports them.
  template <class A, class B>
  bool is_right(const A& a, const B& b) {
    const auto found = contact(a, b), mirrored = contact(b, a);
    ++asked_;
    met_ += found.has_value();
    const char* wrong = mistake<S, N>(a, b, found, mirrored);
    if (wrong == nullptr) return true;
    const auto truth = least_push(exact(a), exact(b));
    FAIL_CHECK(draw_.random << ", " << wrong << ": " << describe(a) << "; " << describe(b)
                            << "; expected " << text(truth) << ", found " << text(found) << " and "
                            << text(mirrored));
    return false;
  }

  /// How many of the pairs met so far.
  [[nodiscard]] long met() const { return met_; }

  void finish() {
    INFO(draw_.random << ", " << met_ << " of " << asked_ << " pairs meet");
    CHECK(met_ >= asked_ * 3 / 10);
    CHECK(met_ <= asked_ * 7 / 10);
  }

 private:
  static std::string text(const std::optional<Push<N>>& truth) {
    std::string out = truth ? truth->depth.str() + " along" : "nothing";
    if (truth) {
      for (std::size_t i = 0; i < truth->normal.size(); ++i) {
        out += " " + (is_zero(truth->normal) ? Integer(0)
                                             : unit_component<N>(truth->normal, i, one_of<S>()))
                         .str();
      }
    }
    return out;
  }
  static std::string text(const std::optional<Contact<S, N>>& found) {
    std::string out = found ? raw(found->depth).str() + " along" : "nothing";
    for (int i = 0; found && i < N; ++i) out += " " + std::to_string(found->normal[i].raw());
    for (std::size_t k = 0; found && k < found->count; ++k) {
      out += "; at " + describe(found->points[k].point) + " " + raw(found->points[k].depth).str() +
             " of " + std::to_string(found->points[k].feature);
    }
    return out;
  }

  Draw<S, N> draw_;
  long met_ = 0, asked_ = 0;
};

/// `count` pairs of every two kinds of shapes.
template <Scalar S, int N>
void examine_contacts(std::uint64_t seed, long count) {
  ContactExam<S, N> exam(seed);
  support::AllShapes<S, N>::for_each_pair(
      [&]<class A, class B>(const A&, const B&) { exam.template examine<A, B>(count); });
  exam.finish();
}

}  // namespace detent::oracle
