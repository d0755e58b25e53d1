# SPDX-License-Identifier: MIT
# What Doxygen reads of a header. Lines keep their numbers.
#
# * Labels of a docstring, such as `domain:`, become commands of the same name (Doxyfile has them).
# * Everything in `namespace detent` joins the group of its folder (layers.dox has them).
# * A deleted function is documented by the comment that says what to write instead.
# * A function without a docstring refers to the one above it, if that has its name or no blank line
#   is between them.
# * Deduction guides and macros that force inlining are left out; `detail::SceneContents` becomes
#   public, because its functions are those of a scene.

# Where the declaration of a function, a class or a variable begins.
function begins(i) {
  return line[i] ~ /^ *(template|\[\[nodiscard\]\]|constexpr|inline|explicit|static|struct|class) ?/ &&
         (line[i - 1] ~ /^ *$|^#|[;{}]$|^ *(public|private):$|^ *\/\/|= delete;/ || line[i - 1] ~ /^ *\/\/\//)
}

# Its name: what stands before the first parenthesis or brace.
function name_of(i,   text, depth, at, letter) {
  text = ""
  for (; i <= NR; ++i) {
    text = text " " line[i]
    if (line[i] ~ /[{;]$/) break
  }
  sub(/^ *template /, "", text)
  if (text ~ /^ *</) {
    depth = 0
    for (at = 1; at <= length(text); ++at) {
      letter = substr(text, at, 1)
      if (letter == "<") ++depth
      if (letter == ">" && --depth == 0) break
    }
    text = substr(text, at + 1)
  }
  sub(/^ *requires is_surface<[A-Za-z]+>/, "", text)
  while (match(text, /^ *requires ?\([^()]*(\([^()]*\)[^()]*)*\)/)) text = substr(text, RLENGTH + 1)
  if (match(text, /operator *[^a-z(]+\(|operator""_[a-z0-9_]+/)) return substr(text, RSTART, RLENGTH)
  if (match(text, /(struct|class) [A-Za-z_]+/)) return substr(text, RSTART, RLENGTH)
  if (text !~ /\(/ && match(text, /[a-z_]+(<.*>)? =/)) {
    text = substr(text, RSTART, RLENGTH)
    sub(/[< ].*/, "", text)
    return text
  }
  if (match(text, /[A-Za-z_0-9]+\(/)) return substr(text, RSTART, RLENGTH)
  return ""
}

function labelled(text,   at) {
  if (match(text, /^ *\/\/\/ (units|domain|result|exact|source|frame): */)) {
    in_label = 1
    at = index(text, ":")
    sub(/\/\/\/ /, "/// @", text)
    return substr(text, 1, at) " " substr(text, RLENGTH + 2)
  }
  if (text !~ /^ *\/\/\/ +[^ ]/) in_label = 0
  if (in_label) sub(/\/\/\/ +/, "/// ", text)
  return text
}

FNR == 1 {
  path = FILENAME
  sub(/^.*include\//, "", path)
  layer = path
  if (!sub(/^detent\//, "", layer) || !sub(/\/[a-z_]+\.hpp$/, "", layer)) layer = ""
  sub(/\//, "_", layer)
}
{
  gsub(/\(min\)\(/, " min(")
  gsub(/\(max\)\(/, " max(")
  gsub(/\(clamp\)\(/, " clamp(")
  gsub(/detail::SceneContents/, "SceneContents")
  if (!/^#/) gsub(/DETENT_[A-Z_]*INLINE[A-Z_]* /, "")
  if (path ~ /scene\/contents\.hpp$/ && /namespace detail/) $0 = ""
  line[FNR] = $0
}

END {
  for (i = 1; i <= NR; ++i) {
    text = line[i]
    if (i == 1) text = "/** @file " path
    if (i == 2) text = "@brief `#include \"" path "\"` */"
    if (layer && text ~ /^namespace detent \{/) text = text " /** @addtogroup layer_" layer " */ /** @{ */"
    if (layer && text ~ /^}  \/\/ namespace detent$/) text = "/** @} */ " text
    if (text ~ /^ *\/\/\//) text = labelled(text)
    gsub(/ *\(tests\/[a-z_0-9\/.]+\)/, " <code>&</code>", text)

    if (text ~ /= delete; *\/\/ detent: /) sub(/\/\/ detent: /, "///< Does not compile: ", text)
    if (text ~ /^(explicit )?[A-Z][A-Za-z]*\(.*\) -> .*;$/) text = ";"
    if (text ~ /^template/ && line[i + 1] ~ /^(explicit )?[A-Z][A-Za-z]*\(.*\) -> .*;$/) text = ""

    if (begins(i)) {
      name = name_of(i)
      key = (text ~ /^ / ? "member " : "") name
      if (line[i - 1] ~ /^ *\/\/\//) documented[key] = 1
      else if (key in documented && name ~ /^(class|struct) /) sub(/[^ ]/, "/** A specialization. */ &", text)
      else if (name ~ /\($/ && (key in documented || line[i - 1] ~ /}$/))
        sub(/[^ ]/, "/** See the function above. */ &", text)
    }
    print text
  }
}
