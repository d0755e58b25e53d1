// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>

#include "bench/results.hpp"

namespace detent::bench {

namespace {

struct Series {
  const char* scalar;
  const char* color;
};
constexpr std::array<Series, 6> series{{{"float", "#888888"},
                                        {"double", "#222222"},
                                        {"q16_16", "#d62728"},
                                        {"q14_16", "#ff7f0e"},
                                        {"q24_8", "#2ca02c"},
                                        {"q8_8", "#1f77b4"}}};

/// A logarithmic scale on the page.
struct Axis {
  double from, to;    // values
  double start, end;  // on the page
  [[nodiscard]] double at(double x) const {
    const double part = std::log(x / from) / std::log(to / from);
    return start + std::clamp(part, 0.0, 1.0) * (end - start);
  }
};

class Panel {
 public:
  Panel(std::FILE* out, double left, double longest, const char* title, const char* label, Axis y)
      : out_(out), x_{0.5, longest, left + 70, left + 430}, y_(y) {
    text(left + 250, 30, "middle", title);
    text(left + 250, 455, "middle", "time as a multiple of float");
    std::fprintf(
        out_, "<text transform='translate(%.0f 235) rotate(-90)' text-anchor='middle'>%s</text>\n",
        left + 14, label);
    for (const double x : {0.5, 1.0, 1.5, 2.0, 3.0, 4.0, 8.0, 16.0, 32.0}) {
      if (x > longest) break;
      line(x_.at(x), y_.start, x_.at(x), y_.end, x == 1 ? "#888888" : "#dddddd");
      std::array<char, 16> mark{};
      std::snprintf(mark.data(), mark.size(), "%g", x);
      text(x_.at(x), y_.start + 18, "middle", mark.data());
    }
  }
  void mark(double y, const char* name) {
    line(x_.start, y_.at(y), x_.end, y_.at(y), "#dddddd");
    text(x_.start - 6, y_.at(y) + 4, "end", name);
  }
  /// Points at the same position are separated by `nudge`, so that each is visible.
  void point(double x, double y, double nudge, const char* color, const std::string& name) {
    std::fprintf(out_,
                 "<circle cx='%.1f' cy='%.1f' r='3.5' fill='%s' fill-opacity='0.75'><title>%s: "
                 "%.2f x float, %.2g</title></circle>\n",
                 x_.at(x), y_.at(y) + nudge, color, name.c_str(), x, y);
  }

 private:
  void line(double x1, double y1, double x2, double y2, const char* color) {
    std::fprintf(out_, "<path d='M%.1f %.1fL%.1f %.1f' stroke='%s'/>\n", x1, y1, x2, y2, color);
  }
  void text(double x, double y, const char* anchor, const char* words) {
    std::fprintf(out_, "<text x='%.1f' y='%.1f' text-anchor='%s'>%s</text>\n", x, y, anchor, words);
  }

  std::FILE* out_;
  Axis x_;
  Axis y_;
};

/// Calls visit(record, ratio) for every point of a scalar.
template <class Visit>
void visit_points(const Results& results, const std::string& scalar, const Visit& visit) {
  for (const auto& record : results.records) {
    if (record.scalar != scalar || record.query.rfind("number", 0) == 0) continue;
    const Times* const time = results.find(record.query, scalar, Manner::shuffled);
    const Times* const base = results.find(record.query, "float", Manner::shuffled);
    if (time != nullptr && base != nullptr) visit(record, results.ratio(*time, *base).median);
  }
}

}  // namespace

void write_plot(std::FILE* out, const Results& results) {
  double longest = 2;
  for (const auto& [scalar, color] : series) {
    visit_points(results, scalar, [&](const Record& record, double ratio) {
      const bool is_shown = record.accuracy.close_asked != 0 || record.accuracy.error > 0;
      while (is_shown && ratio > longest) longest *= 2;
    });
  }
  std::fprintf(out,
               "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 920 500' "
               "font-family='sans-serif' font-size='12'>\n"
               "<rect width='920' height='500' fill='white'/>\n");
  Panel decisions(out, 0, longest, "Hit or miss, a step of 1/256 from touching", "wrong answers",
                  {0.0004, 1, 410, 50});
  decisions.mark(0.0004, "none");
  decisions.mark(0.001, "0.1 %");
  decisions.mark(0.01, "1 %");
  decisions.mark(0.1, "10 %");
  decisions.mark(1, "100 %");
  Panel lengths(out, 460, longest, "Distances and closest points", "largest error, in units",
                {1e-6, 1, 410, 50});
  for (const auto& [value, name] : {std::pair{1e-6, "1e-6"},
                                    {1e-5, "1e-5"},
                                    {1e-4, "1e-4"},
                                    {1e-3, "1e-3"},
                                    {1e-2, "0.01"},
                                    {0.1, "0.1"},
                                    {1.0, "1"}}) {
    lengths.mark(value, name);
  }

  double legend = 190;
  for (const auto& scalar_series : series) {
    const auto& [scalar, color] = scalar_series;
    std::fprintf(out,
                 "<circle cx='%.0f' cy='482' r='5' fill='%s'/><text x='%.0f' y='486'>%s</text>\n",
                 legend, color, legend + 10, scalar);
    legend += 100;
    visit_points(
        results, scalar, [&, scalar = scalar, color = color](const Record& record, double ratio) {
          const std::string name = record.query + ' ' + scalar;
          const auto& accuracy = record.accuracy;
          if (accuracy.close_asked != 0) {
            const double wrong = static_cast<double>(accuracy.close_wrong) /
                                 static_cast<double>(accuracy.close_asked);
            // Each scalar without wrong results gets its own line.
            const double nudge =
                wrong > 0 ? 0 : 7 * static_cast<double>(&scalar_series - series.data()) - 40;
            decisions.point(ratio, std::max(wrong, 0.0004), nudge, color, name);
          }
          if (accuracy.error > 0) lengths.point(ratio, accuracy.error, 0, color, name);
        });
  }
  std::fprintf(out, "</svg>\n");
}

}  // namespace detent::bench
