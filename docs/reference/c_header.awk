# SPDX-License-Identifier: MIT
# What Doxygen reads of detent.h: everything from the first enumeration on joins the group of the C
# interface (layers.dox has it). The assertions of sizes are left out. Lines keep their numbers.

FNR == 1 { print "/** @file detent.h"; next }
FNR == 2 { print "@brief `#include \"detent.h\"` */"; next }
/^\/\* Units\. / { sub(/^/, "/** @addtogroup layer_c */ /** @{ */ "); in_group = 1 }
/^typedef char .*_has_its_size/ {
  print in_group ? "/** @} */" : ""
  in_group = 0
  next
}
{ print }
