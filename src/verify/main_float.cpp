// SPDX-License-Identifier: MIT
//
// The contrast to main_bare.cpp: the questions of q16_16, in the highest dimension of each,
// converted to float and run through the same templates in float arithmetic. There are no golden
// values: the digests are this platform's own. It leaves out text, which the library does not have
// for floats, moving shapes, and surfaces and scenes, which run the same queries as other rows.
//
//     g++ -std=c++20 -O2 -Iinclude -Isrc src/verify/main_float.cpp -o floats && ./floats

#include <cstdio>
#include <utility>

#include "verify/corpus.hpp"
#include "verify/float_cases.hpp"
#include "verify/sink.hpp"

namespace {

using namespace detent;
using namespace detent::verify;

#ifdef DETENT_VERIFY_SMALL
constexpr auto size = small_size;
#else
constexpr auto size = full_size;
#endif

void put_line(void (*put)(const char*), std::string_view name, std::uint64_t digest) {
  char line[64];
  std::snprintf(line, sizeof line, "%.*s %08lx%08lx\n", static_cast<int>(name.size()), name.data(),
                static_cast<unsigned long>(digest >> 32),
                static_cast<unsigned long>(digest & 0xffffffffu));
  put(line);
}

template <class Group>
constexpr int highest_dimension = Group::template asks<3>   ? 3
                                  : Group::template asks<2> ? 2
                                                            : 1;

template <class Case>
concept HasFloats = requires(const Case& c) {
  in_float<float>(c);
};
template <class Group>
constexpr bool asks_floats =
    HasFloats<decltype(draw<Group, q16_16, highest_dimension<Group>>(std::declval<Random&>()))>;

template <class Group, int N, std::size_t Rows>
void add_cells(std::array<Digest, Rows>& digests) {
  std::array<Sink<IntoDigest>, Rows> sinks;
  visit_cases<Group, q16_16, N>(
      size, [&](const auto& c) { answer_all<Group>(in_float<float>(c), sinks); });
  for (std::size_t row = 0; row < Rows; ++row) {
    digests[row].add(sinks[row].taken().digest.value());
  }
}

}  // namespace

extern "C" int detent_verify(void (*put)(const char*)) {
  Digest all;
  visit_groups([&]<class Group>(Group) {
    if constexpr (asks_floats<Group>) {
      std::array<Digest, rows_of<Group>()> digests;
      add_cells<Group, highest_dimension<Group>>(digests);
      for (std::size_t row = 0; row < digests.size(); ++row) {
        put_line(put, Group::names[row], digests[row].value());
        all.add(digests[row].value());
      }
    }
  });
  put_line(put, "all", all.value());
  return 0;
}

#ifndef DETENT_VERIFY_NO_MAIN
int main() {
  return detent_verify([](const char* text) { std::fputs(text, stdout); });
}
#endif
