// SPDX-License-Identifier: MIT
//
// usage: expected full|small|parts|few, or full.N|small.N|parts.N|few.N for a quarter; each may
// have the prefix names-, such as names-full
// Prints the expected output of the verification programs, one after the other, from the golden
// digests alone, without running any query. It is compiled for the host, so a target that
// miscompiles the comparison cannot pass. `full` and `small` are one program per volume of the
// corpus; `parts` is the small corpus with one program per part; `few` omits large parts.
// `names-...` prints the names of the volumes or parts.

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

template <class Part>
constexpr bool is_large = requires {
  Part::large;
};

/// Calls visit(Part{}) for every program of a corpus.
template <class Visit>
void visit_programs(std::string_view corpus, Visit visit) {
  if (corpus == "parts" || corpus == "few") {
    visit_parts([&]<class Part>(Part part) {
      if (corpus == "parts" || !is_large<Part>) visit(part);
    });
  } else {
    visit_volumes(visit);
  }
}

template <class Share>
void print_all(std::string_view corpus) {
  visit_programs(corpus, [&]<class Part>(Part) {
    print_part<Part, Share>(corpus == "full" ? golden::full : golden::small);
  });
}

}  // namespace

int main(int argc, char** argv) {
  const std::string_view what = argc == 2 ? argv[1] : "full";
  constexpr std::string_view names = "names-";
  const auto size = what.substr(0, what.find('.'));
  if (what.starts_with(names)) {
    visit_programs(size.substr(names.size()),
                   []<class Part>(Part) { std::printf("%s\n", Part::name.data()); });
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
