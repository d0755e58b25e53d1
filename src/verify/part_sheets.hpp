// SPDX-License-Identifier: MIT
#pragma once

#include <concepts>
#include <cstdint>
#include <optional>

#include "verify/corpus.hpp"
#include "verify/judge.hpp"
#include "verify/part.hpp"
#include "verify/sink.hpp"

// For the sources of the parts, which instantiate these definitions: part.cpp.in.

namespace detent::verify {
namespace detail {

/// The digest of the bytes, and the bytes themselves if requested.
struct IntoBytes {
  bool keeps_bytes = false;
  Digest digest{};
  std::string bytes;

#if defined(__GNUC__)
  [[gnu::noinline]]  // called for every number of every result: inlining it compiles slowly
#endif
  void
  operator()(std::uint64_t word, int count) {
    digest.add_low_bytes(word, count);
    if (!keeps_bytes) return;
    for (int i = 0; i < count; ++i) bytes += static_cast<char>((word >> (8 * i)) & 0xff);
  }
};

template <class T>
inline constexpr bool is_optional = false;
template <class T>
inline constexpr bool is_optional<std::optional<T>> = true;

/// Takes the results of a row, and counts those that are yes.
struct RowSink {
  Sink<IntoBytes> bytes;
  std::uint32_t yes = 0;

  template <class T>
  void add(const T& answer) {
    if constexpr (std::same_as<T, bool>) yes += answer ? 1u : 0u;
    if constexpr (is_optional<T>) yes += answer.has_value() ? 1u : 0u;
    bytes.add(answer);
  }
};

/// Calls `visit(Space<S, N>{})` with the space of a part's sheet.
template <class Part, class Visit>
void visit_space(std::size_t sheet, Visit&& visit) {
  std::size_t at = 0;
  visit_groups<Part>([&]<class Group>(Group) {
    visit_spaces<Group>([&](auto space) {
      if (at++ == sheet) visit(space);
    });
  });
}

/// Calls `visit(Group{})` with the group of a part's sheet of N dimensions.
template <class Part, int N, class Visit>
void visit_group(std::size_t sheet, Visit&& visit) {
  std::size_t first = 0;
  visit_groups<Part>([&]<class Group>(Group group) {
    const std::size_t last = first + spaces_of<Group>();
    if constexpr (Group::template asks<N>) {
      if (sheet >= first && sheet < last) visit(group);
    }
    first = last;
  });
}

template <int Row, class Group, class Case>
void judge_row(const Case& c, std::uint32_t index, std::optional<Finding>& finding) {
  if (auto wrong = judge::judge<Row>(c, answer<Group, Row>(c))) {
    finding = Finding{index, fields_of(c), std::move(wrong->expected), std::move(wrong->got)};
  }
}

/// The operations of `PartSheets` on sheets in one space. They can be compiled in a source of their
/// own: one_space.cpp.in.
template <class Part, Scalar S, int N>
struct SpaceSheets {
  static std::vector<Answers> answer(std::size_t sheet, std::uint32_t size, bool keep_bytes);
  static std::uint64_t digest_of_questions(std::size_t sheet, std::uint32_t size);
  static std::optional<Finding> first_wrong(std::size_t sheet, std::size_t row, std::uint32_t size);
};

template <class Part, Scalar S, int N>
std::vector<Answers> SpaceSheets<Part, S, N>::answer(std::size_t sheet, std::uint32_t size,
                                                     bool keep_bytes) {
  std::vector<Answers> answers;
  visit_group<Part, N>(sheet, [&]<class Group>(Group) {
    std::array<RowSink, rows_of<Group>()> sinks;
    for (auto& sink : sinks) sink.bytes = Sink(IntoBytes{keep_bytes, {}, {}});
    visit_cases<Group, S, N>(size, [&](const auto& c) { answer_all<Group>(c, sinks); });
    answers.reserve(sinks.size());
    for (const auto& sink : sinks) {
      const auto& taken = sink.bytes.taken();
      answers.push_back({taken.digest.value(), taken.bytes, sink.yes});
    }
  });
  return answers;
}

template <class Part, Scalar S, int N>
std::uint64_t SpaceSheets<Part, S, N>::digest_of_questions(std::size_t sheet, std::uint32_t size) {
  Sink<IntoBytes> sink;
  visit_group<Part, N>(sheet, [&]<class Group>(Group) {
    visit_cases<Group, S, N>(size, [&](const auto& c) { sink.add(c); });
  });
  return sink.taken().digest.value();
}

template <class Part, Scalar S, int N>
std::optional<Finding> SpaceSheets<Part, S, N>::first_wrong(std::size_t sheet, std::size_t row,
                                                            std::uint32_t size) {
  std::optional<Finding> finding;
  visit_group<Part, N>(sheet, [&]<class Group>(Group) {
    std::uint32_t index = 0;
    visit_cases<Group, S, N>(size, [&]<class Case>(const Case& c) {
      [&]<std::size_t... Row>(std::index_sequence<Row...>) {
        if (finding) return;
        ((Row == row ? judge_row<static_cast<int>(Row), Group>(c, index, finding) : void()), ...);
      }
      (std::make_index_sequence<rows_of<Group>()>{});
      ++index;
    });
  });
  return finding;
}

}  // namespace detail

template <class Part>
std::vector<Answers> PartSheets<Part>::answer(std::size_t sheet, std::uint32_t size,
                                              bool keep_bytes) {
  std::vector<Answers> answers;
  detail::visit_space<Part>(sheet, [&]<class S, int N>(Space<S, N>) {
    answers = detail::SpaceSheets<Part, S, N>::answer(sheet, size, keep_bytes);
  });
  return answers;
}

template <class Part>
std::uint64_t PartSheets<Part>::digest_of_questions(std::size_t sheet, std::uint32_t size) {
  std::uint64_t digest = 0;
  detail::visit_space<Part>(sheet, [&]<class S, int N>(Space<S, N>) {
    digest = detail::SpaceSheets<Part, S, N>::digest_of_questions(sheet, size);
  });
  return digest;
}

template <class Part>
std::optional<Finding> PartSheets<Part>::first_wrong(std::size_t sheet, std::size_t row,
                                                     std::uint32_t size) {
  std::optional<Finding> finding;
  detail::visit_space<Part>(sheet, [&]<class S, int N>(Space<S, N>) {
    finding = detail::SpaceSheets<Part, S, N>::first_wrong(sheet, row, size);
  });
  return finding;
}

}  // namespace detent::verify
