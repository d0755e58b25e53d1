// SPDX-License-Identifier: MIT
//
// usage: expected full|small|parts|names
// Prints what the verification program has to print, from the golden digests alone: no question is
// asked. The host compiles it, so a target that miscompiles the comparison cannot pass. With
// `parts` it prints what one program for each part of the small corpus has to, one after the other,
// and with `names` the parts.

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

template <class Part>
void print_part(const Cells& cells) {
  detent::Digest all;
  std::size_t cell = first_cell<Part>();
  visit_groups<Part>([&]<class Group>(Group) {
    for (const auto name : Group::names) {
      detent::Digest row;
      for (std::size_t space = 0; space < spaces_of<Group>(); ++space) row.add(cells[cell++]);
      print(name, row.value());
      all.add(row.value());
    }
  });
  print(Part::name, all.value());
}

}  // namespace

int main(int argc, char** argv) {
  const std::string_view what = argc == 2 ? argv[1] : "full";
  if (what == "parts") {
    visit_parts([]<class Part>(Part) { print_part<Part>(golden::small); });
  } else if (what == "names") {
    visit_parts([]<class Part>(Part) { std::printf("%s\n", Part::name.data()); });
  } else {
    print_part<Corpus>(what == "small" ? golden::small : golden::full);
  }
}
