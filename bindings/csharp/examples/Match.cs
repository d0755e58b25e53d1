// SPDX-License-Identifier: MIT
// The scripted match of every binding: boxes fall on a floor, a scene has a ball around each, rays look
// down at them. Ends with 16 digits that follow from every answer: those of tests/c/match.cpp.
using System;
using Detent;

public sealed class Match {
  const int One = Number.One, Bodies = 12, Ticks = 120, Rays = 8;
  uint state = 1;
  ulong sum;

  int Draw(int count) {
    unchecked { state = state * 1664525u + 1013904223u; }
    return (int)((state >> 8) % (uint)count);
  }
  void Mix(ulong value) { unchecked { sum = sum * 6364136223846793005ul + value; } }

  static Vec3 At(int x, int y, int z) { return new Vec3 { x = x, y = y, z = z }; }

  public string Play() {
    using (var context = new Context()) {
      var world = new World3(context);
      var scene = new Scene3(context);
      var ground = World3.DefaultOptions();
      ground.motion = C.FIXED_BODY;
      world.Add(D3.Aabb(At(-20 * One, -One, -20 * One), At(20 * One, 0, 20 * One)), ground);
      var axes = new Rotation3();
      axes.axis0.x = axes.axis1.y = axes.axis2.z = Number.Unit;
      var boxes = new Id[Bodies];
      var balls = new Id[Bodies];
      for (int i = 0; i < Bodies; ++i) {
        int x = Draw(4 * One) - 2 * One;
        var center = At(x, (2 + 2 * i) * One, Draw(4 * One) - 2 * One);
        int a = One / 2 + Draw(One / 2), b = One / 2 + Draw(One / 2), c = One / 2 + Draw(One / 2);
        boxes[i] = world.Add(D3.Obb(center, At(a, b, c), axes));
        balls[i] = scene.Add(D3.Sphere(center, One), user: (ulong)i);
      }

      byte[] saved = null;
      for (int tick = 0; tick < Ticks; ++tick) {
        if (tick % 10 == 5) world.SetVelocity(boxes[tick / 10], At(One, 5 * One, 0));
        world.Step();
        for (int i = 0; i < Bodies; ++i) {
          Body3 body;
          world.Get(boxes[i], out body);
          scene.Replace(balls[i], D3.Sphere(body.position, One));
        }
        for (int i = 0; i < Rays; ++i) {
          int x = Draw(8 * One) - 4 * One;
          var origin = At(x, 30 * One, Draw(8 * One) - 4 * One);
          ObjectHit3 hit;
          if (scene.Raycast(D3.Ray(origin, new Direction3 { y = -Number.Unit }, 40 * One), 1, out hit)) {
            Mix(unchecked((uint)hit.distance));
            Mix(hit.id.index);
            Mix(unchecked((uint)hit.normal.y));
          } else {
            Mix(uint.MaxValue);
          }
        }
        Mix(world.Digest());
        Mix(scene.Digest());
        if (tick == Ticks / 2) {
          saved = world.Snapshot();
          Mix((ulong)saved.Length);
        }
      }

      world.Restore(saved);
      for (int tick = 0; tick < 10; ++tick) world.Step();
      Mix(world.Digest());
      return sum.ToString("x16");
    }
  }
}
