# SPDX-License-Identifier: MIT
"""docs/dynamics.md, "A tick": steps 10 and 11, fast bodies and what they pass."""
import body as bodies
from compound import placed_parts
from fixed import ONE, dot
from manifold import manifold


def inner_ball(f, n, shape):
    """The inner radius, in steps of the scalar, and the number of the part that has it."""
    if shape.kind == "compound":
        point = bodies.Shape("ball", n, radius=0, ends=[[0] * n])
        turn = [[ONE * (i == j) for j in range(n)] for i in range(n)]
        most, number = 0, 0
        for k, part in enumerate(shape.parts):
            if not part.is_sensor:
                q = [f.lever.near(-dot(axis, part.p), f.F + 36) for axis in part.P]
                _, points = manifold(part.shape, point, turn, q, 0)
                if points and -points[0][1] >> 6 > most:
                    most, number = -points[0][1] >> 6, k
        return most, number
    if shape.kind == "box":
        return max(min(shape.reach), 0), 0
    if shape.kind == "aligned":
        return max(min(min(-x, y) for x, y in zip(shape.low, shape.high)), 0), 0
    if shape.kind == "hull":
        heights = [dot(face[0], shape.hull.points[face[1][0]]) for face in shape.hull.faces]
        return max(min(heights) >> 36, 0), 0
    return max(shape.radius_raw, 0), 0


def seen(f, x, A, p):
    d = [f.lever.near(y - z, f.F + 12) for y, z in zip(p, x)]
    return [f.lever.near(dot(axis, d), f.F + 36) for axis in A]


def stop_before(f, n, shape, start, end, r, margin):
    """Stops before a shape. r and margin are in steps of the scalar, everything else in levers."""
    point = bodies.Shape("ball", n, radius=0, ends=[[0] * n])
    turn = [[ONE * (i == j) for j in range(n)] for i in range(n)]
    if shape.kind == "surface":
        box = [(f.scalar.clamp(min(p, q) - 64 * (r + margin) >> 6),
                f.scalar.clamp(-(-max(p, q) - 64 * (r + margin) >> 6))) for p, q in zip(start, end)]
        stops = []
        for facet in shape.facets:
            if all(p[0] <= q[1] and q[0] <= p[1] for p, q in zip(facet.box, box)):
                stops.append(stop_on_way(
                    f, lambda p, reach, facet=facet: facet.touch(point, turn, p, reach, False),
                    start, end, r, margin))
        return min((s for s in stops if s), default=(0, None))[1]
    for p, q, h in zip(start, end, shape.reach):
        e = 64 * (h + shape.radius_raw + r + margin)
        if min(p, q) > e or max(p, q) < -e:
            return None
    stop = stop_on_way(f, lambda p, reach: manifold(shape, point, turn, p, reach), start, end, r,
                       margin)
    return stop and stop[1]


def stop_on_way(f, touch, start, end, r, margin):
    """Returns t and p, or None."""
    delta = [y - x for x, y in zip(start, end)]
    close = f.gap.clamp(64 * (r + margin))
    reach = close
    for x in delta:
        reach = f.gap.clamp(reach + abs(x))
    p, t = start, 0
    for step in range(16):
        normal, points = touch(p, reach)
        if not points:
            return None
        d = points[0][1]
        if step == 0:
            if d <= 0:
                return None
            aim = f.gap.near(128 * r + 64 * margin, f.F + 7) if d > close else f.gap.near(d, f.F + 7)
        closing = -dot(normal, delta)
        if closing <= 0:
            return None
        if d <= aim:
            break
        t += ((d - aim) << 60) // closing
        if t >= ONE:
            return None
        p = [f.lever.near((x << 30) + t * y, f.F + 36) for x, y in zip(start, delta)]
    return t, p


def rank_of(b):
    if b.motion in ("fixed", "kinematic"):
        return 3 if b.motion == "fixed" else 2
    return 0 if b.is_fast and b.can_move else 1


def collide(world, i, j):
    """Whether step 2 excludes two bodies at most for their bounds."""
    b, o = world.bodies[i], world.bodies[j]
    apart = {frozenset((k.a, k.b)) for k in world.joints_before if not k.numbers["collide"]}
    return (j != i and o.motion != "none" and b.layers & o.meets and o.layers & b.meets and
            frozenset((i, j)) not in apart)


def stops(world, i, j, starts, r, margin, counts):
    """The shapes of body j, of which counts(is sensor) selects parts, that body i cannot pass: number and place
    where it stops."""
    f, o = world.f, world.bodies[j]
    before = placed_parts(f, o.shape, *starts[j])
    now = placed_parts(f, o.shape, o.x, bodies.axes(o.q))
    for p, q in zip(before, now):
        if not counts(p.part and p.part.is_sensor) or p.shape.is_empty:
            continue
        at = stop_before(f, world.n, q.shape, seen(f, p.x, p.axes, starts[i][0]),
                         seen(f, q.x, q.axes, world.bodies[i].x), r, margin)
        if at is not None:
            yield p.number, [f.place.near((y << 24) + sum(a[k] * z for a, z in zip(q.axes, at)), f.F + 36)
                             for k, y in enumerate(q.x)]


def stop_all(world, starts):
    """Stops all fast bodies. `starts` has positions and axes at the start of the tick."""
    for i, b in enumerate(world.bodies):
        if not b.is_fast or not b.can_move:
            continue
        r, _ = inner_ball(world.f, world.n, b.shape)
        for rank in range(4):
            for j, o in enumerate(world.bodies):
                if not collide(world, i, j) or rank_of(o) != rank or b.is_sensor or o.is_sensor:
                    continue
                for _, x in stops(world, i, j, starts, r, world.margin_raw, lambda is_sensor: not is_sensor):
                    stop(b, x)


def stop(b, x):
    b.x = [old if no else new for old, new, no in zip(b.x, x, b.locked_v)]
    b.drift, b.anchor = [0] * len(b.v), [0] * len(b.q)
    b.sleeps, b.quiet = False, 0


def passes(world, starts):
    """The pairs (a, b, part of a, part of b) with a sensor that a fast body passed in this tick."""
    found = set()
    for i, b in enumerate(world.bodies):
        if not b.is_fast or not b.can_move:
            continue
        r, mine = inner_ball(world.f, world.n, b.shape)
        for j, o in enumerate(world.bodies):
            if not collide(world, i, j):
                continue
            both = b.is_sensor or o.is_sensor
            for theirs, _ in stops(world, i, j, starts, r, 0, lambda is_sensor: both or is_sensor):
                found.add((i, j, mine, theirs) if i < j else (j, i, theirs, mine))
    found -= world.touching(world.contacts)
    return found - world.touching(world.contacts_of({pair[:2] for pair in found}))
