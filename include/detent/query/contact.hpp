// SPDX-License-Identifier: MIT
#pragma once

// How to separate two shapes that overlap; touching counts:
//   contact(a, b)       -> optional<Contact<S, N>>   normal, depth and points
//   separation(contact) -> Vec<S, N>                 moves b so that it no longer touches a

#include "detent/query/contact/contact.hpp"
#include "detent/query/contact/pair.hpp"
#include "detent/query/wrong_call.hpp"
