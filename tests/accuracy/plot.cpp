// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "accuracy/report.hpp"

namespace detent::accuracy {
namespace {

struct Line {
  std::string_view scalar;
  Inputs inputs;
  std::string_view label;
  std::string_view brief;  // next to the lines
  const char* colour;
  const char* dashes;
};

constexpr std::array<Line, 8> lines{
    {{"q16_16", Inputs::own, "q16_16", "q16_16", "#0a7a4b", ""},
     {"q14_16", Inputs::own, "q14_16", "q14_16", "#5fbf8f", "2 3"},
     {"q24_8", Inputs::own, "q24_8", "q24_8", "#2563c9", ""},
     {"q8_8", Inputs::own, "q8_8", "q8_8", "#7a3fb8", ""},
     {"double", Inputs::own, "double", "double", "#8a8f98", ""},
     {"textbook float", Inputs::own, "textbook float", "textbook", "#9a6a3a", "5 2"},
     {"float", Inputs::asked, "float, its inputs rounded", "rounded float", "#f0963c", "4 2"},
     {"float", Inputs::own, "float", "float", "#d42a2a", ""}}};

constexpr const char* ink = "#22262c";
constexpr const char* faint = "#d9dce1";
constexpr const char* soft = "#69707a";

/// "2^-16" with the exponent raised.
std::string typeset(const std::string& name) {
  static constexpr std::array<const char*, 10> raised{"⁰", "¹", "²", "³", "⁴",
                                                      "⁵", "⁶", "⁷", "⁸", "⁹"};
  const auto power = std::min(name.find('^'), name.size());
  std::string text = name.substr(0, power);
  for (std::size_t i = power; i < name.size(); ++i) {
    if (name[i] == '-') text += "⁻";
    if (name[i] >= '0' && name[i] <= '9') text += raised[static_cast<std::size_t>(name[i] - '0')];
  }
  return text;
}

std::string number(double value) {
  std::array<char, 32> buffer{};
  std::snprintf(buffer.data(), buffer.size(), "%.1f", value);
  return buffer.data();
}

class Svg {
 public:
  void line(double x1, double y1, double x2, double y2, const char* colour, double width = 1) {
    body_ += "<path d=\"M" + number(x1) + " " + number(y1) + "L" + number(x2) + " " + number(y2) +
             "\" stroke=\"" + colour + "\" stroke-width=\"" + number(width) + "\"/>\n";
  }
  void path(const std::vector<std::array<double, 2>>& points, const Line& style) {
    std::string d;
    for (const auto& [x, y] : points) {
      d += (d.empty() ? "M" : "L") + number(x) + " " + number(y);
      body_ += "<circle cx=\"" + number(x) + "\" cy=\"" + number(y) + "\" r=\"1.6\" fill=\"" +
               style.colour + "\"/>\n";
    }
    body_ += "<path d=\"" + d + "\" fill=\"none\" stroke=\"" + style.colour +
             "\" stroke-width=\"1.4\"" +
             (*style.dashes == 0 ? "" : std::string(" stroke-dasharray=\"") + style.dashes + "\"") +
             "/>\n";
  }
  void box(double x, double y, double width, double height, const std::string& colour) {
    body_ += "<rect x=\"" + number(x) + "\" y=\"" + number(y) + "\" width=\"" + number(width) +
             "\" height=\"" + number(height) + "\" fill=\"" + colour + "\"/>\n";
  }
  void text(double x, double y, const std::string& words, const char* colour = ink,
            const char* anchor = "start", int size = 10, bool bold = false) {
    body_ += "<text x=\"" + number(x) + "\" y=\"" + number(y) + "\" fill=\"" + colour +
             "\" text-anchor=\"" + anchor + "\" font-size=\"" + std::to_string(size) + "\"" +
             (bold ? " font-weight=\"bold\"" : "") + ">" + words + "</text>\n";
  }
  [[nodiscard]] std::string page(double width, double height) const {
    const auto size = number(width) + "\" height=\"" + number(height);
    return "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + size + "\" viewBox=\"0 0 " +
           number(width) + " " + number(height) +
           "\" font-family=\"DejaVu Sans, Verdana, sans-serif\">\n<rect width=\"100%\" "
           "height=\"100%\" fill=\"white\"/>\n" +
           body_ + "</svg>\n";
  }

 private:
  std::string body_;
};

constexpr double panel_width = 205, panel_height = 74, label_width = 84, left = 62, top = 104;
constexpr double column_width = panel_width + label_width + 12;
constexpr double row_height = 2 * panel_height + 44;

/// A logarithmic axis from `low` up, with a separate position for 0.
struct Axis {
  double low, high;  // decades
  double from, to;   // on the page: at `low`, at `high`
  double zero;       // on the page

  [[nodiscard]] double at(double value) const {
    if (value <= 0) return zero;
    const double part = (std::log10(value) - low) / (high - low);
    return from + (to - from) * std::clamp(part, 0.0, 1.0);
  }
};

Axis rung_axis(double x, const std::vector<const Result*>& results) {
  double low = 1e9, high = -1e9;
  for (const Result* const result : results) {
    const double value = result->rung->value;
    if (value <= 0) continue;
    low = std::min(low, std::log10(value));
    high = std::max(high, std::log10(value));
  }
  const bool has_zero = results.front()->rung->value == 0;
  if (high <= low) high = low + 1;
  return {low, high, x + (has_zero ? 22 : 5), x + panel_width - 5, x + 6};
}

struct Label {
  double y;
  std::string words;
  const char* colour;
};

/// Writes labels next to their lines, moved apart where they would overlap.
void write(Svg& svg, double x, double low, double high, std::vector<Label> labels) {
  constexpr double step = 9.5;
  std::sort(labels.begin(), labels.end(), [](const Label& a, const Label& b) { return a.y < b.y; });
  double next = low;
  for (Label& label : labels) {
    label.y = std::max(label.y, next);
    next = label.y + step;
  }
  double limit = high;
  for (auto label = labels.rbegin(); label != labels.rend(); ++label) {
    label->y = std::min(label->y, limit);
    limit = label->y - step;
  }
  for (const Label& label : labels) svg.text(x, label.y + 3, label.words, label.colour, "start", 8);
}

/// One measure of one query on one ladder: a line per scalar.
void panel(Svg& svg, double x, double y, const std::vector<const Result*>& results,
           bool shows_errors) {
  const double bottom = y + panel_height;
  const Axis across = rung_axis(x, results);
  const Axis up = shows_errors ? Axis{-6, 9, bottom - 8, y + 4, bottom - 2}
                               : Axis{-3, 0, bottom - 16, y + 4, bottom - 4};
  const std::vector<std::pair<double, const char*>> ticks =
      shows_errors ? std::vector<std::pair<double, const char*>>{{1e-6, "10⁻⁶"}, {1e-3, "10⁻³"},
                                                                 {1, "1"},       {1e3, "10³"},
                                                                 {1e6, "10⁶"},   {1e9, "10⁹"}}
                   : std::vector<std::pair<double, const char*>>{
                         {0, "0"}, {0.001, "0.1 %"}, {0.01, "1 %"}, {0.1, "10 %"}, {1, "100 %"}};
  for (const auto& [value, words] : ticks) {
    const bool is_base = value == (shows_errors ? 1 : 0);
    svg.line(x, up.at(value), x + panel_width, up.at(value), is_base ? soft : faint,
             is_base ? 0.8 : 0.6);
    svg.text(x - 4, up.at(value) + 3, words, soft, "end", 8);
  }
  std::vector<Label> labels;
  for (const Line& style : lines) {
    std::vector<std::array<double, 2>> points;
    bool is_zero = true;
    for (const Result* const result : results) {
      const Cell* const cell = find(*result, style.scalar, style.inputs);
      if (cell == nullptr) continue;
      const double wrong = static_cast<double>(cell->wrong) / static_cast<double>(cell->questions);
      const double value = shows_errors ? cell->largest : wrong;
      is_zero = is_zero && value == 0;
      points.push_back({across.at(result->rung->value), up.at(value)});
    }
    if (points.empty() || (is_zero && !shows_errors && style.scalar != "q16_16")) continue;
    svg.path(points, style);
    const bool is_quiet = is_zero && !shows_errors;
    labels.push_back({points.back()[1], is_quiet ? "all others" : std::string(style.brief),
                      is_quiet ? soft : style.colour});
  }
  write(svg, x + panel_width + 4, y + 2, bottom, labels);
}

void rung_names(Svg& svg, double x, double y, const std::vector<const Result*>& results) {
  const Axis across = rung_axis(x, results);
  double free_from = x - 20;
  for (const Result* const result : results) {
    const double place = across.at(result->rung->value);
    const double half = 2.6 * static_cast<double>(result->rung->name.size());
    const bool is_last = result == results.back();
    const double last = across.at(results.back()->rung->value) -
                        2.6 * static_cast<double>(results.back()->rung->name.size());
    if (place - half < free_from || (!is_last && place + half > last - 4)) continue;
    svg.text(place, y, typeset(result->rung->name), soft, "middle", 8);
    free_from = place + half + 6;
  }
}

/// White for no errors, then from yellow to dark red.
std::string heat(const Cell& cell) {
  if (cell.wrong == 0) return "#e4f1e9";
  const double wrong = static_cast<double>(cell.wrong) / static_cast<double>(cell.questions);
  const double part = std::clamp(std::log10(wrong / 0.0005) / 3, 0.0, 1.0);
  std::array<char, 8> buffer{};
  std::snprintf(buffer.data(), buffer.size(), "#%02x%02x%02x",
                static_cast<unsigned>(253 - 115 * part * part),
                static_cast<unsigned>(225 - 205 * part), static_cast<unsigned>(140 - 120 * part));
  return buffer.data();
}

constexpr double strip = 15;

/// A row per pair of shapes, a cell per rung.
double strips(Svg& svg, double y, const Report& report) {
  double x = left + 92;
  std::vector<const Query*> pairs;
  for (const Query& query : queries()) {
    if ((query.kind == "overlaps" || query.kind == "intersects") &&
        !column(report, query, Ladder::size).empty()) {
      pairs.push_back(&query);
    }
  }
  if (pairs.empty()) return y;
  svg.text(left - 44, y,
           "Overlaps and segments: how often float decides wrongly, on numbers that it has", ink,
           "start", 13, true);
  svg.text(left - 44, y + 16, "q16_16, q14_16, q24_8 and q8_8: never, in any field.", ink);
  Cell sample;
  sample.questions = 1000;
  double legend = left + 330;
  for (const auto& [wrong, words] : std::initializer_list<std::pair<long, const char*>>{
           {0, "none"}, {1, "0.1 %"}, {10, "1 %"}, {100, "10 %"}, {500, "50 %"}}) {
    sample.wrong = wrong;
    svg.box(legend, y + 7, 18, 11, heat(sample));
    svg.text(legend + 23, y + 16, words, soft, "start", 9);
    legend += 70;
  }
  svg.text(legend, y + 16, "blank: no such question", soft, "start", 9);
  y += 50;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    svg.text(x - 8, y + strip * static_cast<double>(i) + 11, pairs[i]->name, ink, "end", 9);
  }
  for (const Ladder ladder : ladders) {
    std::vector<const Rung*> across;
    for (const Rung& rung : rungs()) {
      if (rung.ladder == ladder && ladder != Ladder::distance) across.push_back(&rung);
    }
    if (across.empty()) continue;
    svg.text(x, y - 8, std::string(name_of(ladder)), ink, "start", 10, true);
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      for (const Result* const result : column(report, *pairs[i], ladder)) {
        const auto place = std::find(across.begin(), across.end(), result->rung) - across.begin();
        const Cell* const cell = find(*result, "float", Inputs::own);
        if (cell == nullptr) continue;
        svg.box(x + 23 * static_cast<double>(place), y + strip * static_cast<double>(i), 22,
                strip - 1, heat(*cell));
      }
    }
    const double below = y + strip * static_cast<double>(pairs.size()) + 10;
    for (std::size_t i = 0; i < across.size(); ++i) {
      const bool is_last = i + 1 == across.size();
      if (!is_last && (i % 2 == 1 || i + 2 == across.size())) continue;
      svg.text(x + 23 * static_cast<double>(i) + 11, below, typeset(across[i]->name), soft,
               "middle", 8);
    }
    x += 23 * static_cast<double>(across.size()) + 22;
  }
  return y + strip * static_cast<double>(pairs.size()) + 30;
}

}  // namespace

std::string plot(const Report& report) {
  Svg svg;
  svg.text(left - 44, 26, "Right and wrong along a ladder of scales", ink, "start", 17, true);
  svg.text(left - 44, 44,
           "Raycasts. Above: how often hit or miss is wrong. Below: the largest error of the "
           "distance, in units of 2⁻¹⁶. Judged by exact arithmetic on the scalar's own numbers.",
           soft);
  double legend = left - 44;
  for (const Line& style : lines) {
    svg.path({{legend, 58}, {legend + 24, 58}}, style);
    svg.text(legend + 30, 61, std::string(style.label), style.colour, "start", 9, true);
    legend += 52 + 6.2 * static_cast<double>(style.label.size());
  }
  static constexpr std::array<const char*, 4> titles{
      "size of the shape", "distance from the ray's start", "distance from the world's origin",
      "angle between ray and shape"};
  for (std::size_t i = 0; i < titles.size(); ++i) {
    svg.text(left + column_width * static_cast<double>(i), top - 18, titles[i], ink, "start", 11,
             true);
  }
  double y = top;
  for (const Query& query : queries()) {
    if (query.kind != "raycast") continue;
    bool is_shown = false;
    for (const Ladder ladder : ladders) {
      const auto results = column(report, query, ladder);
      if (results.empty()) continue;
      const double x = left + column_width * static_cast<double>(ladder);
      panel(svg, x, y, results, false);
      panel(svg, x, y + panel_height + 8, results, true);
      rung_names(svg, x, y + 2 * panel_height + 18, results);
      is_shown = true;
    }
    if (!is_shown) continue;
    svg.text(left - 44, y - 2, query.name.substr(query.name.find('/') + 1), ink, "start", 11, true);
    y += row_height;
  }
  y = strips(svg, y + 24, report);
  svg.text(left - 44, y + 6, "Measured " + circumstances(report) + "; ./dev accuracy", soft,
           "start", 9);
  return svg.page(left + 4 * column_width + 8, y + 20);
}

}  // namespace detent::accuracy
