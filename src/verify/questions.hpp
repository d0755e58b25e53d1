// SPDX-License-Identifier: MIT
#pragma once

// A group draws cases of one kind and runs several queries on each; every query is a row of the
// report. A group has
//   names              the names of the rows
//   asks<N>            whether it runs in dimension N; numbers run in one
//   draw<S, N>(random) a case: the arguments of the queries
//   answer<Row>(case)  the library's result, of any type that a digest takes
//   share              for slow queries: it runs one in this many of the questions
// and every case type lists its fields or has an `append`, because the questions have a digest too.

#include "verify/questions/casts.hpp"
#include "verify/questions/meshes.hpp"
#include "verify/questions/motions.hpp"
#include "verify/questions/numbers.hpp"
#include "verify/questions/pairs.hpp"
#include "verify/questions/points.hpp"
#include "verify/questions/rays.hpp"
#include "verify/questions/rotations.hpp"
#include "verify/questions/scene_casts.hpp"
#include "verify/questions/scene_views.hpp"
#include "verify/questions/scenes.hpp"
#include "verify/questions/sizes.hpp"
#include "verify/questions/targets.hpp"
#include "verify/questions/views.hpp"
#include "verify/questions/walks.hpp"
#include "verify/questions/worlds.hpp"
