# SPDX-License-Identifier: MIT
"""docs/contacts_of_bodies.md. Lengths are integers in steps of a lever, feet in 1/256 of that."""
from math import isqrt

from fixed import Format, ONE, cross, dot, ratio, root_nearest, round_div, squared, \
    unit

LEVER = Format(31, 0)
CORNER = Format(33, 0)
FOOT = Format(39, 0)
TOLERANCE = 1 << 11
NOTHING = (None, [])


def rounded(v, shift, kind=LEVER):
    return [kind.near(x, shift) for x in v]


def combine(p, r):
    """p_0 r_0 + p_1 r_1 (+ p_2 r_2), times 2^30."""
    return [dot(p, column) for column in zip(*r)]


def placed(t, p, r, kind=LEVER):
    """t + p_0 r_0 + ..., rounded."""
    return [kind.near((x << 30) + y, 30) for x, y in zip(t, combine(p, r))]


def to_foot(v):
    return [x << 8 for x in v]


def minus(a, b):
    return [x - y for x, y in zip(a, b)]


def kept(points, margin):
    return [p for p in points if p[1] <= margin]


# The pose of a pair

def manifold(a, b, r, t, margin):
    """Returns the normal and the points (position, separation, feature) of two shapes; b is at t
    with axes r."""
    n = len(t)
    if a.is_empty or b.is_empty:
        return NOTHING
    if "hull" in (a.kind, b.kind):
        return hull.manifold(a, b, r, t, margin)
    if a.is_box and b.is_box:
        t = [LEVER.near((x << 30) + y - (c << 30), 30)
             for x, y, c in zip(t, combine(b.center, r), a.center)]
        normal, points = boxes(a.half, b.half, r, t, margin)
        return normal, moved(points, a.center)
    if a.is_box:
        t = rounded(minus(t, a.center), 0)
        ends = [placed(t, p, r) for p in b.ends]
        normal, points = box_round(a.half, ends, b.radius, margin)
        return normal, moved(points, a.center)
    if b.is_box:
        t = placed(t, b.center, r)
        ends = [[LEVER.near(dot(r[j], minus(q, t)), 30) for j in range(n)] for q in a.ends]
        normal, points = box_round(b.half, ends, a.radius, margin)
        if not points:
            return NOTHING
        return ([ratio.near(-x, 60) for x in combine(normal, r)],
                [(placed(t, p, r), s, f) for p, s, f in points])
    a_ends = [rounded(p, 0) for p in a.ends]
    b_ends = [placed(t, p, r) for p in b.ends]
    return round_round(a_ends, a.radius, b_ends, b.radius, margin)


def moved(points, c):
    return [([LEVER.clamp(x + y) for x, y in zip(p, c)], s, f) for p, s, f in points]


# Balls and capsules

def foot_at(s, d, num, den):
    """s + the rounded d num / den, with s and d in levers."""
    return [(x << 8) + FOOT.clamp(round_div((y * num) << 8, den)) for x, y in zip(s, d)]


def foot(p, s, e):
    """The foot of the perpendicular from p (a foot) on the segment from s to e (levers)."""
    d = minus(e, s)
    w = dot(minus(p, to_foot(s)), d)
    dd = squared(d) << 8
    if w <= 0:
        return to_foot(s)
    if w >= dd:
        return to_foot(e)
    return foot_at(s, d, w, dd)


def distance(p, q):
    """The distance between two feet, in steps of a lever."""
    return root_nearest(squared(minus(q, p)), 1 << 16)


def between(p, n, ra, s):
    """p + n (r_a + s / 2), rounded to levers."""
    return [LEVER.near((x << 23) + y * (2 * ra + s), 31) for x, y in zip(p, n)]


def balls(p, ra, q, rb, margin):
    s = LEVER.clamp(distance(p, q) - (ra + rb))
    n = unit(minus(q, p))
    return n, kept([(between(p, n, ra, s), s, 0)], margin)


def across(d, e, toward):
    """The direction perpendicular to d and e."""
    d = d if any(d) else e
    if len(d) == 2:
        v = [-d[1], d[0]]
    else:
        v = cross(d, e)
        if not any(v):
            least = min(range(3), key=lambda i: abs(d[i]))
            u = [int(i == least) for i in range(3)]
            v = cross(u, d)
    if dot(v, toward) < 0:
        v = [-x for x in v]
    return unit(v)


def round_round(a_ends, ra, b_ends, rb, margin):
    a_ball, b_ball = len(a_ends) == 1, len(b_ends) == 1
    if a_ball and b_ball:
        return balls(to_foot(a_ends[0]), ra, to_foot(b_ends[0]), rb, margin)
    if a_ball:
        p = to_foot(a_ends[0])
        return balls(p, ra, foot(p, *b_ends), rb, margin)
    if b_ball:
        q = to_foot(b_ends[0])
        return balls(foot(q, *a_ends), ra, q, rb, margin)
    return capsules(a_ends, ra, b_ends, rb, margin)


def feet(a_ends, b_ends):
    """Steps 1 and 2 for two capsules."""
    (a, a2), (b, b2) = a_ends, b_ends
    d, e, r = minus(a2, a), minus(b2, b), minus(a, b)
    A, B, C = dot(d, d), dot(d, e), dot(e, e)
    W, V = A * C - B * B, B * dot(e, r) - C * dot(d, r)
    if W <= 0 or V <= 0:
        p = to_foot(a)
    elif V >= W:
        p = to_foot(a2)
    else:
        p = foot_at(a, d, V, W)
    q = foot(p, b, b2)
    if q == to_foot(b) or q == to_foot(b2):
        p = foot(q, a, a2)
    return p, q


def capsules(a_ends, ra, b_ends, rb, margin):
    (a, a2), (b, b2) = a_ends, b_ends
    d, e = minus(a2, a), minus(b2, b)
    A, C = dot(d, d), dot(e, e)
    W = A * C - dot(d, e) ** 2
    p, q = feet(a_ends, b_ends)
    single = balls(p, ra, q, rb, margin)
    if distance(p, q) == 0:
        n = across(d, e, minus([x + y for x, y in zip(b, b2)], [x + y for x, y in zip(a, a2)]))
        s = LEVER.clamp(-(ra + rb))
        single = n, kept([(between(p, n, ra, s), s, 0)], margin)
    if 1024 * W >= A * C or not single[1]:
        return single
    f, g = dot(minus(b, a), d), dot(minus(b2, a), d)
    (low, first), (high, last) = ((f, b), (g, b2)) if f <= g else ((g, b2), (f, b))
    if low >= A or high <= 0:
        return single
    n = single[0]
    pairs = [(foot(to_foot(first), a, a2), to_foot(first)) if low > 0
             else (to_foot(a), foot(to_foot(a), b, b2)),
             (foot(to_foot(last), a, a2), to_foot(last)) if high < A
             else (to_foot(a2), foot(to_foot(a2), b, b2))]
    points = []
    for feature, (p, q) in enumerate(pairs, 1):
        s = LEVER.near(dot(n, minus(q, p)) - ((ra + rb) << 38), 38)
        points.append((between(p, n, ra, s), s, feature))
    points = kept(points, margin)
    return (n, points) if points else single


# A box and a ball or capsule

def box_round(h, ends, r, margin):
    if len(ends) == 1:
        return box_ball(h, to_foot(ends[0]), r, margin)[1]
    if ends[0] == ends[1]:
        return box_ball(h, to_foot(ends[0]), r, margin)[1]
    return box_capsule(h, ends[0], ends[1], r, margin)


def box_ball(h, q, r, margin):
    """D, and the manifold of a ball around q, a foot."""
    h8 = to_foot(h)
    c = [min(max(x, -y), y) for x, y in zip(q, h8)]
    D = distance(q, c)
    if D > 0:
        s, n = LEVER.clamp(D - r), unit(minus(q, c))
    else:
        i = max(range(len(q)), key=lambda k: abs(q[k]) - h8[k])
        s = LEVER.near(abs(q[i]) - h8[i] - (r << 8), 8)
        sign = -1 if q[i] < 0 else 1
        n = [sign * ONE if k == i else 0 for k in range(len(q))]
        c[i] = sign * h8[i]
    return D, (n, kept([(between(c, n, 0, s), s, 0)], margin))


def nearest_to_box(h, a, d):
    """The least x in [0, 1] at which the distance is least, as num / den."""
    n = len(a)
    den = 1
    for x in d:
        den *= abs(x) or 1

    def slope(X):
        total = 0
        for i in range(n):
            y, e = a[i] * den + d[i] * X, h[i] * den
            total += d[i] * (y - e if y > e else y + e if y < -e else 0)
        return total
    at, low = 0, slope(0)
    if low >= 0:
        return 0, 1
    stops = [(side * h[i] - a[i]) * (den // d[i]) for i in range(n) if d[i] for side in (-1, 1)]
    for X in sorted(x for x in stops if 0 < x < den) + [den]:
        high = slope(X)
        if high >= 0:
            return at * (high - low) + (X - at) * -low, (high - low) * den
        at, low = X, high
    return 1, 1


def box_capsule(h, a, a2, r, margin):
    n = len(a)
    d, total = minus(a2, a), [x + y for x, y in zip(a, a2)]
    num, den = nearest_to_box(h, a, d)
    if num == 0:
        f = to_foot(a)
    elif num == den:
        f = to_foot(a2)
    else:
        f = foot_at(a, d, num, den)
    meets = all(abs(a[i] * den + d[i] * num) <= h[i] * den for i in range(n))
    twice = [abs(total[i]) - abs(d[i]) - 2 * h[i] for i in range(n)]
    face = max(range(n), key=lambda i: twice[i])
    limit2 = twice[face] + 2 * TOLERANCE
    if meets:
        best = None
        for i in range(3) if n == 3 else (0,):
            l = [0] * n
            if n == 2:
                l = [d[1], -d[0]]
            else:
                j, k = (i + 1) % 3, (i + 2) % 3
                l[j], l[k] = d[k], -d[j]
            if 4096 * squared(l) < squared(d):
                continue
            e2 = abs(dot(l, total)) - 2 * sum(abs(x) * y for x, y in zip(l, h))
            E = round_div(e2 << 8, 2 * isqrt(squared(l) << 16))
            if best is None or E > best[0]:
                best = E, i, l
        if best is not None and 2 * best[0] > limit2:
            return capsule_across(h, a, d, total, best, r, margin)
        return capsule_on_face(h, a, a2, face, total, r, margin)
    D, single = box_ball(h, f, r, margin)
    if not single[1] or 2 * D > limit2:
        return single
    on_face = capsule_on_face(h, a, a2, face, total, r, margin)
    return on_face if on_face[1] else single


def capsule_across(h, a, d, total, best, r, margin):
    E, i, l = best
    n = len(a)
    if dot(l, total) < 0:
        l = [-x for x in l]
    s = LEVER.clamp(E - r)
    z = [-h[c] if l[c] < 0 or (l[c] == 0 and total[c] < 0) else h[c] for c in range(n)]
    plane = [c for c in range(n) if n == 2 or c != i]
    w = sum((z[c] - a[c]) * d[c] for c in plane)
    dd = sum(d[c] * d[c] for c in plane)
    if w <= 0:
        f = to_foot(a)
    elif w >= dd:
        f = to_foot([x + y for x, y in zip(a, d)])
    else:
        f = foot_at(a, d, w, dd)
    normal = unit(l)
    point = [LEVER.near((x << 23) - y * (r + E), 31) for x, y in zip(f, normal)]
    return normal, kept([(point, s, 4)], margin)


def clip_new(p, u, q, v, k, e):
    """Clips from the kept end p with room u to the lost end q with room v."""
    new = [x + CORNER.clamp(round_div((y - x) * u, u - v)) for x, y in zip(p, q)]
    new[k] = e
    return new


def clip_ends(ends, k, e, names):
    """Clips (point, name) pairs at e, then at -e."""
    for side, name in zip((1, -1), names):
        rooms = [e - side * p[k] for p, _ in ends]
        result = []
        for i, (p, old) in enumerate(ends):
            if rooms[i] >= 0:
                result.append((p, old))
            elif len(ends) == 2 and rooms[1 - i] > 0:
                result.append((clip_new(ends[1 - i][0], rooms[1 - i], p, rooms[i], k, side * e), name))
        ends = result
    return ends


def capsule_on_face(h, a, a2, i, total, r, margin):
    n = len(a)
    sign = -1 if total[i] < 0 else 1
    ends = [(a, 0), (a2, 1)]
    for c in range(1, n):
        k = (i + c) % n
        ends = clip_ends(ends, k, h[k] + TOLERANCE, (2 * c, 2 * c + 1))
    points = []
    for p, name in ends:
        s = LEVER.clamp(sign * p[i] - h[i] - r)
        point = [LEVER.clamp(x) for x in p]
        point[i] = LEVER.near(2 * p[i] - sign * (2 * r + s), 1)
        points.append((point, s, 8 + 8 * (2 * i + (sign < 0)) + name))
    return [sign * ONE if k == i else 0 for k in range(n)], kept(points, margin)


# Boxes

def boxes(a, b, r, t, margin):
    n = len(t)
    if min(a) < 0 or min(b) < 0:
        return NOTHING
    along_a = [(abs(t[i]) - a[i] << 30) - sum(abs(r[j][i]) * b[j] for j in range(n)) for i in range(n)]
    along_b = [abs(dot(t, r[j])) - (b[j] << 30) - sum(abs(r[j][i]) * a[i] for i in range(n))
               for j in range(n)]
    if max(along_a) > margin << 30 or max(along_b) > margin << 30:
        return NOTHING
    k = max(range(n), key=lambda i: along_a[i])
    of_b = max(along_b) > along_a[k] + (TOLERANCE << 30)
    if of_b:
        k = max(range(n), key=lambda j: along_b[j])
    S = LEVER.near(along_b[k] if of_b else along_a[k], 30)
    if n == 3:
        best = None
        for i in range(3):
            i1, i2 = (i + 1) % 3, (i + 2) % 3
            for j in range(3):
                j1, j2 = (j + 1) % 3, (j + 2) % 3
                m = r[j][i1] ** 2 + r[j][i2] ** 2
                if m < 1 << 48:
                    continue
                s = abs(t[i2] * r[j][i1] - t[i1] * r[j][i2]) - a[i1] * abs(r[j][i2]) \
                    - a[i2] * abs(r[j][i1]) - b[j1] * abs(r[j2][i]) - b[j2] * abs(r[j1][i])
                s = LEVER.clamp(round_div(s, min(isqrt(m), ONE)))
                if s > margin:
                    return NOTHING
                if best is None or s > best[0]:
                    best = s, i, j
        if best is not None and best[0] > LEVER.clamp(S + TOLERANCE):
            return box_edges(a, b, r, t, *best)
    return box_faces(a, b, r, t, k, of_b, margin)


def box_faces(a, b, r, t, k, of_b, margin):
    n = len(t)
    if not of_b:
        sign = -1 if t[k] < 0 else 1
        own, other = a, b
        parts = [r[m][k] for m in range(n)]
    else:
        sign = -1 if dot(t, r[k]) >= 0 else 1
        own, other = b, a
        parts = [r[k][m] for m in range(n)]
    m = max(range(n), key=lambda i: abs(parts[i]))
    side = -1 if sign * parts[m] > 0 else 1
    corners = []
    for signs in ((1, 1), (-1, 1), (-1, -1), (1, -1)) if n == 3 else ((1,), (-1,)):
        p = [0] * n
        p[m] = side * other[m]
        for c, x in enumerate(signs, 1):
            p[(m + c) % n] = x * other[(m + c) % n]
        if not of_b:
            p = placed(t, p, r, CORNER)
        else:
            p = [CORNER.near(dot(minus(p, t), r[j]), 30) for j in range(n)]
        corners.append(p)
    if n == 2:
        side_axis = (k + 1) % 2
        named = clip_ends([(corners[0], 0), (corners[1], 1)], side_axis,
                          own[side_axis] + TOLERANCE, (2, 3))
    else:
        polygon = list(zip(corners, range(4)))
        for c in (1, 2):
            axis = (k + c) % 3
            polygon = clip_polygon(polygon, axis, own[axis] + TOLERANCE, 2 * c + 2)
        named = [(p, 8 * polygon[i - 1][1] + line) for i, (p, line) in enumerate(polygon)]
    points = []
    for p, name in named:
        s = LEVER.clamp(sign * p[k] - own[k])
        if s <= margin:
            points.append((p, s, name))
    points = reduced(points, k)
    kind = ((2 * (k + (n if of_b else 0)) + (sign < 0)) * 8 + 2 * m + (side < 0)) * 64
    if not of_b:
        normal = [sign * ONE if i == k else 0 for i in range(n)]
    else:
        normal = list(r[k]) if sign < 0 else [-x for x in r[k]]
    result = []
    for p, s, name in points:
        twice = [2 * x for x in p]
        twice[k] -= sign * s
        if not of_b:
            point = [LEVER.near(x, 1) for x in twice]
        else:
            point = [LEVER.near((x << 31) + y, 31) for x, y in zip(t, combine(twice, r))]
        result.append((point, s, kind + name))
    return normal, result


def clip_polygon(polygon, k, e, cut):
    """Clips the corners of a polygon at e, then at -e; the cuts are numbered cut and cut + 1."""
    for side in (1, -1):
        rooms = [e - side * p[k] for p, _ in polygon]
        result = []
        for i, (p, line) in enumerate(polygon):
            j = (i + 1) % len(polygon)
            u, v = rooms[i], rooms[j]
            if u >= 0:
                result.append((p, cut if u == 0 and v < 0 else line))
            if u > 0 and v < 0:
                result.append((clip_new(p, u, polygon[j][0], v, k, side * e), cut))
            elif u < 0 and v > 0:
                result.append((clip_new(polygon[j][0], v, p, u, k, side * e), line))
        polygon = result
        cut += 1
    return polygon


def reduced(points, k):
    """Reduces the points to at most four."""
    if len(points) <= 4:
        return points
    x, y = (k + 1) % 3, (k + 2) % 3
    deepest = min(range(len(points)), key=lambda i: points[i][1])
    o = points[deepest][0]
    flat = [(p[x] - o[x], p[y] - o[y]) for p, _, _ in points]
    farthest = max(range(len(points)), key=lambda i: squared(flat[i]))
    f = flat[farthest]
    areas = [f[0] * q[1] - f[1] * q[0] for q in flat]
    keep = {deepest, farthest}
    left = max(range(len(points)), key=lambda i: areas[i])
    right = min(range(len(points)), key=lambda i: areas[i])
    if areas[left] > 0:
        keep.add(left)
    if areas[right] < 0:
        keep.add(right)
    return [p for i, p in enumerate(points) if i in keep]


def box_edges(a, b, r, t, s, i, j):
    i1, i2 = (i + 1) % 3, (i + 2) % 3
    l = [0, 0, 0]
    l[i1], l[i2] = -r[j][i2], r[j][i1]
    if dot(l, t) < 0:
        l = [-x for x in l]
    bits = 0
    z = [0, 0, 0]
    for c in range(3):
        if c == i:
            continue
        negated = l[c] < 0 or (l[c] == 0 and t[c] < 0)
        z[c] = -a[c] if negated else a[c]
        bits = 2 * bits + negated
    y = [0, 0, 0]
    for k in range(3):
        if k == j:
            continue
        x = dot(l, r[k])
        negated = x > 0 or (x == 0 and dot(t, r[k]) >= 0)
        y[k] = -b[k] if negated else b[k]
        bits = 2 * bits + negated
    g = minus(placed(t, y, r, CORNER), z)
    v = CORNER.clamp(round_div(-(g[i1] * r[j][i1] + g[i2] * r[j][i2]) << 30,
                               r[j][i1] ** 2 + r[j][i2] ** 2))
    v = min(max(v, -b[j]), b[j])
    z[i] = min(max(CORNER.near((g[i] << 30) + v * r[j][i], 30), -a[i]), a[i])
    n = unit(l)
    point = [LEVER.near((x << 31) + c * s, 31) for x, c in zip(z, n)]
    return n, [(point, s, (1 << 15) + (3 * i + j) * 16 + bits)]


import hull  # noqa: E402  needs the functions above
