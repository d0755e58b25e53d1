#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""usage: run.py TWIN_STATES [--ticks N] [--scenes FILE] [SCENE...]

Steps the scenes of scenes.txt, or of another file, and compares every tick with what the program
TWIN_STATES prints. FILE may be -: then TWIN_STATES prints the scenes too, without an argument.
Exits with 1 at the first difference, and says where it is.
"""
import os
import subprocess
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import scenes
from follow import fails, follow


def field_of(line, i, n):
    """The name of word i in a line of a state."""
    words = line.split()
    if words[0] == "body":
        count = {"place": n, "orientation": 2 if n == 2 else 4, "velocity": n,
                 "spin": 1 if n == 2 else 3, "drift": n, "anchor": 2 if n == 2 else 4, "quiet": 1, "sleeps": 1}
        names = ["body", "index"]
    elif words[0] == "event":
        count, names = {}, ["event", "a", "b", "part of a", "part of b", "begins"]
    elif words[0] == "joint":
        count, names = {"impulse": 99}, ["joint", "index", "a", "b"]
    else:
        count = {"feature or pressure": 2 * int(words[6]), "friction": 1 if n == 2 else 3,
                 "rolling": 1 if n == 2 else 3}
        names = ["contact", "a", "b", "part", "triangle", "touches", "points"]
    for name, times in count.items():
        names += ["%s %d" % (name, k) for k in range(times)]
    return names[i] if i < len(names) else "count"


def difference(twin, code, n):
    for a, b in zip(twin, code):
        if a != b:
            u, v = a.split(), b.split()
            i = next((i for i, (x, y) in enumerate(zip(u, v)) if x != y), min(len(u), len(v)))
            return "%s:\n  twin %s\n  code %s" % (field_of(a, i, n), a, b)
    return "%d lines of the twin, %d of the code:\n  %s" % (
        len(twin), len(code), "\n  ".join((twin + code)[min(len(twin), len(code)):]))


def states(n, lines, ticks):
    world = scenes.build(n, lines)
    for tick in range(ticks + 1):
        if tick:
            scenes.step(world, tick)
        yield list(world.state())


def main(arguments):
    given = None
    if "--ticks" in arguments:
        i = arguments.index("--ticks")
        given = int(arguments[i + 1])
        del arguments[i:i + 2]
    path = os.path.join(os.path.dirname(os.path.abspath(__file__)), "scenes.txt")
    if "--scenes" in arguments:
        i = arguments.index("--scenes")
        path = arguments[i + 1]
        del arguments[i:i + 2]
    if not arguments:
        print(__doc__, file=sys.stderr)
        return 2
    program, chosen = arguments[0], arguments[1:]
    failed = False
    if path == "-":
        text = subprocess.run([program], stdout=subprocess.PIPE, text=True, check=True).stdout
    else:
        with open(path, encoding="ascii") as file:
            text = file.read()
    for name, n, lines in scenes.read(text):
        if chosen and name not in chosen:
            continue
        everyday = [int(words[1]) for words in lines if words[0] == "everyday"]
        ticks = given or (everyday or [1000])[0]
        failed |= fails(name, ticks, lambda: follow(
            name, [program, path, name, str(ticks)], states(n, lines, ticks),
            lambda twin, code: ", " + difference(twin, code, n)))
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
