// SPDX-License-Identifier: MIT
#include "replay.hpp"

#include <unistd.h>
#include <zlib.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "error.hpp"
#include "gzip.hpp"
#include "support/catch.hpp"

using namespace detent;
using namespace detent::cli;

namespace {

/// A directory of replays that is deleted at the end of the test.
class Folder {
 public:
  Folder()
      : path_(std::filesystem::temp_directory_path() / ("replays-" + std::to_string(getpid()))) {
    std::filesystem::create_directories(path_);
  }
  ~Folder() { std::filesystem::remove_all(path_); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  std::string add(const std::string& name, const std::string& bytes) const {
    const auto path = (path_ / name).string();
    std::ofstream(path, std::ios::binary) << bytes;
    return path;
  }
  [[nodiscard]] std::string path() const { return path_.string(); }

 private:
  std::filesystem::path path_;
};

std::string example(std::uint64_t seed, int frames = 300, int every = 60) {
  return example_replay({"", seed, frames, every});
}
ReplayReport check(const std::string& path, const std::string& shard = "1/1") {
  return check_replays({{path}, shard});
}
bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

/// Compresses `bytes` into a gzip file.
std::string packed(const Folder& folder, const std::string& bytes) {
  const auto path = folder.path() + "/packed.tmp";
  const auto file = gzopen(path.c_str(), "wb");
  REQUIRE(file != nullptr);
  REQUIRE(gzwrite(file, bytes.data(), static_cast<unsigned>(bytes.size())) ==
          static_cast<int>(bytes.size()));
  REQUIRE(gzclose(file) == Z_OK);
  std::ifstream stream(path, std::ios::binary);
  std::string result{std::istreambuf_iterator<char>(stream), {}};
  std::filesystem::remove(path);
  return result;
}

}  // namespace

TEST_CASE("replay check: examples are reproduced, and differ by seed") {
  const Folder folder;
  folder.add("a", example(1));
  folder.add("b", example(2));
  const auto report = check(folder.path());
  CHECK(report.problems.empty());
  CHECK(report.totals == ReplayTotals{2, 2, 0, 0, 0, 600});
  CHECK(example(1) == example(1));
  CHECK(example(1) != example(2));
}

TEST_CASE("replay check: the first frame that differs is named") {
  const Folder folder;
  // A digest is changed, and all checksums after it are corrected.
  for (const int every : {1, 60}) {
    auto bytes = example(3, 120, every);
    std::vector<std::size_t> blocks;
    const auto word = [&](std::size_t at, std::size_t size) {
      std::size_t value = 0;
      for (std::size_t i = 0; i < size; ++i) {
        value |= std::size_t{static_cast<unsigned char>(bytes[at + i])} << (8 * i);
      }
      return value;
    };
    const auto head = 18 + word(13, 1) + word(14, 4);
    for (auto at = head + 8; at < bytes.size(); at += 15 + word(at, 2)) blocks.push_back(at);
    const std::size_t changed = every == 1 ? 77 : 1;
    bytes[blocks.at(changed) + 3] ^= 1;
    auto seed = std::uint64_t{word(head, 8)};
    for (const auto at : blocks) {
      const auto size = 11 + word(at, 2);
      seed = detail::digest_from(seed, std::as_bytes(std::span(bytes)).subspan(at, size));
      for (std::size_t i = 0; i < 4; ++i) bytes[at + size + i] = static_cast<char>(seed >> (8 * i));
    }
    const auto report = check(folder.add("changed", bytes));
    REQUIRE(report.problems.size() == 1);
    INFO(report.problems[0]);
    CHECK(has(report.problems[0], "changed: "));
    CHECK(has(report.problems[0],
              every == 1 ? "frame 77: a different" : "one of the frames 60 to 119: a different"));
    CHECK(report.totals.different == 1);
  }
}

TEST_CASE("replay check: files that are not replays are named, and the others are checked") {
  const Folder folder;
  const auto right = example(4);
  auto broken = right;
  broken[broken.size() - 10] ^= 1;
  folder.add("broken", broken);
  folder.add("cut", right.substr(0, right.size() - 10));
  folder.add("empty", "");
  folder.add("right", right);
  const auto report = check(folder.path());
  CHECK(report.totals == ReplayTotals{4, 2, 0, 2, 1, 240 + 240 + 300});
  REQUIRE(report.problems.size() == 2);
  CHECK(has(report.problems[0], "broken: a byte has changed after frame 240; copy"));
  CHECK(has(report.problems[1],
            "empty: not a replay, or its head is damaged; copy it again, or name a file"));
  std::filesystem::create_directory(folder.path() + "/nothing");
  CHECK_THROWS_AS(check(folder.path() + "/nothing"), InputError);
  const auto missing = check(folder.path() + "/missing");
  REQUIRE(missing.problems.size() == 1);
  CHECK(has(missing.problems[0], "missing"));
  CHECK(missing.totals.unreadable == 1);
}

TEST_CASE("replay check: gzip files are unpacked") {
  const Folder folder;
  const auto right = example(5);
  const auto small = packed(folder, right);
  CHECK(small.size() < right.size());
  folder.add("a.gz", small);
  folder.add("b.gz", small.substr(0, small.size() / 2));
  folder.add("c.gz", packed(folder, right.substr(0, right.size() - 10)));
  const auto report = check(folder.path());
  CHECK(report.totals == ReplayTotals{3, 2, 0, 1, 1, 300 + 240});
  REQUIRE(report.problems.size() == 1);
  CHECK(has(report.problems[0], "b.gz: a damaged or truncated gzip file"));
}

TEST_CASE("unpacked: concatenated gzip files, and damaged ones") {
  const Folder folder;
  CHECK(unpacked("f", "") == "");
  CHECK(unpacked("f", "\x1f") == "\x1f");
  CHECK(unpacked("f", "plain") == "plain");
  const std::string text(300'000, 'a');
  const auto one = packed(folder, text), other = packed(folder, "bc");
  CHECK(unpacked("f", one) == text);
  CHECK(unpacked("f", one + other) == text + "bc");
  for (std::size_t size = 2; size < other.size(); ++size) {
    CHECK_THROWS_AS(unpacked("f", other.substr(0, size)), InputError);
    CHECK_THROWS_AS(unpacked("f", one + other.substr(0, size)), InputError);
  }
  for (std::size_t i = 10; i < other.size(); ++i) {  // after the header, which contains a date
    auto changed = other;
    changed[i] = static_cast<char>(changed[i] ^ 0x10);
    try {
      const auto content = unpacked("f", changed);
      CHECK(content == "bc");  // a bit that nothing reads
    } catch (const InputError& error) {
      CHECK(has(error.what(), "f: a damaged or truncated gzip file"));
    }
  }
}

TEST_CASE("replay check: shards add up to the whole") {
  const Folder folder;
  for (std::uint64_t i = 0; i < 20; ++i) folder.add("m" + std::to_string(i), example(i, 30));
  ReplayTotals sum;
  for (const std::string shard : {"1/3", "2/3", "3/3"}) {
    const auto part = check(folder.path(), shard).totals;
    CHECK(part.files > 2);
    sum += part;
  }
  CHECK(sum == check(folder.path()).totals);
  for (const std::string shard : {"0/3", "4/3", "1", "1/", "a/b", "1/3x", "-1/3", "1/0"}) {
    CHECK_THROWS_AS(check(folder.path(), shard), InputError);
  }
}
