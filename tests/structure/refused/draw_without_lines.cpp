// SPDX-License-Identifier: MIT
#include "detent/draw/draw.hpp"
using namespace detent;

struct Canvas {
  void line(const Vec<q16_16, 3>& a, const Vec<q16_16, 3>& b, const Colour& colour);
};

void show(Canvas& canvas, const Sphere<q16_16, 3>& ball) { draw(canvas, ball, Colour{}); }
