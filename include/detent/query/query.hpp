// SPDX-License-Identifier: MIT
#pragma once

// The query layer: overlaps, raycasts, casts, distances, closest points and contacts.

#include "detent/query/barycentric.hpp"
#include "detent/query/batch.hpp"
#include "detent/query/cast.hpp"
#include "detent/query/closest_point.hpp"
#include "detent/query/closest_points.hpp"
#include "detent/query/contact.hpp"
#include "detent/query/contains.hpp"
#include "detent/query/distance.hpp"
#include "detent/query/intersection.hpp"
#include "detent/query/intersects.hpp"
#include "detent/query/on.hpp"
#include "detent/query/overlaps.hpp"
#include "detent/query/raycast.hpp"
#include "detent/query/time_of_impact.hpp"
