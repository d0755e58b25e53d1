# SPDX-License-Identifier: MIT
"""Compares every tick of a twin with what a program prints."""
import subprocess
import time


def follow(name, command, states, difference):
    """What is wrong, or None. `states` are the lines of the twin at each tick."""
    process = subprocess.Popen(command, stdout=subprocess.PIPE, text=True)
    for tick, twin in enumerate(states):
        code = []
        for line in process.stdout:
            if line == "\n":
                break
            code.append(line.rstrip("\n"))
        if twin != code:
            process.kill()
            process.wait()
            return "%s, tick %d%s" % (name, tick, difference(twin, code))
    return None if process.wait() == 0 else "%s: %s failed" % (name, command[0])


def fails(name, ticks, check):
    """Whether check() finds something wrong; prints what, or how long it took."""
    start = time.monotonic()
    problem = check()
    print(problem or "%s: %d ticks are equal (%d ms)" % (
        name, ticks, round(1000 * (time.monotonic() - start))))
    return problem is not None
