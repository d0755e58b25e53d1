// SPDX-License-Identifier: MIT
#include "accuracy/report.hpp"

#include <array>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <nlohmann/json.hpp>

namespace detent::accuracy {
namespace {

/// Truncated to three digits, so that a value below 1 prints below 1; 0 prints as "0".
std::string brief(double value) {
  if (value == 0) return "0";
  const double last_digit = std::pow(10, std::floor(std::log10(value)) - 2);
  value = std::floor(value / last_digit + 1e-6) * last_digit;
  std::array<char, 32> buffer{};
  const char* const format = value >= 1e5 || value < 1e-3 ? "%.1e" : value >= 100 ? "%.0f" : "%.3g";
  std::snprintf(buffer.data(), buffer.size(), format, value);
  return buffer.data();
}

std::string percent(const Cell& cell) {
  return brief(100.0 * static_cast<double>(cell.wrong) / static_cast<double>(cell.questions));
}

std::string text_of(const Cell* cell) {
  if (cell == nullptr) return " ";
  return percent(*cell) + " · " + brief(cell->largest) + " (" + brief(cell->median) + ")";
}

/// What a column of a table shows.
struct Who {
  std::string_view scalar;
  Inputs inputs;
};

enum class Verdict { as_good, less_exact, wrong, none };

/// Compares float on its own numbers with the fixed-point scalar of the finest grid on this rung.
Verdict verdict(const Result& result) {
  const Cell* const own = find(result, "float", Inputs::own);
  if (own == nullptr) return Verdict::none;
  if (own->wrong > 0) return Verdict::wrong;
  const bool is_fine = find(result, "q16_16", Inputs::own) != nullptr;
  return own->largest < (is_fine ? 1 : 256) ? Verdict::as_good : Verdict::less_exact;
}

std::string text_of(Verdict verdict) {
  static constexpr std::array<const char*, 4> texts{"**as good**", "right, less exact", "wrong",
                                                    "has no such numbers"};
  return texts[static_cast<std::size_t>(verdict)];
}

std::string row_of(const std::vector<std::string>& cells) {
  std::string line = "|";
  for (const auto& cell : cells) line += " " + cell + " |";
  return line + "\n";
}
std::string ruler(std::size_t columns) {
  std::string line = "|";
  for (std::size_t i = 0; i < columns; ++i) line += i == 0 ? "---|" : "---:|";
  return line + "\n";
}

std::string totals(const Report& report) {
  static constexpr std::array<Who, 10> all{{{"q16_16", Inputs::own},
                                            {"q14_16", Inputs::own},
                                            {"q24_8", Inputs::own},
                                            {"q8_8", Inputs::own},
                                            {"double", Inputs::own},
                                            {"float", Inputs::own},
                                            {"textbook float", Inputs::own},
                                            {"float", Inputs::asked},
                                            {"q24_8", Inputs::asked},
                                            {"q8_8", Inputs::asked}}};
  std::string text = row_of({"scalar", "inputs", "questions", "wrong decisions", "wrong in %",
                             "distances not the exact one rounded down"}) +
                     ruler(6);
  for (const Who& who : all) {
    Cell sum;
    for (const Result& result : report.results) {
      const Cell* const cell = find(result, who.scalar, who.inputs);
      if (cell == nullptr) continue;
      sum.questions += cell->questions;
      sum.wrong += cell->wrong;
      sum.off += cell->off;
    }
    if (sum.questions == 0) continue;
    const bool is_own_fixed = who.inputs == Inputs::own && who.scalar[0] == 'q';
    text += row_of({std::string(who.scalar), who.inputs == Inputs::own ? "own" : "as asked",
                    std::to_string(sum.questions), std::to_string(sum.wrong), percent(sum),
                    is_own_fixed ? std::to_string(sum.off) : " "});
  }
  return text;
}

/// The number of rungs on which float is as good, right but less exact, and wrong.
std::string float_table(const Report& report) {
  std::vector<std::string> heads{"query"};
  for (const Ladder ladder : ladders) heads.emplace_back(name_of(ladder));
  std::string text = row_of(heads) + ruler(heads.size());
  for (const Query& query : queries()) {
    std::vector<std::string> cells{query.name};
    bool is_asked = false;
    for (const Ladder ladder : ladders) {
      std::array<int, 4> counts{};
      for (const Result* const result : column(report, query, ladder)) {
        ++counts[static_cast<std::size_t>(verdict(*result))];
        is_asked = true;
      }
      const bool has_any = counts[0] + counts[1] + counts[2] > 0;
      cells.push_back(has_any ? std::to_string(counts[0]) + " / " + std::to_string(counts[1]) +
                                    " / " + std::to_string(counts[2])
                              : " ");
    }
    if (is_asked) text += row_of(cells);
  }
  return text;
}

std::string raycast_table(const Report& report, const Query& query, Ladder ladder) {
  const auto results = column(report, query, ladder);
  if (results.empty()) return {};
  std::vector<Who> columns{{"q16_16", Inputs::own}, {"q14_16", Inputs::own},
                           {"q24_8", Inputs::own},  {"q8_8", Inputs::own},
                           {"double", Inputs::own}, {"float", Inputs::own}};
  if (find(*results.front(), "textbook float", Inputs::asked) != nullptr) {
    columns.push_back({"textbook float", Inputs::own});
  }
  for (const auto scalar : {"float", "q24_8", "q8_8"}) columns.push_back({scalar, Inputs::asked});
  std::vector<std::string> heads{std::string(name_of(ladder))};
  for (const Who& who : columns) {
    heads.push_back(std::string(who.scalar) + (who.inputs == Inputs::own ? "" : " as asked"));
  }
  heads.emplace_back("float is");
  std::string text = row_of(heads) + ruler(heads.size());
  for (const Result* const result : results) {
    std::vector<std::string> cells{result->rung->name};
    for (const Who& who : columns) cells.push_back(text_of(find(*result, who.scalar, who.inputs)));
    cells.push_back(text_of(verdict(*result)));
    text += row_of(cells);
  }
  return text + "\n";
}

/// Pairs of shapes down, rungs across.
std::string decision_table(const Report& report, Ladder ladder, Who who) {
  std::vector<const Rung*> columns;
  for (const Rung& rung : rungs()) {
    if (rung.ladder == ladder) columns.push_back(&rung);
  }
  std::vector<std::string> heads{std::string(name_of(ladder))};
  for (const Rung* const rung : columns) heads.push_back(rung->name);
  std::string text = row_of(heads) + ruler(heads.size());
  bool is_empty = true;
  for (const Query& query : queries()) {
    const auto results = column(report, query, ladder);
    if (query.kind == "raycast" || results.empty()) continue;
    std::vector<std::string> cells{query.name};
    for (const Rung* const rung : columns) {
      const Cell* cell = nullptr;
      for (const Result* const result : results) {
        if (result->rung == rung) cell = find(*result, who.scalar, who.inputs);
      }
      cells.push_back(cell == nullptr ? " " : percent(*cell));
      is_empty = is_empty && cell == nullptr;
    }
    text += row_of(cells);
  }
  return is_empty ? "" : text + "\n";
}

}  // namespace

const Cell* find(const Result& result, std::string_view scalar, Inputs inputs) {
  for (const Cell& cell : result.cells) {
    if (cell.scalar == scalar && cell.inputs == inputs) return &cell;
  }
  return nullptr;
}

std::vector<const Result*> column(const Report& report, const Query& query, Ladder ladder) {
  std::vector<const Result*> found;
  for (const Result& result : report.results) {
    if (result.query == &query && result.rung->ladder == ladder) found.push_back(&result);
  }
  return found;
}

std::string circumstances(const Report& report) {
  std::array<char, 16> date{};
  const std::time_t now = std::time(nullptr);
  std::strftime(date.data(), date.size(), "%Y-%m-%d", std::gmtime(&now));
#if defined(__clang__)
  const std::string compiler = "clang++ " __clang_version__;
#elif defined(__GNUC__)
  const std::string compiler = "g++ " __VERSION__;
#else
  const std::string compiler = "another compiler";
#endif
  return std::string(date.data()) + ", " + compiler + ", seed " + std::to_string(report.seed) +
         ", " + std::to_string(report.count) + " questions a rung (fewer where the judge is slow)";
}

std::string markdown(const Report& report) {
  std::string text = "## All together\n\nMeasured " + circumstances(report) + ".\n\n" +
                     totals(report) +
                     "\nOn how many rungs float is as good as the fixed scalars / right but less "
                     "exact / wrong, on its own numbers:\n\n" +
                     float_table(report) + "\n## The ladders\n\n";
  for (const Ladder ladder : ladders) {
    text += "- " + std::string(name_of(ladder)) + ": " + std::string(description_of(ladder)) + "\n";
  }
  text +=
      "\n## Raycasts\n\nWrong decisions in % · largest (median) error of the distance in units " +
      std::string("of 2^-16.\n\n");
  for (const Query& query : queries()) {
    if (query.kind != "raycast") continue;
    for (const Ladder ladder : ladders) {
      const auto table = raycast_table(report, query, ladder);
      if (table.empty()) continue;
      text += "### " + query.name + ", " + std::string(name_of(ladder)) + "\n\n" + table;
    }
  }
  text += "## Overlaps and segments\n\nWrong decisions in %.\n\n";
  static constexpr std::array<Who, 3> shown{
      {{"float", Inputs::own}, {"float", Inputs::asked}, {"double", Inputs::own}}};
  for (const Ladder ladder : ladders) {
    for (const Who& who : shown) {
      const auto table = decision_table(report, ladder, who);
      if (table.empty()) continue;
      text += "### " + std::string(who.scalar) + (who.inputs == Inputs::own ? "" : " as asked") +
              ", " + std::string(name_of(ladder)) + "\n\n" + table;
    }
  }
  return text;
}

std::string json(const Report& report) {
  nlohmann::ordered_json all;
  all["measured"] = circumstances(report);
  all["seed"] = report.seed;
  all["cells"] = nlohmann::ordered_json::array();
  for (const Result& result : report.results) {
    for (const Cell& cell : result.cells) {
      all["cells"].push_back({{"query", result.query->name},
                              {"ladder", name_of(result.rung->ladder)},
                              {"rung", result.rung->name},
                              {"value", result.rung->value},
                              {"scalar", cell.scalar},
                              {"inputs", cell.inputs == Inputs::own ? "own" : "asked"},
                              {"questions", cell.questions},
                              {"hits", cell.hits},
                              {"wrong", cell.wrong},
                              {"not_rounded_down", cell.off},
                              {"median_error", cell.median},
                              {"largest_error", cell.largest}});
    }
  }
  return all.dump(1) + "\n";
}

}  // namespace detent::accuracy
