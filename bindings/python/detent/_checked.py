# SPDX-License-Identifier: MIT
"""ctypes keeps only the low bits of an integer that does not fit. These types raise instead."""
import ctypes


class Structure(ctypes.Structure):
    """A structure whose integers raise OverflowError."""

    def __setattr__(self, name, value):
        super().__setattr__(name, value)
        if isinstance(value, int):
            kept = getattr(self, name)
            if kept != value and kept is not None:  # None is a null pointer
                raise OverflowError(f'{name} = {value} does not fit')


def argument(kind):
    """A type of a function's arguments; ctypes turns its OverflowError into an ArgumentError."""

    class Argument:
        @staticmethod
        def from_param(value):
            given = kind(value)
            if given.value != value:
                raise OverflowError(f'{value} does not fit')
            return given

    return Argument


def int32_array(numbers, count):
    """An array of `count` int32_t."""
    result = (ctypes.c_int32 * count)(*numbers)
    if any(kept != number for kept, number in zip(result, numbers)):
        raise OverflowError('a number does not fit')
    return result
