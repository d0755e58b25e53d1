// SPDX-License-Identifier: MIT
//
// usage: PROPERTY CORPUS COUNT
// Without the fuzzing engine, checks the property for every file in the folder CORPUS and for COUNT
// seeded random inputs, half of which are such files with a few bytes changed.

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

#include "property.hpp"
#include "support/random.hpp"

namespace {

using Input = std::vector<std::uint8_t>;

std::vector<Input> read_corpus(const std::string& folder) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());  // directory order differs between systems
  std::vector<Input> corpus;
  for (const auto& file : files) {
    std::ifstream stream(file, std::ios::binary);
    Input input;
    for (char c = 0; stream.get(c);) input.push_back(static_cast<std::uint8_t>(c));
    corpus.push_back(std::move(input));
  }
  return corpus;
}

Input draw(detent::test::Random& random, const std::vector<Input>& corpus) {
  Input input;
  if (random.coin() && !corpus.empty()) {
    input = corpus[random.below(corpus.size())];
    for (auto changes = random.below(6); changes > 0 && !input.empty(); --changes) {
      input[random.below(input.size())] = static_cast<std::uint8_t>(random.next());
    }
  } else {
    input.resize(random.below(256));
    for (auto& byte : input) byte = static_cast<std::uint8_t>(random.next());
  }
  return input;
}

bool holds(const Input& input) {
  try {
    detent::fuzz::property(input);
    return true;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n%zu bytes, for xxd -r -p: ", error.what(), input.size());
    for (const auto byte : input) std::fprintf(stderr, "%02x", byte);
    std::fputc('\n', stderr);
    return false;
  }
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 3) {
    std::fprintf(stderr, "usage: %s CORPUS COUNT\n", arguments[0]);
    return 2;
  }
  const auto corpus = read_corpus(arguments[1]);
  int failed = 0;
  for (const auto& input : corpus) failed += holds(input) ? 0 : 1;
  try {
    detent::fuzz::after_corpus();
  } catch (const std::exception& error) {
    std::fprintf(stderr, "the corpus: %s\n", error.what());
    ++failed;
  }
  detent::test::Random random(0xf022);
  const long draws = std::strtol(arguments[2], nullptr, 10);
  for (long i = 0; i < draws && failed < 5; ++i) failed += holds(draw(random, corpus)) ? 0 : 1;
  std::printf("%zu files, %ld random inputs (seed 0xf022), %d failed\n", corpus.size(), draws,
              failed);
  return failed == 0 ? 0 : 1;
}
