// SPDX-License-Identifier: MIT
// Tests of the C# binding. The program exits with 1 if one fails.
using System;
using Detent;

static class Tests {
  const int One = Number.One;
  static int failed;

  static void Expect(bool isRight, string what) {
    if (isRight) return;
    Console.WriteLine("failed: " + what);
    ++failed;
  }
  static int StatusOf(Action action) {
    try {
      action();
    } catch (DetentException e) {
      return e.Message.Length > 5 ? e.Status : 0;
    }
    return C.OK;
  }
  static Vec2 At(int x, int y) { return new Vec2 { x = x, y = y }; }

  static void Queries() {
    var ball = D2.Sphere(At(10 * One, 0), One);
    Hit2 hit;
    var east = new Direction2 { x = Number.Unit };
    Expect(D2.Raycast(D2.Ray(At(0, 0), east), ball, out hit) && hit.distance == 9 * One, "raycast");
    Expect(!D2.Raycast(D2.Ray(At(0, 2 * One), east), ball, out hit), "a miss");
    Expect(D2.Contains(ball, At(11 * One, 0)) && !D2.Contains(ball, At(11 * One + 1, 0)), "contains");
    Expect(D2.Overlaps(ball, D2.Aabb(At(0, 0), At(9 * One, One))), "touching overlaps");
    Expect(D2.Distance(ball, D2.Capsule(At(0, 0), At(5 * One, 0), One)) == 3 * One, "distance");
    Expect(Number.Raw(1.5) == 98304 && Number.Of(98304) == 1.5 && Number.Raw(2.5 / One) == 2, "numbers");
  }

  static void Scenes() {
    using (var context = new Context()) {
      var scene = new Scene2(context);
      var ball = scene.Add(D2.Sphere(At(0, 0), One), layers: 2, user: 7);
      Found found;
      Expect(scene.Nearest(D2.Point(At(3 * One, 0)), ~0u, out found) && found.distance == 2 * One &&
             found.id.Equals(ball), "nearest");
      Expect(!scene.Any(D2.Point(At(0, 0)), 1) && scene.Any(D2.Point(At(0, 0)), 2), "layers");
      ulong before = scene.Digest();
      var saved = scene.Snapshot();
      Expect(scene.Move(ball, At(0, One)) && scene.Digest() != before, "move");
      scene.Restore(saved);
      Expect(scene.Digest() == before, "restore");
      Expect(scene.Remove(ball) && !scene.Remove(ball) && scene.Size == 0, "remove");
      Expect(StatusOf(() => scene.Restore(new byte[40])) == C.NO_SNAPSHOT, "no snapshot");
      ObjectHit2 hit;
      var crooked = D2.Ray(At(0, 0), new Direction2 { x = Number.Unit, y = Number.Unit });
      Expect(StatusOf(() => scene.Raycast(crooked, 1, out hit)) == C.NOT_UNIT, "not a unit vector");
    }
  }

  static void Following() {
    using (var context = new Context()) {
      var scene = new Scene2(context);
      var world = new World2(context);
      var ball = world.Add(D2.Sphere(At(0, 9 * One), One));
      Expect(world.SetPosition(ball, At(0, 5 * One)), "set position");
      scene.Follow(world);
      ObjectHit2 hit;
      var up = D2.Ray(At(0, 0), new Direction2 { y = Number.Unit });
      Expect(scene.Raycast(up, ~0u, out hit) && hit.id.Equals(ball) && hit.distance == 4 * One, "follow");
    }
  }

  static void Contacts() {
    using (var context = new Context()) {
      var world = new World2(context);
      var fixedBody = World2.DefaultOptions();
      fixedBody.motion = C.FIXED_BODY;
      var floor = world.Add(D2.Aabb(At(-5 * One, -One), At(5 * One, 0)), fixedBody);
      var box = world.Add(D2.Aabb(At(-One, 0), At(One, 2 * One)));
      for (int tick = 0; tick < 30; ++tick) world.Step();
      var contacts = new World2Contact[4];
      Expect(world.Contacts(new Id(), contacts) == 1 && world.Contacts(box, contacts) == 1, "contacts");
      Expect(contacts[0].a.Equals(floor) && contacts[0].normal.y == Number.Unit, "a contact");
      Expect(Math.Abs(contacts[0].impulse - 4 * 10 * One / 240) < 500, "an impulse");
      Expect(world.SetFriction(box, One / 4) && world.SetRestitution(box, One / 2), "a material");
      Expect(world.SetSensor(box, true) && world.SetFilter(box, 2, 4), "a filter");
      Expect(world.SetGravityScale(box, -One) && world.SetDamping(box, 0, One), "gravity");
      Expect(world.SetLocked(box, C.LOCK_X) && world.SetFast(box, true) && world.SetUser(box, 7), "other setters");
      world.SetVelocity(box, At(One, 0));
      world.Step();
      Expect(world.Contacts(box, contacts) == 0, "no contacts");
      Body2 body;
      Expect(world.Get(box, out body) && body.velocity.x == 0, "a lock");
      Expect(Math.Abs(body.velocity.y - 10 * One / 60) < 20, "it rises");
      world.SetGravity(At(0, 10 * One));
      world.Step();
      Expect(world.Get(box, out body) && Math.Abs(body.velocity.y) < 40, "other gravity pulls it back");
    }
  }

  // A million calls: allocating 16 bytes in each would trigger several collections.
  static void NoGarbage() {
    using (var context = new Context()) {
      var scene = new Scene2(context);
      var world = new World2(context);
      var ball = scene.Add(D2.Sphere(At(0, 0), One));
      var body = world.Add(D2.Sphere(At(0, 0), One));
      var ray = D2.Ray(At(-5 * One, 0), new Direction2 { x = Number.Unit });
      int collections = GC.CollectionCount(0), hits = 0;
      for (int i = 0; i < 1000000; ++i) {
        ObjectHit2 hit;
        Body2 state;
        if (scene.Raycast(ray, 1, out hit) && world.Get(body, out state)) ++hits;
      }
      Expect(hits == 1000000 && GC.CollectionCount(0) == collections, "calls make no garbage");
      Expect(scene.Replace(ball, D2.Sphere(At(One, 0), One)), "replace");
    }
  }

  static int Main() {
    C.CheckSizes();
    string expected = Environment.GetEnvironmentVariable("DETENT_MATCH");
    string played = new Match().Play();
    Expect(played == expected, "the match ends with " + played + " instead of " + expected);
    Queries();
    Scenes();
    Following();
    Contacts();
    NoGarbage();
    Console.WriteLine(failed == 0 ? "all tests passed" : failed + " failed");
    return failed == 0 ? 0 : 1;
  }
}
