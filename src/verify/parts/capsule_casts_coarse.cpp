// SPDX-License-Identifier: MIT
#include "verify/part_sheets.hpp"

namespace detent::verify::detail {

using Group = Casts<CapsuleKind, ObbKind, 3>;
template std::vector<Answers> answers_of<Group, q24_8, 3>(std::uint32_t, bool);
template std::optional<Finding> first_wrong_answer<Group, q24_8, 3>(std::size_t, std::uint32_t);
template std::vector<Answers> answers_of<Group, q8_8, 3>(std::uint32_t, bool);
template std::optional<Finding> first_wrong_answer<Group, q8_8, 3>(std::size_t, std::uint32_t);

}  // namespace detent::verify::detail
