# SPDX-License-Identifier: MIT
#
# usage: awk -f stack.awk GRAPH.ci... - <DISASSEMBLY
# Prints the maximum stack in bytes that `ask` needs: the deepest path of the compiler's call graphs
# (-fcallgraph-info=su), and into runtime functions as far as their disassembly shows it. Prints "-"
# if `ask` reaches a call through a pointer, whose depth is not known.

function call(from, to) { if (from != to) callees[from] = callees[from] " " to }

# The graph names a constructor C2 where it is defined and C1 where it is called.
function defined(f,   other) {
  other = f
  return !(f in frame) && sub(/C1/, "C2", other) && other in frame ? other : f
}

function depth(f,   n, i, list, d, deepest) {
  if (f == "__indirect_call") is_unknown = 1
  f = defined(f)
  if (f in known) return known[f]
  if (f in busy) { print "stack: recursion in " f > "/dev/stderr"; failed = 1; return 0 }
  busy[f] = 1
  n = split(callees[f], list, " ")
  for (i = 1; i <= n; ++i) if ((d = depth(list[i])) > deepest) deepest = d
  delete busy[f]
  return known[f] = frame[f] + deepest
}

/^(node|edge): / {
  split($0, text, "\"")
  sub(/^[^:]*:/, "", text[2])
  sub(/^[^:]*:/, "", text[4])
  if ($1 == "edge:") {
    call(text[2], text[4])
  } else if (match($0, /[0-9]+ bytes \([a-z]*/)) {
    if ($0 !~ /bytes \(static/) { print "stack: unbounded in " text[2] > "/dev/stderr"; failed = 1 }
    frame[text[2]] = substr($0, RSTART) + 0
    is_compiled[text[2]] = 1
  }
}

/^[0-9a-f]+ <.*>:$/ {
  function_name = substr($2, 2, length($2) - 3)
  if (place[$1] == "") place[$1] = function_name
}
/^ +[0-9a-f]+:/ && !(function_name in is_compiled) {
  if ($2 == "push") {
    registers = $0
    frame[function_name] += 4 * (gsub(/,/, "", registers) + 1)
  } else if ($2 == "sub" && $3 == "sp,") {
    frame[function_name] += substr($4, 2)
  } else if ($2 ~ /^bl?(\.n)?$/ && match($0, /<[^+>]*>/)) {
    call(function_name, substr($0, RSTART + 1, RLENGTH - 2))
  }
}

END { most = depth("ask"); if (failed) exit 1; print is_unknown ? "-" : most }
