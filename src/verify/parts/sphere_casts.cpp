// SPDX-License-Identifier: MIT
#include "verify/part_sheets.hpp"

// The coarse scalars are in sphere_casts_coarse.cpp, so that a compiler needs less memory.
namespace detent::verify::detail {

using Group = Casts<SphereKind, TriangleKind, 3>;
extern template std::vector<Answers> answers_of<Group, q24_8, 3>(std::uint32_t, bool);
extern template std::optional<Finding> first_wrong_answer<Group, q24_8, 3>(std::size_t,
                                                                           std::uint32_t);
extern template std::vector<Answers> answers_of<Group, q8_8, 3>(std::uint32_t, bool);
extern template std::optional<Finding> first_wrong_answer<Group, q8_8, 3>(std::size_t,
                                                                          std::uint32_t);

}  // namespace detent::verify::detail

template struct detent::verify::PartSheets<detent::verify::SphereCasts>;
