// SPDX-License-Identifier: MIT
// A query of two shapes that do not move. CMakeLists.txt compiles it for every query, dimension and
// pair: contacts of one shape with all others take g++ more than 900 MB.

#include "bench/still_pairs.hpp"
#include "bench/suite.hpp"

namespace detent::bench {

template <PairQuery What, int N, int A, int B>
void add_pair(Suite& suite) {
  visit_pair<What, N, A, B>([&](const auto& query) { suite.add_pair(query); });
}
template void add_pair<PairQuery::DETENT_BENCH_QUERY, DETENT_BENCH_DIMENSION, DETENT_BENCH_A,
                       DETENT_BENCH_B>(Suite&);

}  // namespace detent::bench
