// SPDX-License-Identifier: MIT
//
// usage: detent-samples NAME... | all [--ticks N] [--picture FILE.png] [--size WxH]
//        detent-samples --list
// Plays samples and prints their digests every 60 ticks and at the end, then their status; `all`
// prints digests only. The picture shows the last tick, several samples in two columns. Bad
// arguments print one line and exit with 2.
#include <algorithm>
#include <charconv>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string_view>

#include "gallery.hpp"
#include "painter.hpp"

namespace {

using namespace samples;

[[noreturn]] void refuse(const std::string& why) {
  std::fprintf(stderr, "detent-samples: %s\n", why.c_str());
  std::exit(2);
}

int number_of(std::string_view text, int most, const char* what) {
  int value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || value < 1 || value > most) {
    refuse("'" + std::string(text) + "' is no " + what + "; write a whole number from 1 to " +
           std::to_string(most));
  }
  return value;
}

struct Command {
  std::vector<const Entry*> entries;
  int ticks = 300, width = 640, height = 400;
  std::string picture;
  bool is_all = false;
};

Command read(int count, char** words) {
  Command command;
  for (int i = 1; i < count; ++i) {
    const std::string word = words[i];
    const auto value = [&]() -> std::string_view {
      if (++i == count) refuse("there is no value after " + word);
      return words[i];
    };
    if (word == "--list") {
      for (const Entry* each : gallery()) std::printf("%-16s%s\n", each->name, each->sentence);
      std::exit(0);
    } else if (word == "--ticks") {
      command.ticks = number_of(value(), 1'000'000, "number of ticks");
    } else if (word == "--picture") {
      command.picture = value();
    } else if (word == "--size") {
      const auto size = value();
      const auto by = (std::min)(size.find('x'), size.size());
      command.width = number_of(size.substr(0, by), 4000, "width");
      command.height = number_of(size.substr((std::min)(by + 1, size.size())), 4000, "height");
    } else if (word == "all") {
      command.entries.assign(gallery().begin(), gallery().end());
      command.is_all = true;
    } else if (const Entry* entry = find(word)) {
      command.entries.push_back(entry);
    } else {
      refuse("no sample or option '" + word + "'; --list shows the samples");
    }
  }
  if (command.entries.empty()) refuse("which sample? --list shows them, 'all' plays all");
  return command;
}

void print(const char* name, int tick, const Sample& sample) {
  std::printf("%s %d %016llx\n", name, tick, static_cast<unsigned long long>(sample.digest()));
  std::fflush(stdout);
}

}  // namespace

int main(int count, char** words) {
  const Command command = read(count, words);
  constexpr int gap = 8;
  const auto rows = static_cast<int>((command.entries.size() + 1) / 2);
  const bool is_alone = command.entries.size() == 1;
  Image sheet(is_alone ? command.width : 2 * command.width + gap,
              rows * (command.height + gap) - gap);
  int place = 0;
  for (const Entry* entry : command.entries) {
    const auto sample = entry->make();
    for (int tick = 1; tick <= command.ticks; ++tick) {
      sample->step({});
      if (tick % 60 == 0 || tick == command.ticks) print(entry->name, tick, *sample);
    }
    if (!command.is_all) std::printf("%s\n", sample->status().c_str());
    if (command.picture.empty()) continue;
    Picture picture;
    sample->draw(picture);
    sheet.place(painted(picture, sample->view(), command.width, command.height),
                place % 2 * (command.width + gap), place / 2 * (command.height + gap));
    ++place;
  }
  if (command.picture.empty()) return 0;
  std::ofstream file(command.picture, std::ios::binary);
  file << sheet.png();
  if (!file.flush()) refuse("cannot write " + command.picture);
}
