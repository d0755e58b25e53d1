// SPDX-License-Identifier: MIT
#include "accuracy/survey.hpp"

#include <algorithm>
#include <stdexcept>

#include "accuracy/catalogue.hpp"
#include "detent/number/digest.hpp"

namespace detent::accuracy {

const std::vector<Query>& queries() {
  static const std::vector<Query> all = [] {
    std::vector<Query> list;
    add_raycasts(list);
    add_sphere_overlaps(list);
    add_box_overlaps(list);
    add_flat_overlaps(list);
    add_capsule_overlaps(list);
    add_hull_overlaps(list);
    add_segments(list);
    add_pair_distances(list);
    add_pair_contacts(list);
    add_round_closest_points(list);
    add_flat_closest_points(list);
    add_sphere_casts(list);
    add_capsule_casts(list);
    add_box_casts(list);
    add_hull_casts(list);
    add_cameras(list);
    add_impacts(list);
    add_movers(list);
    add_planar_raycasts(list);
    add_planar_round_overlaps(list);
    add_planar_flat_overlaps(list);
    add_planar_hull_overlaps(list);
    add_planar_segments(list);
    add_planar_distances(list);
    add_planar_capsule_contacts(list);
    add_planar_box_contacts(list);
    add_planar_closest_points(list);
    add_planar_casts(list);
    return list;
  }();
  return all;
}

namespace {

/// Every rung of every query has its own random numbers.
std::uint64_t seed_for(const Query& query, const Rung& rung, std::uint64_t seed) {
  Digest digest;
  digest.add(seed);
  for (const char c : query.name + ' ' + rung.name) digest.add(static_cast<std::uint8_t>(c));
  digest.add(static_cast<std::uint8_t>(rung.ladder));
  return digest.value();
}

}  // namespace

Result survey(const Query& query, const Rung& rung, long count, std::uint64_t seed) {
  Result result{&query, &rung,
                query.ask(rung, std::max(count / query.cost, 2L), seed_for(query, rung, seed))};
  for (const Cell& cell : result.cells) {
    if (cell.hits * 10 >= cell.questions * 3 && cell.hits * 10 <= cell.questions * 7) continue;
    throw std::runtime_error(query.name + ", " + std::string(name_of(rung.ladder)) + " " +
                             rung.name + ", " + cell.scalar + ": " + std::to_string(cell.hits) +
                             " hits in " + std::to_string(cell.questions) +
                             " questions are not 30 to 70 %; the rung needs other shapes");
  }
  return result;
}

}  // namespace detent::accuracy
