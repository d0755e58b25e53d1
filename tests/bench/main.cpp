// SPDX-License-Identifier: MIT
// Runs float and fixed interleaved in one process and prints the cost of exactness. Unknown options
// go to Google Benchmark: --benchmark_filter=raycast --benchmark_repetitions=5

#include <cstdlib>
#include <ctime>
#include <fstream>
#include <string>
#include <string_view>

#include "bench/bodies.hpp"
#include "bench/pairs.hpp"
#include "bench/results.hpp"
#include "bench/still_pairs.hpp"

namespace detent::bench {

namespace {

constexpr std::string_view usage =
    R"(usage: detent-bench [--csv FILE] [--plot FILE] [--seed N] [BENCHMARK OPTION...]

  --csv FILE    writes every time, ratio and accuracy
  --plot FILE   writes speed against accuracy as SVG
  --seed N      draws other inputs; golden hit counts exist for the default only

Useful of Google Benchmark: --benchmark_filter=REGEX, --benchmark_repetitions=N
)";

/// Prints nothing, because times are collected turn by turn.
class Silence : public benchmark::BenchmarkReporter {
 public:
  bool ReportContext(const Context&) override { return true; }
  void ReportRuns(const std::vector<Run>&) override {}
};

/// Runs the turns of `row` alternately, as often as Google Benchmark requests, and stores their
/// times.
void add_benchmark(const Row& row, Results& results) {
  benchmark::RegisterBenchmark((row.query + '|' + name_of(row.manner)).c_str(),
                               [&row, &results](benchmark::State& state) {
                                 std::vector<Times*> times;
                                 for (const auto& [scalar, turn] : row.turns) {
                                   const auto name = benchmark_name(row.query, scalar, row.manner);
                                   times.push_back(&results.times[name]);
                                 }
                                 for (auto _ : state) {
                                   for (std::size_t i = 0; i < times.size(); ++i) {
                                     times[i]->add(row.turns[i].second());
                                   }
                                 }
                               });
}

std::string processor_name() {
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);) {
    if (line.rfind("model name", 0) == 0) return line.substr(line.find(':') + 2);
  }
  return "unknown processor";
}

Results::Machine this_machine() {
  std::array<char, 32> date{};
  const std::time_t now = std::time(nullptr);
  std::strftime(date.data(), date.size(), "%Y-%m-%d", std::gmtime(&now));
#if defined(__clang__)
  const std::string compiler = "clang " __clang_version__;
#else
  const std::string compiler = "gcc " __VERSION__;
#endif
  return {processor_name(), compiler + " " DETENT_BENCH_FLAGS, date.data()};
}

/// Whether every exact scalar had the expected number of hits; prints those that did not.
bool hits_are_right(const std::vector<Record>& records) {
  bool all_right = true;
  for (const auto& record : records) {
    if (!record.is_exact || record.hits == record.expected) continue;
    std::fprintf(stderr, "%s in %s: %zu hits instead of %zu\n", record.query.c_str(),
                 record.scalar.c_str(), record.hits, record.expected);
    all_right = false;
  }
  return all_right;
}

template <class Write>
void write_file(const std::string& path, const Write& write) {
  if (path.empty()) return;
  std::FILE* const file = std::fopen(path.c_str(), "w");
  if (file == nullptr) {
    std::fprintf(stderr, "cannot write %s\n", path.c_str());
    std::exit(1);
  }
  write(file);
  std::fclose(file);
}

int run(int count, char** arguments) {
  std::string csv, plot;
  std::uint64_t seed = default_seed;
  std::vector<std::string> rest{"detent-bench", "--benchmark_enable_random_interleaving=true",
                                "--benchmark_repetitions=5", "--benchmark_min_time=0.1"};
  for (int i = 1; i < count; ++i) {
    const std::string argument = arguments[i];
    if (argument == "--help" || argument == "-h") {
      std::fputs(usage.data(), stdout);
      return 0;
    }
    const auto value = [&] {
      if (i + 1 == count) {
        std::fprintf(stderr, "%s needs a value\n", argument.c_str());
        std::exit(2);
      }
      return std::string(arguments[++i]);
    };
    if (argument == "--csv") {
      csv = value();
    } else if (argument == "--plot") {
      plot = value();
    } else if (argument == "--seed") {
      seed = std::strtoull(value().c_str(), nullptr, 10);
    } else {
      rest.push_back(argument);
    }
  }
  std::vector<char*> pointers;
  for (auto& option : rest) pointers.push_back(option.data());
  int rest_count = static_cast<int>(pointers.size());
  benchmark::Initialize(&rest_count, pointers.data());
  if (benchmark::ReportUnrecognizedArguments(rest_count, pointers.data())) return 2;

  Suite suite(seed);
  add_raycasts(suite);
  add_raycast_hits(suite);
  add_contains(suite);
  add_closest_points(suite);
  add_distances(suite);
  add_sphere_overlaps(suite);
  add_box_overlaps(suite);
  add_other_overlaps(suite);
  add_intersects(suite);
  add_hulls(suite);
  add_planar(suite);
  add_cameras(suite);
  add_bodies(suite);
  add_pairs<PairQuery::distance, 3>(suite);
  add_pairs<PairQuery::distance, 2>(suite);
  add_pairs<PairQuery::closest_points, 3>(suite);
  add_pairs<PairQuery::closest_points, 2>(suite);
  add_pairs<PairQuery::contact, 3>(suite);
  add_pairs<PairQuery::contact, 2>(suite);
  add_casts<MovingSphere, 3>(suite);
  add_casts<MovingSphere, 2>(suite);
  add_casts<MovingAabb, 3>(suite);
  add_casts<MovingAabb, 2>(suite);
  add_casts<MovingObb, 3>(suite);
  add_casts<MovingObb, 2>(suite);
  add_casts<MovingTriangle, 3>(suite);
  add_casts<MovingTriangle, 2>(suite);
  add_casts<MovingCapsule, 3>(suite);
  add_casts<MovingCapsule, 2>(suite);
  add_casts<MovingRock, 3>(suite);
  add_casts<MovingRock, 2>(suite);
  add_casts<MovingSegment, 3>(suite);
  add_casts<MovingSegment, 2>(suite);
  add_batches(suite);
  add_baselines(suite);
  add_engines(suite);
  add_peers(suite);
  if (!hits_are_right(suite.records())) return 1;

  Results results;
  results.machine = this_machine();
  results.seed = seed;
  results.records = suite.records();
  for (const auto& row : suite.rows()) add_benchmark(row, results);
  std::fprintf(stderr, "detent-bench: %zu rows, up to a second each\n", suite.rows().size());
  Silence silence;
  benchmark::RunSpecifiedBenchmarks(&silence);

  write_tables(stdout, results);
  write_file(csv, [&](std::FILE* file) { write_csv(file, results); });
  write_file(plot, [&](std::FILE* file) { write_plot(file, results); });
  return 0;
}

}  // namespace

}  // namespace detent::bench

int main(int count, char** arguments) { return detent::bench::run(count, arguments); }
