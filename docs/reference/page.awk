# SPDX-License-Identifier: MIT
# What Doxygen reads of a page. Titles and headings get labels, and links become references: to
# pages, headings and headers of the reference, and to files in the source tree, which
# DETENT_ROOT leads to from the reference's folder.

function label_of(path) {
  sub(/.*\//, "", path)
  sub(/\.md$/, "", path)
  return path == "README" ? "index" : tolower(path)
}

# As on code hosts: lower case, no punctuation, hyphens for spaces.
function slug(text) {
  gsub(/\]\([^)]*\)/, "", text)
  text = tolower(text)
  gsub(/[^a-z0-9 _-]/, "", text)
  gsub(/ /, "-", text)
  return text
}

function normal(path,   count, part, i, result) {
  while (path ~ /^\.\.\//) {
    sub(/^\.\.\//, "", path)
    folder = ""
  }
  return folder path
}

function reference(target,   anchor, path) {
  if (target ~ /^[a-z]+:/) return target
  anchor = ""
  path = target
  if (match(target, /#/)) {
    path = substr(target, 1, RSTART - 1)
    anchor = substr(target, RSTART + 1)
  }
  if (path == "") return "@ref " page "-" anchor
  folder = home
  path = normal(path)
  if (path ~ /^([A-Z]+|docs\/[a-z_]+)\.md$/)
    return "@ref " label_of(path) (anchor == "" ? "" : "-" anchor)
  if (path ~ /^include\/detent\/(detent|version)\.hpp$|^include\/detent\/(number|math|shape|query|scene|draw|lockstep|dynamics)\/[a-z_]+(\/[a-z_]+)?\.hpp$/ &&
      path !~ /\/(filter|kernel)\/|short_words/) {
    sub(/^include\//, "", path)
    return "@ref " path
  }
  return ENVIRON["DETENT_ROOT"] "/" path (anchor == "" ? "" : "#" anchor)
}

function linked(text,   result, start, target) {
  result = ""
  while (match(text, /\]\([^ )]+\)/)) {
    start = substr(text, 1, RSTART - 1)
    target = substr(text, RSTART + 2, RLENGTH - 3)
    text = substr(text, RSTART + RLENGTH)
    if (start !~ /!\[[^]]*$/) target = reference(target)
    result = result start "](" target ")"
  }
  return result text
}

FNR == 1 {
  page = label_of(FILENAME)
  home = FILENAME ~ /\/docs\/[a-z_]+\.md$/ ? "docs/" : ""
}
/^ *```/ { in_block = !in_block }
in_block { print; next }
/^# / { print $0 " {#" (page == "index" ? "mainpage" : page) "}"; next }
/^##+ / { print linked($0) " {#" page "-" slug(substr($0, index($0, " ") + 1)) "}"; next }
{ print linked($0) }
