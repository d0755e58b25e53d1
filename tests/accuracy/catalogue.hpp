// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "accuracy/survey.hpp"

namespace detent::accuracy {

// One function per source file, because every query is compiled for six scalars.
void add_raycasts(std::vector<Query>& queries);
void add_sphere_overlaps(std::vector<Query>& queries);
void add_box_overlaps(std::vector<Query>& queries);
void add_flat_overlaps(std::vector<Query>& queries);
void add_capsule_overlaps(std::vector<Query>& queries);
void add_hull_overlaps(std::vector<Query>& queries);
void add_segments(std::vector<Query>& queries);
void add_pair_distances(std::vector<Query>& queries);
void add_pair_contacts(std::vector<Query>& queries);
void add_round_closest_points(std::vector<Query>& queries);
void add_flat_closest_points(std::vector<Query>& queries);
void add_sphere_casts(std::vector<Query>& queries);
void add_capsule_casts(std::vector<Query>& queries);
void add_box_casts(std::vector<Query>& queries);
void add_hull_casts(std::vector<Query>& queries);
void add_cameras(std::vector<Query>& queries);
void add_impacts(std::vector<Query>& queries);
void add_movers(std::vector<Query>& queries);

// The same in 2D.
void add_planar_raycasts(std::vector<Query>& queries);
void add_planar_round_overlaps(std::vector<Query>& queries);
void add_planar_flat_overlaps(std::vector<Query>& queries);
void add_planar_hull_overlaps(std::vector<Query>& queries);
void add_planar_segments(std::vector<Query>& queries);
void add_planar_distances(std::vector<Query>& queries);
void add_planar_capsule_contacts(std::vector<Query>& queries);
void add_planar_box_contacts(std::vector<Query>& queries);
void add_planar_closest_points(std::vector<Query>& queries);
void add_planar_casts(std::vector<Query>& queries);

}  // namespace detent::accuracy
