// SPDX-License-Identifier: MIT
// The scripted match that every binding plays: boxes fall on a floor, a scene holds a ball around
// each, and rays are cast down at them. Prints a digest of all results, 16 digits equal to those of
// tests/c/match.cpp.
using System;
using System.Collections.Generic;
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

  static void Press(byte[] pad, uint frame, uint player) {
    pad[0] = (byte)(frame < 80 ? frame / (7 + 4 * player) % 5 : 0);
    pad[1] = (byte)(frame < 80 ? frame / 3 % 4 : 0);
  }
  static void Simulate(PlayedWorld3 world, Id[] balls, uint[] words, byte[] inputs) {
    world.GetWords(words);
    for (int player = 0; player < 2; ++player) {
      int speed = inputs[2 * player], which = inputs[2 * player + 1];
      words[player] += (uint)speed;
      if (speed == 0) continue;
      world.SetVelocity(balls[2 * player + which % 2], At((speed - 2) * One, which * One, 0));
    }
    world.SetWords(words);
    world.Step();
  }
  static void Require(bool isSo) {
    if (!isSo) throw new Exception("the match for two is not as it should be");
  }

  // A two-player match between two sessions in one program. Packets are delayed; every fifth is
  // lost.
  void PlayForTwo(Context context) {
    const uint frames = 120;
    var start = new World3(context);
    var ground = World3.DefaultOptions();
    ground.motion = C.FIXED_BODY;
    start.Add(D3.Aabb(At(-20 * One, -One, -20 * One), At(20 * One, 0, 20 * One)), ground);
    var balls = new Id[4];
    for (int i = 0; i < 4; ++i) balls[i] = start.Add(D3.Sphere(At((2 * i - 3) * One, 2 * One, 0), One / 2));
    var sessions = new Session3[2];
    for (uint i = 0; i < 2; ++i) {
      var settings = Context.DefaultSessionSettings();
      settings.match = 4711;
      settings.self = i;
      settings.input_size = settings.words = 2;
      settings.replay_every = 10 * (1 - i);
      sessions[i] = new Session3(context, start, settings);
    }
    var wire = new Queue<KeyValuePair<uint, byte[]>>();
    var pad = new byte[2];
    var words = new uint[2];
    var room = new byte[C.PACKET];
    int sent = 0;
    Frame frame;
    for (ulong now = 0; sessions[0].Status.frame < frames || sessions[1].Status.frame < frames; now += 16667) {
      while (wire.Count > 8) {
        var next = wire.Dequeue();
        sessions[next.Key].Receive(1 - next.Key, next.Value, next.Value.Length, now);
      }
      for (uint player = 0; player < 2; ++player) {
        var session = sessions[player];
        uint played = session.Status.frame, to;
        int size;
        Press(pad, played, player);
        while (played < frames && session.BeginFrame(pad, out frame)) {
          Simulate(session.World, balls, words, session.Inputs);
          session.EndFrame();
        }
        while (session.Packet(now, room, out to, out size)) {
          if (++sent % 5 == 0) continue;
          var packet = new byte[size];
          Array.Copy(room, packet, size);
          wire.Enqueue(new KeyValuePair<uint, byte[]>(to, packet));
        }
      }
    }
    foreach (var session in sessions) {
      SessionEvent happened;
      string field;
      Require(session.Event(out happened, out field) && happened.kind == C.CONNECTED && field == null);
      Require(!session.Event(out happened, out field) && session.Status.resimulated > 0);
    }
    Mix(sessions[0].World.Digest());
    Require(sessions[0].World.Diff(sessions[1].World) == "");
    sessions[1].World.GetWords(words);
    Mix(words[0]);
    Mix(words[1]);

    var replay = new Replay3(context, start, sessions[0].Replay(), 2, 2);
    while (replay.BeginFrame(out frame)) {
      Simulate(replay.World, balls, words, replay.Inputs);
      replay.EndFrame();
    }
    var check = replay.Check();
    Require(check.is_equal == 1 && check.frames > 100 && check.frames == sessions[0].Status.final_frame);
  }

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
      PlayForTwo(context);
      return sum.ToString("x16");
    }
  }
}
