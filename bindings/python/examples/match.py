# SPDX-License-Identifier: MIT
"""The scripted match that every binding plays: boxes fall on a floor, a scene holds a ball around
each, and rays are cast down at them. Prints a digest of all results, 16 digits equal to those of
tests/c/match.cpp."""
import detent
from detent import ONE, UNIT, d3

BODIES, TICKS, RAYS = 12, 120, 8
MASK = (1 << 64) - 1


class Match:
    def __init__(self, context):
        self.state, self.sum = 1, 0
        self.world, self.scene = context.world3(), context.scene3()
        self.world.add(d3.aabb((-20 * ONE, -ONE, -20 * ONE), (20 * ONE, 0, 20 * ONE)),
                       motion=detent.FIXED)
        self.boxes, self.balls = [], []
        for i in range(BODIES):
            x = self.draw(4 * ONE) - 2 * ONE
            center = (x, (2 + 2 * i) * ONE, self.draw(4 * ONE) - 2 * ONE)
            half = tuple(ONE // 2 + self.draw(ONE // 2) for _ in range(3))
            self.boxes.append(self.world.add(d3.obb(center, half)))
            self.balls.append(self.scene.add(d3.sphere(center, ONE), user=i))

    def draw(self, count):
        self.state = (self.state * 1664525 + 1013904223) & 0xffffffff
        return (self.state >> 8) % count

    def mix(self, value):
        self.sum = (self.sum * 6364136223846793005 + value) & MASK

    def tick(self, tick):
        if tick % 10 == 5:
            self.world.set_velocity(self.boxes[tick // 10], (ONE, 5 * ONE, 0))
        self.world.step()
        for box, ball in zip(self.boxes, self.balls):
            self.scene.replace(ball, d3.sphere(self.world.position(box), ONE))
        for _ in range(RAYS):
            x = self.draw(8 * ONE) - 4 * ONE
            origin = (x, 30 * ONE, self.draw(8 * ONE) - 4 * ONE)
            hit = self.scene.raycast(d3.ray(origin, (0, -UNIT, 0), 40 * ONE), layers=1)
            if hit:
                self.mix(hit.distance & 0xffffffff)
                self.mix(hit.id.index)
                self.mix(hit.normal[1] & 0xffffffff)
            else:
                self.mix(0xffffffff)
        self.mix(self.world.digest())
        self.mix(self.scene.digest())


FRAMES = 120


def press(frame, player):
    """A player's input; it takes effect two frames later."""
    return bytes((frame // (7 + 4 * player) % 5, frame // 3 % 4) if frame < 80 else (0, 0))


def simulate(world, balls, inputs):
    words = world.words
    for player, (speed, which) in enumerate(inputs):
        words[player] += speed
        if speed:
            world.set_velocity(balls[2 * player + which % 2], ((speed - 2) * ONE, which * ONE, 0))
    world.words = words
    world.step()


def play_for_two(context, match):
    """A two-player match between two sessions in one program. Packets are delayed; every fifth is
    lost."""
    start = context.world3()
    start.add(d3.aabb((-20 * ONE, -ONE, -20 * ONE), (20 * ONE, 0, 20 * ONE)), motion=detent.FIXED)
    balls = [start.add(d3.sphere(((2 * i - 3) * ONE, 2 * ONE, 0), ONE // 2)) for i in range(4)]
    sessions = [context.session3(start, match=4711, self=i, input_size=2, words=2,
                                 replay_every=10 * (1 - i)) for i in range(2)]
    wire, sent, tick = [], 0, 0
    while any(session.status.frame < FRAMES for session in sessions):
        now, tick = tick * 16667, tick + 1
        while len(wire) > 8:
            to, packet = wire.pop(0)
            sessions[to].receive(1 - to, packet, now)
        for player, session in enumerate(sessions):
            if session.status.frame < FRAMES:
                for frame in session.frames(press(session.status.frame, player)):
                    simulate(session.world, balls, frame.inputs)
            for to, packet in session.packets(now):
                sent += 1
                if sent % 5:
                    wire.append((to, packet))
    for session in sessions:
        assert [event.kind for event in session.events()] == [detent.events['connected']]
        assert session.status.resimulated > 0
    match.mix(sessions[0].world.digest())
    assert not sessions[0].world.diff(sessions[1].world)
    for word in sessions[1].world.words:
        match.mix(word)

    replay = context.replay3(sessions[0].replay(), start, input_size=2, words=2)
    for frame in replay.frames():
        simulate(replay.world, balls, frame.inputs)
    check = replay.check()
    assert check.is_equal and check.frames == sessions[0].status.final_frame > 100


def play():
    with detent.Context() as context:
        match = Match(context)
        for tick in range(TICKS):
            match.tick(tick)
            if tick == TICKS // 2:
                saved = match.world.snapshot()
                match.mix(len(saved))
        match.world.restore(saved)
        for _ in range(10):
            match.world.step()
        match.mix(match.world.digest())
        play_for_two(context, match)
        return f'{match.sum:016x}'


if __name__ == '__main__':
    print(play())
