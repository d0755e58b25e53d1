// SPDX-License-Identifier: MIT
#include "verify.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <numeric>
#include <optional>
#include <vector>

#include "commands.hpp"
#include "detent/number/digest.hpp"
#include "detent/version.hpp"
#include "error.hpp"
#include "file.hpp"
#include "print.hpp"
#include "verify/corpus.hpp"
#include "verify/golden.hpp"
#include "verify/sheets.hpp"
#include "workers.hpp"

namespace detent::cli {
namespace {

using verify::Answers;
using verify::Finding;
using verify::Sheet;
using verify::sheets;
using Json = nlohmann::ordered_json;

/// A sheet's results for one row, and their golden digest.
struct Cell {
  std::size_t sheet = 0;
  std::size_t row = 0;  // of the sheet
  Answers answers;
  std::optional<std::uint64_t> golden;

  [[nodiscard]] bool is_golden() const { return answers.digest == golden; }
  [[nodiscard]] std::string name() const {
    const Sheet& from = sheets()[sheet];
    return std::string(from.scalar) + " " + std::to_string(from.dimension) + "D";
  }
  [[nodiscard]] std::uint32_t questions(std::uint32_t size) const {
    return sheets()[sheet].questions(size);
  }
};

/// A query: a line of the report.
struct Row {
  std::string name;
  std::vector<Cell> cells;

  [[nodiscard]] std::uint64_t digest() const {
    Digest digest;
    for (const Cell& cell : cells) digest.add(cell.answers.digest);
    return digest.value();
  }
  [[nodiscard]] std::uint64_t golden() const {
    Digest digest;
    for (const Cell& cell : cells) digest.add(cell.golden.value_or(0));
    return digest.value();
  }
  [[nodiscard]] bool is_golden() const {
    return std::all_of(cells.begin(), cells.end(), [](const Cell& c) { return c.is_golden(); });
  }
  /// The number of questions of the row in a corpus of this size.
  [[nodiscard]] std::uint64_t questions(std::uint32_t size) const {
    return std::accumulate(
        cells.begin(), cells.end(), std::uint64_t{0},
        [&](std::uint64_t sum, const Cell& cell) { return sum + cell.questions(size); });
  }
};

std::string digits(std::uint64_t value) { return hexadecimal(value).substr(2); }

std::string words_of_environment() {
  std::string words =
#if defined(__clang__)
      "clang " __clang_version__;
#elif defined(__GNUC__)
      "gcc " __VERSION__;
#elif defined(_MSC_VER)
      "MSVC " + std::to_string(_MSC_FULL_VER);
#else
      "an unknown compiler";
#endif
  while (words.back() == ' ') words.pop_back();
  return words;
}
constexpr int word_bits = static_cast<int>(8 * sizeof(void*));
constexpr const char* byte_order = std::endian::native == std::endian::little ? "little" : "big";
constexpr const char* int128 = DETENT_NATIVE_INT128 ? "native" : "portable";

std::vector<std::string> row_names() {
  std::vector<std::string> names;
  for (const Sheet& sheet : sheets()) {
    if (sheet.first_row != names.size()) continue;
    names.insert(names.end(), sheet.rows.begin(), sheet.rows.end());
  }
  return names;
}

/// The rows that --only selects, not yet run.
std::vector<Row> chosen_rows(const std::string& only) {
  const auto names = row_names();
  std::vector<Row> all(names.size());
  for (std::size_t i = 0; i < sheets().size(); ++i) {
    const Sheet& sheet = sheets()[i];
    for (std::size_t row = 0; row < sheet.rows.size(); ++row) {
      all[sheet.first_row + row].cells.push_back({i, row, {}, std::nullopt});
    }
  }
  std::vector<Row> chosen;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (names[i].compare(0, only.size(), only) != 0) continue;
    all[i].name = names[i];
    chosen.push_back(std::move(all[i]));
  }
  if (chosen.empty()) {
    std::string valid;
    for (const auto& name : names) valid += (valid.empty() ? "" : ", ") + name;
    throw InputError("--only: no query begins with \"" + only + "\"; choose from " + valid);
  }
  return chosen;
}

/// Runs the questions of all rows, on the given number of threads.
void answer(std::vector<Row>& rows, std::uint32_t size, bool keep_bytes, int threads) {
  std::vector<std::vector<Cell*>> wanted(sheets().size());
  for (Row& row : rows) {
    for (Cell& cell : row.cells) wanted[cell.sheet].push_back(&cell);
  }
  for_each_index({threads, "verify"}, static_cast<int>(wanted.size()), [&](int index) {
    const auto sheet = static_cast<std::size_t>(index);
    if (wanted[sheet].empty()) return;
    auto answers = verify::answer(sheet, size, keep_bytes);
    for (Cell* cell : wanted[sheet]) cell->answers = std::move(answers[cell->row]);
  });
}

template <std::size_t Size>
void set_golden(std::vector<Row>& rows, const std::array<std::uint64_t, Size>& golden) {
  for (Row& row : rows) {
    for (Cell& cell : row.cells) {
      const auto at = sheets()[cell.sheet].cells[cell.row];
      if (at < golden.size()) cell.golden = golden[at];
    }
  }
}

std::uint64_t question_count(const std::vector<Row>& rows, std::uint32_t size) {
  return std::accumulate(rows.begin(), rows.end(), std::uint64_t{0},
                         [&](auto sum, const Row& row) { return sum + row.questions(size); });
}

/// The known facts about a row that differs from golden.
struct Difference {
  const Row* row;
  std::vector<const Cell*> cells;    // those that differ
  const Cell* found_in = nullptr;    // where exact arithmetic disagrees
  std::optional<Finding> finding;    // the wrong result there
  bool has_other_questions = false;  // the corpus itself differs
};

/// Looks for the first wrong result in `cells`, in order.
void find_wrong(Difference& difference, const std::vector<const Cell*>& cells, std::uint32_t size) {
  for (const Cell* cell : cells) {
    difference.finding = verify::first_wrong(cell->sheet, cell->row, size);
    if (!difference.finding) continue;
    difference.found_in = cell;
    return;
  }
}

/// The rows that differ; with `exact` also those with a wrong result despite a golden digest.
std::vector<Difference> differences(const std::vector<Row>& rows, std::uint32_t size, bool exact,
                                    int threads) {
  std::vector<std::optional<Difference>> looked_at(rows.size());
  const Workers workers{threads, exact ? "exact" : ""};
  for_each_index(workers, static_cast<int>(rows.size()), [&](int index) {
    const Row& row = rows[static_cast<std::size_t>(index)];
    Difference difference{&row, {}, nullptr, {}, false};
    std::vector<const Cell*> suspects;
    for (const Cell& cell : row.cells) {
      if (!cell.is_golden()) difference.cells.push_back(&cell);
      if (!cell.is_golden() || exact) suspects.push_back(&cell);
    }
    find_wrong(difference, suspects, size);
    for (const Cell* cell : difference.cells) {
      const auto questions = verify::digest_of_questions(cell->sheet, verify::full_size);
      difference.has_other_questions = difference.has_other_questions ||
                                       cell->sheet >= verify::golden::questions.size() ||
                                       questions != verify::golden::questions[cell->sheet];
    }
    if (!difference.cells.empty() || difference.finding) {
      looked_at[static_cast<std::size_t>(index)] = std::move(difference);
    }
  });
  std::vector<Difference> found;
  for (auto& difference : looked_at) {
    if (difference) found.push_back(std::move(*difference));
  }
  return found;
}

/// Why the judge found no wrong result.
std::string explanation(const Difference& difference) {
  if (difference.has_other_questions) {
    return "the queries themselves differ: they are generated by integer arithmetic only, so "
           "suspect the compiler";
  }
  return "no answer is wrong by exact arithmetic: what differs may be the last bit of a normal or "
         "of a rotation, or this program was built from different sources than its golden values; "
         "write the answers with --dump here and on a machine that agrees, and compare them "
         "with cmp";
}

std::string padded(std::string text, std::size_t width) {
  if (text.size() < width) text.append(width - text.size(), ' ');
  return text;
}
std::string aligned_right(const std::string& text, std::size_t width) {
  return text.size() < width ? std::string(width - text.size(), ' ') + text : text;
}

std::string table_line(const std::string& name, std::uint64_t count, std::uint64_t digest,
                       bool is_golden) {
  return padded(name, 30) + aligned_right(std::to_string(count), 9) + "  " + digits(digest) +
         (is_golden ? "  ok\n" : "  DIFFERENT\n");
}

struct Report {
  const std::vector<Row>& rows;
  const std::vector<Difference>& differences;
  std::uint32_t size;
  bool has_all_rows;

  [[nodiscard]] std::uint64_t digest(std::uint64_t (Row::*of)() const) const {
    Digest all;
    for (const Row& row : rows) all.add((row.*of)());
    return all.value();
  }
  [[nodiscard]] bool is_golden() const {
    return std::all_of(rows.begin(), rows.end(), [](const Row& row) { return row.is_golden(); });
  }

  [[nodiscard]] std::string table() const {
    std::string text = padded("query", 30) + "  queries  digest\n";
    for (const Row& row : rows) {
      text += table_line(row.name, row.questions(size), row.digest(), row.is_golden());
    }
    if (has_all_rows) {
      text += table_line("all", question_count(rows, size), digest(&Row::digest), is_golden());
    }
    text += "results_version " + std::to_string(results_version) + "; " + words_of_environment() +
            "; " + std::to_string(word_bits) + "-bit words, " + byte_order + "-endian, " + int128 +
            " 128-bit integers\n";
    for (const Difference& difference : differences) text += "\n" + words(difference);
    return text;
  }

  [[nodiscard]] static std::string words(const Difference& difference) {
    std::string text = difference.row->name;
    if (difference.cells.empty()) {
      text += " has its golden digest, but a wrong answer\n";
    } else {
      text += " differs for";
      for (const Cell* cell : difference.cells) {
        text += (cell == difference.cells.front() ? " " : ", ") + cell->name();
      }
      text += "\n";
    }
    if (!difference.finding) return text + "  " + explanation(difference) + "\n";
    const Finding& finding = *difference.finding;
    text += "  first wrong answer: " + difference.found_in->name() + ", question " +
            std::to_string(finding.index) + "\n";
    for (const auto& [name, value] : finding.question) {
      text += "    " + padded(name, 18) + value + "\n";
    }
    text += "    " + padded("expected", 18) + finding.expected + "\n";
    return text + "    " + padded("got", 18) + finding.got + "\n";
  }

  [[nodiscard]] std::string json() const {
    Json root;
    root["results_version"] = results_version;
    root["compiler"] = words_of_environment();
    root["word_bits"] = word_bits;
    root["byte_order"] = byte_order;
    root["int128"] = int128;
    root["questions_per_cell"] = size;
    root["rows"] = Json::array();
    for (const Row& row : rows) {
      root["rows"].push_back({{"query", row.name},
                              {"queries", row.questions(size)},
                              {"digest", digits(row.digest())},
                              {"golden", digits(row.golden())},
                              {"ok", row.is_golden()}});
    }
    if (has_all_rows) {
      root["all"] = {{"queries", question_count(rows, size)},
                     {"digest", digits(digest(&Row::digest))},
                     {"golden", digits(digest(&Row::golden))},
                     {"ok", is_golden()}};
    }
    root["differences"] = Json::array();
    for (const Difference& difference : differences) {
      root["differences"].push_back(json(difference));
    }
    root["ok"] = differences.empty();
    return root.dump(2) + "\n";
  }

  [[nodiscard]] static Json json(const Cell& cell) {
    const Sheet& sheet = sheets()[cell.sheet];
    return {{"scalar", std::string(sheet.scalar)}, {"dimension", sheet.dimension}};
  }
  [[nodiscard]] static Json json(const Difference& difference) {
    Json object;
    object["query"] = difference.row->name;
    object["cells"] = Json::array();
    for (const Cell* cell : difference.cells) object["cells"].push_back(json(*cell));
    if (!difference.finding) {
      object["explanation"] = explanation(difference);
      return object;
    }
    const Finding& finding = *difference.finding;
    Json first = json(*difference.found_in);
    first["index"] = finding.index;
    first["question"] = Json::object();
    for (const auto& [name, value] : finding.question) first["question"][name] = value;
    first["expected"] = finding.expected;
    first["got"] = finding.got;
    object["first_wrong"] = first;
    return object;
  }
};

/// Appends the lowest `count` bytes of a word, lowest first.
void append_bytes(std::string& bytes, std::uint64_t word, int count) {
  for (int i = 0; i < count; ++i) bytes += static_cast<char>((word >> (8 * i)) & 0xff);
}
void append_name(std::string& bytes, std::string_view name) {
  append_bytes(bytes, name.size(), 1);
  bytes += name;
}

/// The format is described in docs/verify.md.
void dump(OutputFile& file, const std::vector<Row>& rows, std::uint32_t size) {
  std::size_t cell_count = 0;
  for (const Row& row : rows) cell_count += row.cells.size();
  std::string header = "detent 1";
  append_bytes(header, static_cast<std::uint64_t>(results_version), 4);
  append_bytes(header, cell_count, 4);
  file.write(header);
  for (const Row& row : rows) {
    for (const Cell& cell : row.cells) {
      const Sheet& sheet = sheets()[cell.sheet];
      std::string start;
      append_name(start, row.name);
      append_name(start, sheet.scalar);
      append_bytes(start, static_cast<std::uint64_t>(sheet.dimension), 1);
      append_bytes(start, cell.questions(size), 4);
      append_bytes(start, cell.answers.bytes.size(), 8);
      file.write(start);
      file.write(cell.answers.bytes);
    }
  }
  file.commit();
}

std::string golden_array(const std::string& name, const std::vector<std::uint64_t>& values) {
  std::string text = "inline constexpr std::array<std::uint64_t, " + std::to_string(values.size()) +
                     "> " + name + "{";
  for (std::size_t i = 0; i < values.size(); ++i) {
    text += (i % 4 == 0 ? "\n    " : " ") + hexadecimal(values[i]) + "u,";
  }
  return text + "};\n";
}

/// The digest of the questions of each sheet.
std::vector<std::uint64_t> question_digests(int threads) {
  std::vector<std::uint64_t> digests(sheets().size());
  for_each_index({threads, ""}, static_cast<int>(digests.size()), [&](int index) {
    const auto sheet = static_cast<std::size_t>(index);
    digests[sheet] = verify::digest_of_questions(sheet, verify::full_size);
  });
  return digests;
}

/// src/verify/golden.hpp for these answers to the full corpus, and this program's to the others.
std::string golden_header(const std::vector<Row>& full, const std::vector<std::uint64_t>& questions,
                          int threads) {
  std::string text =
      "// SPDX-License-Identifier: MIT\n"
      "#pragma once\n"
      "\n"
      "// Printed by `detent verify --golden`: not to be edited. docs/verify.md says when it may\n"
      "// change. One digest for each cell, in the order of the corpus, for each of its sizes.\n"
      "\n"
      "#include <array>\n"
      "#include <cstdint>\n"
      "\n"
      "// clang-format off\n"
      "namespace detent::verify::golden {\n"
      "\n"
      "inline constexpr int results_version = " +
      std::to_string(results_version) + ";\n";
  const auto add = [&](const char* name, const std::vector<Row>& rows) {
    std::vector<std::uint64_t> digests;
    for (const Row& row : rows) {
      for (const Cell& cell : row.cells) digests.push_back(cell.answers.digest);
    }
    text += "\n" + golden_array(name, digests);
  };
  const auto add_answers = [&](const char* name, std::uint32_t size) {
    auto rows = chosen_rows("");
    answer(rows, size, false, threads);
    add(name, rows);
  };
  add("full", full);
  add_answers("small", verify::small_size);
  add_answers("constant", verify::constant_size);
  text += "\n// Of the questions themselves.\n" + golden_array("questions", questions);
  return text + "\n}  // namespace detent::verify::golden\n";
}

/// A line per row: this version's results, and the digest of the questions.
std::string results(const std::vector<Row>& rows, const std::vector<std::uint64_t>& questions) {
  std::string text;
  for (const Row& row : rows) {
    Digest asked;
    for (const Cell& cell : row.cells) asked.add(questions[cell.sheet]);
    text += std::to_string(results_version) + " " + row.name + " " + digits(asked.value()) + " " +
            digits(row.digest()) + "\n";
  }
  return text;
}

}  // namespace

bool verify(const VerifyOptions& options) {
  if (options.golden || options.results) {
    auto rows = chosen_rows(options.golden ? "" : options.only);
    answer(rows, verify::full_size, false, options.threads);
    const auto questions = question_digests(options.threads);
    if (options.golden) print(golden_header(rows, questions, options.threads));
    if (options.results) print(results(rows, questions));
    if (!options.table) return true;
    set_golden(rows, verify::golden::full);
    const std::vector<Difference> unjudged;
    const Report report{rows, unjudged, verify::full_size, true};
    print(report.table());
    return report.is_golden();
  }
  const auto size = options.small ? verify::small_size : verify::full_size;
  auto rows = chosen_rows(options.only);
  if (verify::golden::results_version != results_version) {
    throw InputError("src/verify/golden.hpp", {},
                     "holds version " + std::to_string(verify::golden::results_version) +
                         " of the results, but the library has version " +
                         std::to_string(results_version) +
                         "; write a new one with detent verify --golden");
  }
  std::optional<OutputFile> file;
  if (!options.dump.empty()) file.emplace(options.dump);

  answer(rows, size, file.has_value(), options.threads);
  if (options.small) {
    set_golden(rows, verify::golden::small);
  } else {
    set_golden(rows, verify::golden::full);
  }
  if (file) dump(*file, rows, size);
  const auto found = differences(rows, size, options.exact, options.threads);
  const Report report{rows, found, size, options.only.empty()};
  print(options.json ? report.json() : report.table());
  return found.empty();
}

}  // namespace detent::cli
