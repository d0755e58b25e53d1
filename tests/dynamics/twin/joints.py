# SPDX-License-Identifier: MIT
"""docs/joints.md."""
from math import isqrt

from fixed import ONE, PI, PI_BITS, Format, arc, cross, dot, ratio, squared, unit

TURN, TURN_SHARE = Format(31, 28), Format(31, 24)
HARD = 963621081, 271712043, 110120743
PUSHES = {"distance": "distance", "ball": "point", "cone": "point", "hinge": "point", "weld": "point",
          "slider": "line", "wheel": "line"}
TURNS = {"cone": "swinging", "hinge": "turning", "weld": "stiff", "slider": "stiff", "wheel": "turning"}


class Joint:
    """A joint as added (numbers of the scalar, frames as axes), and its impulses."""

    def __init__(self, kind, n, a, b, anchors, keys):
        self.kind, self.n, self.a, self.b, self.anchors = kind, n, a, b, anchors
        no_frame = [[ONE * (i == k) for k in range(n)] for i in range(n)]
        one = keys.pop("one")
        self.numbers = {"collide": 0, "break": 0, "least": 0, "most": one, "frequency": 0, "damping": one,
                        "length": one if kind == "distance" else 0, "angle": 0, "max_force": 0, "cone": 0, "limits": None,
                        "motor": [0, 0], "frame_a": no_frame, "frame_b": no_frame}
        self.numbers.update(keys)
        counts = {"distance": 3, "point": n, "line": n + 3, "turning": 3 if n == 2 else 5,
                  "stiff": 1 if n == 2 else 3, "swinging": 3, None: 0}
        self.push = [0] * counts[PUSHES[kind]]
        self.turn = [0] * counts[TURNS.get(kind)]


class Row:
    def __init__(self, law, soft=HARD, target=0, most=None):
        self.law, self.soft, self.target, self.most = law, soft, target, most


class Solved:
    """A joint during a tick."""

    def __init__(self, solver, joint):
        self.solver, self.joint, self.f, self.n = solver, joint, solver.f, solver.n
        world, f, k = solver.world, self.f, joint.numbers
        self.a, self.b = world.bodies[joint.a], world.bodies[joint.b]
        self.alpha, self.beta = solver.shares(self.a, self.b)
        self.rate = world.rate
        self.broken = False
        self.torque = None  # the most of row 0 of the turns
        n = self.n
        block, turns = PUSHES[joint.kind], TURNS.get(joint.kind)
        self.pushes, self.turns = [None] * len(joint.push), [None] * len(joint.turn)
        spring = Row("spring", self.softness()) if k["frequency"] > 0 else None
        if block == "point":
            self.pushes = [Row("equal") for _ in range(n)]
            if joint.kind == "ball":
                if spring:
                    self.pushes = [Row("spring", spring.soft) for _ in range(n)]
                if k["max_force"] > 0:
                    for row in self.pushes:
                        row.most = self.over_masses(k["max_force"], f.impulse)
        elif block == "distance":
            self.pushes[0] = spring
            if k["least"] >= k["most"]:
                self.pushes[1] = Row("equal")
            else:
                if k["least"] > 0:
                    self.pushes[1] = Row("limit")
                self.pushes[2] = Row("limit")
        else:
            speed, force = k["motor"]
            if joint.kind == "slider" and force > 0:
                self.pushes[0] = Row("motor", target=f.speed.quotient(speed, self.rate, f.F),
                                     most=self.over_masses(force, f.impulse))
            self.pushes[1] = spring
            if k["limits"]:
                self.pushes[2], self.pushes[3] = Row("limit"), Row("limit")
            self.pushes[4:] = [Row("equal") for _ in range(n - 1)]
        if turns == "stiff":
            soft = spring if joint.kind == "weld" else None
            self.turns = [Row("spring", soft.soft) if soft else Row("equal") for _ in self.turns]
        elif turns == "swinging":
            if k["cone"] > 0:
                self.turns[0] = Row("limit")
            if k["limits"]:
                self.turns[1], self.turns[2] = Row("limit"), Row("limit")
        elif turns == "turning":
            speed, torque = k["motor"]
            if torque > 0:
                self.turns[0] = Row("motor", target=f.spin.quotient(speed, self.rate, f.F))
                self.torque = self.over_masses(torque, f.torque)
            if joint.kind == "hinge" and spring:
                self.turns[0] = Row("spring", spring.soft)
            if joint.kind == "hinge" and k["limits"]:
                self.turns[1], self.turns[2] = Row("limit"), Row("limit")
            self.turns[3:] = [Row("equal") for _ in self.turns[3:]]
        self.strength = self.over_masses(k["break"], f.impulse) if k["break"] > 0 else None
        joint.push = [p if row else 0 for p, row in zip(joint.push, self.pushes)]
        joint.turn = [p if row else 0 for p, row in zip(joint.turn, self.turns)]

    def softness(self):
        F, k = self.f.F, self.joint.numbers
        w = ratio.quotient(2 * k["frequency"] * PI, self.rate, F + PI_BITS)
        z = max(k["damping"], 0)
        p = w * ((2 * z << 30 - F) + w)  # times 2^60
        whole = (1 << 60) + p
        return ratio.quotient(p, whole), ratio.quotient(w * w, whole), ratio.quotient(1 << 60, whole)

    def over_masses(self, x, kind):
        """Numbers of the scalar divided by masses with 2 F bits."""
        square = self.rate * self.rate
        return kind.clamp(sum(kind.quotient(x, body.mass * square, -self.f.F)
                              for body in (self.a, self.b) if body.can_move))

    # Geometry

    def aim(self):
        f, n, k = self.f, self.n, self.joint.numbers
        reach = f.reach
        a, b = self.a, self.b
        self.Ga = [[f.gyration.near(self.alpha * x, 96 - 2 * f.F) for x in row] for row in a.G]
        self.Gb = [[f.gyration.near(self.beta * x, 96 - 2 * f.F) for x in row] for row in b.G]

        def out(body, v, kind, bits):
            return [kind.near(dot(column, v), 30 + bits) for column in zip(*body.axes)]
        self.ra, self.rb = (out(body, p, reach, f.F) for body, p in zip((a, b), self.joint.anchors))
        self.d = [reach.clamp(y - x + s - r) for x, y, r, s in zip(a.x, b.x, self.ra, self.rb)]
        if self.joint.kind in TURNS:
            self.fa = [out(a, axis, ratio, 30) for axis in k["frame_a"]]
            self.fb = [out(b, axis, ratio, 30) for axis in k["frame_b"]]
        fine = 12  # numbers of the scalar in Reach

        def world_axis(i):
            return [ONE * (i == c) for c in range(n)]

        def minus(v):
            return [-x for x in v]

        def cosine(i, j):
            return ratio.near(dot(self.fa[i], self.fb[j]), 60)
        block = PUSHES[self.joint.kind]
        if block == "point":
            for i in range(n):
                self.push(i, world_axis(i), self.d[i])
        elif block == "distance":
            l = reach.clamp(isqrt(squared(self.d)))
            e = unit(self.d)
            self.push(0, e, l - (k["length"] << fine))
            self.push(1, e, l - ((k["most"] if k["least"] >= k["most"] else k["least"]) << fine))
            self.push(2, minus(e), (k["most"] << fine) - l)
        else:
            axis = self.fa[0]
            h = reach.near(dot(axis, self.d), f.F + 42)
            lower, upper = k["limits"] or (0, 0)
            self.push(0, axis, 0, True)
            self.push(1, axis, h - (k["length"] << fine), True)
            self.push(2, axis, h - (lower << fine), True)
            self.push(3, minus(axis), (upper << fine) - h, True)
            for i in range(1, n):
                self.push(3 + i, self.fa[i], reach.near(dot(self.fa[i], self.d), f.F + 42), True)
        turns = TURNS.get(self.joint.kind)
        if turns == "turning":
            axis = [ONE] if n == 2 else self.fa[2]
            angle = self.angle(cosine(0, 0), cosine(1, 0))
            is_spring = self.turns[0] and self.turns[0].law == "spring"
            self.turn(0, axis, f.spin.near((angle << f.F) - (k["angle"] << 28), f.F + 28) if is_spring else 0)
            if self.turns[1]:
                lower, upper = k["limits"]
                self.turn(1, axis, f.spin.near((angle << f.F) - (lower << 28), f.F + 28))
                self.turn(2, minus(axis), f.spin.near((upper << 28) - (angle << f.F), f.F + 28))
            if n == 3:
                self.turn(3, self.fa[0], f.spin.near(-cosine(1, 2), 30))
                self.turn(4, self.fa[1], f.spin.near(cosine(0, 2), 30))
        elif turns == "swinging":
            if self.turns[0]:
                self.swing(cosine(2, 2))
            if self.turns[1]:
                self.twist()
        elif turns == "stiff":
            if n == 2:
                self.turn(0, [ONE], self.angle(cosine(0, 0), cosine(1, 0)))
            else:
                products = [cross(x, y) for x, y in zip(self.fa, self.fb)]
                for i in range(3):
                    self.turn(i, world_axis(i), f.spin.near(sum(p[i] for p in products), 61))

    def angle(self, x, y):
        return self.f.spin.near(arc(y, x) * PI, 31 + PI_BITS)

    def swing(self, x):
        spin, F = self.f.spin, self.f.F
        s = [ratio.near(c, 60) for c in cross(self.fb[2], self.fa[2])]
        e = unit(s) if any(s) else self.fa[0]
        swing = abs(self.angle(x, ratio.clamp(isqrt(squared(s)))))
        self.turn(0, e, spin.near((self.joint.numbers["cone"] << 28) - (swing << F), F + 28))

    def twist(self):
        spin, F, fa, fb = self.f.spin, self.f.F, self.fa, self.fb
        lower, upper = self.joint.numbers["limits"]
        twist = self.angle(ratio.near(dot(fa[0], fb[0]) + dot(fa[1], fb[1]), 61),
                           ratio.near(dot(fa[1], fb[0]) - dot(fa[0], fb[1]), 61))
        both = [x + y for x, y in zip(fa[2], fb[2])]
        m = unit(both) if any(both) else fa[2]
        h = ratio.clamp(isqrt(squared(both) // 4))

        def gap(x):  # x times 2^(F + 28)
            return spin.near(h * spin.near(x, F + 28), 58)
        self.turn(1, m, gap((twist << F) - (lower << 28)))
        self.turn(2, [-x for x in m], gap((upper << 28) - (twist << F)))

    def push(self, i, u, gap, line=False):
        row, f, solver = self.pushes[i], self.f, self.solver
        if row is None:
            return
        row.u = u
        row.au = [ratio.near(self.alpha * x, 60) for x in u]
        row.bu = [ratio.near(self.beta * x, 60) for x in u]
        lost = solver.locked(row, self.a, self.b)
        arm = [x + y for x, y in zip(self.ra, self.d)] if line else self.ra
        row.ca = solver.moment(self.a, [f.arm.near(x, f.F + 12) for x in arm], u)
        row.cb = solver.moment(self.b, [f.arm.near(x, f.F + 12) for x in self.rb], u)
        solver.Ga, solver.Gb = self.Ga, self.Gb
        solver.respond(row, lost)
        row.gap = f.speed.clamp(gap)

    def turn(self, i, c, gap):
        row, f = self.turns[i], self.f
        if row is None:
            return
        near = f.gyration.near
        ya, yb = ([near(dot(line, c), 96 - 2 * f.F) for line in G] for G in (self.Ga, self.Gb))
        s = near(dot(c, ya), 96 - 2 * f.F) + near(dot(c, yb), 96 - 2 * f.F)
        row.c, row.gap = c, gap
        row.sa = [TURN_SHARE.quotient(y, s) if s > 0 else 0 for y in ya]
        row.sb = [TURN_SHARE.quotient(y, s) if s > 0 else 0 for y in yb]
        if i == 0 and self.torque is not None:
            row.most = max(TURN.near(self.torque * s, f.F + 32 + 66 - 2 * f.F), 0)

    # Solving

    def apply_turn(self, row, p):
        near, a, b = self.f.spin.near, self.a, self.b
        clamp = self.f.spin.clamp
        if a.can_move:
            a.w = [clamp(w - near(s * p, 52)) for w, s in zip(a.w, row.sa)]
        if b.can_move:
            b.w = [clamp(w + near(s * p, 52)) for w, s in zip(b.w, row.sb)]

    def warm_start(self):
        for row, p in zip(self.turns, self.joint.turn):
            if row:
                self.apply_turn(row, p)
        for row, p in zip(self.pushes, self.joint.push):
            if row:
                self.solver.apply(self, row, p)

    def next(self, row, m, v, P, kind, rates, biased):
        """The impulse after one more solve, and the impulse applied."""
        scale = kind.f + 30
        if row.law == "motor":
            p = kind.near(-m * (v - row.target), scale)
        elif row.law == "limit" and row.gap > 0:
            p = kind.near(-m * (v + row.gap), scale)
        elif biased or row.law == "spring":
            rigid, pull, loss = row.soft
            t = rates.near(rigid * v + pull * row.gap, scale)
            p = kind.near(-m * t - loss * P, scale)
        else:
            p = kind.near(-m * v, scale)
        new = kind.clamp(P + p)
        if row.law == "limit":
            new = max(new, 0)
        if row.most is not None:
            new = min(max(new, -row.most), row.most)
        return new, kind.clamp(new - P)

    def solve(self, biased):
        f, joint, a, b = self.f, self.joint, self.a, self.b
        for i, row in enumerate(self.turns):
            if row:
                v = f.spin.near(dot(row.c, [y - x for x, y in zip(a.w, b.w)]), 58)
                joint.turn[i], p = self.next(row, ONE, v, joint.turn[i], TURN, f.spin, biased)
                self.apply_turn(row, p)
        for i, row in enumerate(self.pushes):
            if row:
                v = self.solver.speed_along(self, row)
                joint.push[i], p = self.next(row, row.m, v, joint.push[i], f.impulse, f.speed, biased)
                self.solver.apply(self, row, p)
        if not biased and self.strength is not None:
            load = [0] * self.n
            for row, P in zip(self.pushes, joint.push):
                if row:
                    load = [f.length.clamp(x + f.length.near(u * P, f.F + 42)) for x, u in zip(load, row.u)]
            self.broken |= squared(load) > self.strength ** 2
