// SPDX-License-Identifier: MIT
//
// usage: detent-bench-mover
// Characters walk through a town of 1,000 boxes on terrain of 32,768 triangles, some of them from
// roofs, in q16_16 and in float, alternating. Prints a table as CSV. Fails if the walk in q16_16 is
// not the golden one.

#include <cstdint>
#include <cstdio>
#include <vector>

#include "bench/drawn_scene.hpp"
#include "detent/number/digest.hpp"
#include "detent/scene/height_field.hpp"
#include "detent/scene/mover.hpp"
#include "detent/scene/scene.hpp"

namespace detent::bench {
namespace {

constexpr int characters = 40, frames = 100, passes = 9;
constexpr std::uint32_t samples = 129;  // of the terrain, on each side, 2 units apart

/// The town, in units; all numbers are multiples of 1/256.
struct Town {
  std::vector<double> heights;
  std::vector<Aabb<double, 3>> boxes;
  std::vector<Vec<double, 3>> starts;
  std::vector<Vec<double, 3>> ways;  // the path of each character, changing every 20 frames

  Town() {
    test::Random random(7);
    const auto number = [&](double low, double high) {
      return static_cast<double>(random.between(std::lround(low * 256), std::lround(high * 256))) /
             256;
    };
    for (std::uint32_t i = 0; i < samples * samples; ++i) heights.push_back(number(-0.25, 0.25));
    for (int i = 0; i < 1000; ++i) {
      const double x = number(-120, 120), z = number(-120, 120);
      const double wide = number(0.5, 3), deep = number(0.5, 3), high = number(0.125, 6);
      boxes.push_back({{x - wide, -2, z - deep}, {x + wide, high, z + deep}});
    }
    for (int i = 0; i < characters; ++i) {
      const double x = number(-60, 60), z = number(-60, 60);
      starts.push_back({x, 7, z});
      for (int turn = 0; turn < frames / 20; ++turn) {
        const double east = number(-0.25, 0.25), south = number(-0.25, 0.25);
        ways.push_back({east, -0.25, south});
      }
    }
  }
};

/// The town in one scalar, with its characters.
template <Scalar S>
class Place {
 public:
  std::size_t touches = 0, grounded = 0;
  Digest digest;
  Timer timer;

  explicit Place(const Town& town) : town_(town) {
    for (const double height : town.heights) heights_.push_back(number(height));
    field_ = FieldAsset<S>(
        1, height_field<S>({number(-128), number(-128)}, number(2), samples, samples, heights_)
               .value_or(HeightField<S>()));
    world_.add(PlacedField<S>{&field_}, {.motion = Motion::fixed});
    for (const auto& box : town.boxes) {
      world_.add(Aabb<S, 3>{as<S>(box.min), as<S>(box.max)}, {.motion = Motion::fixed});
    }
    world_.optimize();
  }

  void walk() {
    std::vector<Mover<S, 3, Capsule>> walkers;
    for (const auto& at : town_.starts) {
      const Vec<double, 3> head{at.x, at.y + 1, at.z};
      walkers.push_back({{as<S>(at), as<S>(head), number(0.375)}});
    }
    touches = grounded = 0;
    timer.time([&] {
      for (std::size_t frame = 0; frame < frames; ++frame) {
        for (std::size_t i = 0; i < walkers.size(); ++i) {
          const auto result =
              walkers[i].move(world_, as<S>(town_.ways[i * (frames / 20) + frame / 20]));
          touches += result.count;
          grounded += walkers[i].ground.is_grounded ? 1 : 0;
        }
      }
    });
    digest = {};
    if constexpr (is_fixed<S>) {
      for (const auto& walker : walkers) digest.add(walker);
    }
  }
  void print(const char* name) const {
    std::printf("%s,%.2f,%zu,%zu\n", name, timer.least() / (characters * frames), touches,
                grounded);
  }

 private:
  static S number(double x) { return as<S>(Vec<double, 3>{x, 0, 0}).x; }

  const Town& town_;
  std::vector<S> heights_;
  FieldAsset<S> field_;
  Scene<S, 3, Aabb, FieldInstance> world_;
};

}  // namespace
}  // namespace detent::bench

int main() {
  using namespace detent;
  using namespace detent::bench;
  const Town town;
  Place<q16_16> exact(town);
  Place<float> rounded(town);
  for (int i = 0; i < passes; ++i) {
    exact.walk();
    rounded.walk();
  }
  std::printf("scalar,us a move,touched,on the ground of %d\n", characters * frames);
  exact.print("q16_16");
  rounded.print("float");
  constexpr std::uint64_t golden = 0xf5b29ed4f095c73b;
  if (exact.digest.value() == golden) return 0;
  std::printf("golden: 0x%016llx\n", static_cast<unsigned long long>(exact.digest.value()));
  return 1;
}
