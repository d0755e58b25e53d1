// SPDX-License-Identifier: MIT
#include "accuracy/report.hpp"

#include <array>
#include <cmath>
#include <cstdio>
#include <ctime>

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

/// The scalar whose results a column shows.
struct Who {
  std::string_view scalar;
  Inputs inputs;
};
constexpr std::array<Who, 10> all{{{"q16_16", Inputs::own},
                                   {"q14_16", Inputs::own},
                                   {"q24_8", Inputs::own},
                                   {"q8_8", Inputs::own},
                                   {"double", Inputs::own},
                                   {"float", Inputs::own},
                                   {"textbook float", Inputs::own},
                                   {"float", Inputs::asked},
                                   {"q24_8", Inputs::asked},
                                   {"q8_8", Inputs::asked}}};

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
  static constexpr std::array<const char*, 4> texts{"as good", "right but less exact", "wrong", ""};
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
  std::string text = row_of({"scalar", "inputs", "questions", "wrong decisions", "wrong in %",
                             "lengths and points not the exact ones, rounded"}) +
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

/// Counts the rungs on which float is as good, right but less exact, and wrong: one row per kind of
/// query.
std::string float_table(const Report& report) {
  std::vector<std::string> heads{"queries"};
  for (const Ladder ladder : ladders) heads.emplace_back(name_of(ladder));
  std::string text = row_of(heads) + ruler(heads.size());
  for (const bool is_planar : {false, true}) {
    for (const std::string_view kind :
         {"raycast", "overlaps", "intersects", "distance", "contact", "closest_points", "cast",
          "pick_ray", "project", "time_of_impact", "mover"}) {
      std::vector<std::string> cells{std::string(kind) + (is_planar ? " in 2D" : " in 3D")};
      bool has_any = false;
      for (const Ladder ladder : ladders) {
        std::array<int, 4> counts{};
        for (const Query& query : queries()) {
          if (query.kind != kind || query.name.ends_with("_2d") != is_planar) continue;
          for (const Result* const result : column(report, query, ladder)) {
            ++counts[static_cast<std::size_t>(verdict(*result))];
          }
        }
        const bool is_asked = counts[0] + counts[1] + counts[2] > 0;
        has_any = has_any || is_asked;
        cells.push_back(is_asked ? std::to_string(counts[0]) + " / " + std::to_string(counts[1]) +
                                       " / " + std::to_string(counts[2])
                                 : " ");
      }
      if (has_any) text += row_of(cells);
    }
  }
  return text;
}

/// The cells of a data row. Lengths have errors in every scalar. For yes or no only `float` and
/// `double` are shown, because a wrong fixed scalar fails the run.
std::string data_of(const Result& result, const Who& who) {
  const bool has_lengths = result.query->kind != "overlaps" && result.query->kind != "intersects";
  const bool is_shown = has_lengths || who.scalar == "float" || who.scalar == "double";
  const Cell* const cell = is_shown ? find(result, who.scalar, who.inputs) : nullptr;
  if (cell == nullptr) return ",,,";
  return "," + percent(*cell) +
         (has_lengths ? "," + brief(cell->largest) + "," + brief(cell->median) : ",,");
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

std::string summary(const Report& report) {
  return "Measured " + circumstances(report) + ".\n\n" + totals(report) +
         "\nOn how many rungs float is as good as the fixed scalars / right but less exact / "
         "wrong, "
         "on its own numbers:\n\n" +
         float_table(report);
}

std::string csv(const Report& report) {
  std::string text = "# " + circumstances(report) + "\nquery,ladder,rung";
  for (const Who& who : all) {
    for (const auto what : {" wrong %", " largest", " median"}) {
      text += "," + std::string(who.scalar) + (who.inputs == Inputs::own ? "" : " as asked") + what;
    }
  }
  text += ",float is\n";
  for (const Result& result : report.results) {
    text += result.query->name + "," + std::string(name_of(result.rung->ladder)) + "," +
            result.rung->name;
    for (const Who& who : all) text += data_of(result, who);
    text += "," + text_of(verdict(result)) + "\n";
  }
  return text;
}

}  // namespace detent::accuracy
