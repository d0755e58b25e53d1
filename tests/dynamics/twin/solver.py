# SPDX-License-Identifier: MIT
"""docs/dynamics.md, "A tick": steps 6 to 8."""
from math import isqrt

from body import axes, carried, turned
from fixed import ONE, cross, dot, ratio, unit
from joints import Solved

SOFT = 1019539814, 43903628, 54202010
WALL = 1047058379, 86454362, 26683445


class Row:
    """Moments, responses and effective mass; the unit vector u with its shares."""


class Solver:
    def __init__(self, world):
        self.world, self.f, self.n = world, world.f, world.n
        F = self.f.F
        self.spin_shift = 38 - F + F + 12

    # 6. Rows

    def shares(self, a, b):
        if a.can_move and b.can_move:
            return ratio.quotient(b.mass, a.mass + b.mass), ratio.quotient(a.mass, a.mass + b.mass)
        return ONE * a.can_move, ONE * b.can_move

    def prepare(self, pair):
        f, n, world = self.f, self.n, self.world
        c = self.contact = world.contacts[pair]
        a, b = c.a, c.b = world.bodies[pair[0]], world.bodies[pair[1]]
        c.alpha, c.beta = self.shares(a, b)
        c.soft = SOFT if c.alpha and c.beta else WALL
        A = a.axes
        c.n = [ratio.near(sum(A[i][k] * c.normal[i] for i in range(n)), 60) for k in range(n)]
        self.Ga = [[f.gyration.near(c.alpha * x, 96 - 2 * f.F) for x in row] for row in a.G]
        self.Gb = [[f.gyration.near(c.beta * x, 96 - 2 * f.F) for x in row] for row in b.G]
        p = [[f.lever.near(sum(A[i][k] * point[i] for i in range(n)), f.F + 36) for k in range(n)]
             for point, _, _ in c.points]
        middle = [f.lever.quotient(sum(x[k] for x in p), c.count, f.F + 6) for k in range(n)]
        if n == 2:
            tangents = [[c.n[1], -c.n[0]]]
        else:
            e = min(range(3), key=lambda i: abs(c.n[i]))
            t1 = unit(cross(c.n, [int(i == e) for i in range(3)]))
            tangents = [t1, [ratio.near(x, 60) for x in cross(c.n, t1)]]
        c.rows = [self.row(x, c.n) for x in p]
        c.friction_rows = [self.row(middle, [f.ratio.clamp(x) for x in t]) for t in tangents]
        if n == 3:
            self.twist(p, middle)
        c.rolls = c.resistance > 0 and c.radius > 0
        if c.rolls:
            self.prepare_rolling()
        c.gap = [f.speed.near(s, f.F + 6) for _, s, _ in c.points]
        friction = c.friction_of[0] * c.friction_of[1]
        c.grip = f.ratio.clamp(isqrt(max(friction, 0) << 60 - 2 * f.F))
        c.bounce = ratio.near(max(c.restitution_of), f.F)
        c.closing = [self.rate(row, a.v, a.w, b.v, b.w) for row in c.rows]
        c.gap_now = list(c.gap)
        c.pushed = [False] * c.count

    def row(self, p, u):
        c, f = self.contact, self.f
        ra = [f.arm.clamp(x) for x in p]
        rb = [f.arm.clamp(x - d) for x, d in zip(p, c.offset)]
        row = Row()
        row.u = u
        row.au = [ratio.near(c.alpha * x, 60) for x in u]
        row.bu = [ratio.near(c.beta * x, 60) for x in u]
        lost = self.locked(row, c.a, c.b)
        row.ca = self.moment(c.a, ra, u)
        row.cb = self.moment(c.b, rb, u)
        self.respond(row, lost)
        return row

    def locked(self, row, a, b):
        """Removes the locked axes from a push; returns the loss."""
        lost = 0
        for body, push in (a, row.au), (b, row.bu):
            if body.can_move:
                gone = [x if no else 0 for x, no in zip(push, body.locked_v)]
                push[:] = [x - y for x, y in zip(push, gone)]
                lost += self.f.give.near(dot(gone, row.u), 60)
        return lost

    def moment(self, body, r, u):
        f = self.f
        if body.motion == "fixed":
            return [0] * (1 if self.n == 2 else 3)
        return [f.moment.near(x, f.F + 36) for x in cross(r, u)]

    def respond(self, row, lost=0):
        f = self.f
        shift = 66 - 2 * f.F + f.F + 6
        row.ja = [f.response.near(dot(G, row.ca), shift) for G in self.Ga]
        row.jb = [f.response.near(dot(G, row.cb), shift) for G in self.Gb]
        ga = f.give.near(dot(row.ca, row.ja), 44)
        gb = f.give.near(dot(row.cb, row.jb), 44)
        whole = ONE - lost + max(ga, 0) + max(gb, 0)
        row.m = 0 if whole < ONE >> 6 else ratio.quotient(ONE, whole)

    def twist(self, p, middle):
        c, f = self.contact, self.f
        lengths = [f.arm.clamp(isqrt(sum((x - y) ** 2 for x, y in zip(q, middle)))) for q in p]
        l = max(lengths)
        c.reach = [ratio.quotient(x, l) for x in lengths]
        row = c.twist = Row()
        row.u = row.au = row.bu = [0, 0, 0]
        moment = [f.moment.near(l * x, f.F + 36) for x in c.n]
        row.ca = [0] * 3 if c.a.motion == "fixed" else moment
        row.cb = [0] * 3 if c.b.motion == "fixed" else moment
        self.respond(row)

    def prepare_rolling(self):
        c, f = self.contact, self.f
        c.reach_of_roll = f.arm.near(c.radius, f.F)
        c.resist = ratio.near(c.resistance, f.F)
        shift = 66 - 2 * f.F + f.F + 6
        c.Ja, c.Jb = [[[f.response.near(x * c.reach_of_roll, shift) for x in row] for row in G]
                      for G in (self.Ga, self.Gb)]
        give = [f.give.near(c.reach_of_roll * max(sum(map(abs, row)) for row in J), 44)
                for J in (c.Ja, c.Jb)]
        c.roll_mass = ratio.quotient(ONE, ONE + sum(give))

    # 7. Substeps

    def rate(self, row, va, wa, vb, wb):
        f = self.f
        r = f.sum.near(dot(row.u, [y - x for x, y in zip(va, vb)]), f.F + 42)
        return f.speed.near(r + dot(row.cb, wb) - dot(row.ca, wa), f.F + 34)

    def speed_along(self, c, row):
        return self.rate(row, c.a.v, c.a.w, c.b.v, c.b.w)

    def apply(self, c, row, p):
        if p == 0:
            return
        near, clamp, turn = self.f.speed.near, self.f.speed.clamp, self.f.spin.near
        F, k = self.f.F + 42, self.spin_shift
        a, b = c.a, c.b
        if a.can_move:
            a.v = [clamp(v - near(u * p, F)) for v, u in zip(a.v, row.au)]
            a.w = [clamp(w - turn(j * p, k)) for w, j in zip(a.w, row.ja)]
        if b.can_move:
            b.v = [clamp(v + near(u * p, F)) for v, u in zip(b.v, row.bu)]
            b.w = [clamp(w + turn(j * p, k)) for w, j in zip(b.w, row.jb)]

    def push(self, c, i, p):
        P = max(self.f.impulse.clamp(c.pressure[i] + p), 0)
        change, c.pressure[i] = P - c.pressure[i], P
        self.apply(c, c.rows[i], change)
        c.pushed[i] |= P > 0

    def point(self, c, i, biased):
        f, row = self.f, c.rows[i]
        v = self.speed_along(c, row)
        gap = f.speed.clamp(c.gap[i] + self.rate(row, c.a.D, c.a.E, c.b.D, c.b.E))
        c.gap_now[i] = gap
        scale = f.F + 42
        if gap > 0:
            p = f.impulse.near(-row.m * (v + gap), scale)
        elif biased:
            rigid, pull, loss = c.soft
            t = f.speed.near(rigid * v + max(pull * gap, -self.world.push << 30), scale)
            p = f.impulse.near(-row.m * t - loss * c.pressure[i], scale)
        else:
            p = f.impulse.near(-row.m * v, scale)
        self.push(c, i, p)

    def friction(self, c):
        f = self.f
        near, scale = f.impulse.near, f.F + 42
        T = c.friction = list(c.friction)
        if self.n == 3:
            row = c.twist
            L = f.impulse.clamp(sum(near(x * y, scale) for x, y in zip(c.reach, c.pressure)))
            limit = near(c.grip * L, scale)
            t = f.impulse.clamp(T[2] - near(row.m * self.speed_along(c, row), scale))
            t = min(max(t, -limit), limit)
            change, T[2] = f.impulse.clamp(t - T[2]), t
            self.apply(c, row, change)
        L = f.impulse.clamp(sum(c.pressure))
        limit = near(c.grip * L, scale)
        t = [f.impulse.clamp(x - near(row.m * self.speed_along(c, row), scale))
             for x, row in zip(T, c.friction_rows)]
        if self.n == 2:
            t[0] = min(max(t[0], -limit), limit)
        else:
            square = t[0] * t[0] + t[1] * t[1]
            if square > limit * limit:
                r = f.length.clamp(isqrt(square - 1) + 1)
                t = [f.impulse.quotient(x * limit, r, f.F + 12) for x in t]
        for i, row in enumerate(c.friction_rows):
            change, T[i] = f.impulse.clamp(t[i] - T[i]), t[i]
            self.apply(c, row, change)

    def roll(self, c, k, p):
        turn, shift = self.f.spin, self.spin_shift
        for body, J, sign in (c.a, c.Ja, -1), (c.b, c.Jb, 1):
            if body.can_move:
                body.w = [turn.clamp(w + sign * turn.near(row[k] * p, shift))
                          for w, row in zip(body.w, J)]

    def rolling(self, c):
        f = self.f
        near, scale = f.impulse.near, f.F + 42
        limit = near(c.resist * f.impulse.clamp(sum(c.pressure)), scale)
        rates = [f.speed.near(c.reach_of_roll * (y - x), f.F + 34) for x, y in zip(c.a.w, c.b.w)]
        t = [f.impulse.clamp(x - near(c.roll_mass * v, scale)) for x, v in zip(c.rolling, rates)]
        if self.n == 2:
            t[0] = min(max(t[0], -limit), limit)
        else:
            square = sum(x * x for x in t)
            if square > limit * limit:
                r = f.length.clamp(isqrt(square - 1) + 1)
                t = [f.impulse.quotient(x * limit, r, f.F + 12) for x in t]
        for k, x in enumerate(t):
            self.roll(c, k, f.impulse.clamp(x - c.rolling[k]))
        c.rolling = t

    def lock(self, b):
        if b.locked:
            b.v = [0 if no else v for v, no in zip(b.v, b.locked_v)]
            b.w = [0 if no else w for w, no in zip(b.w, b.locked_w)]

    def points(self, c, substep, biased):
        capacity = 2 if self.n == 2 else 4
        first = substep if biased else substep + capacity // 2
        for k in range(first, first + capacity):
            if k % capacity < c.count:
                self.point(c, k % capacity, biased)

    def substep(self, contacts, joints, s):
        f, world = self.f, self.world
        awake = [b for b in world.bodies if b.can_move and not b.sleeps]
        for b in awake:
            b.v = [f.speed.clamp(v + g) for v, g in zip(b.v, b.gravity)]
            b.v = [f.speed.clamp(v + p) for v, p in zip(b.v, b.push)]
            b.w = [f.spin.clamp(w + t) for w, t in zip(b.w, b.twist)]
            if b.kept_v != ONE:
                b.v = [f.speed.near(v * b.kept_v, f.F + 42) for v in b.v]
            if b.kept_w != ONE:
                b.w = [f.spin.near(w * b.kept_w, 58) for w in b.w]
            self.lock(b)
            if not b.is_round:
                b.half = axes(turned(b.q, b.w, 2))
                b.w = carried(f, b, b.w, axes(b.q), b.half)
                self.lock(b)
        for j in joints:
            j.warm_start()
        for c in contacts:
            for row, p in zip(c.rows, c.pressure):
                self.apply(c, row, p)
            for row, p in zip(c.friction_rows, c.friction):
                self.apply(c, row, p)
            if self.n == 3:
                self.apply(c, c.twist, c.friction[2])
            if c.rolls:
                for k, p in enumerate(c.rolling):
                    self.roll(c, k, p)
        for j in joints:
            j.solve(True)
        for c in contacts:
            self.points(c, s, True)
        for b in world.bodies:
            if b.motion == "kinematic" and any(b.v + b.w) or b.can_move and not b.sleeps:
                if b.can_move:
                    self.lock(b)
                before, b.x = b.x, [f.place.clamp(x + v) for x, v in zip(b.x, b.v)]
                b.D = [f.speed.clamp(d + x - y) for d, x, y in zip(b.D, b.x, before)]
                b.E = [f.spin.clamp(x + w) for x, w in zip(b.E, b.w)]
                b.q = turned(b.q, b.w)
                if b.can_move and not b.is_round:
                    b.w = carried(f, b, b.w, b.half, axes(b.q))
                    self.lock(b)
        for i in {i for j in joints for i in (j.joint.a, j.joint.b)}:
            world.find_axes(world.bodies[i])
        for j in joints:
            j.aim()
        for j in joints:
            j.solve(False)
        for c in contacts:
            self.points(c, s, False)
            if c.rolls:
                self.rolling(c)
            self.friction(c)

    # 8. Bounce

    def bounce(self, c):
        f, scale = self.f, self.f.F + 42
        for i, row in enumerate(c.rows):
            if c.pushed[i] and c.closing[i] < -self.world.bounce:
                back = f.speed.near(c.bounce * c.closing[i], scale)
                t = f.speed.clamp(self.speed_along(c, row) + back)
                self.push(c, i, f.impulse.near(-row.m * t, scale))


def solve(world, order):
    solver = Solver(world)
    for b in world.bodies:
        b.D, b.E = list(b.drift), list(b.lean)
    for pair in order:
        solver.prepare(pair)
    world.let_go()
    contacts = [world.contacts[pair] for pair in order]
    awake = [world.is_awake(i) for i in range(len(world.bodies))]
    joints = [Solved(solver, j) for j in world.joints if j and (awake[j.a] or awake[j.b])]
    for j in joints:
        j.aim()
    for s in range(world.substeps):
        solver.substep(contacts, joints, s)
    for c in contacts:
        if c.bounce:
            solver.bounce(c)
        gaps = c.gap_now if world.hold > 0 else c.gap
        c.touches = any(g <= 0 for g in gaps) or any(c.pushed)
    return [j.joint for j in joints if j.broken]
