// SPDX-License-Identifier: MIT
//
// Moving bodies are apart at every sampled time before their time of impact, or at every sampled
// time if there is none, and at that time as close as stated.

#include "decode.hpp"
#include "oracle/describe.hpp"
#include "oracle/hull.hpp"
#include "oracle/impact_truth.hpp"
#include "spaces.hpp"

namespace detent::fuzz {
namespace {

template <Scalar S, int N>
Sweep<S, N> sweep_of(Decoder<S, N>& decoder, Source& source) {
  const auto start = decoder.point();
  Sweep<S, N> sweep{start, source.below(8) == 0 ? start : decoder.point()};
  if (source.below(3) == 0) return sweep;
  sweep.start_rotation = decoder.rotation();
  sweep.end_rotation = source.below(4) == 0 ? sweep.start_rotation : decoder.rotation();
  return sweep;
}

template <class A, class B, Scalar S, int N>
void check(Decoder<S, N>& decoder, Source& source) {
  const auto a = decoder.template shape<A>();
  const auto b = decoder.template shape<B>();
  const auto sweep_a = sweep_of(decoder, source), sweep_b = sweep_of(decoder, source);
  const S target = S::from_raw(static_cast<typename S::raw_type>(source.below(64)));
  const auto impact = time_of_impact(a, sweep_a, b, sweep_b, target);
  const auto because = [&](const std::string& fault) {
    return fault + ": " + oracle::describe(a) + "; " + oracle::describe(b);
  };
  const bool is_empty = !detail::has_points(a) || !detail::has_points(b);
  require(!impact || !is_empty, [&] { return because("an empty shape is hit"); });
  if (is_empty) return;
  const auto fault =
      oracle::fault_of(impact, oracle::moving(a, sweep_a), oracle::moving(b, sweep_b), target, 6);
  require(!fault, [&] { return because(*fault); });
}

}  // namespace

void property(Bytes input) {
  Source source(input);
  in_a_space(source, [&]<Scalar S, int N>(Space<S, N>) {
    const auto one_of = [&](const auto& f) {
      with_one_of(support::MovingShapes<S, N>(), source, f);
    };
    one_of([&]<class A>(std::type_identity<A>) {
      one_of([&]<class B>(std::type_identity<B>) {
        Decoder<S, N> decoder(source);
        check<A, B>(decoder, source);
      });
    });
  });
}

}  // namespace detent::fuzz
