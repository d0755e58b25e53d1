// SPDX-License-Identifier: MIT
//
// Runs every raycast and overlap, and other queries, in every scalar over a range of scales, checks each result with
// exact arithmetic, and reports (docs/accuracy.md).
#include <unistd.h>

#include <charconv>
#include <cstdio>
#include <optional>

#include "accuracy/report.hpp"
#include "error.hpp"
#include "file.hpp"
#include "print.hpp"
#include "program.hpp"

namespace detent::accuracy {
namespace {

using cli::InputError;

struct Options {
  std::string csv;  // files to write; empty for none
  std::string svg;
  std::string only;  // only queries whose name starts with this
  int count = 2000;
  std::uint64_t seed = 1;
};

/// One line on standard error: redrawn in place on a terminal, otherwise one line per query.
class Progress {
 public:
  explicit Progress(std::size_t total) : total_(total) {}
  ~Progress() {
    if (redraws_ && done_ > 0) std::fputs("\r\033[K", stderr);
  }
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void begin(const std::string& query) {
    ++done_;
    std::fprintf(stderr, redraws_ ? "\r\033[Kaccuracy %zu/%zu %s" : "accuracy %zu/%zu %s\n", done_,
                 total_, query.c_str());
    std::fflush(stderr);
  }

 private:
  std::size_t total_;
  std::size_t done_ = 0;
  bool redraws_ = isatty(STDERR_FILENO) != 0;
};

/// A file that is opened before the work starts and written afterwards.
class Output {
 public:
  explicit Output(const std::string& path) {
    if (!path.empty()) file_.emplace(path);
  }
  void write(const std::string& text) {
    if (!file_) return;
    file_->write(text);
    file_->commit();
  }

 private:
  std::optional<cli::OutputFile> file_;
};

bool is_right(const Report& report) {
  for (const auto& result : report.results) {
    for (const auto& cell : result.cells) {
      if (cell.inputs == Inputs::own && cell.scalar[0] == 'q' && cell.wrong + cell.off > 0) {
        return false;
      }
    }
  }
  return true;
}

/// Prints the summary. Returns whether every fixed-point result was the exact one, rounded once,
/// and every character ended where it should.
bool measure(const Options& options) {
  Output csv(options.csv), svg(options.svg);
  std::vector<const Query*> chosen;
  for (const auto& query : queries()) {
    if (query.name.starts_with(options.only)) chosen.push_back(&query);
  }
  if (chosen.empty()) {
    throw InputError(
        "--only: no query begins with \"" + options.only +
        "\"; try raycast/, overlaps/, intersects/, distance/, closest_points/, contact/, "
        "cast/, pick_ray/, project/, time_of_impact/ or mover/");
  }
  Report report{{}, options.count, options.seed};
  {
    Progress progress(chosen.size());
    for (const auto* const query : chosen) {
      progress.begin(query->name);
      for (const auto& rung : rungs()) {
        if (!query->applies(rung)) continue;
        report.results.push_back(survey(*query, rung, options.count, options.seed));
      }
    }
  }
  csv.write(accuracy::csv(report));
  svg.write(plot(report));
  cli::print(summary(report));
  return is_right(report);
}

std::uint64_t parse_seed(const std::string& text) {
  std::uint64_t seed = 0;
  const char* const end = text.data() + text.size();
  const auto read = std::from_chars(text.data(), end, seed);
  if (read.ec == std::errc() && read.ptr == end) return seed;
  throw InputError("--seed: \"" + text +
                   "\" is not a number from 0 below 2^64; write, for example, 2");
}

int run(int argc, char** argv) {
  Options options;
  std::string seed = "1";
  CLI::App app(
      "detent: count wrong answers and measure errors of every scalar along a ladder of scales",
      "detent-accuracy");
  app.add_option("--csv", options.csv, "Write every number to this file")->check(cli::check_name);
  app.add_option("--svg", options.svg, "Draw the results to this file")->check(cli::check_name);
  app.add_option("--only", options.only, "Only queries whose name starts with this");
  app.add_option("--count", options.count, "Inputs at every rung")
      ->capture_default_str()
      ->check(CLI::Range(100, 1000000));
  app.add_option("--seed", seed, "Seed of the random inputs")->capture_default_str();
  if (!cli::parse(app, argc, argv)) return 0;
  options.seed = parse_seed(seed);
  return measure(options) ? 0 : 1;
}

}  // namespace
}  // namespace detent::accuracy

int main(int argc, char** argv) {
  return detent::cli::run_program("detent-accuracy",
                                  [&] { return detent::accuracy::run(argc, argv); });
}
