// SPDX-License-Identifier: MIT
//
// usage: questions SCALAR FILE [SEED]
// Writes the inputs of a group of queries to FILE in the memory layout of a little-endian machine,
// and prints the name of each query with its results on this machine. Needs the macro GROUP
// (visit_raycasts, ...).

#include <cstdio>
#include <cstdlib>
#include <string>

#include "size/queries.hpp"
#include "support/scalars.hpp"

namespace detent::size {
namespace {

template <class S>
class Writer {
 public:
  Writer(std::FILE* file, std::uint64_t seed) : file_(file), seed_(seed) {}

  template <class Q>
  void operator()(const Q& query) const {
    using Question = typename Q::template Question<S>;
    static_assert(std::endian::native == std::endian::little &&
                  std::is_trivially_copyable_v<decltype(Question::first)> &&
                  std::is_trivially_copyable_v<decltype(Question::second)>);
    auto drawn = bench::draw_questions(query, seed_, bench::scale_for<S>);
    drawn.resize(question_count);
    const auto questions = bench::as_questions<S>(query, drawn);
    Tally tally;
    for (const auto& question : questions) tally(query.template operator()<S>(question));
    std::printf("%s %lu %08lx\n", std::string(query.name).c_str(),
                static_cast<unsigned long>(tally.hits), static_cast<unsigned long>(tally.digest));
    const std::size_t size = question_count * sizeof(Question);
    std::fwrite(questions.data(), 1, size, file_);
    for (std::size_t i = size; i < size_of_questions<Question>; ++i) std::fputc(0, file_);
  }

 private:
  std::FILE* file_;
  std::uint64_t seed_;
};

bool write(const std::string& scalar, std::FILE* file, std::uint64_t seed) {
  bool is_known = false;
  support::for_each_scalar(support::AllScalars(), [&]<Scalar S>(S) {
    if (scalar != support::scalar_name<S>) return;
    GROUP(Writer<S>(file, seed));
    is_known = true;
  });
  return is_known;
}

}  // namespace
}  // namespace detent::size

int main(int argc, char** argv) {
  if (argc < 3 || argc > 4) return 2;
  const auto seed = argc == 4 ? std::strtoull(argv[3], nullptr, 10) : detent::bench::default_seed;
  std::FILE* file = std::fopen(argv[2], "wb");
  if (file == nullptr) return 1;
  const bool is_known = detent::size::write(argv[1], file, seed);
  return std::fclose(file) == 0 && is_known ? 0 : 1;
}
