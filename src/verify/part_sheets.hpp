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

/// Calls `visit(Group{}, Space<S, N>{})` for the sheet of a part with this index.
template <class Part, class Visit>
void visit_sheet(std::size_t index, Visit&& visit) {
  std::size_t at = 0;
  visit_groups<Part>([&]<class Group>(Group group) {
    visit_spaces<Group>([&](auto space) {
      if (at++ == index) visit(group, space);
    });
  });
}

template <int Row, class Group, class Case>
void judge_row(const Case& c, std::uint32_t index, std::optional<Finding>& finding) {
  if (auto wrong = judge::judge<Row>(c, answer<Group, Row>(c))) {
    finding = Finding{index, fields_of(c), std::move(wrong->expected), std::move(wrong->got)};
  }
}

/// The cells of a group in one space. Groups that take long to compile have one source per space:
/// one_space.cpp.in.
template <class Group, Scalar S, int N>
struct GroupSheet {
  static std::vector<Answers> answers(std::uint32_t size, bool keep_bytes);
  static std::optional<Finding> first_wrong(std::size_t row, std::uint32_t size);
};

template <class Group, Scalar S, int N>
std::vector<Answers> GroupSheet<Group, S, N>::answers(std::uint32_t size, bool keep_bytes) {
  std::array<RowSink, rows_of<Group>()> sinks;
  for (auto& sink : sinks) sink.bytes = Sink(IntoBytes{keep_bytes, {}, {}});
  visit_cases<Group, S, N>(size, [&](const auto& c) { answer_all<Group>(c, sinks); });
  std::vector<Answers> answers;
  answers.reserve(sinks.size());
  for (const auto& sink : sinks) {
    const auto& taken = sink.bytes.taken();
    answers.push_back({taken.digest.value(), taken.bytes, sink.yes});
  }
  return answers;
}

template <class Group, Scalar S, int N>
std::optional<Finding> GroupSheet<Group, S, N>::first_wrong(std::size_t row, std::uint32_t size) {
  std::optional<Finding> finding;
  std::uint32_t index = 0;
  visit_cases<Group, S, N>(size, [&]<class Case>(const Case& c) {
    [&]<std::size_t... Row>(std::index_sequence<Row...>) {
      if (finding) return;
      ((Row == row ? judge_row<static_cast<int>(Row), Group>(c, index, finding) : void()), ...);
    }
    (std::make_index_sequence<rows_of<Group>()>{});
    ++index;
  });
  return finding;
}

}  // namespace detail

template <class Part>
std::vector<Answers> PartSheets<Part>::answer(std::size_t sheet, std::uint32_t size,
                                              bool keep_bytes) {
  std::vector<Answers> answers;
  detail::visit_sheet<Part>(sheet, [&]<class Group, class S, int N>(Group, Space<S, N>) {
    answers = detail::GroupSheet<Group, S, N>::answers(size, keep_bytes);
  });
  return answers;
}

template <class Part>
std::uint64_t PartSheets<Part>::digest_of_questions(std::size_t sheet, std::uint32_t size) {
  Sink<detail::IntoBytes> sink;
  detail::visit_sheet<Part>(sheet, [&]<class Group, class S, int N>(Group, Space<S, N>) {
    visit_cases<Group, S, N>(size, [&](const auto& c) { sink.add(c); });
  });
  return sink.taken().digest.value();
}

template <class Part>
std::optional<Finding> PartSheets<Part>::first_wrong(std::size_t sheet, std::size_t row,
                                                     std::uint32_t size) {
  std::optional<Finding> finding;
  detail::visit_sheet<Part>(sheet, [&]<class Group, class S, int N>(Group, Space<S, N>) {
    finding = detail::GroupSheet<Group, S, N>::first_wrong(row, size);
  });
  return finding;
}

}  // namespace detent::verify
