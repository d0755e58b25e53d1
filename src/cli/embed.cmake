# SPDX-License-Identifier: MIT
#
# cmake -DINPUTS=a.json,b.json -DOUTPUT=embedded.cpp -P embed.cmake
# Writes a source file with the text of each input, as a_json and b_json.

set(texts "")
string(REPLACE "," ";" inputs "${INPUTS}")
foreach(input IN LISTS inputs)
  get_filename_component(name "${input}" NAME_WE)
  file(READ "${input}" content)
  string(APPEND texts "const std::string_view ${name}_json = R\"json(${content})json\";\n")
endforeach()
file(WRITE "${OUTPUT}" "#include \"embedded.hpp\"

namespace detent::cli {

${texts}
}  // namespace detent::cli
")
