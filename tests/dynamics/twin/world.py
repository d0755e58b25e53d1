# SPDX-License-Identifier: MIT
"""docs/dynamics.md, "A tick": steps 1 to 5 and 9, and events."""
import body as bodies
import fast
import solver
import terrain
from compound import out_of_part, placed_parts
from fixed import Formats, cross, dot, ratio, round_div, round_shift, unit
from manifold import combine, manifold, placed


class Contact:
    def __init__(self, n):
        self.touches, self.count = False, 0
        self.feature, self.pressure = [], []
        self.friction = [0] * (1 if n == 2 else 3)
        self.rolling = [0] * (1 if n == 2 else 3)


class World:
    def __init__(self, n, settings, bits=31, frac=16):
        f = self.f = Formats(bits, frac)
        self.n, self.ticks_per_second = n, settings["ticks"]
        rate = self.rate = settings["ticks"] * settings["substeps"]
        self.substeps = settings["substeps"]
        self.push = f.speed.quotient(settings["push"], rate, f.F)
        self.bounce = f.speed.quotient(settings["bounce"], rate, f.F)
        self.sleep = f.speed.quotient(settings["sleep"], rate, f.F)
        self.sleep_spin = f.spin.quotient(settings["sleep"], rate, f.F)
        self.margin_raw = settings["margin"]
        self.margin = f.lever.near(settings["margin"], f.F)
        self.hold, self.grid = f.speed.near(settings["hold"], f.F), 1
        while 1023 * self.grid < self.hold:
            self.grid *= 2
        self.bodies, self.contacts, self.joints = [], {}, []  # None for a removed joint
        self.touch_events = []
        self.set_gravity(settings["gravity"])

    def add(self, motion, shape, place, q, options, frame):
        f = self.f
        b = bodies.Body()
        b.motion, b.shape = motion, shape
        b.x = bodies.placed(f, shape, place, frame)
        b.q = list(q)
        still = motion == "fixed"
        b.v = [0 if still else f.speed.quotient(v, self.rate, f.F) for v in options["velocity"]]
        b.w = [0 if still else f.spin.quotient(w, self.rate, f.F) for w in options["spin"]]
        b.quiet, b.sleeps = 0, False
        b.friction, b.restitution = options["friction"], options["restitution"]
        b.rolling = options["rolling"]
        b.kept_v = bodies.kept(options["damping"], self.rate, f.F)
        b.kept_w = bodies.kept(options["spin_damping"], self.rate, f.F)
        b.layers, b.meets = options["layers"], options["meets"]
        b.is_fast = options["fast"]
        b.is_sensor, b.locked, locked = options["sensor"], options["locked"], options["locked"]
        b.locked_v = [locked >> k & 1 for k in range(self.n)]
        b.locked_w = [int(locked >> 3 != 0)] if self.n == 2 else [locked >> k & 1 for k in (3, 4, 5)]
        b.gravity_scale = options["gravity_scale"]
        self.attract(b)
        b.push, b.twist = [0] * self.n, [0] * len(b.w)
        b.drift, b.anchor = [0] * self.n, [0] * len(b.q)
        bodies.set_mass(f, self.n, b, options["density"])
        self.bodies.append(b)

    def attract(self, b):
        f, scale = self.f, b.gravity_scale
        b.gravity = [g if scale == 1 << f.F else f.speed.near(scale * g, f.F + f.F + 12)
                     for g in self.gravity]

    # Between ticks

    def set_gravity(self, numbers):
        self.gravity = [self.f.speed.quotient(g, self.rate * self.rate, self.f.F) for g in numbers]
        for b in self.bodies:
            self.attract(b)
            b.sleeps, b.quiet = False, 0

    def set_motion(self, index, what, numbers):
        b = self.bodies[index]
        if b.motion == "fixed":
            return
        if what == "velocity":
            b.v = [self.f.speed.quotient(v, self.rate, self.f.F) for v in numbers]
        else:
            b.w = [self.f.spin.quotient(w, self.rate, self.f.F) for w in numbers]
        b.sleeps, b.quiet = False, 0

    def place(self, index, place=None, q=None):
        """Puts a body elsewhere, or turns it."""
        b = self.bodies[index]
        if place:
            b.x = [self.f.place.near(x, self.f.F) for x in place]
        if q and not (b.shape.kind == "surface" and b.shape.is_solid):
            b.q = list(q)
        b.drift, b.anchor = [0] * self.n, [0] * len(b.q)
        self.rouse([index])
        for key, c in self.contacts.items():
            if index in key[:2]:
                c.pressure = [0] * c.count
                c.friction, c.rolling = [0] * len(c.friction), [0] * len(c.rolling)
                self.rouse(key[:2])
        for joint in self.joints:
            if joint and index in (joint.a, joint.b):
                self.rouse((joint.a, joint.b))

    def push_body(self, index, what, numbers):
        """Applies forces, torques and impulses."""
        b, f, n = self.bodies[index], self.f, self.n
        if not b.can_move:
            return
        self.find_axes(b)
        N = self.rate if what == "impulse" else self.rate ** 2
        dv, torque, scale = [0] * n, numbers, f.F
        if what != "torque":
            push = numbers[:n]
            dv = [0 if no else f.speed.quotient(x << 2 * f.F, b.mass * N, f.F)
                  for x, no in zip(push, b.locked_v)]
            if what == "push":
                torque = [0] * len(b.w)
            else:
                r = [f.lever.near((p << 12) - x, f.F + 12) for p, x in zip(numbers[n:], b.x)]
                torque, scale = cross(r, push), 2 * f.F + 6
        turn = [sum(g * t for g, t in zip(row, torque)) for row in b.G]
        dw = [f.spin.quotient(t << 2 * f.F, b.mass * N, scale + 66 - 2 * f.F) for t in turn]
        if what == "impulse":
            b.v = [f.speed.clamp(x + d) for x, d in zip(b.v, dv)]
            b.w = [f.spin.clamp(x + d) for x, d in zip(b.w, dw)]
        else:
            b.push = [f.speed.clamp(x + d) for x, d in zip(b.push, dv)]
            b.twist = [f.spin.clamp(x + d) for x, d in zip(b.twist, dw)]
        b.sleeps, b.quiet = False, 0

    def remove(self, index):
        for pair in [key for key in self.contacts if index in key[:2]]:
            self.rouse(pair[:2])
            del self.contacts[pair]
        for joint in self.joints:
            if joint and index in (joint.a, joint.b):
                self.end(joint)
        b = self.bodies[index]
        b.motion, b.can_move, b.layers, b.v, b.w = "none", False, 0, [0] * len(b.v), [0] * len(b.w)

    def rouse(self, indices):
        for i in indices:
            self.bodies[i].sleeps, self.bodies[i].quiet = False, 0

    def end(self, joint):
        self.rouse((joint.a, joint.b))
        self.joints[self.joints.index(joint)] = None

    def change(self, joint, numbers):
        self.rouse((joint.a, joint.b))
        joint.numbers.update(numbers)

    def step(self):
        for b in self.bodies:
            self.find_axes(b)
        starts = [(list(b.x), b.axes) for b in self.bodies]
        before = self.touching(self.contacts)
        pairs = list(self.pairs())
        self.hold_back()
        self.contacts = self.find_contacts(pairs)
        self.joints_before = [j for j in self.joints if j]
        islands, active = self.islands()
        broken = solver.solve(self, self.coloured(active))
        self.rest(islands)
        fast.stop_all(self, starts)
        passes = fast.passes(self, starts)
        for joint in broken:
            self.end(joint)
        now = self.touching(self.contacts)
        self.touch_events = sorted([(*pair, 0, int(pair in now)) for pair in before ^ now] +
                             [(*pair, 1 + end, 1 - end) for pair in passes for end in (0, 1)])

    def touching(self, contacts):
        """The pairs (a, b, part of a, part of b) that touch."""
        found = set()
        for (a, b, part, other), c in contacts.items():
            if c.touches:
                of_a, of_b = (self.bodies[i].shape.kind == "compound" for i in (a, b))
                found.add((a, b, part if of_a else 0, (other if of_a else part) if of_b else 0))
        return found

    def contacts_of(self, pairs):
        """The contacts of some pairs at the end of a tick."""
        for b in self.bodies:
            self.find_axes(b)
        self.hold_back()
        contacts = self.find_contacts(sorted(pairs))
        self.let_go()
        return contacts

    # 1. Axes

    def find_axes(self, b):
        f = self.f
        A = b.axes = bodies.axes(b.q)
        if self.n == 2:
            b.G = [[0]] if b.locked_w[0] else [b.inverse]
        elif not b.can_move:
            b.G = [[0] * 3] * 3
        else:
            inverse = bodies.rows(b.inverse)
            H = [[f.gyration.near(sum(A[i][r] * inverse[i][c] for i in range(3)), 96 - 2 * f.F)
                  for c in range(3)] for r in range(3)]
            b.G = bodies.rows([f.gyration.near(sum(H[r][i] * A[i][c] for i in range(3)), 96 - 2 * f.F)
                               for r, c in bodies.ENTRIES])
            b.G = [[0 if b.locked_w[i] or b.locked_w[j] else b.G[i][j] for j in range(3)]
                   for i in range(3)]

    # 2. Pairs

    def pairs(self):
        boxes = [bodies.bounds(self.f, self.n, b.x, b.axes, b.shape, self.margin_raw)
                 for b in self.bodies]
        apart = {frozenset((j.a, j.b)) for j in self.joints if j and not j.numbers["collide"]}
        for i, a in enumerate(self.bodies):
            for j in range(i + 1, len(self.bodies)):
                b = self.bodies[j]
                if (a.can_move or b.can_move) and a.layers & b.meets and b.layers & a.meets and all(
                        p[0] <= q[1] and q[0] <= p[1] for p, q in zip(boxes[i], boxes[j])) and (
                            frozenset((i, j)) not in apart):
                    yield i, j

    # Held bodies

    def hold_back(self):
        """Puts held bodies where they are held, until `let_go`."""
        f = self.f
        self.held = [(b, b.x, b.axes) for b in self.bodies if any(b.anchor)]
        for b in self.bodies:
            b.lean = [0] * len(b.w)
        for b, x, _ in self.held:
            b.x = [f.place.clamp(y - d) for y, d in zip(x, b.drift)]
            u = unit(b.anchor)
            b.axes, b.lean = bodies.axes(u), self.lean(u, b.q)

    def lean(self, u, q):
        """The turn from u to q."""
        near = self.f.spin.near
        if self.n == 2:
            return [near(u[0] * q[1] - u[1] * q[0], 60)]
        return [near(2 * (u[3] * q[i] - q[3] * u[i] - q[j] * u[k] + q[k] * u[j]), 60)
                for i, j, k in ((0, 1, 2), (1, 2, 0), (2, 0, 1))]

    def let_go(self):
        for b, x, A in self.held:
            b.x, b.axes = x, A

    def slack(self, b):
        f = self.f
        if not any(b.anchor):
            return 0
        lean = sum(map(abs, b.lean))
        radius, reach = b.shape.radius_raw, b.shape.reach
        reach = f.lever.near(abs(radius) + sum(map(abs, reach)), f.F)
        return f.lever.near((sum(map(abs, b.drift)) << 22) + reach * lean, f.F + 34)

    def note_hold(self, b, touched):
        if not touched:
            b.drift, b.anchor = [0] * len(b.v), [0] * len(b.q)
            return
        at, most = [round_shift(x, 18) for x in b.q], 32 if self.n == 2 else 16
        if any(b.anchor) and all(abs(x) <= self.hold for x in b.D) and all(
                abs(x - y) <= most for x, y in zip(at, b.anchor)):
            b.drift = list(b.D)
        else:
            b.anchor = at
            b.drift = [x - self.grid * round_div(x, self.grid) for x in b.x]

    # 3. Contacts

    def find_contacts(self, pairs):
        """The contacts of pairs, which continue those of the world."""
        old, found, f = self.contacts, {}, self.f
        for i, j in pairs:
            a, b = self.bodies[i], self.bodies[j]
            if a.shape.kind == b.shape.kind == "surface":
                continue
            d = self.pose(a, b)[0]
            slack = self.slack(a) + self.slack(b)
            margin = f.lever.clamp(self.margin + slack)
            margin_raw = self.margin_raw
            if slack:
                margin_raw = f.scalar.near((margin_raw << 6) + slack + (1 << 5), f.F + 6)
            for p in placed_parts(f, a.shape, a.x, a.axes):
                for q in placed_parts(f, b.shape, b.x, b.axes):
                    if "surface" in (p.shape.kind, q.shape.kind):
                        self.touch_surface(found, (i, j, p.number or q.number), p, q, d, old,
                                           margin_raw, margin)
                        continue
                    numbers = (p.number, q.number) if p.part else (q.number, 0)
                    touch = manifold(p.shape, q.shape, *self.pose(p, q)[1:], margin)
                    if p.part and touch[1]:
                        touch = out_of_part(f, p.part, *touch)
                    key = (i, j, *numbers)
                    self.add_contact(found, key, (p.part, q.part), d, touch, old.get(key))
        return found

    def touch_surface(self, contacts, numbers, p, q, d, old, margin_raw, margin):
        a, b = self.bodies[numbers[0]], self.bodies[numbers[1]]
        ground, other = (p, q) if p.shape.kind == "surface" else (q, p)
        found = terrain.contacts(self.f, ground.shape, other.shape, *self.pose(ground, other)[1:],
                                 margin_raw, margin)
        parts = {key[3]: c for key, c in old.items() if key[:3] == numbers}
        _, r, t = self.pose(a, b)
        for c in found:
            if not c.points:
                continue
            n, points = c.n, c.points
            if ground is q:
                n = [ratio.near(-x, 60) for x in combine(n, r)]
                points = [(placed(t, x, r), s, name) for x, s, name in points]
            self.add_contact(contacts, (*numbers, c.facet.index), (p.part, q.part), d, (n, points),
                             terrain.last_of(found, c, parts))

    def pose(self, a, b):
        """The offset of b from a, and b's axes and position in a's frame."""
        f = self.f
        d = [f.lever.near(y - x, f.F + 12) for x, y in zip(a.x, b.x)]
        t = [f.lever.near(dot(axis, d), f.F + 36) for axis in a.axes]
        r = [[ratio.near(dot(u, v), 60) for u in a.axes] for v in b.axes]
        return d, r, t

    def add_contact(self, contacts, key, parts, offset, found, last):
        normal, points = found
        if not points:
            return
        a, b = self.bodies[key[0]], self.bodies[key[1]]
        c = contacts[key] = Contact(self.n)
        c.offset, c.normal, c.points = offset, normal, points
        c.count, c.feature = len(points), [p[2] for p in points]
        pressures = dict(zip(last.feature, last.pressure)) if last else {}
        c.pressure = [pressures.get(feature, 0) for feature in c.feature]
        if last:
            c.friction, c.rolling, c.touches = last.friction, last.rolling, last.touches
        made = [part or body for part, body in zip(parts, (a, b))]
        c.friction_of, c.restitution_of = [m.friction for m in made], [m.restitution for m in made]
        c.resistance = max(0, *(m.rolling for m in made))
        radii = [s.radius_raw for s in (part.shape if part else body.shape
                                        for part, body in zip(parts, (a, b)))
                 if s.kind in ("ball", "capsule")]
        c.radius = max(min(radii), 0) if radii else 0
        c.is_sensed = any(x.is_sensor for x in (a, b, *made))
        if c.is_sensed:
            c.pressure, c.friction = [0] * c.count, [0] * (1 if self.n == 2 else 3)
            c.rolling = list(c.friction)
            c.touches = any(p[1] <= 0 for p in points)

    # 4. Islands

    def islands(self):
        root = list(range(len(self.bodies)))

        def find(i):
            while root[i] != i:
                i = root[i]
            return i
        solid = [key for key, c in self.contacts.items() if not c.is_sensed]
        linked = [key[:2] for key in solid] + [(j.a, j.b) for j in self.joints if j]
        for i, j in linked:
            if self.bodies[i].can_move and self.bodies[j].can_move:
                a, b = find(i), find(j)
                root[max(a, b)] = min(a, b)
        groups = {}
        for i, b in enumerate(self.bodies):
            if b.can_move:
                groups.setdefault(find(i), []).append(i)
        awake = {g for g, members in groups.items() if any(not self.bodies[i].sleeps for i in members)}
        for pair in linked:
            for i, j in (pair, pair[::-1]):
                other = self.bodies[j]
                if self.bodies[i].can_move and other.motion == "kinematic" and any(other.v + other.w):
                    awake.add(find(i))
        for g, members in groups.items():
            for i in members:
                b = self.bodies[i]
                if g in awake and b.sleeps:
                    b.quiet = 0
                b.sleeps = g not in awake
        active = [key for key in solid if self.is_awake(key[0]) or self.is_awake(key[1])]
        return [groups[g] for g in groups if g in awake], active

    def is_awake(self, i):
        return self.bodies[i].can_move and not self.bodies[i].sleeps

    # 5. Order

    def coloured(self, active):
        used, order = {}, []
        for pair in sorted(active):
            mine = [used.setdefault(i, set()) for i in pair[:2] if self.is_awake(i)]
            greatest = 47 if len(mine) == 2 else 62
            colour = next((c for c in range(greatest, -1, -1) if not any(c in s for s in mine)), 63)
            for s in mine:
                s.add(colour)
            order.append((colour, pair))
        self.touched = {i for i, colours in used.items() if colours}
        return [pair for _, pair in sorted(order)]

    # 9. Rest

    def rest(self, islands):
        for members in islands:
            for i in members:
                b = self.bodies[i]
                slow = all(abs(v) <= self.sleep for v in b.v) and all(
                    abs(w) <= self.sleep_spin for w in b.w)
                b.quiet = min(b.quiet + 1, 255) if slow else 0
                if self.hold > 0:
                    self.note_hold(b, i in self.touched)
                b.push, b.twist = [0] * len(b.v), [0] * len(b.w)
            if self.sleep > 0 and all(self.bodies[i].quiet >= min(max(self.ticks_per_second // 2, 1), 255)
                                      for i in members):
                for i in members:
                    b = self.bodies[i]
                    b.sleeps, b.v, b.w = True, [0] * len(b.v), [0] * len(b.w)

    def state(self):
        """The lines printed by twin_states.cpp for one tick."""
        for i, b in enumerate(self.bodies):
            if b.motion == "none":
                continue
            yield " ".join(map(str, ["body", i, *b.x, *b.q, *b.v, *b.w, *b.drift, *b.anchor,
                                     b.quiet, int(b.sleeps)]))
        for key, c in sorted(self.contacts.items()):
            points = [x for p in zip(c.feature, c.pressure) for x in p]
            yield " ".join(map(str, ["contact", *key, int(c.touches), c.count, *points, *c.friction,
                                     *c.rolling]))
        for i, j in enumerate(self.joints):
            if j:
                yield " ".join(map(str, ["joint", i, j.a, j.b, *j.push, *j.turn]))
        for a, b, of_a, of_b, _, begins in self.touch_events:
            yield " ".join(map(str, ["event", a, b, of_a, of_b, begins]))
