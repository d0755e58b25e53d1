// SPDX-License-Identifier: MIT
// Two moving bodies, or a shape at a mesh. CMakeLists.txt compiles it for every row.

#include "bench/bodies.hpp"
#include "bench/suite.hpp"

namespace detent::bench {

template <int Row>
void add_body(Suite& suite) {
  visit_body<Row>([&](const auto& query) { suite.add_pair(query); });
}
template void add_body<DETENT_BENCH_ROW>(Suite&);

}  // namespace detent::bench
