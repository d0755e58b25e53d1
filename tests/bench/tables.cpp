// SPDX-License-Identifier: MIT
#include <array>
#include <set>

#include "bench/results.hpp"

namespace detent::bench {

namespace {

constexpr std::array<const char*, 6> own_scalars{"float",  "double", "q16_16",
                                                 "q14_16", "q24_8",  "q8_8"};

bool is_own(const std::string& scalar) {
  return std::find(own_scalars.begin(), own_scalars.end(), scalar) != own_scalars.end();
}

std::vector<std::string> queries_of(const Results& results) {
  std::vector<std::string> queries;
  for (const auto& record : results.records) {
    if (queries.empty() || std::find(queries.begin(), queries.end(), record.query) == queries.end())
      queries.push_back(record.query);
  }
  return queries;
}

const Record* find_record(const Results& results, const std::string& query,
                          const std::string& scalar) {
  for (const auto& record : results.records) {
    if (record.query == query && record.scalar == scalar) return &record;
  }
  return nullptr;
}

void write_ratios(std::FILE* out, const Results& results, Manner manner) {
  std::fprintf(out,
               "| query | float, ns | double | q16_16 | q14_16 | q24_8 | q8_8 |\n"
               "|---|---:|---:|---:|---:|---:|---:|\n");
  for (const auto& query : queries_of(results)) {
    const Times* const base = results.find(query, "float", manner);
    if (base == nullptr || results.find(query, "q8_8", manner) == nullptr) continue;
    std::fprintf(out, "| %-25s | %5.1f |", query.c_str(), base->median());
    for (const std::string scalar : own_scalars) {
      if (scalar == "float") continue;
      const Times* const time = results.find(query, scalar, manner);
      if (time == nullptr) {
        std::fprintf(out, " |");
        continue;
      }
      const auto ratio = results.ratio(*time, *base);
      std::fprintf(out, " %.2f ± %.2f |", ratio.median, ratio.spread);
    }
    std::fprintf(out, "\n");
  }
}

/// The percentage of wrong results, or nothing if there are none to count.
std::string percent(std::size_t wrong, std::size_t asked) {
  if (asked == 0) return "";
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.3g",
                100.0 * static_cast<double>(wrong) / static_cast<double>(asked));
  return text.data();
}

/// The same with its unit, except for 0.
std::string share(std::size_t wrong, std::size_t asked) {
  const auto text = percent(wrong, asked);
  return text.empty() || wrong == 0 ? text : text + " %";
}

std::string length(double x) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.1e", x);
  return text.data();
}

void write_accuracy(std::FILE* out, const Results& results) {
  std::fprintf(out,
               "| query | float wrong | when close | float error | double error | q16_16 wrong | "
               "when close | q24_8 error | q8_8 wrong | q8_8 error |\n"
               "|---|---:|---:|---:|---:|---:|---:|---:|---:|---:|\n");
  for (const auto& query : queries_of(results)) {
    const Record* const records[] = {
        find_record(results, query, "float"), find_record(results, query, "double"),
        find_record(results, query, "q16_16"), find_record(results, query, "q24_8"),
        find_record(results, query, "q8_8")};
    if (records[4] == nullptr) continue;
    const auto& [single, twice, exact, coarse, tiny] = records;
    const auto& a = single->accuracy;
    const bool decides = a.close_asked != 0;
    if (!decides && a.error == 0) continue;  // it would have no columns except times
    const auto wrong = [&](const Record& record) {
      return decides ? share(record.accuracy.wrong, record.accuracy.asked) : std::string();
    };
    const auto close = [&](const Record& record) {
      return share(record.accuracy.close_wrong, record.accuracy.close_asked);
    };
    const auto error = [&](const Record& record) {
      return single->accuracy.error == 0 ? std::string() : length(record.accuracy.error);
    };
    const std::string coarse_error = coarse == nullptr ? "" : error(*coarse);
    std::fprintf(out, "| %s | %s | %s | %s | %s | %s | %s | %s | %s | %s |\n", query.c_str(),
                 wrong(*single).c_str(), close(*single).c_str(), error(*single).c_str(),
                 error(*twice).c_str(), wrong(*exact).c_str(), close(*exact).c_str(),
                 coarse_error.c_str(), wrong(*tiny).c_str(), error(*tiny).c_str());
  }
}

void write_baselines(std::FILE* out, const Results& results) {
  std::fprintf(out,
               "| question | answered by | ns | multiple of float | wrong | error |\n"
               "|---|---|---:|---:|---:|---:|\n");
  for (const auto& query : queries_of(results)) {
    const bool has_baseline = std::any_of(
        results.records.begin(), results.records.end(),
        [&](const Record& record) { return record.query == query && !is_own(record.scalar); });
    const Times* base = results.find(query, "float", Manner::shuffled);
    if (base == nullptr) base = results.find(query, hardware, Manner::shuffled);
    if (!has_baseline || base == nullptr) continue;
    for (const auto& record : results.records) {
      if (record.query != query) continue;
      if (is_own(record.scalar) && record.scalar != "float" && record.scalar != "q16_16") continue;
      const Times* const time = results.find(query, record.scalar, Manner::shuffled);
      if (time == nullptr) continue;
      const auto ratio = results.ratio(*time, *base);
      std::fprintf(out, "| %s | %s | %.1f | %.2f ± %.2f | %s | %s |\n", query.c_str(),
                   record.scalar.c_str(), time->median(), ratio.median, ratio.spread,
                   share(record.accuracy.wrong, record.accuracy.asked).c_str(),
                   length(record.accuracy.error).c_str());
    }
  }
}

}  // namespace

void write_tables(std::FILE* out, const Results& results) {
  std::fprintf(out, "%s; %s; %s; seed %llu\n", results.machine.processor.c_str(),
               results.machine.compiler.c_str(), results.machine.date.c_str(),
               static_cast<unsigned long long>(results.seed));
  for (const Manner manner : manners) {
    std::fprintf(out, "\n### Multiples of float, %s\n\n", name_of(manner).c_str());
    write_ratios(out, results, manner);
  }
  std::fprintf(out, "\n### Accuracy\n\n");
  write_accuracy(out, results);
  std::fprintf(out, "\n### Baselines\n\n");
  write_baselines(out, results);
}

void write_csv(std::FILE* out, const Results& results) {
  std::fprintf(out, "# %s; %s; %s; seed %llu\nquery,scalar", results.machine.processor.c_str(),
               results.machine.compiler.c_str(), results.machine.date.c_str(),
               static_cast<unsigned long long>(results.seed));
  for (const Manner manner : manners) {
    const auto name = name_of(manner);
    std::fprintf(out, ",%s ns,%s multiple,%s ±", name.c_str(), name.c_str(), name.c_str());
  }
  std::fprintf(out, ",wrong %%,close wrong %%,largest error\n");
  for (const auto& record : results.records) {
    std::fprintf(out, "%s,\"%s\"", record.query.c_str(), record.scalar.c_str());
    for (const Manner manner : manners) {
      const Times* const time = results.find(record.query, record.scalar, manner);
      const Times* base = results.find(record.query, "float", manner);
      if (base == nullptr) base = results.find(record.query, hardware, manner);
      if (time == nullptr || base == nullptr) {
        std::fprintf(out, ",,,");
        continue;
      }
      const auto ratio = results.ratio(*time, *base);
      std::fprintf(out, ",%.1f,%.2f,%.2f", time->median(), ratio.median, ratio.spread);
    }
    const auto& accuracy = record.accuracy;
    std::fprintf(out, ",%s,%s,%.1e\n", percent(accuracy.wrong, accuracy.asked).c_str(),
                 percent(accuracy.close_wrong, accuracy.close_asked).c_str(), accuracy.error);
  }
}

}  // namespace detent::bench
