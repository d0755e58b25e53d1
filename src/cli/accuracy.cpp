// SPDX-License-Identifier: MIT
#include "accuracy.hpp"

#include <unistd.h>

#include <cstdio>
#include <optional>

#include "accuracy/report.hpp"
#include "commands.hpp"
#include "error.hpp"
#include "file.hpp"
#include "print.hpp"

namespace detent::cli {
namespace {

using accuracy::Report;

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

/// A file that is opened before the work starts and written after it.
class Output {
 public:
  explicit Output(const std::string& path) {
    if (!path.empty()) file_.emplace(path);
  }
  [[nodiscard]] bool is_wanted() const { return file_.has_value(); }
  void write(const std::string& text) {
    if (!file_) return;
    file_->write(text);
    file_->commit();
  }

 private:
  std::optional<OutputFile> file_;
};

bool is_exact(const Report& report) {
  for (const auto& result : report.results) {
    for (const auto& cell : result.cells) {
      if (cell.inputs == accuracy::Inputs::own && cell.scalar[0] == 'q' &&
          cell.wrong + cell.off > 0) {
        return false;
      }
    }
  }
  return true;
}

}  // namespace

bool measure_accuracy(const AccuracyOptions& options) {
  Output markdown(options.markdown), json(options.json), svg(options.svg);
  std::vector<const accuracy::Query*> chosen;
  for (const auto& query : accuracy::queries()) {
    if (query.name.starts_with(options.only)) chosen.push_back(&query);
  }
  if (chosen.empty()) {
    throw InputError("--only: no query begins with \"" + options.only +
                     "\"; try raycast/, overlaps/ or intersects/");
  }
  Report report{{}, options.count, options.seed};
  {
    Progress progress(chosen.size());
    for (const auto* const query : chosen) {
      progress.begin(query->name);
      for (const auto& rung : accuracy::rungs()) {
        if (!query->applies(rung)) continue;
        report.results.push_back(accuracy::survey(*query, rung, options.count, options.seed));
      }
    }
  }
  markdown.write(accuracy::markdown(report));
  json.write(accuracy::json(report));
  svg.write(accuracy::plot(report));
  if (!markdown.is_wanted() && !json.is_wanted() && !svg.is_wanted()) {
    print(accuracy::markdown(report));
  }
  return is_exact(report);
}

}  // namespace detent::cli
