# SPDX-License-Identifier: MIT
# usage: awk -f links.awk *.html
#
# Prints the links of HTML pages, `page <tab> target`: those to an anchor that no page has, as
# `#page#anchor`, and those to a file that is none of the pages, for the caller to look for. Anchors
# that Doxygen names are its own affair: it links to members of which it shows nothing but the name.

FNR == 1 {
  page = FILENAME
  sub(/.*\//, "", page)
  exists[page] = 1
}
{
  rest = $0
  while (match(rest, /(href|src|data|id|name)="[^"]*"/)) {
    attribute = substr(rest, RSTART, RLENGTH)
    rest = substr(rest, RSTART + RLENGTH)
    kind = attribute
    sub(/=.*/, "", kind)
    sub(/^[a-z]*="/, "", attribute)
    sub(/"$/, "", attribute)
    if (kind == "id" || kind == "name") anchor[page "#" attribute] = 1
    else if (attribute !~ /^([a-z]+:|\/\/)/ && attribute != "") link[page "\t" attribute] = 1
  }
}
END {
  for (key in link) {
    split(key, part, "\t")
    target = part[2]
    file = target
    name = ""
    if (match(target, /#/)) {
      file = substr(target, 1, RSTART - 1)
      name = substr(target, RSTART + 1)
    }
    if (file == "") file = part[1]
    if (!(file in exists)) print part[1] "\t" file
    else if (name != "" && name !~ /^a[0-9a-f]+$|-(classes|members)$/ && !(file "#" name in anchor)) print part[1] "\t#" file "#" name
  }
}
