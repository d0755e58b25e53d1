// SPDX-License-Identifier: MIT
//
// usage: expected full|small|parts|names, or for a quarter full.N|small.N|parts.N
// Prints the expected output of the verification program, from the golden digests alone, without
// running any queries. The host compiles it, so a target that miscompiles the comparison cannot
// pass. `parts` prints the expected output of one program per part of the small corpus, one after
// the other; `names` prints the parts.

#include <cinttypes>
#include <cstdio>
#include <string_view>

#include "verify/check.hpp"

using namespace detent::verify;

namespace {

using Cells = decltype(golden::full);

void print(std::string_view name, std::uint64_t digest) {
  std::printf("%.*s %016" PRIx64 " ok\n", static_cast<int>(name.size()), name.data(), digest);
}

template <class Part, class Share>
void print_part(const Cells& cells) {
  detent::Digest all;
  std::size_t cell = first_cell<Part>();
  visit_groups<Part>([&]<class Group>(Group) {
    for (const auto name : Group::names) {
      detent::Digest row;
      visit_spaces<Group>([&]<class S, int N>(Space<S, N>) {
        const auto digest = cells[cell++];
        if constexpr (Share::template has<Group, S, N>) row.add(digest);
      });
      print(name, row.value());
      all.add(row.value());
    }
  });
  print(Part::name, all.value());
}

template <class Share>
void print_all(std::string_view size) {
  if (size == "parts") {
    visit_parts([]<class Part>(Part) { print_part<Part, Share>(golden::small); });
  } else {
    print_part<Corpus, Share>(size == "small" ? golden::small : golden::full);
  }
}

}  // namespace

int main(int argc, char** argv) {
  const std::string_view what = argc == 2 ? argv[1] : "full";
  const auto size = what.substr(0, what.find('.'));
  if (what == "names") {
    visit_parts([]<class Part>(Part) { std::printf("%s\n", Part::name.data()); });
  } else if (what.ends_with(".0")) {
    print_all<Quarter<0>>(size);
  } else if (what.ends_with(".1")) {
    print_all<Quarter<1>>(size);
  } else if (what.ends_with(".2")) {
    print_all<Quarter<2>>(size);
  } else if (what.ends_with(".3")) {
    print_all<Quarter<3>>(size);
  } else {
    print_all<Whole>(size);
  }
}
