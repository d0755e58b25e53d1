// SPDX-License-Identifier: MIT
#pragma once

// A group draws cases of one kind and puts several questions to each; a question is a row of the
// report. A group says
//   names              what the rows are called
//   asks<N>            in which dimensions it asks; a number has one
//   draw<S, N>(random) a case: the arguments of a question
//   answer<Row>(case)  what the library says, as anything that a digest takes
//   share              where questions are dear: it asks one in so many of what other groups do
// and for every case type there is `append`, since the questions have a digest too.

#include "verify/questions/meshes.hpp"
#include "verify/questions/motions.hpp"
#include "verify/questions/numbers.hpp"
#include "verify/questions/pairs.hpp"
#include "verify/questions/points.hpp"
#include "verify/questions/rays.hpp"
#include "verify/questions/rotations.hpp"
#include "verify/questions/scenes.hpp"
#include "verify/questions/sizes.hpp"
