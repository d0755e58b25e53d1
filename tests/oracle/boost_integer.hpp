// SPDX-License-Identifier: MIT
#pragma once

#include <boost/multiprecision/cpp_int.hpp>

#include "oracle/long_integer.hpp"

namespace detent::oracle {

boost::multiprecision::cpp_int boost_integer(const LongInteger& x);
LongInteger long_integer(const boost::multiprecision::cpp_int& x);

}  // namespace detent::oracle
