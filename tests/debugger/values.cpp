// SPDX-License-Identifier: MIT
//
// Values for a debugger to show (gdb.sh).

#include <optional>

#include "detent/math/quat.hpp"
#include "detent/math/rotation.hpp"
#include "detent/scene/object.hpp"
#include "detent/shape/obb.hpp"
#include "detent/shape/ray.hpp"
#include "detent/shape/sphere.hpp"

using namespace detent;
using S = q16_16;

namespace shown {

// Not const, so that they are always in memory; initialised before the program runs.
constinit S number = S::from_raw(212992);
constinit S least = S::lowest();
constinit S step = S::from_raw(-1);
constinit q8_8 small = q8_8::from_raw(-0x180);
constinit auto product = S::from_raw(-3) * S::from_raw(65537);
constinit auto of_128_bits = S::lowest() * S::lowest() * S::from_raw(3);
constinit auto of_200_bits =
    S::lowest() * S::lowest() * S::lowest() * S::lowest() * S::lowest() * S::from_raw(-1);
constinit Vec<S, 2> flat{S::from_raw(1 << 15), S(-2)};
constinit Vec<S, 3> vector{S(1), S::from_raw(-1 << 14), S(30000)};
constinit Vec<float, 3> rounded{1, 0.5f, -2};
constinit Direction<S, 3> direction = Direction<S, 3>::along(1);
constinit Rotation<S, 2> rotation{};
constinit Quat<S> quat{};
constinit auto angle = Angle<S>::from_raw(0xc0000000u);
constinit auto half_turn = Angle<S>::from_raw(0x80000000u);
constinit auto radians = Angle<double>::from_raw(1.5);
constinit ObjectId object{5, 20};
constinit FrameId nothing{};
constinit Sphere<S, 3> sphere{{S(1), S(2), S(3)}, S::from_raw(1 << 13)};
constinit Obb<S, 2> box{{S(1), S(2)}, {S(3), S(4)}, {}};

}  // namespace shown

int main() {
  std::optional<S> distance = S::from_raw(212992);
  std::optional<Vec<S, 2>> point = shown::flat;
  std::optional<S> miss;
  return distance && point && !miss ? 0 : 1;  // the debugger stops here
}
