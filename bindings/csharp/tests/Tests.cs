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
  static bool IsNear(int length, double wanted) { return Math.Abs(Number.Of(length) - wanted) < 0.02; }

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

  // Bodies of area 2 and mass 2.
  static void Bodies() {
    using (var context = new Context()) {
      var settings = World2.DefaultSettings();
      settings.gravity = new Vec2();
      var world = new World2(context, settings);
      var shape = D2.Aabb(At(-One, -One / 2), At(One, One / 2));
      var options = World2.DefaultOptions();
      options.user = 7;
      options.layers = 2;
      var chosen = new Id { index = 5, generation = 3 };
      Expect(world.AddAs(chosen, shape, options) && !world.AddAs(chosen, shape, options), "a chosen id");
      var box = world.Add(D2.Aabb(At(9 * One, -One / 2), At(11 * One, One / 2)));
      var ids = new Id[4];
      Expect(world.BodyIds(ids) == 2 && ids[0].Equals(box) && ids[1].Equals(chosen), "ids");
      Expect(world.BodyIds(new Id[0]) == 2 && world.BodyIds(new Id[1]) == 2, "ids without room");

      // The moment of inertia is 2 * (2 * 2 + 1 * 1) / 12 = 5 / 6.
      Expect(world.ApplyForce(box, At(60 * One, 0)) && world.ApplyImpulse(box, At(0, 2 * One)), "pushes");
      Expect(world.ApplyTorque(box, 50 * One) && world.SetAngularVelocity(chosen, One), "turns");
      world.Step();
      var states = new Body2[2];
      world.Bodies(ids, states, 2);
      Expect(IsNear(states[0].velocity.x, 0.5) && IsNear(states[0].velocity.y, 1), "a force and an impulse");
      Expect(IsNear(states[0].angular_velocity0, 1) && IsNear(states[1].angular_velocity0, 1), "a torque");
      Expect(StatusOf(() => world.Bodies(ids, states, 3)) == C.BAD_ARGUMENT, "room for two states");
      Expect(StatusOf(() => world.Bodies(ids, states, -1)) == C.BAD_ARGUMENT, "a negative count");
      world.Bodies(new[] { new Id(), chosen }, states, 2);
      Expect(states[0].Equals(new Body2()) && states[1].rotation.axis0.y > 0, "no state");

      BodyInfo info;
      Expect(world.GetInfo(chosen, out info) && info.user == 7 && info.layers == 2 && info.is_asleep == 0 &&
             info.motion == C.DYNAMIC_BODY, "properties");
      Expect(!world.GetInfo(new Id(), out info), "no properties");
      Transform2 frame;
      Expect(world.GetFrame(chosen, out frame) && frame.rotation.Equals(states[1].rotation), "a frame");
      ulong one, other;
      Expect(world.DigestOf(box, out one) && world.DigestOf(chosen, out other) && one != other, "digests");
      Expect(!world.DigestOf(new Id(), out one) && !world.GetFrame(new Id(), out frame), "no body");
      var scene = new Scene2(context);
      scene.Follow(world);
      Id body;
      uint part;
      Expect(world.PartOf(box, out body, out part) && body.Equals(box) && part == 0, "a part");
      Expect(!world.PartOf(new Id(), out body, out part), "no part");

      var touches = new Touch[4];
      Expect(world.Touching(new Id(), touches) == 0, "nothing touches");
      Expect(world.SetPosition(box, At(One, One / 2)), "set position");
      world.Step();
      Expect(world.Events(touches) == 1 && touches[0].begins == 1, "a touch begins");
      Expect(world.Touching(box, touches) == 1 && touches[0].a.Equals(box) && touches[0].b.Equals(chosen), "a touch");
      Expect(world.SetPosition(box, At(9 * One, 0)), "set position");
      world.Step();
      Expect(world.Events(touches) == 1 && touches[0].begins == 0, "a touch ends");
    }
  }

  // An arm of mass 1/2 from (0, 5) to (2, 5), on a hinge at its left end.
  sealed class Pendulum {
    public const double Mass = 0.5, Inertia = Mass * (1 + (4 + 1.0 / 16) / 12);  // about the hinge
    public readonly World2 World;
    public readonly Id Wall, Arm;
    public Joint2 Hinge;
    public Pendulum(Context context, int gravity = -10 * One) {
      var settings = World2.DefaultSettings();
      settings.gravity = At(0, gravity);
      World = new World2(context, settings);
      var options = World2.DefaultOptions();
      options.motion = C.FIXED_BODY;
      Wall = World.Add(D2.Sphere(At(0, 5 * One), One / 8), options);
      Arm = World.Add(D2.Aabb(At(0, 39 * One / 8), At(2 * One, 41 * One / 8)));
      Hinge = World2.DefaultJoint(C.HINGE_JOINT, Wall, Arm);
      Expect(World.LocalPoint(Arm, At(0, 5 * One), out Hinge.anchor_b), "a local point");
    }
    public Id Join() {
      Id id;
      Expect(World.AddJoint(Hinge, out id), "a hinge");
      return id;
    }
    public void Run(int ticks) {
      for (int tick = 0; tick < ticks; ++tick) World.Step();
    }
    public Body2 State {
      get {
        Body2 body;
        Expect(World.Get(Arm, out body), "an arm");
        return body;
      }
    }
  }

  static void Joints() {
    using (var context = new Context()) {
      Vec2 force;
      int torque;
      // It swings freely. Its height becomes its spin, and at the bottom the hinge carries its weight
      // and its centripetal force.
      var free = new Pendulum(context);
      Expect(free.Hinge.anchor_b.Equals(At(-One, 0)), "the end of the arm");
      var hinge = free.Join();
      while (free.State.rotation.axis0.x > 0) free.World.Step();
      double square = 2 * 10 * Pendulum.Mass / Pendulum.Inertia;
      Expect(IsNear(free.State.angular_velocity0, -Math.Sqrt(square)), "the spin at the bottom");
      Expect(free.World.JointForce(hinge, out force) && free.World.JointTorque(hinge, out torque) && torque == 0 &&
             IsNear(force.y, Pendulum.Mass * (10 + square)), "the force at the bottom");

      // A brake holds it: its weight is 5, at a distance of 1.
      var held = new Pendulum(context);
      held.Hinge.motor_force = 50 * One;
      hinge = held.Join();
      Expect(held.World.JointForce(hinge, out force) && force.Equals(new Vec2()), "no force before the first step");
      held.Run(30);
      Expect(held.World.JointForce(hinge, out force) && IsNear(force.x, 0) && IsNear(force.y, 5), "the weight");
      Expect(held.World.JointTorque(hinge, out torque) && IsNear(torque, 5), "the torque of a brake");

      // Too weak a brake slips with all it has.
      held.Hinge.motor_force = One;
      Expect(held.World.ChangeJoint(hinge, held.Hinge), "a weak brake");
      held.Run(10);
      Expect(held.State.angular_velocity0 < -One / 2, "it slips");
      Expect(held.World.JointTorque(hinge, out torque) && IsNear(torque, 1), "the torque of a weak brake");

      // It rests on its limit.
      var limited = new Pendulum(context);
      limited.Hinge.has_limits = 1;
      limited.Hinge.lower = -One / 2;
      limited.Hinge.upper = One;
      hinge = limited.Join();
      limited.Run(300);
      Expect(IsNear(limited.State.rotation.axis0.y / (Number.Unit / One), -Math.Sin(0.5)), "a limit");
      Expect(limited.World.JointTorque(hinge, out torque) && IsNear(torque, 5 * Math.Cos(0.5)),
             "the torque of a limit");

      // Without gravity its motor turns it, and the hinge has only the centripetal force.
      var turned = new Pendulum(context, 0);
      turned.Hinge.motor_speed = 2 * One;
      turned.Hinge.motor_force = 50 * One;
      hinge = turned.Join();
      turned.Run(60);
      Expect(IsNear(turned.State.angular_velocity0, 2), "a motor");
      Expect(turned.World.JointForce(hinge, out force), "a force");
      var length = (int)Math.Sqrt((double)force.x * force.x + (double)force.y * force.y);
      Expect(IsNear(length, Pendulum.Mass * 2 * 2), "a centripetal force");
      Expect(turned.World.JointTorque(hinge, out torque) && IsNear(torque, 0), "a motor without a load");
    }
  }

  static void JointsInSpace() {
    using (var context = new Context()) {
      var world = new World3(context);
      var options = World3.DefaultOptions();
      options.motion = C.FIXED_BODY;
      var wall = world.Add(D3.Sphere(new Vec3(), One / 8), options);
      var arm = world.Add(D3.Aabb(new Vec3 { y = -One / 2, z = -One / 2 },
                                  new Vec3 { x = 2 * One, y = One / 2, z = One / 2 }));
      // Axis 2, about which a hinge turns, is x: the brake has no load, the alignment has it all.
      var axes = new Rotation3();
      axes.axis0.y = axes.axis1.z = axes.axis2.x = Number.Unit;
      var joint = World3.DefaultJoint(C.HINGE_JOINT, wall, arm);
      Expect(world.LocalPoint(arm, new Vec3(), out joint.anchor_b) && joint.anchor_b.x == -One, "a local point");
      Expect(world.LocalFrame(wall, axes, out joint.frame_a) && world.LocalFrame(arm, axes, out joint.frame_b) &&
             joint.frame_b.Equals(axes), "a local frame");
      joint.motor_force = 50 * One;
      Id hinge;
      Expect(world.AddJoint(joint, out hinge), "a hinge");
      for (int tick = 0; tick < 30; ++tick) world.Step();
      Vec3 force, torque;
      Expect(world.JointForce(hinge, out force) && IsNear(force.y, 20), "the weight");
      Expect(world.JointTorque(hinge, out torque) && IsNear(torque.z, 20) && IsNear(torque.x, 0) &&
             IsNear(torque.y, 0), "the torque of the alignment");
      Expect(world.RemoveJoint(hinge), "a removal");

      // The moment of inertia about x is 2 * (1 * 1 + 1 * 1) / 12 = 1 / 3.
      Body3 body;
      Expect(world.SetAngularVelocity(arm, new Vec3 { x = One, y = 2 * One, z = 3 * One }) &&
             world.Get(arm, out body) && IsNear(body.angular_velocity0, 1) && IsNear(body.angular_velocity1, 2) &&
             IsNear(body.angular_velocity2, 3), "a spin");
      Expect(world.SetAngularVelocity(arm, new Vec3()) && world.ApplyTorque(arm, new Vec3 { x = 20 * One }), "turns");
      world.Step();
      Expect(world.Get(arm, out body) && IsNear(body.angular_velocity0, 1) && IsNear(body.angular_velocity1, 0) &&
             IsNear(body.angular_velocity2, 0), "a torque");
    }
  }

  static void LivesOfJoints() {
    using (var context = new Context()) {
      var pendulum = new Pendulum(context);
      var world = pendulum.World;
      Joint2 joint = pendulum.Hinge, read;
      joint.motor_force = 50 * One;
      joint.break_force = 4 * One;
      Id hinge, weld;
      Expect(world.AddJoint(joint, out hinge) && world.GetJoint(hinge, out read) && read.Equals(joint), "read back");
      joint.motor_speed = One;
      Expect(world.ChangeJoint(hinge, joint) && world.GetJoint(hinge, out read) && read.motor_speed == One,
             "a change");
      var other = World2.DefaultJoint(C.WELD_JOINT, pendulum.Wall, pendulum.Arm);
      Expect(world.AddJoint(other, out weld) && !world.ChangeJoint(hinge, other) && world.JointCount == 2, "a weld");
      var ids = new Id[2];
      Expect(world.JointIds(ids) == 2 && ids[0].Equals(hinge) && ids[1].Equals(weld), "the ids of joints");
      Expect(world.RemoveJoint(weld) && !world.RemoveJoint(weld) && world.JointIds(new Id[0]) == 1, "a removal");
      Expect(world.Broken(ids) == 0, "none is broken");
      pendulum.Run(1);  // its weight is 5
      Expect(world.Broken(ids) == 1 && ids[0].Equals(hinge) && world.JointCount == 0, "a broken joint");

      Vec2 force, local;
      int torque;
      Rotation2 frame, axes = World2.DefaultJoint(C.WELD_JOINT, new Id(), new Id()).frame_a;
      Expect(!world.GetJoint(hinge, out read) && !world.ChangeJoint(hinge, joint), "no joint");
      Expect(!world.JointForce(hinge, out force) && !world.JointTorque(hinge, out torque), "no force of no joint");
      Expect(!world.LocalPoint(new Id(), At(0, 0), out local) && !world.LocalFrame(new Id(), axes, out frame),
             "no body");
      joint.b = pendulum.Wall;
      Expect(!world.AddJoint(joint, out hinge), "a joint of one body");
      joint.b = new Id();
      Expect(!world.AddJoint(joint, out hinge), "a joint of no body");
      joint.break_force = -1;
      Expect(StatusOf(() => world.AddJoint(joint, out hinge)) == C.BAD_ARGUMENT, "a negative force");
      Expect(StatusOf(() => world.LocalFrame(pendulum.Arm, new Rotation2(), out frame)) == C.NOT_UNIT, "no axes");
      Expect(StatusOf(() => World2.DefaultJoint(C.CONE_JOINT, hinge, hinge)) == C.BAD_ARGUMENT, "a cone in 2D");
    }
  }

  // A million calls: allocating 16 bytes in each would trigger several collections.
  static void NoGarbage() {
    using (var context = new Context()) {
      var scene = new Scene2(context);
      var world = new World2(context);
      var ball = scene.Add(D2.Sphere(At(0, 0), One));
      var body = world.Add(D2.Sphere(At(0, 0), One));
      var joint = World2.DefaultJoint(C.BALL_JOINT, body, world.Add(D2.Sphere(At(0, 0), One)));
      Id id;
      Expect(world.AddJoint(joint, out id), "a joint");
      var ray = D2.Ray(At(-5 * One, 0), new Direction2 { x = Number.Unit });
      var ids = new Id[1];
      int collections = GC.CollectionCount(0), hits = 0;
      for (int i = 0; i < 1000000; ++i) {
        ObjectHit2 hit;
        Body2 state;
        Vec2 force;
        bool isThere = scene.Raycast(ray, 1, out hit) && world.Get(body, out state);
        if (isThere && world.JointForce(id, out force) && world.JointIds(ids) == 1) ++hits;
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
    Bodies();
    Joints();
    JointsInSpace();
    LivesOfJoints();
    NoGarbage();
    Console.WriteLine(failed == 0 ? "all tests passed" : failed + " failed");
    return failed == 0 ? 0 : 1;
  }
}
