# SPDX-License-Identifier: MIT
"""The scripted match of every binding: boxes fall on a floor, a scene has a ball around each, rays look
down at them. Prints 16 digits that follow from every answer: those of tests/c/match.cpp."""
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
        return f'{match.sum:016x}'


if __name__ == '__main__':
    print(play())
