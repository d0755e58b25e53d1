# SPDX-License-Identifier: MIT
"""Run by gdb: prints a source that compiles only if the types and members in detent.natvis exist.

Each expression becomes the body of a member function of a struct derived from a type to which its
entry applies. Names of Microsoft's library are replaced by those of libstdc++.
"""

import re
import xml.etree.ElementTree as tree

SAMPLES = {
    ("detent::Fixed<*,*>", "MediumHigh"): ["Fixed<15, 8>", "Fixed<31, 16>", "Fixed<62, 62>"],
    ("detent::Fixed<*,*>", "MediumLow"): ["Fixed<94, 91>", "Fixed<160, 80>"],
    ("detent::Vec<*,2>", None): ["Vec<q16_16, 2>", "Vec<float, 2>"],
    ("detent::Vec<*,3>", None): ["Vec<q16_16, 3>"],
    ("detent::Vec<*,4>", None): ["Vec<q16_16, 4>"],
    ("detent::Direction<*,*>", None): ["Direction<q16_16, 3>", "Direction<float, 2>"],
    ("detent::Quat<*>", None): ["Quat<q16_16>"],
    ("detent::Rotation<*,*>", None): ["Rotation<q16_16, 3>"],
    ("detent::Angle<float>", None): ["Angle<float>"],
    ("detent::Angle<double>", None): ["Angle<double>"],
    ("detent::Angle<*>", None): ["Angle<q16_16>"],
    ("detent::detail::Id<*>", None): ["ObjectId", "FrameId"],
}
SPACE = "{http://schemas.microsoft.com/vstudio/debugger/natvis/2010}"


def expressions(entry):
    for node in entry.iter():
        if "Condition" in node.attrib:
            yield node.attrib["Condition"]
        if node.tag == SPACE + "DisplayString":
            yield from re.findall("{([^{}]*)}", node.text)
        elif node.tag in (SPACE + "Item", SPACE + "ExpandedItem"):
            yield node.text


print("#include <detent/detent.hpp>")
print("using namespace detent;")
count = 0
for entry in tree.parse("src/debugger/detent.natvis").getroot():
    assert entry.tag == SPACE + "Type", entry.tag
    for sample in SAMPLES.pop((entry.attrib["Name"], entry.attrib.get("Priority"))):
        arguments = re.findall("[0-9]+", sample[sample.find("<") :])
        for expression in expressions(entry):
            text = expression.replace("_Elems", "_M_elems").replace("__int64", "long long")
            for i, argument in enumerate(arguments):
                text = text.replace("$T%d" % (i + 1), argument)
            print("struct Check%d : %s { void look() { (void)(%s); } };" % (count, sample, text))
            count += 1
assert not SAMPLES, "no entry for %s" % list(SAMPLES)
assert count > 30, "only %d expressions" % count
