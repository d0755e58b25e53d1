// SPDX-License-Identifier: MIT
#pragma once

// How two shapes that overlap are separated; touching counts:
//   contact(a, b)       -> optional<Contact<S, N>>   normal, depth and points
//   separation(contact) -> Vec<S, N>                 by which b, moved, no longer touches a

#include "detent/query/contact/contact.hpp"
#include "detent/query/contact/pair.hpp"
#include "detent/query/wrong_call.hpp"
