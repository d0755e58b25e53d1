// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "detent/math/vec.hpp"
#include "detent/number/decimal.hpp"
#include "detent/number/fixed.hpp"

// Reads scene files for the programs that play them.

namespace detent::test {

using S = q16_16;

[[noreturn]] inline void fail(const std::string& what) {
  std::cerr << "scene file: " << what << "\n";
  std::exit(2);
}

inline S number(std::istream& in) {
  std::string text;
  in >> text;
  const auto value = S::parse(text);
  if (!value) fail("not a number: " + text);
  return *value;
}

template <int N>
Vec<S, N> vector(std::istream& in) {
  Vec<S, N> v{};
  for (int i = 0; i < N; ++i) v[i] = number(in);
  return v;
}

/// One scene of a file.
struct SceneText {
  int dimension = 0, ticks = 0;  // ticks: 0 if the file does not say
  std::vector<std::string> lines;
  std::map<int, std::vector<std::string>> events;  // by tick: what follows "at TICK"

  /// Calls f(word, rest) with the first word of each line, in order.
  template <class F>
  void for_each_line(const F& f) const {
    for (const auto& line : lines) {
      std::istringstream in(line);
      std::string word;
      in >> word;
      f(word, in);
    }
  }
  /// Calls f(rest of line) for each event of a tick.
  template <class F>
  void for_each_event(int tick, const F& f) const {
    const auto found = events.find(tick);
    if (found == events.end()) return;
    for (const auto& event : found->second) f(event);
  }
};

/// Reads a scene, which lasts from the line "scene NAME DIMENSION [TICKS]" to the next such line.
inline SceneText read_scene(const char* path, const std::string& name) {
  SceneText scene;
  std::ifstream file(path);
  bool is_mine = false;
  for (std::string line; std::getline(file, line);) {
    line.resize(std::min(line.size(), line.find('#')));
    std::istringstream in(line);
    std::string word;
    if (!(in >> word)) continue;
    if (word == "scene") {
      in >> word;
      is_mine = word == name;
      if (is_mine) in >> scene.dimension >> scene.ticks;
    } else if (is_mine && word == "at") {
      int tick = 0;
      in >> tick;
      std::getline(in, scene.events[tick].emplace_back());
    } else if (is_mine) {
      scene.lines.push_back(line);
    }
  }
  if (scene.dimension != 2 && scene.dimension != 3) fail("no scene " + name);
  return scene;
}

}  // namespace detent::test
