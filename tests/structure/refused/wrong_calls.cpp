// SPDX-License-Identifier: MIT
// Each call is an error whose message contains the comment after it.           (wrong_calls.sh)
#include "detent/detent.hpp"
using namespace detent;

void calls(const Sphere<q16_16, 3>& ball, const Ray<q16_16, 3>& ray, const Vec<q16_16, 3>& point,
           const Segment<q16_16, 3>& segment, const Sphere<q8_8, 3>& small,
           const Sphere<q16_16, 2>& disc, const Vec<q16_16, 2>& flat, const Mesh<q16_16>& mesh,
           const Plane<q16_16, 3>& wall, const Sweep<q16_16, 3>& still,
           const Direction<q16_16, 3>& ahead, q16_16 reach) {
  overlaps(ball, ray);                        // a ray: use raycast(ray, shape)
  overlaps(ray, ball);                        // a ray: use raycast(ray, shape)
  overlaps(mesh, ray);                        // a ray: use raycast(ray, shape)
  overlaps(ball, point);                      // a point: use contains(shape, point)
  overlaps(point, ball);                      // a point: use contains(shape, point)
  overlaps(segment, ball);                    // a segment: use intersects(segment, shape)
  overlaps(ball, segment);                    // a segment: use intersects(segment, shape)
  overlaps(ball, small);                      // give both shapes the same scalar and dimension
  overlaps(disc, ball);                       // give both shapes the same scalar and dimension
  intersects(ray, ball);                      // a ray: use raycast(ray, shape)
  intersects(segment, ray);                   // a ray: use raycast(ray, shape)
  intersects(segment, point);                 // a point: use contains(shape, point)
  intersects(ball, ball);                     // two shapes: use overlaps(a, b)
  intersects(segment, small);                 // give both the same scalar and dimension
  contains(point, ball);                      // swap them: contains(shape, point)
  contains(ball, ball);                       // no point: use overlaps(a, b) for two shapes
  contains(ball, flat);                       // give both the same scalar and dimension
  closest_point(point, ball);                 // swap them: closest_point(shape, point)
  closest_point(ball, ball);                  // no point: it takes a shape and a point
  closest_point(small, point);                // give both the same scalar and dimension
  closest_points(ball, point);                // a point: use closest_point(shape, point)
  closest_points(ray, ball);                  // a ray: it takes two shapes or segments
  closest_points(ball, small);                // give both the same scalar and dimension
  distance(point, ball);                      // swap them: distance(shape, point)
  distance(ball, ray);                        // a ray: it takes a ray and a point, or two shapes
  distance(ball, small);                      // give both the same scalar and dimension
  distance(point, flat);                      // give both the same scalar and dimension
  contact(ball, ray);                         // a ray: use raycast_hit(ray, shape)
  contact(point, ball);                       // a point: give a sphere of radius 0
  contact(mesh, small);                       // give both the same scalar and dimension
  contact(ball, small);                       // give both the same scalar and dimension
  contact(mesh, ball);                        // a mesh or terrain: use contacts(mesh, shape, out)
  contact(ball, mesh);                        // a mesh or terrain: use contacts(mesh, shape, out)
  cast(ball, point, reach, ball);             // a vector: give a direction, *normalize(v)
  cast(ball, ahead, reach, ray);              // a ray: use raycast_hit(ray, shape)
  cast(point, ahead, reach, ball);            // a point: give a sphere of radius 0
  cast(wall, ahead, reach, ball);             // a plane rests: give it as the target
  cast(ball, point, reach, ray);              // a ray: use raycast_hit(ray, shape)
  cast(wall, point, reach, ball);             // a plane rests: give it as the target
  cast(ball, ahead, reach, small);            // give both the same scalar and dimension
  raycast(ball, ray);                         // swap them: raycast(ray, shape)
  raycast(mesh, ray);                         // swap them: raycast(ray, shape)
  raycast(segment, ball);                     // no ray; segments: intersects(segment, shape)
  raycast(ray, point);                        // a point: use contains(ray, point)
  raycast(ray, small);                        // give both the same scalar and dimension
  raycast_hit(ball, ray);                     // swap them: raycast_hit(ray, shape)
  raycast_hit(segment, ball);                 // no ray; segments: intersects(segment, shape)
  raycast_hit(ray, point);                    // a point: use contains(ray, point)
  raycast_hit(ray, disc);                     // give both the same scalar and dimension
  raycast_interval(ball, ray);                // swap them: raycast_interval(ray, shape)
  raycast_interval(ball, segment);            // no ray: it takes a ray and a shape
  raycast_interval(ray, point);               // a point: use contains(ray, point)
  raycast_interval(ray, small);               // give both the same scalar and dimension
  time_of_impact(ball, still, wall, still);   // a plane rests: use time_of_impact(a, sweep, plane)
  time_of_impact(ball, point, wall, point);   // a plane rests: use time_of_impact(a, sweep, plane)
  time_of_impact(ball, still, point, still);  // no shape: use a Sphere or Capsule of radius 0
  time_of_impact(ball, point, ball, point);   // a vector: give a Sweep{start, end}
  time_of_impact(ball, still, small, still);  // give both shapes the same scalar and dimension
}
