// SPDX-License-Identifier: MIT
//
// usage: forms [times]
// Tests the boxes of tree nodes against rays and boxes, with this machine's vectors and with
// arrays. Both forms must give the same keys and masks, and every machine the same digest, which is
// printed. `times` also prints nanoseconds per node, measured alternately. On aarch64 each pass is
// between two `yield`s, at which tests/size/count_instructions.c counts. (tests/platforms/forms)

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <vector>

#include "detent/cull/search.hpp"
#include "detent/cull/static_tree/along.hpp"
#include "detent/number/digest.hpp"
#include "support/random.hpp"

namespace {

using namespace detent;
using detail::ArrayLanes;
using detail::VectorLanes;

void mark() {
#if defined(__aarch64__)
  asm volatile("yield" ::: "memory");
#endif
}

constexpr std::size_t count = 512, in_cache = 16;
using Keys = std::array<std::int64_t, 9>;  // of eight children, and a mask of those hit

/// Random nodes of a mesh's and of a scene's tree, with a ray and a box for each.
template <Scalar S, int N>
struct Questions {
  using Box = detail::QuantizedBox<S, N>;

  std::vector<detail::StaticRay<S, N>> rays;
  std::vector<detail::RayProbe<S, N>> probes;
  std::vector<Box> boxes;
  std::vector<typename detail::StaticRay<S, N>::Time> limits;
  std::vector<StaticNode<S, N>> static_nodes;
  std::vector<detail::TreeNode<S, N>> nodes;

  explicit Questions(std::uint64_t seed) {
    test::Random random(seed);
    const auto raw = [](std::int64_t x) {
      return S::from_raw(static_cast<typename S::raw_type>(x));
    };
    const auto point = [&] {
      return make_vec<N>([&](int) { return raw(random.edgy(bits_of<S>)); });
    };
    const auto around = [](const Vec<S, N>& a, const Vec<S, N>& b) {
      return Aabb<S, N>{make_vec<N>([&](int i) { return (std::min)(a[i], b[i]); }),
                        make_vec<N>([&](int i) { return (std::max)(a[i], b[i]); })};
    };
    while (rays.size() < count) {
      const auto whole = around(point(), point());
      const auto inside = [&] {
        return make_vec<N>(
            [&](int i) { return raw(random.between(whole.min[i].raw(), whole.max[i].raw())); });
      };
      const auto origin = random.coin() ? point() : inside();
      const auto target = inside();
      const auto direction = normalize(random.one_in(8) ? point() : make_vec<N>([&](int i) {
        return raw((target[i].raw() >> 1) - (origin[i].raw() >> 1));
      }));
      if (!direction) continue;
      const auto length = random.coin() ? largest<S> : raw(random.between(0, largest<S>.raw()));
      const Ray<S, N> ray{origin, *direction, length};
      rays.emplace_back(ray, whole);
      limits.push_back(rays.back().time(length));
      probes.emplace_back(ray);
      boxes.emplace_back(around(inside(), inside()));
      StaticNode<S, N> tree(whole);
      detail::TreeNode<S, N> node;
      for (auto children = random.between(1, 8); children > 0; --children) {
        const auto box = around(inside(), inside());
        tree.add_child(box, 0, 1);
        node.set(node.count++, Box(box));
      }
      static_nodes.push_back(tree);
      nodes.push_back(node);
    }
  }

  /// Calls ask(i, keys) `count` times between two marks, for as many nodes as there are answers.
  template <class Ask>
  [[gnu::noinline]] static void pass(std::vector<Keys>& answers, const Ask& ask) {
    const std::size_t last = answers.size() - 1;  // 2^n - 1
    mark();
    for (std::size_t i = 0; i < count; ++i) ask(i & last, answers[i & last]);
    mark();
  }
  /// A ray against a mesh node.
  template <class Lanes>
  void in_mesh(std::vector<Keys>& answers) const {
    pass(answers, [&](std::size_t i, Keys& keys) {
      typename detail::StaticRay<S, N>::Times enter;
      keys[8] = rays[i].template meets<Lanes>(static_nodes[i], limits[i], enter);
      std::copy(enter.begin(), enter.end(), keys.begin());
    });
  }
  /// A ray against a scene node; `RayKeys` uses 64 bits and one box at a time.
  template <class RayForm>
  void in_scene(std::vector<Keys>& answers) const {
    const auto used = static_cast<std::ptrdiff_t>(answers.size());
    const std::vector<RayForm> forms(probes.begin(), probes.begin() + used);
    pass(answers, [&](std::size_t i, Keys& keys) {
      std::array<typename RayForm::Key, 8> enter;
      keys[8] = forms[i].keys(nodes[i], enter);
      std::copy(enter.begin(), enter.end(), keys.begin());
    });
  }
  /// A box against a scene node.
  template <class Lanes>
  void in_region(std::vector<Keys>& answers) const {
    pass(answers,
         [&](std::size_t i, Keys& keys) { keys[8] = nodes[i].template meeting<Lanes>(boxes[i]); });
  }
};

/// The least time of a few passes, in nanoseconds per node.
template <class Pass>
double time_of(const Pass& pass) {
  const auto start = std::chrono::steady_clock::now();
  for (int i = 0; i < 40; ++i) pass();
  const std::chrono::duration<double, std::nano> time = std::chrono::steady_clock::now() - start;
  return time.count() / (40 * count);
}

using Answers = std::vector<Keys>;

/// Compares the two forms of one kind of query, and adds the results to a digest.
template <class Array, class Vector>
bool compare(const char* name, bool has_times, Digest& digest, const Array& by_array,
             const Vector& by_vector) {
  Answers first(count), second(count);
  by_array(first);
  by_vector(second);
  for (const auto& keys : first) {
    for (const auto key : keys) digest.add(key);
  }
  if (has_times) {
    double array = 1e9, vector = 1e9;
    first.resize(in_cache), second.resize(in_cache);
    for (int round = 0; round < 15; ++round) {
      array = (std::min)(array, time_of([&] { by_array(first); }));
      vector = (std::min)(vector, time_of([&] { by_vector(second); }));
    }
    std::printf("%s: arrays %.1f ns, vectors %.1f ns, ratio %.2f\n", name, array, vector,
                vector / array);
  }
  if (first == second) return true;
  std::printf("%s: vectors differ from arrays\n", name);
  return false;
}

template <Scalar S, int N>
bool examine(bool has_times, Digest& digest) {
  using detail::RayKeys, detail::RayLanes;
  using Int = std::int32_t;
  const Questions<S, N> questions(0xf02);
  bool is_right = compare(
      "ray, node of a mesh", has_times, digest,
      [&](Answers& a) { questions.template in_mesh<ArrayLanes<Int>>(a); },
      [&](Answers& a) { questions.template in_mesh<VectorLanes<Int>>(a); });
  is_right &= compare(
      "ray, node of a scene", has_times, digest,
      [&](Answers& a) { questions.template in_scene<RayLanes<S, N, ArrayLanes<Int>>>(a); },
      [&](Answers& a) { questions.template in_scene<RayLanes<S, N, VectorLanes<Int>>>(a); });
  is_right &= compare(
      "box, node of a scene", has_times, digest,
      [&](Answers& a) { questions.template in_region<ArrayLanes<Int>>(a); },
      [&](Answers& a) { questions.template in_region<VectorLanes<Int>>(a); });
  // Without vectors, boxes of scenes are tested one by one in 64 bits.
  Answers answers(count);
  const auto one_by_one = [&] { questions.template in_scene<RayKeys<S, N>>(answers); };
  one_by_one();
  for (const auto& keys : answers) digest.add(keys[8]);
  if (has_times) {
    double time = 1e9;
    answers.resize(in_cache);
    for (int round = 0; round < 15; ++round) time = (std::min)(time, time_of(one_by_one));
    std::printf("ray, node of a scene: one by one %.1f ns\n", time);
  }
  return is_right;
}

}  // namespace

int main(int arguments, char**) {
  const bool has_times = arguments > 1;
  Digest digest;
  bool is_right = examine<q16_16, 3>(has_times, digest);
  is_right &= examine<q16_16, 2>(false, digest);
  is_right &= examine<q14_16, 3>(false, digest);
  is_right &= examine<q24_8, 3>(false, digest);
  is_right &= examine<q8_8, 3>(false, digest);
  std::printf("forms %016llx\n", static_cast<unsigned long long>(digest.value()));
  return is_right ? 0 : 1;
}
