# SPDX-License-Identifier: MIT
#
# cmake -DINPUT=arena.json -DOUTPUT=embedded.cpp -P embed.cmake
# Writes a source file that holds the text of INPUT.

file(READ "${INPUT}" content)
file(WRITE "${OUTPUT}" "#include \"embedded.hpp\"

namespace detent::cli {

const std::string_view arena_json = R\"arena(${content})arena\";

}  // namespace detent::cli
")
