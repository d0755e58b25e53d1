# SPDX-License-Identifier: MIT
"""Reads scenes.txt."""
from body import Shape, axes, from_rotation, no_rotation
from compound import Compound, Part
from fixed import parse, unit
from joints import Joint
from terrain import Surface
from world import World

DEFAULTS = {"density": "1", "friction": "0.6", "restitution": "0", "rolling": "0", "damping": "0", "spin_damping": "0",
            "gravity_scale": "1", "locked": "0", "layers": "1", "meets": str(0xffffffff)}


def read(text):
    """Reads the scenes: (name, dimension, lines)."""
    scenes = []
    for line in text.splitlines():
        words = line.split("#")[0].split()
        if not words:
            continue
        if words[0] == "scene":
            scenes.append((words[1], int(words[2]), []))
        else:
            scenes[-1][2].append(words)
    return scenes


def build(n, lines):
    bits, frac = 31, 16
    for words in lines:
        if words[:2] == ["set", "scalar"]:
            bits, frac = int(words[2]), int(words[3])

    def num(text):
        return parse(text, frac)
    settings = {"ticks": 60, "substeps": 4, "gravity": [0, num("-10"), 0][:n], "push": num("3"),
                "bounce": num("1"), "sleep": num("0.05"), "margin": num("0.02"),
                "hold": num("0.1")}
    for words in lines:
        if words[0] == "set":
            key = words[1]
            if key == "scalar":
                continue
            if key in ("ticks", "substeps"):
                settings[key] = int(words[2])
            else:
                values = [num(x) for x in words[2:]]
                settings[key] = values if key == "gravity" else values[0]
    world = World(n, settings, bits, frac)
    points = {}
    for words in lines:
        if words[0] == "points":
            numbers = [num(x) for x in words[2:]]
            points[words[1]] = [numbers[i:i + n] for i in range(0, len(numbers), n)]
        if words[0] == "grid":
            points[words[1]] = grid(words, num)
        if words[0] == "part":
            points.setdefault(words[1], []).append(part(world.f, n, words[2:], num, points))
        elif words[0] == "body":
            add(world, n, words, num, points)
        elif words[0] == "joint":
            join(world, n, words, num)
    world.events = {}
    for words in lines:
        if words[0] == "at":
            world.events.setdefault(int(words[1]), []).append((words[2], words[3:]))
    world.num = num
    return world


def step(world, tick):
    """Applies the scene's commands for this tick, then steps."""
    for what, words in world.events.get(tick, ()):
        if what == "gravity":
            world.set_gravity([world.num(x) for x in words])
            continue
        index, numbers = int(words[0]), words[1:]
        if what == "remove":
            world.remove(index)
        elif what == "end":
            world.end(world.joints[index])
        elif what == "change":
            world.change(world.joints[index], joint_keys(list(numbers), world.num, 2 if world.n == 2 else 4))
        elif what == "place":
            world.place(index, place=[world.num(x) for x in numbers])
        elif what == "turned":
            world.place(index, q=read_turn(world.n, list(numbers), what, world.f)[1])
        elif what in ("velocity", "spin"):
            world.set_motion(index, what, [world.num(x) for x in numbers])
        else:
            world.push_body(index, what, [world.num(x) for x in numbers])
    world.step()


def joint_keys(words, num, size):
    keys = {}
    while words:
        key = words.pop(0)
        if key in ("frame_a", "frame_b"):
            keys[key] = axes([int(words.pop(0)) for _ in range(size)])
        elif key in ("axes_a", "axes_b"):
            keys["frame" + key[4:]] = read_axes(2 if size == 2 else 3, words)
        elif key in ("limits", "motor"):
            keys[key] = [num(words.pop(0)), num(words.pop(0))]
        elif key == "collide":
            keys[key] = 1
        else:
            keys[key] = num(words.pop(0))
    return keys


def grid(words, num):
    """The triangles of a height field."""
    x, z, cell = [num(w) for w in words[2:5]]
    columns, rows = int(words[5]), int(words[6])
    heights = [num(w) for w in words[7:]]

    def sample(i, j):
        return x + i * cell, heights[(j * columns + i) % len(heights)], z + j * cell
    triangles = []
    for j in range(rows - 1):
        for i in range(columns - 1):
            k = len(triangles)
            triangles.append((k, (sample(i, j), sample(i, j + 1), sample(i + 1, j))))
            triangles.append((k + 1, (sample(i + 1, j), sample(i, j + 1), sample(i + 1, j + 1))))
    return triangles


def join(world, n, words, num):
    kind, a, b, rest = words[1], int(words[2]), int(words[3]), words[4:]
    anchors = [[num(x) for x in rest[:n]], [num(x) for x in rest[n:2 * n]]]
    keys = joint_keys(rest[2 * n:], num, 2 if n == 2 else 4)
    world.joints.append(Joint(kind, n, a, b, anchors, {"one": num("1"), **keys}))


def read_shape(n, kind, rest, num, points):
    """Reads a shape and its position, consuming their words."""
    def vector(count=n):
        values = [num(x) for x in rest[:count]]
        del rest[:count]
        return values
    if kind == "ball":
        place, radius = vector(), vector(1)[0]
        return Shape(kind, n, radius=radius, ends=[[0] * n]), place
    if kind == "box":
        place = vector()
        return Shape(kind, n, half=vector()), place
    if kind == "hull":
        place = vector()
        return Shape(kind, n, points=points[rest.pop(0)]), place
    if kind in ("mesh", "field"):
        place = vector()
        return Surface(points[rest.pop(0)], kind == "field"), place
    low, high = vector(), vector()
    place = [x + y >> 1 for x, y in zip(low, high)]
    low, high = [[x - c for x, c in zip(p, place)] for p in (low, high)]
    if kind == "aligned":
        return Shape(kind, n, low=low, high=high), place
    return Shape(kind, n, radius=vector(1)[0], ends=[low, high]), place


def read_axes(n, rest):
    return [[int(rest.pop(0)) for _ in range(n)] for _ in range(n)]


def read_turn(n, rest, key, f):
    """Reads the frame of a `turned` or of `axes`, and its orientation; f are the world's formats."""
    fine = 14 if f.bits <= 15 else 30  # of directions
    if key == "axes":
        frame = read_axes(n, rest)
        return frame, unit(frame[0] if n == 2 else from_rotation(frame, fine))
    q = unit([int(rest.pop(0)) for _ in range(2 if n == 2 else 4)])
    frame = axes(q)
    return frame, q if n == 2 else unit(from_rotation(frame, fine))


def part(f, n, words, num, points):
    kind, rest = words[0], words[1:]
    shape, place = read_shape(n, kind, rest, num, points)
    options = {key: num(DEFAULTS[key]) for key in ("density", "friction", "restitution", "rolling")}
    q, is_sensor = no_rotation(n), False
    frame = axes(q)
    while rest:
        key = rest.pop(0)
        if key == "sensor":
            is_sensor = True
        elif key in ("turned", "axes"):
            frame, q = read_turn(n, rest, key, f)
        else:
            options[key] = num(rest.pop(0))
    return Part(f, n, shape, place, q, frame, options["density"], options["friction"],
                options["restitution"], options["rolling"], is_sensor)


def add(world, n, words, num, points):
    motion, kind, rest = words[1], words[2], words[3:]

    def vector(count=n):
        values = [num(x) for x in rest[:count]]
        del rest[:count]
        return values
    if kind == "compound":
        place = vector()
        shape = Compound(world.f, n, points[rest.pop(0)])
    else:
        shape, place = read_shape(n, kind, rest, num, points)
    options = {key: int(value) if key in ("layers", "meets", "locked") else num(value)
               for key, value in DEFAULTS.items()}
    options["sensor"] = options["fast"] = False
    options["velocity"], options["spin"], q = [0] * n, [0] * (1 if n == 2 else 3), no_rotation(n)
    frame = axes(q)
    while rest:
        key = rest.pop(0)
        if key in ("velocity", "spin"):
            options[key] = vector(len(options[key]))
        elif key in ("layers", "meets", "locked"):
            options[key] = int(rest.pop(0))
        elif key in ("sensor", "fast"):
            options[key] = True
        elif key in ("turned", "axes"):
            frame, q = read_turn(n, rest, key, world.f)
        else:
            options[key] = vector(1)[0]
    world.add(motion, shape, place, q, options, frame)
