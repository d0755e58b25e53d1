// SPDX-License-Identifier: MIT
// A cast of one moving shape at a target. CMakeLists.txt compiles it for every pair and dimension:
// those of a moving capsule at two targets take g++ 900 MB.

#include "bench/pairs.hpp"
#include "bench/suite.hpp"

namespace detent::bench {

template <template <class, int> class Shape, int N, int Target>
void add_cast(Suite& suite) {
  visit_cast<Shape, N, Target>([&](const auto& query) { suite.add_pair(query); });
}
template void add_cast<DETENT_BENCH_SHAPE, DETENT_BENCH_DIMENSION, DETENT_BENCH_TARGET>(Suite&);

}  // namespace detent::bench
