// SPDX-License-Identifier: MIT
//
// usage: expected full|small
// Prints what the verification program has to print, from the golden digests alone: no question is
// asked. The host compiles it, so a target that miscompiles the comparison cannot pass.

#include <cinttypes>
#include <cstdio>
#include <string_view>

#include "verify/check.hpp"

using namespace detent::verify;

int main(int argc, char** argv) {
  const bool small = argc == 2 && std::string_view(argv[1]) == "small";
  const auto& cells = small ? golden::small : golden::full;
  const auto print = [](std::string_view name, std::uint64_t digest) {
    std::printf("%.*s %016" PRIx64 " ok\n", static_cast<int>(name.size()), name.data(), digest);
  };

  detent::Digest all;
  std::size_t cell = 0;
  visit_groups([&]<class Group>(Group) {
    for (const auto name : Group::names) {
      detent::Digest row;
      for (std::size_t space = 0; space < spaces_of<Group>(); ++space) row.add(cells[cell++]);
      print(name, row.value());
      all.add(row.value());
    }
  });
  print("all", all.value());
}
