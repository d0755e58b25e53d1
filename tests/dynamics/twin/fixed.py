# SPDX-License-Identifier: MIT
"""Numbers of docs/dynamics.md, "Notation": integers in steps of a format's grid, rounded to
nearest."""
from math import isqrt
from operator import mul


def round_div(n, d):
    """n / d to the nearest integer, ties to even; d > 0."""
    q, r = divmod(n, d)
    r += r
    return q + (r > d or (r == d and q & 1))


def round_shift(n, k):
    """n 2^-k to the nearest integer, ties to even."""
    if k <= 0:
        return n << -k
    return (n + (1 << (k - 1)) - 1 + (n >> k & 1)) >> k


def root_nearest(n, d=1):
    """The square root of n / d to the nearest integer."""
    r = isqrt(4 * n // d)
    return (r + 1) >> 1


class Format:
    """The format (b, f): multiples of 2^-f from -2^b 2^-f to (2^b - 1) 2^-f."""

    def __init__(self, b, f):
        self.f, self.low, self.high = f, -(1 << b), (1 << b) - 1

    def clamp(self, x):
        return self.low if x < self.low else self.high if x > self.high else x

    def near(self, n, f):
        """near(n 2^-f)"""
        k = f - self.f
        # as round_shift, which is inlined because nothing is called more often
        x = (n + (1 << (k - 1)) - 1 + (n >> k & 1)) >> k if k > 0 else n << -k
        return self.low if x < self.low else self.high if x > self.high else x

    def quotient(self, n, d, f=0):
        """near(n / d 2^-f); 0 / 0 is 0."""
        if d < 0:
            n, d = -n, -d
        if d == 0:
            return self.high if n > 0 else self.low if n < 0 else 0
        k = self.f - f
        return self.clamp(round_div(n << k, d) if k >= 0 else round_div(n, d << -k))


class Formats:
    """The formats of the scalar Fixed<bits, frac>."""

    def __init__(self, bits, frac):
        F = self.F = frac
        self.bits = bits
        self.scalar = Format(bits, F)
        self.place = Format(bits + 12, F + 12)
        self.speed = Format(30, F + 12)
        self.spin = Format(30, 28)
        self.impulse = Format(31, F + 12)
        self.ratio = ratio
        self.lever = Format(31, F + 6)
        self.gap = self.lever
        self.arm = Format(29, F + 6)
        self.moment = Format(30, F + 6)
        self.response = Format(31, 38 - F)
        self.gyration = Format(52, 66 - 2 * F)
        self.give = Format(59, 30)
        self.sum = Format(62, F + 34)
        self.length = Format(33, F + 12)
        self.stretch = Format(47, 30)
        self.fine_spin = Format(51, 44)
        self.reach = Format(37, F + 12)
        self.torque = Format(62, F + 32)
        self.bound = Format(bits + 15, F + 12)
        self.mass = Format(63, 2 * F)
        self.squared_gyration = Format(2 * bits + 34, 2 * F + 30)


ratio = Format(31, 30)
ONE = 1 << 30  # 1 in Ratio


def dot(a, b):
    if len(a) == 3:
        return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
    return sum(map(mul, a, b))


def cross(a, b):
    """The cross product: one number in 2D, three in 3D."""
    if len(a) == 2:
        return [a[0] * b[1] - a[1] * b[0]]
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def squared(v):
    return dot(v, v)


def unit(v, frac=30):
    """v / |v|, each component rounded to nearest in steps of 2^-frac, by default Ratio; ties do not occur."""
    n = squared(v)
    if n == 0:
        return [1 << frac] + [0] * (len(v) - 1)
    out = []
    for x in v:
        y = (isqrt((x * x << 2 * frac + 2) // n) + 1) >> 1
        out.append(-y if x < 0 else y)
    return out


def parse(text, frac):
    """Rounds a decimal to the nearest multiple of 2^-frac."""
    negative = text.startswith("-")
    whole, _, rest = text.lstrip("-").partition(".")
    n = round_div(int(whole + rest) << frac, 10 ** len(rest))
    return -n if negative else n


def _pi(bits):
    def arctan_inverse(x):
        total, term, n, sign = 0, (1 << (bits + 64)) // x, 1, 1
        while term:
            total += sign * (term // n)
            term //= x * x
            n, sign = n + 2, -sign
        return total
    return round_shift(4 * (4 * arctan_inverse(5) - arctan_inverse(239)), 64)


PI_BITS = 124
PI = _pi(PI_BITS)


def arc(y, x, bits=96):
    """The angle of (x, y) in [-1/2, 1/2) turn, rounded to the nearest multiple of 2^-32; 0 for 0,
    0."""
    if x == 0 and y == 0:
        return 0
    u, v = abs(x), abs(y)
    low, high = min(u, v), max(u, v)
    t = (low << bits) // high
    for _ in range(6):  # arctan t is twice arctan of t / (1 + sqrt(1 + t^2))
        t = (t << bits) // ((1 << bits) + isqrt((1 << 2 * bits) + t * t))
    total, term, k = 0, t, 0
    while term:
        total += -(term // (2 * k + 1)) if k & 1 else term // (2 * k + 1)
        term, k = (term * t >> bits) * t >> bits, k + 1
    turns = (total << 6 + PI_BITS) // (2 * PI)  # times 2^bits
    if v > u:
        turns = (1 << bits - 2) - turns
    if x < 0:
        turns = (1 << bits - 1) - turns
    if y < 0:
        turns = -turns
    n = round_shift(turns, bits - 32)
    return n - (1 << 32) if n >= 1 << 31 else n
