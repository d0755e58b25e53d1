// SPDX-License-Identifier: MIT
#include "replay.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <chrono>
#include <cstddef>
#include <filesystem>
#include <iostream>
#include <span>

#include "detent/dynamics/dynamics.hpp"
#include "detent/number/literals.hpp"
#include "error.hpp"
#include "file.hpp"
#include "gzip.hpp"

namespace detent::cli {
namespace {

using namespace detent::literals;
using S = q16_16;
using Blocks = World<S, 2, Sphere, Obb>;
using Pad = std::array<std::int8_t, 2>;  // a push along x and y
using Inputs = FrameInputs<Pad, 2>;
constexpr std::string_view kind = "detent example blocks 1";
constexpr std::array balls{BodyId{3, 4}, BodyId{4, 5}};

/// The part of the example that replays do not store: the ground, and walls on both sides.
Blocks ground() {
  Blocks world;
  BodyOptions<S, 2> fixed;
  fixed.motion = BodyMotion::fixed;
  world.add(Obb<S, 2>{{0_q16_16, -1_q16_16}, {40_q16_16, 1_q16_16}, {}}, fixed);
  world.add(Obb<S, 2>{{-9_q16_16, 20_q16_16}, {1_q16_16, 20_q16_16}, {}}, fixed);
  world.add(Obb<S, 2>{{9_q16_16, 20_q16_16}, {1_q16_16, 20_q16_16}, {}}, fixed);
  return world;
}

/// Two balls between towers of six blocks.
Blocks start() {
  Blocks world = ground();
  world.add(Sphere<S, 2>{{-2_q16_16, 1_q16_16}, 0.5_q16_16});
  world.add(Sphere<S, 2>{{2_q16_16, 1_q16_16}, 0.5_q16_16});
  for (int i = 0; i < 12; ++i) {
    const S x(i < 6 ? -5 : 5);
    world.add(Obb<S, 2>{{x, nearest_to<S>(S(i % 6) + 0.5_q16_16)}, {0.5_q16_16, 0.5_q16_16}, {}});
  }
  return world;
}

void simulate(Blocks& world, const Inputs& pads) {
  for (std::size_t i = 0; i < 2; ++i) {
    if (pads[i] != Pad{}) world.apply_force(balls[i], {S(pads[i][0]), S(pads[i][1])});
  }
  world.step();
}

/// K and N of "K/N".
std::array<std::uint32_t, 2> parse_shard(const std::string& text) {
  std::array<std::uint32_t, 2> shard{};
  const char* const end = text.data() + text.size();
  const auto first = std::from_chars(text.data(), end, shard[0]);
  if (first.ec == std::errc() && first.ptr != end && *first.ptr == '/') {
    const auto second = std::from_chars(first.ptr + 1, end, shard[1]);
    const bool is_right = second.ec == std::errc() && second.ptr == end;
    if (is_right && shard[0] >= 1 && shard[0] <= shard[1]) return shard;
  }
  throw InputError("--shard: \"" + text +
                   "\" is not a shard; write K/N with K from 1 to N, such as 2/8");
}

/// All files of the shard, in order of their paths. The shard is chosen by the name in its folder.
std::vector<std::filesystem::path> files_of(const ReplayOptions& options) {
  const auto [shard, shards] = parse_shard(options.shard);
  std::vector<std::filesystem::path> files;
  for (const auto& path : options.paths) {
    std::error_code error;
    if (!std::filesystem::is_directory(path, error)) {
      files.emplace_back(path);
      continue;
    }
    const auto before = files.size();
    for (const auto& entry : std::filesystem::directory_iterator(path, error)) {
      if (entry.is_regular_file(error)) files.push_back(entry.path());
    }
    if (error) throw InputError(path, {}, error.message() + "; name files, or a folder of replays");
    if (files.size() == before) {
      throw InputError(path, {}, "has no files in it; name files, or a folder of replays");
    }
  }
  std::erase_if(files, [&, k = shard, n = shards](const auto& file) {
    return !is_in_shard(file.filename().string(), k, n);
  });
  std::sort(files.begin(), files.end());
  return files;
}

std::string frames_of(const ReplayCheck& check) {
  if (check.frames == check.equal + 1) return "frame " + std::to_string(check.equal);
  return "one of the frames " + std::to_string(check.equal) + " to " +
         std::to_string(check.frames - 1);
}

/// What is wrong with a replay and what to do, or nothing.
std::string problem_of(const ReplayCheck& check) {
  if (!check.is_equal) {
    return frames_of(check) + ": a different result" +
           (check.frames > check.equal + 1
                ? "; record a digest every frame to find out which"
                : "; simulate up to there on both machines and compare with diff(a, b)");
  }
  switch (check.state) {
    case ReplayState::whole:
    case ReplayState::cut:
      return "";
    case ReplayState::corrupted:
      return "a byte has changed after frame " + std::to_string(check.frames) +
             "; copy the file again";
    case ReplayState::no_replay:
      return "not a replay, or its head is damaged; copy it again, or name a file written by "
             "detent "
             "replay example or a ReplayWriter";
    case ReplayState::other_inputs:
      return "a replay of a different game; check it with that game's own program";
    case ReplayState::other_results:
      return "recorded with a different results_version; check it with that version of detent";
  }
  return "";
}

struct FileCheck {
  ReplayCheck check;
  std::string problem;
};

FileCheck check_file(const std::string& path) {
  std::string bytes;
  try {
    bytes = unpacked(path, read_file(path));
  } catch (const InputError& error) {
    return {{ReplayState::no_replay, 0, 0, true}, error.what()};
  }
  const ReplayReader<Pad, 2> replay(std::as_bytes(std::span(bytes)));
  FileCheck result;
  result.check.state = replay.state();
  Blocks world = ground();
  if (replay.state() == ReplayState::whole) {
    if (!replay.is_kind(kind)) {
      result.check.state = ReplayState::other_inputs;
    } else if (restore(world, replay.snapshot()) != Restored::yes || replay.players() != 2) {
      result.check.state = ReplayState::no_replay;
    } else {
      result.check = check_replay(replay, world, simulate);
    }
  }
  const auto problem = problem_of(result.check);
  if (!problem.empty()) result.problem = InputError(path, {}, problem).what();
  return result;
}

}  // namespace

ReplayReport check_replays(const ReplayOptions& options) {
  ReplayReport report;
  for (const auto& file : files_of(options)) {
    const auto result = check_file(file.string());
    report.totals += result.check;
    if (!result.problem.empty()) report.problems.push_back(result.problem);
  }
  return report;
}

int replay_check(const ReplayOptions& options) {
  const auto begin = std::chrono::steady_clock::now();
  const auto report = check_replays(options);
  const auto time = std::chrono::duration_cast<std::chrono::milliseconds>(
      std::chrono::steady_clock::now() - begin);
  for (const auto& problem : report.problems) std::cerr << "detent: " << problem << '\n';
  const auto& totals = report.totals;
  std::cout << "{\"files\": " << totals.files << ", \"equal\": " << totals.equal
            << ", \"different\": " << totals.different << ", \"unreadable\": " << totals.unreadable
            << ", \"cut\": " << totals.cut << ", \"frames\": " << totals.frames
            << ", \"milliseconds\": " << time.count() << "}\n";
  if (totals.unreadable != 0) return 2;
  return totals.different != 0 ? 1 : 0;
}

std::string example_replay(const ExampleOptions& options) {
  std::string bytes;
  const auto append = [&](std::span<const std::byte> more) {
    for (const auto byte : more) bytes.push_back(static_cast<char>(byte));
  };
  Blocks world = start();
  const auto before = snapshot(world);
  ReplayWriter<Pad, 2> replay(static_cast<std::size_t>(options.every));
  replay.begin({.kind = kind, .players = 2, .snapshot = before}, append);
  std::array<Pad, 2> pressed{};
  auto random = options.seed * 2 + 1;
  for (int frame = 0; frame < options.frames; ++frame) {
    Inputs pads(static_cast<std::uint32_t>(frame), 2);
    for (std::size_t i = 0; i < 2; ++i) {
      random = random * 6364136223846793005u + 1442695040888963407u;
      if (random >> 60 == 0) {  // a key changes about four times a second
        pressed[i] = {static_cast<std::int8_t>((random >> 40) % 31 - 15),
                      static_cast<std::int8_t>((random >> 50) % 16)};
      }
      pads.set(i, pressed[i]);
    }
    simulate(world, pads);
    replay.add(pads, world, append);
  }
  replay.end(world, append);
  return bytes;
}

void replay_example(const ExampleOptions& options) {
  OutputFile file(options.out);
  file.write(example_replay(options));
  file.commit();
}

}  // namespace detent::cli
