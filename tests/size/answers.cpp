// SPDX-License-Identifier: MIT
//
// Runs a group of queries on a microcontroller; its output must equal that of questions.cpp. A
// `yield` before and after each query lets count_instructions.c count. Needs the macros SCALAR,
// GROUP (visit_raycasts, ...) and QUESTIONS, the file with the inputs.

#include "size/queries.hpp"

#include "platforms/bare/semihosting.hpp"

__asm__(".section .rodata.questions\n.balign 4\nquestions:\n.incbin \"" QUESTIONS "\"\n.text\n");

namespace detent::size {
namespace {

extern "C" const unsigned char questions[];

template <class S, class Q>
[[gnu::noinline]] auto answer(const typename Q::template Question<S>& question) {
  return Q{}.template operator()<S>(question);
}

class Printer {
 public:
  explicit Printer(void (*put)(const char*)) : put_(put) {}

  template <class Q>
  void operator()(const Q& query) {
    using S = SCALAR;
    using Question = typename Q::template Question<S>;
    const auto* question = reinterpret_cast<const Question*>(place_);
    Tally tally;
    for (int i = 0; i < question_count; ++i) {
      __asm__ volatile("yield" : : : "memory");
      const auto result = answer<S, Q>(question[i]);
      __asm__ volatile("yield" : : "m"(result) : "memory");
      tally(result);
    }
    place_ += size_of_questions<Question>;

    put_(query.name.data());
    put_(" ");
    put_number(tally.hits, 10);
    put_(" ");
    put_number(tally.digest, 16);
    put_("\n");
  }

 private:
  void put_number(std::uint32_t x, std::uint32_t base) const {
    char text[9];
    char* digit = text + 8;
    *digit = 0;
    do {
      *--digit = "0123456789abcdef"[x % base];
      x /= base;
    } while (x != 0 || (base == 16 && digit != text));
    put_(digit);
  }

  void (*put_)(const char*);
  const unsigned char* place_ = questions;
};

}  // namespace
}  // namespace detent::size

extern "C" int detent_verify(void (*put)(const char*)) {
  detent::size::Printer printer(put);
  detent::size::GROUP([&](const auto& query) { printer(query); });
  return 0;
}
