// SPDX-License-Identifier: MIT
// Alternatives that a user might choose, on the same inputs in the same run.

#include "bench/plain.hpp"
#include "bench/suite.hpp"
#if DETENT_BENCH_LIBFIXMATH
#include <libfixmath/fix16.h>
#endif

namespace detent::bench {

namespace {

template <class T>
using Pairs = std::vector<std::pair<T, T>>;

/// Numbers over the whole range of q16_16 whose product and quotient are in range.
Pairs<q16_16> draw_numbers(std::uint64_t seed) {
  test::Random random(seed);
  Pairs<q16_16> pairs(question_count);
  for (auto& [a, b] : pairs) {
    const auto magnitude = static_cast<std::int32_t>(random.between(65536, 128 * 65536));
    a = q16_16::from_raw(static_cast<std::int32_t>(random.between(0, 128 * 65536)));
    b = q16_16::from_raw(random.coin() ? magnitude : -magnitude);
  }
  return pairs;
}

template <class T, class Convert>
Pairs<T> convert(const Pairs<q16_16>& pairs, const Convert& to) {
  Pairs<T> result;
  for (const auto& [a, b] : pairs) result.emplace_back(to(a), to(b));
  return result;
}

/// Times one operation and compares its results with `exact`: a result is wrong if it is off by a
/// step of 2^-16 or more.
template <class T, class Operation, class Value, class Exact>
void add_operation(Suite& suite, const std::string& name, const std::string& scalar,
                   const Pairs<q16_16>& numbers, const Pairs<T>& questions,
                   const Operation& operation, const Value& value, const Exact& exact) {
  Accuracy accuracy;
  for (std::size_t i = 0; i < question_count; ++i) {
    const double error =
        std::abs(value(operation(questions[i])) - exact(static_cast<double>(numbers[i].first),
                                                        static_cast<double>(numbers[i].second)));
    ++accuracy.asked;
    accuracy.wrong += error * 65536 >= 1 ? 1u : 0u;
    accuracy.error = std::max(accuracy.error, error);
  }
  suite.add_record({name, scalar, 0, 0, false, accuracy});
  suite.add(name, scalar, questions, operation, [](const auto&) { return true; });
}

template <class Multiply, class Divide, class Root, class T, class Value>
void add_arithmetic(Suite& suite, const std::string& scalar, const Pairs<q16_16>& numbers,
                    const Pairs<T>& questions, const Multiply& multiply, const Divide& divide,
                    const Root& root, const Value& value) {
  // Products have 48 bits and quotients have 23-bit operands, so double is precise enough as a
  // reference.
  add_operation(suite, "number/multiply", scalar, numbers, questions, multiply, value,
                [](double a, double b) { return a * b; });
  add_operation(suite, "number/divide", scalar, numbers, questions, divide, value,
                [](double a, double b) { return a / b; });
  add_operation(suite, "number/sqrt", scalar, numbers, questions, root, value,
                [](double a, double) { return std::sqrt(a); });
}

void add_numbers(Suite& suite) {
  const auto numbers = draw_numbers(suite.seed());
  const auto as_is = [](auto x) { return static_cast<double>(x); };
  add_arithmetic(
      suite, "float", numbers,
      convert<float>(numbers, [](q16_16 x) { return static_cast<float>(static_cast<double>(x)); }),
      [](const auto& x) { return x.first * x.second; },
      [](const auto& x) { return x.first / x.second; },
      [](const auto& x) { return std::sqrt(x.first); }, as_is);
  add_arithmetic(
      suite, "q16_16", numbers, numbers,
      [](const auto& x) { return nearest_to<q16_16>(x.first * x.second); },
      [](const auto& x) { return quotient_nearest<q16_16>(x.first, x.second); },
      [](const auto& x) { return sqrt_floor<q16_16>(x.first); }, as_is);
  add_arithmetic(
      suite, "plain Q16.16", numbers,
      convert<plain::Number>(numbers, [](q16_16 x) { return plain::Number{x.raw()}; }),
      [](const auto& x) { return x.first * x.second; },
      [](const auto& x) { return x.first / x.second; },
      [](const auto& x) { return plain::sqrt(x.first); },
      [](plain::Number x) { return x.raw / 65536.0; });
#if DETENT_BENCH_LIBFIXMATH
  add_arithmetic(
      suite, "libfixmath", numbers,
      convert<fix16_t>(numbers, [](q16_16 x) { return fix16_t{x.raw()}; }),
      [](const auto& x) { return fix16_mul(x.first, x.second); },
      [](const auto& x) { return fix16_div(x.first, x.second); },
      [](const auto& x) { return fix16_sqrt(x.first); }, [](fix16_t x) { return x / 65536.0; });
#endif
}

/// The root of 62 random bits, compared with the processor's.
void add_long_roots(Suite& suite) {
  using Square = Fixed<62, 32>;
  test::Random random(suite.seed());
  std::vector<Square> squares(question_count);
  std::vector<double> as_double;
  Accuracy accuracy;
  for (auto& x : squares) {
    x = Square::from_raw(static_cast<std::int64_t>(random.next() >> 2 >> random.below(48)));
    as_double.push_back(static_cast<double>(x));
    const double error = std::sqrt(as_double.back()) - static_cast<double>(sqrt_floor<q16_16>(x));
    ++accuracy.asked;
    accuracy.wrong += error * 65536 >= 1 ? 1u : 0u;
    accuracy.error = std::max(accuracy.error, error);
  }
  const std::string name = "number/sqrt of 62 bits";
  const auto is_hit = [](const auto&) { return true; };
  suite.add_record({name, hardware, 0, 0, false, {}});
  suite.add(
      name, hardware, as_double, [](const double& x) { return std::sqrt(x); }, is_hit);
  suite.add_record({name, "sqrt_floor", 0, 0, false, accuracy});
  suite.add(
      name, "sqrt_floor", squares, [](const Square& x) { return sqrt_floor<q16_16>(x); }, is_hit);
}

plain::Vector as_plain(const Vec<q16_16, 3>& v) { return {{v.x.raw()}, {v.y.raw()}, {v.z.raw()}}; }
plain::Ray as_plain(const Ray<q16_16, 3>& ray) {
  return {as_plain(ray.origin),
          as_plain(nearest_to<q16_16>(ray.direction.vec())),
          {ray.max_distance.raw()}};
}
plain::Sphere as_plain(const Sphere<q16_16, 3>& sphere) {
  return {as_plain(sphere.center), {sphere.radius.raw()}};
}
plain::Box as_plain(const Aabb<q16_16, 3>& box) { return {as_plain(box.min), as_plain(box.max)}; }
plain::Triangle as_plain(const Triangle<q16_16, 3>& triangle) {
  return {as_plain(triangle.a), as_plain(triangle.b), as_plain(triangle.c)};
}

template <class Q>
void add_plain(Suite& suite, const Q& query, Scale scale) {
  const auto drawn = draw_questions(query, suite.seed(), scale);
  const auto exact = as_questions<q16_16>(query, drawn);
  const auto ask = [](const auto& question) {
    return plain::raycast(question.first, question.second);
  };
  using Shape = decltype(as_plain(exact[0].second));
  std::vector<std::pair<plain::Ray, Shape>> questions;
  Accuracy accuracy;
  std::size_t hit_count = 0, expected = 0;
  for (const auto& question : exact) {
    questions.emplace_back(as_plain(question.first), as_plain(question.second));
    const auto truth = query.template operator()<q16_16>(question);
    const auto answer = ask(questions.back());
    ++accuracy.asked;
    accuracy.wrong += truth.has_value() != answer.has_value() ? 1u : 0u;
    hit_count += answer ? 1u : 0u;
    expected += truth ? 1u : 0u;
    if (truth && answer) {
      accuracy.error =
          std::max(accuracy.error, std::abs(answer->raw / 65536.0 - static_cast<double>(*truth)));
    }
  }
  const std::string name = scale.reach == small.reach ? "plain Q16.16, small" : "plain Q16.16";
  suite.add_record({std::string(query.name), name, hit_count, expected, false, accuracy});
  suite.add(std::string(query.name), name, questions, ask,
            [ask](const auto& question) { return ask(question).has_value(); });
}

}  // namespace

void add_baselines(Suite& suite) {
  add_numbers(suite);
  add_long_roots(suite);
  for (const Scale scale : {ordinary, small}) {
    add_plain(suite, query<Ray, Sphere>("raycast/sphere", ask_raycast), scale);
    add_plain(suite, query<Ray, Aabb>("raycast/aabb", ask_raycast), scale);
    add_plain(suite, query<Ray, Triangle>("raycast/triangle", ask_raycast), scale);
  }
}

}  // namespace detent::bench
