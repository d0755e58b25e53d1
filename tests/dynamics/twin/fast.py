# SPDX-License-Identifier: MIT
"""docs/dynamics.md, "A tick": step 10, fast bodies."""
import body as bodies
from compound import placed_parts
from fixed import ONE, dot
from manifold import manifold


def inner_radius(f, n, shape):
    """In steps of the scalar."""
    if shape.kind == "compound":
        point = bodies.Shape("ball", n, radius=0, ends=[[0] * n])
        turn = [[ONE * (i == j) for j in range(n)] for i in range(n)]
        most = 0
        for part in shape.parts:
            if not part.is_sensor:
                q = [f.lever.near(-dot(axis, part.p), f.F + 36) for axis in part.P]
                _, points = manifold(part.shape, point, turn, q, 0)
                if points:
                    most = max(most, -points[0][1] >> 6)
        return most
    if shape.kind == "box":
        return max(min(shape.reach), 0)
    if shape.kind == "aligned":
        return max(min(min(-x, y) for x, y in zip(shape.low, shape.high)), 0)
    if shape.kind == "hull":
        heights = [dot(face[0], shape.hull.points[face[1][0]]) for face in shape.hull.faces]
        return max(min(heights) >> 36, 0)
    return max(shape.radius_raw, 0)


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


def stop_all(world, starts):
    """Stops all fast bodies. `starts` has positions and axes at the start of the tick."""
    f, n = world.f, world.n
    apart = {frozenset((j.a, j.b)) for j in world.joints_before if not j.numbers["collide"]}
    for i, b in enumerate(world.bodies):
        if not b.is_fast or not b.can_move:
            continue
        r = inner_radius(f, n, b.shape)
        for rank in range(4):
            for j, o in enumerate(world.bodies):
                if (j == i or o.motion == "none" or rank_of(o) != rank or b.is_sensor or
                        o.is_sensor or not (b.layers & o.meets and o.layers & b.meets) or
                        frozenset((i, j)) in apart):
                    continue
                before = placed_parts(f, o.shape, *starts[j])
                now = placed_parts(f, o.shape, o.x, bodies.axes(o.q))
                for p, q in zip(before, now):
                    if not (p.part and p.part.is_sensor) and not p.shape.is_empty:
                        stop(world, b, starts[i][0], p, q, r)


def stop(world, b, start, before, now, r):
    """Stops b before a shape, given its poses at both times."""
    f, A = world.f, now.axes
    p = stop_before(f, world.n, now.shape, seen(f, before.x, before.axes, start), seen(f, now.x, A, b.x),
                    r, world.margin_raw)
    if p is None:
        return
    x = [f.place.near((y << 24) + sum(a[k] * z for a, z in zip(A, p)), f.F + 36)
         for k, y in enumerate(now.x)]
    b.x = [old if no else new for old, new, no in zip(b.x, x, b.locked_v)]
    b.drift, b.lean = [0] * len(b.v), [0] * len(b.w)
    b.sleeps, b.quiet = False, 0
