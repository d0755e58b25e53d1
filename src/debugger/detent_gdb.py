# SPDX-License-Identifier: MIT
"""Printers for gdb: numbers of detent as exact decimals, vectors and rotations by their numbers.

In gdb, or in ~/.gdbinit:  source .../detent_gdb.py
`print/r x` shows a value without them. Works with gdb 9 and later.
"""

import gdb
import gdb.printing


def is_big_endian():
    return "big" in gdb.execute("show endian", to_string=True)


def elements(array):
    """The elements of a std::array, whose only field is the array in every standard library."""
    fields = array.type.strip_typedefs().fields()
    data = array[fields[0]]
    low, high = data.type.strip_typedefs().range()
    return [data[i] for i in range(low, high + 1)]


def integer(value):
    """A built-in integer of any width, or a detent::Wide."""
    kind = value.type.strip_typedefs()
    if kind.code == gdb.TYPE_CODE_STRUCT:
        words = elements(value["words_"])
        size = 64 * len(words)
        result = sum((int(word) & (2**64 - 1)) << (64 * i) for i, word in enumerate(words))
        return result - (1 << size) if result >> (size - 1) else result
    if kind.sizeof <= 8:
        return int(value)
    # Older versions of gdb truncate wider values.
    memory = gdb.selected_inferior().read_memory(value.address, kind.sizeof)
    order = "big" if is_big_endian() else "little"
    return int.from_bytes(bytes(memory), order, signed=True)


def decimal(numerator, places):
    """numerator / 2^places, exactly."""
    sign = "-" if numerator < 0 else ""
    numerator = abs(numerator)
    whole, rest = numerator >> places, numerator & ((1 << places) - 1)
    if rest == 0:
        return sign + str(whole)
    digits = str((rest * 10**places) >> places).rjust(places, "0").rstrip("0")
    return sign + str(whole) + "." + digits


def raw_and_text(value):
    raw = integer(value["raw_"])
    return raw, decimal(raw, int(value.type.strip_typedefs().template_argument(1)))


def text(value):
    """A number without its raw value, for lists of them."""
    kind = value.type.strip_typedefs()
    return str(value) if kind.code == gdb.TYPE_CODE_FLT else raw_and_text(value)[1]


def vector_text(vector):
    names = [field.name for field in vector.type.strip_typedefs().fields()]
    return "(" + ", ".join(text(vector[name]) for name in names) + ")"


class Printer:
    def __init__(self, value):
        self.value = value


class FixedPrinter(Printer):
    def to_string(self):
        raw, number = raw_and_text(self.value)
        return "%s (raw %d)" % (number, raw)


class WidePrinter(Printer):
    def to_string(self):
        return str(integer(self.value))


class VecPrinter(Printer):
    def to_string(self):
        return vector_text(self.value)


class DirectionPrinter(Printer):
    def to_string(self):
        return vector_text(self.value["components_"])


class QuatPrinter(Printer):
    def to_string(self):
        return vector_text(self.value["xyzw_"])


class RotationPrinter(Printer):
    def to_string(self):
        axes = elements(self.value["axes_"])
        return "axes " + ", ".join(vector_text(axis["components_"]) for axis in axes)


class AnglePrinter(Printer):
    def to_string(self):
        raw = self.value["raw_"]
        if raw.type.strip_typedefs().code == gdb.TYPE_CODE_FLT:
            return "%s radians" % raw
        # In (-180, 180], like degrees().
        signed = int(raw) - 2**32 if int(raw) > 2**31 else int(raw)
        return "%s degrees (raw %d)" % (decimal(360 * signed, 32), int(raw))


class IdPrinter(Printer):
    def to_string(self):
        generation = int(self.value["generation"])
        return "%d:%d" % (int(self.value["index"]), generation) if generation else "none"


def collection():
    printers = gdb.printing.RegexpCollectionPrettyPrinter("detent")
    for name, printer in (
        ("Fixed", FixedPrinter),
        ("Wide", WidePrinter),
        ("Vec", VecPrinter),
        ("Direction", DirectionPrinter),
        ("Quat", QuatPrinter),
        ("Rotation", RotationPrinter),
        ("Angle", AnglePrinter),
        ("detail::Id", IdPrinter),
    ):
        printers.add_printer(name, "^detent::" + name + "<.*>$", printer)
    return printers


gdb.printing.register_pretty_printer(None, collection(), replace=True)
