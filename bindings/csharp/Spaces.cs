// SPDX-License-Identifier: MIT
// Written by bindings/generate from bindings/csharp/spaces.cs.in: change that file instead.
// Shapes, scenes and worlds of both dimensions. No call allocates garbage except Snapshot.
using System;

namespace Detent {

/// <summary>Shapes, rays and queries in 2D.</summary>
public static unsafe class D2 {
  public static Ray2 Ray(Vec2 origin, Direction2 direction, int maxDistance = int.MaxValue) {
    return new Ray2 { origin = origin, direction = direction, max_distance = maxDistance };
  }
  public static Shape2 Sphere(Vec2 center, int radius) {
    var shape = new Shape2 { kind = C.SPHERE };
    shape.of.sphere = new Sphere2 { center = center, radius = radius };
    return shape;
  }
  public static Shape2 Aabb(Vec2 min, Vec2 max) {
    var shape = new Shape2 { kind = C.AABB };
    shape.of.aabb = new Aabb2 { min = min, max = max };
    return shape;
  }
  public static Shape2 Obb(Vec2 center, Vec2 halfExtents, Rotation2 rotation) {
    var shape = new Shape2 { kind = C.OBB };
    shape.of.obb = new Obb2 { center = center, half_extents = halfExtents, rotation = rotation };
    return shape;
  }
  public static Shape2 Capsule(Vec2 a, Vec2 b, int radius) {
    var shape = new Shape2 { kind = C.CAPSULE };
    shape.of.capsule = new Capsule2 { a = a, b = b, radius = radius };
    return shape;
  }
  public static Shape2 Plane(Direction2 normal, int offset) {
    var shape = new Shape2 { kind = C.PLANE };
    shape.of.plane = new Plane2 { normal = normal, offset = offset };
    return shape;
  }
  public static Shape2 Triangle(Vec2 a, Vec2 b, Vec2 c) {
    var shape = new Shape2 { kind = C.TRIANGLE };
    shape.of.triangle = new Triangle2 { a = a, b = b, c = c };
    return shape;
  }
  public static Shape2 Point(Vec2 at) {
    var shape = new Shape2 { kind = C.POINT };
    shape.of.point = at;
    return shape;
  }

  public static bool Raycast(Ray2 ray, Shape2 shape, out Hit2 hit) {
    fixed (Hit2* to = &hit) return Number.Check(C.detent_raycast2(&ray, &shape, to));
  }
  public static bool Overlaps(Shape2 a, Shape2 b) {
    return Number.Check(C.detent_overlaps2(&a, &b));
  }
  public static bool Contains(Shape2 shape, Vec2 point) {
    return Number.Check(C.detent_contains2(&shape, &point));
  }
  public static int Distance(Shape2 a, Shape2 b) {
    int distance;
    Number.Check(C.detent_distance2(&a, &b, &distance));
    return distance;
  }
}

/// <summary>Objects and queries over them. For functions missing here, call C with
/// Handle.</summary>
public sealed unsafe class Scene2 {
  readonly Context context;
  public readonly uint Handle;

  public Scene2(Context context) {
    this.context = context;
    uint handle;
    Number.Check(C.detent_scene2_create(context.Memory, &handle));
    Handle = handle;
  }
  public void Destroy() { Number.Check(C.detent_scene2_destroy(context.Memory, Handle)); }

  public Id Add(Shape2 shape, uint layers = 1, ulong user = 0, bool isFixed = false) {
    var traits = new Traits { user = user, layers = layers, motion = isFixed ? C.FIXED : C.MOVING };
    Id id;
    Number.Check(C.detent_scene2_add(context.Memory, Handle, &shape, &traits, &id));
    return id;
  }
  public bool Remove(Id id) { return Number.Check(C.detent_scene2_remove(context.Memory, Handle, id)); }
  public bool Replace(Id id, Shape2 shape) {
    return Number.Check(C.detent_scene2_replace(context.Memory, Handle, id, &shape));
  }
  public bool Move(Id id, Vec2 by) {
    return Number.Check(C.detent_scene2_move(context.Memory, Handle, id, &by));
  }
  public void Follow(World2 world, bool sensors = false) {
    Number.Check(C.detent_scene2_follow(context.Memory, Handle, world.Handle, sensors ? 1u : 0u));
  }
  public bool Raycast(Ray2 ray, uint layers, out ObjectHit2 hit) {
    fixed (ObjectHit2* to = &hit) {
      return Number.Check(C.detent_scene2_raycast(context.Memory, Handle, &ray, layers, to));
    }
  }
  public bool Nearest(Shape2 question, uint layers, out Found found) {
    fixed (Found* to = &found) {
      return Number.Check(C.detent_scene2_nearest(context.Memory, Handle, &question, layers, to));
    }
  }
  public bool Any(Shape2 question, uint layers) {
    return Number.Check(C.detent_scene2_any(context.Memory, Handle, &question, layers));
  }
  public int Size {
    get {
      uint size;
      Number.Check(C.detent_scene2_size(context.Memory, Handle, &size));
      return (int)size;
    }
  }
  public ulong Digest() {
    ulong digest;
    Number.Check(C.detent_scene2_digest(context.Memory, Handle, &digest));
    return digest;
  }
  public byte[] Snapshot() {
    uint size;
    Number.Check(C.detent_scene2_snapshot(context.Memory, Handle, null, 0, &size));
    var bytes = new byte[size];
    fixed (byte* to = bytes) {
      Number.Check(C.detent_scene2_snapshot(context.Memory, Handle, to, size, &size));
    }
    return bytes;
  }
  public void Restore(byte[] bytes) {
    fixed (byte* from = bytes) {
      Number.Check(C.detent_scene2_restore(context.Memory, Handle, from, (uint)bytes.Length));
    }
  }
  /// <summary>The first fields that differ, one per line.</summary>
  public string Diff(Scene2 other, uint most = 16) {
    uint size;
    if (!Number.Check(C.detent_scene2_diff(context.Memory, Handle, other.Handle, most, null, 0, &size))) {
      return "";
    }
    var bytes = new byte[size];
    fixed (byte* to = bytes) {
      Number.Check(C.detent_scene2_diff(context.Memory, Handle, other.Handle, most, to, size, &size));
    }
    return System.Text.Encoding.ASCII.GetString(bytes);
  }
}

/// <summary>Moving bodies. For functions missing here, call C with Handle.</summary>
public unsafe class World2 {
  internal readonly Context context;
  public readonly uint Handle;

  public static World2Settings DefaultSettings() {
    World2Settings settings;
    Number.Check(C.detent_world2_default_settings(&settings));
    return settings;
  }
  public static Body2Options DefaultOptions() {
    Body2Options options;
    Number.Check(C.detent_body2_default_options(&options));
    return options;
  }

  internal World2(Context context, uint handle) {
    this.context = context;
    Handle = handle;
  }
  public World2(Context context) : this(context, DefaultSettings()) {}
  public World2(Context context, World2Settings settings) {
    this.context = context;
    uint handle;
    Number.Check(C.detent_world2_create(context.Memory, &settings, &handle));
    Handle = handle;
  }
  public void Destroy() { Number.Check(C.detent_world2_destroy(context.Memory, Handle)); }

  public Id Add(Shape2 shape) { return Add(shape, DefaultOptions()); }
  public Id Add(Shape2 shape, Body2Options options) {
    Id id;
    Number.Check(C.detent_world2_add(context.Memory, Handle, &shape, &options, &id));
    return id;
  }
  public bool Remove(Id id) { return Number.Check(C.detent_world2_remove(context.Memory, Handle, id)); }
  public void Step() { Number.Check(C.detent_world2_step(context.Memory, Handle)); }
  public bool Get(Id id, out Body2 body) {
    fixed (Body2* to = &body) return Number.Check(C.detent_world2_body(context.Memory, Handle, id, to));
  }
  public bool SetPosition(Id id, Vec2 position) {
    return Number.Check(C.detent_world2_set_position(context.Memory, Handle, id, &position));
  }
  public bool SetRotation(Id id, Rotation2 rotation) {
    return Number.Check(C.detent_world2_set_rotation(context.Memory, Handle, id, &rotation));
  }
  public bool SetFilter(Id id, uint layers, uint collidesWith) {
    return Number.Check(C.detent_world2_set_filter(context.Memory, Handle, id, layers, collidesWith));
  }
  public bool SetFriction(Id id, int friction) {
    return Number.Check(C.detent_world2_set_friction(context.Memory, Handle, id, friction));
  }
  public bool SetRestitution(Id id, int restitution) {
    return Number.Check(C.detent_world2_set_restitution(context.Memory, Handle, id, restitution));
  }
  public bool SetSensor(Id id, bool isSensor) {
    return Number.Check(C.detent_world2_set_sensor(context.Memory, Handle, id, isSensor ? 1u : 0u));
  }
  public bool SetGravityScale(Id id, int scale) {
    return Number.Check(C.detent_world2_set_gravity_scale(context.Memory, Handle, id, scale));
  }
  public bool SetDamping(Id id, int linear, int angular) {
    return Number.Check(C.detent_world2_set_damping(context.Memory, Handle, id, linear, angular));
  }
  public bool SetLocked(Id id, uint locked) {
    return Number.Check(C.detent_world2_set_locked(context.Memory, Handle, id, locked));
  }
  public bool SetFast(Id id, bool isFast) {
    return Number.Check(C.detent_world2_set_fast(context.Memory, Handle, id, isFast ? 1u : 0u));
  }
  public bool SetUser(Id id, ulong user) {
    return Number.Check(C.detent_world2_set_user(context.Memory, Handle, id, user));
  }
  /// <summary>Sets the gravity of the world and wakes all bodies.</summary>
  public void SetGravity(Vec2 gravity) {
    Number.Check(C.detent_world2_set_gravity(context.Memory, Handle, &gravity));
  }
  /// <summary>Writes as many contacts of a body as there is room for; new Id() for those of all.
  /// Returns how many there are. The first `count` of their points are set.</summary>
  public int Contacts(Id id, World2Contact[] contacts) {
    uint count;
    fixed (World2Contact* to = contacts) {
      Number.Check(C.detent_world2_contacts(context.Memory, Handle, id, to, (uint)contacts.Length, &count));
    }
    return (int)count;
  }
  public bool SetVelocity(Id id, Vec2 velocity) {
    return Number.Check(C.detent_world2_set_velocity(context.Memory, Handle, id, &velocity));
  }
  public bool ApplyImpulse(Id id, Vec2 impulse, Vec2 at) {
    return Number.Check(C.detent_world2_apply_impulse(context.Memory, Handle, id, &impulse, &at));
  }
  public bool ApplyForce(Id id, Vec2 force, Vec2 at) {
    return Number.Check(C.detent_world2_apply_force(context.Memory, Handle, id, &force, &at));
  }
  public int Size {
    get {
      uint size;
      Number.Check(C.detent_world2_size(context.Memory, Handle, &size));
      return (int)size;
    }
  }
  public ulong Digest() {
    ulong digest;
    Number.Check(C.detent_world2_digest(context.Memory, Handle, &digest));
    return digest;
  }
  public byte[] Snapshot() {
    uint size;
    Number.Check(C.detent_world2_snapshot(context.Memory, Handle, null, 0, &size));
    var bytes = new byte[size];
    fixed (byte* to = bytes) {
      Number.Check(C.detent_world2_snapshot(context.Memory, Handle, to, size, &size));
    }
    return bytes;
  }
  public void Restore(byte[] bytes) {
    fixed (byte* from = bytes) {
      Number.Check(C.detent_world2_restore(context.Memory, Handle, from, (uint)bytes.Length));
    }
  }
  /// <summary>The first fields that differ, one per line.</summary>
  public string Diff(World2 other, uint most = 16) {
    uint size;
    if (!Number.Check(C.detent_world2_diff(context.Memory, Handle, other.Handle, most, null, 0, &size))) {
      return "";
    }
    var bytes = new byte[size];
    fixed (byte* to = bytes) {
      Number.Check(C.detent_world2_diff(context.Memory, Handle, other.Handle, most, to, size, &size));
    }
    return System.Text.Encoding.ASCII.GetString(bytes);
  }
}

/// <summary>The world of a session or replay, with words of game state that a rollback also
/// restores. It can be changed only during a frame.</summary>
public sealed unsafe class PlayedWorld2 : World2 {
  internal PlayedWorld2(Context context, uint handle) : base(context, handle) {}

  /// <summary>Their number is in the settings.</summary>
  public void GetWords(uint[] words) {
    fixed (uint* to = words) Number.Check(C.detent_world2_words(context.Memory, Handle, to));
  }
  public void SetWords(uint[] words) {
    fixed (uint* from = words) Number.Check(C.detent_world2_set_words(context.Memory, Handle, from));
  }
}

/// <summary>A network match from a world that all peers start with. No call allocates garbage
/// except Replay and the names of events.</summary>
public sealed unsafe class Session2 {
  readonly Context context;
  public readonly uint Handle;
  public readonly PlayedWorld2 World;
  /// <summary>The inputs of all players in the open frame, concatenated.</summary>
  public readonly byte[] Inputs;
  readonly uint inputSize;

  public Session2(Context context, World2 start, SessionSettings settings) {
    this.context = context;
    uint handle, world;
    Number.Check(C.detent_session2_create(context.Memory, &settings, start.Handle, &handle));
    Handle = handle;
    Number.Check(C.detent_session2_world(context.Memory, Handle, &world));
    World = new PlayedWorld2(context, world);
    inputSize = settings.input_size;
    Inputs = new byte[C.PLAYERS * inputSize];
  }
  public void Destroy() { Number.Check(C.detent_session2_destroy(context.Memory, Handle)); }

  /// <summary>True if there is a frame to simulate: change World depending only on Inputs, step it,
  /// call EndFrame, and repeat with the same input. Otherwise frame.state says why not.</summary>
  public bool BeginFrame(byte[] pad, out Frame frame) {
    if (pad.Length != inputSize) throw new DetentException(C.BAD_ARGUMENT);
    fixed (byte* from = pad, to = Inputs) fixed (Frame* into = &frame) {
      return Number.Check(C.detent_session2_begin_frame(context.Memory, Handle, from, into, to));
    }
  }
  public void EndFrame() { Number.Check(C.detent_session2_end_frame(context.Memory, Handle)); }
  /// <summary>Takes a packet that arrived at a time in microseconds; false if it was not
  /// used.</summary>
  public bool Receive(uint peer, byte[] packet, int size, ulong now) {
    if ((uint)size > (uint)packet.Length) throw new DetentException(C.BAD_ARGUMENT);
    fixed (byte* from = packet) {
      return Number.Check(C.detent_session2_receive(context.Memory, Handle, peer, from, (uint)size, now));
    }
  }
  /// <summary>The next packet due, in an array of C.PACKET bytes.</summary>
  public bool Packet(ulong now, byte[] packet, out uint peer, out int size) {
    uint to, count;
    bool isDue;
    fixed (byte* at = packet) {
      isDue = Number.Check(C.detent_session2_packet(context.Memory, Handle, now, &to, at,
                                                      (uint)packet.Length, &count));
    }
    peer = isDue ? to : 0;
    size = isDue ? (int)count : 0;
    return isDue;
  }
  /// <summary>The next event, and the name of the field that differs, or null.</summary>
  public bool Event(out SessionEvent happened, out string field) {
    byte* name = stackalloc byte[(int)C.NAME];
    SessionEvent own;
    bool isThere = Number.Check(C.detent_session2_event(context.Memory, Handle, &own, name, C.NAME));
    happened = isThere ? own : default(SessionEvent);
    field = isThere && own.name_size != 0 ? new string((sbyte*)name, 0, (int)own.name_size) : null;
    return isThere;
  }
  public SessionStatus Status {
    get {
      SessionStatus status;
      Number.Check(C.detent_session2_status(context.Memory, Handle, &status));
      return status;
    }
  }
  /// <summary>The number of frames known to be equal at the peer and here.</summary>
  public uint Matched(uint peer) {
    uint frame;
    Number.Check(C.detent_session2_matched(context.Memory, Handle, peer, &frame));
    return frame;
  }
  public bool IsAwaited(uint player) {
    return Number.Check(C.detent_session2_is_awaited(context.Memory, Handle, player));
  }
  public void Drop(uint peer) { Number.Check(C.detent_session2_drop(context.Memory, Handle, peer)); }
  public void Pause(bool isPaused) {
    Number.Check(C.detent_session2_pause(context.Memory, Handle, isPaused ? 1u : 0u));
  }
  /// <summary>The replay of all final frames, or null if none is recorded.</summary>
  public byte[] Replay() {
    uint size;
    Number.Check(C.detent_session2_replay(context.Memory, Handle, null, 0, &size));
    if (size == 0) return null;
    var bytes = new byte[size];
    fixed (byte* to = bytes) {
      Number.Check(C.detent_session2_replay(context.Memory, Handle, to, size, &size));
    }
    return bytes;
  }
}

/// <summary>A replay to resimulate, with the inputs and words of its session.</summary>
public sealed unsafe class Replay2 {
  readonly Context context;
  public readonly uint Handle;
  public readonly PlayedWorld2 World;
  /// <summary>The inputs of all players in the open frame, concatenated.</summary>
  public readonly byte[] Inputs;

  public Replay2(Context context, World2 start, byte[] bytes, uint inputSize, uint words) {
    this.context = context;
    uint handle, world;
    fixed (byte* from = bytes) {
      Number.Check(C.detent_replay2_create(context.Memory, from, (uint)bytes.Length, start.Handle,
                                             inputSize, words, &handle));
    }
    Handle = handle;
    Number.Check(C.detent_replay2_world(context.Memory, Handle, &world));
    World = new PlayedWorld2(context, world);
    Inputs = new byte[C.PLAYERS * inputSize];
  }
  public void Destroy() { Number.Check(C.detent_replay2_destroy(context.Memory, Handle)); }
  public bool BeginFrame(out Frame frame) {
    fixed (byte* to = Inputs) fixed (Frame* into = &frame) {
      return Number.Check(C.detent_replay2_begin_frame(context.Memory, Handle, into, to));
    }
  }
  public void EndFrame() { Number.Check(C.detent_replay2_end_frame(context.Memory, Handle)); }
  public ReplayCheck Check() {
    ReplayCheck check;
    Number.Check(C.detent_replay2_check(context.Memory, Handle, &check));
    return check;
  }
}

/// <summary>Shapes, rays and queries in 3D.</summary>
public static unsafe class D3 {
  public static Ray3 Ray(Vec3 origin, Direction3 direction, int maxDistance = int.MaxValue) {
    return new Ray3 { origin = origin, direction = direction, max_distance = maxDistance };
  }
  public static Shape3 Sphere(Vec3 center, int radius) {
    var shape = new Shape3 { kind = C.SPHERE };
    shape.of.sphere = new Sphere3 { center = center, radius = radius };
    return shape;
  }
  public static Shape3 Aabb(Vec3 min, Vec3 max) {
    var shape = new Shape3 { kind = C.AABB };
    shape.of.aabb = new Aabb3 { min = min, max = max };
    return shape;
  }
  public static Shape3 Obb(Vec3 center, Vec3 halfExtents, Rotation3 rotation) {
    var shape = new Shape3 { kind = C.OBB };
    shape.of.obb = new Obb3 { center = center, half_extents = halfExtents, rotation = rotation };
    return shape;
  }
  public static Shape3 Capsule(Vec3 a, Vec3 b, int radius) {
    var shape = new Shape3 { kind = C.CAPSULE };
    shape.of.capsule = new Capsule3 { a = a, b = b, radius = radius };
    return shape;
  }
  public static Shape3 Plane(Direction3 normal, int offset) {
    var shape = new Shape3 { kind = C.PLANE };
    shape.of.plane = new Plane3 { normal = normal, offset = offset };
    return shape;
  }
  public static Shape3 Triangle(Vec3 a, Vec3 b, Vec3 c) {
    var shape = new Shape3 { kind = C.TRIANGLE };
    shape.of.triangle = new Triangle3 { a = a, b = b, c = c };
    return shape;
  }
  public static Shape3 Point(Vec3 at) {
    var shape = new Shape3 { kind = C.POINT };
    shape.of.point = at;
    return shape;
  }

  public static bool Raycast(Ray3 ray, Shape3 shape, out Hit3 hit) {
    fixed (Hit3* to = &hit) return Number.Check(C.detent_raycast3(&ray, &shape, to));
  }
  public static bool Overlaps(Shape3 a, Shape3 b) {
    return Number.Check(C.detent_overlaps3(&a, &b));
  }
  public static bool Contains(Shape3 shape, Vec3 point) {
    return Number.Check(C.detent_contains3(&shape, &point));
  }
  public static int Distance(Shape3 a, Shape3 b) {
    int distance;
    Number.Check(C.detent_distance3(&a, &b, &distance));
    return distance;
  }
}

/// <summary>Objects and queries over them. For functions missing here, call C with
/// Handle.</summary>
public sealed unsafe class Scene3 {
  readonly Context context;
  public readonly uint Handle;

  public Scene3(Context context) {
    this.context = context;
    uint handle;
    Number.Check(C.detent_scene3_create(context.Memory, &handle));
    Handle = handle;
  }
  public void Destroy() { Number.Check(C.detent_scene3_destroy(context.Memory, Handle)); }

  public Id Add(Shape3 shape, uint layers = 1, ulong user = 0, bool isFixed = false) {
    var traits = new Traits { user = user, layers = layers, motion = isFixed ? C.FIXED : C.MOVING };
    Id id;
    Number.Check(C.detent_scene3_add(context.Memory, Handle, &shape, &traits, &id));
    return id;
  }
  public bool Remove(Id id) { return Number.Check(C.detent_scene3_remove(context.Memory, Handle, id)); }
  public bool Replace(Id id, Shape3 shape) {
    return Number.Check(C.detent_scene3_replace(context.Memory, Handle, id, &shape));
  }
  public bool Move(Id id, Vec3 by) {
    return Number.Check(C.detent_scene3_move(context.Memory, Handle, id, &by));
  }
  public void Follow(World3 world, bool sensors = false) {
    Number.Check(C.detent_scene3_follow(context.Memory, Handle, world.Handle, sensors ? 1u : 0u));
  }
  public bool Raycast(Ray3 ray, uint layers, out ObjectHit3 hit) {
    fixed (ObjectHit3* to = &hit) {
      return Number.Check(C.detent_scene3_raycast(context.Memory, Handle, &ray, layers, to));
    }
  }
  public bool Nearest(Shape3 question, uint layers, out Found found) {
    fixed (Found* to = &found) {
      return Number.Check(C.detent_scene3_nearest(context.Memory, Handle, &question, layers, to));
    }
  }
  public bool Any(Shape3 question, uint layers) {
    return Number.Check(C.detent_scene3_any(context.Memory, Handle, &question, layers));
  }
  public int Size {
    get {
      uint size;
      Number.Check(C.detent_scene3_size(context.Memory, Handle, &size));
      return (int)size;
    }
  }
  public ulong Digest() {
    ulong digest;
    Number.Check(C.detent_scene3_digest(context.Memory, Handle, &digest));
    return digest;
  }
  public byte[] Snapshot() {
    uint size;
    Number.Check(C.detent_scene3_snapshot(context.Memory, Handle, null, 0, &size));
    var bytes = new byte[size];
    fixed (byte* to = bytes) {
      Number.Check(C.detent_scene3_snapshot(context.Memory, Handle, to, size, &size));
    }
    return bytes;
  }
  public void Restore(byte[] bytes) {
    fixed (byte* from = bytes) {
      Number.Check(C.detent_scene3_restore(context.Memory, Handle, from, (uint)bytes.Length));
    }
  }
  /// <summary>The first fields that differ, one per line.</summary>
  public string Diff(Scene3 other, uint most = 16) {
    uint size;
    if (!Number.Check(C.detent_scene3_diff(context.Memory, Handle, other.Handle, most, null, 0, &size))) {
      return "";
    }
    var bytes = new byte[size];
    fixed (byte* to = bytes) {
      Number.Check(C.detent_scene3_diff(context.Memory, Handle, other.Handle, most, to, size, &size));
    }
    return System.Text.Encoding.ASCII.GetString(bytes);
  }
}

/// <summary>Moving bodies. For functions missing here, call C with Handle.</summary>
public unsafe class World3 {
  internal readonly Context context;
  public readonly uint Handle;

  public static World3Settings DefaultSettings() {
    World3Settings settings;
    Number.Check(C.detent_world3_default_settings(&settings));
    return settings;
  }
  public static Body3Options DefaultOptions() {
    Body3Options options;
    Number.Check(C.detent_body3_default_options(&options));
    return options;
  }

  internal World3(Context context, uint handle) {
    this.context = context;
    Handle = handle;
  }
  public World3(Context context) : this(context, DefaultSettings()) {}
  public World3(Context context, World3Settings settings) {
    this.context = context;
    uint handle;
    Number.Check(C.detent_world3_create(context.Memory, &settings, &handle));
    Handle = handle;
  }
  public void Destroy() { Number.Check(C.detent_world3_destroy(context.Memory, Handle)); }

  public Id Add(Shape3 shape) { return Add(shape, DefaultOptions()); }
  public Id Add(Shape3 shape, Body3Options options) {
    Id id;
    Number.Check(C.detent_world3_add(context.Memory, Handle, &shape, &options, &id));
    return id;
  }
  public bool Remove(Id id) { return Number.Check(C.detent_world3_remove(context.Memory, Handle, id)); }
  public void Step() { Number.Check(C.detent_world3_step(context.Memory, Handle)); }
  public bool Get(Id id, out Body3 body) {
    fixed (Body3* to = &body) return Number.Check(C.detent_world3_body(context.Memory, Handle, id, to));
  }
  public bool SetPosition(Id id, Vec3 position) {
    return Number.Check(C.detent_world3_set_position(context.Memory, Handle, id, &position));
  }
  public bool SetRotation(Id id, Rotation3 rotation) {
    return Number.Check(C.detent_world3_set_rotation(context.Memory, Handle, id, &rotation));
  }
  public bool SetFilter(Id id, uint layers, uint collidesWith) {
    return Number.Check(C.detent_world3_set_filter(context.Memory, Handle, id, layers, collidesWith));
  }
  public bool SetFriction(Id id, int friction) {
    return Number.Check(C.detent_world3_set_friction(context.Memory, Handle, id, friction));
  }
  public bool SetRestitution(Id id, int restitution) {
    return Number.Check(C.detent_world3_set_restitution(context.Memory, Handle, id, restitution));
  }
  public bool SetSensor(Id id, bool isSensor) {
    return Number.Check(C.detent_world3_set_sensor(context.Memory, Handle, id, isSensor ? 1u : 0u));
  }
  public bool SetGravityScale(Id id, int scale) {
    return Number.Check(C.detent_world3_set_gravity_scale(context.Memory, Handle, id, scale));
  }
  public bool SetDamping(Id id, int linear, int angular) {
    return Number.Check(C.detent_world3_set_damping(context.Memory, Handle, id, linear, angular));
  }
  public bool SetLocked(Id id, uint locked) {
    return Number.Check(C.detent_world3_set_locked(context.Memory, Handle, id, locked));
  }
  public bool SetFast(Id id, bool isFast) {
    return Number.Check(C.detent_world3_set_fast(context.Memory, Handle, id, isFast ? 1u : 0u));
  }
  public bool SetUser(Id id, ulong user) {
    return Number.Check(C.detent_world3_set_user(context.Memory, Handle, id, user));
  }
  /// <summary>Sets the gravity of the world and wakes all bodies.</summary>
  public void SetGravity(Vec3 gravity) {
    Number.Check(C.detent_world3_set_gravity(context.Memory, Handle, &gravity));
  }
  /// <summary>Writes as many contacts of a body as there is room for; new Id() for those of all.
  /// Returns how many there are. The first `count` of their points are set.</summary>
  public int Contacts(Id id, World3Contact[] contacts) {
    uint count;
    fixed (World3Contact* to = contacts) {
      Number.Check(C.detent_world3_contacts(context.Memory, Handle, id, to, (uint)contacts.Length, &count));
    }
    return (int)count;
  }
  public bool SetVelocity(Id id, Vec3 velocity) {
    return Number.Check(C.detent_world3_set_velocity(context.Memory, Handle, id, &velocity));
  }
  public bool ApplyImpulse(Id id, Vec3 impulse, Vec3 at) {
    return Number.Check(C.detent_world3_apply_impulse(context.Memory, Handle, id, &impulse, &at));
  }
  public bool ApplyForce(Id id, Vec3 force, Vec3 at) {
    return Number.Check(C.detent_world3_apply_force(context.Memory, Handle, id, &force, &at));
  }
  public int Size {
    get {
      uint size;
      Number.Check(C.detent_world3_size(context.Memory, Handle, &size));
      return (int)size;
    }
  }
  public ulong Digest() {
    ulong digest;
    Number.Check(C.detent_world3_digest(context.Memory, Handle, &digest));
    return digest;
  }
  public byte[] Snapshot() {
    uint size;
    Number.Check(C.detent_world3_snapshot(context.Memory, Handle, null, 0, &size));
    var bytes = new byte[size];
    fixed (byte* to = bytes) {
      Number.Check(C.detent_world3_snapshot(context.Memory, Handle, to, size, &size));
    }
    return bytes;
  }
  public void Restore(byte[] bytes) {
    fixed (byte* from = bytes) {
      Number.Check(C.detent_world3_restore(context.Memory, Handle, from, (uint)bytes.Length));
    }
  }
  /// <summary>The first fields that differ, one per line.</summary>
  public string Diff(World3 other, uint most = 16) {
    uint size;
    if (!Number.Check(C.detent_world3_diff(context.Memory, Handle, other.Handle, most, null, 0, &size))) {
      return "";
    }
    var bytes = new byte[size];
    fixed (byte* to = bytes) {
      Number.Check(C.detent_world3_diff(context.Memory, Handle, other.Handle, most, to, size, &size));
    }
    return System.Text.Encoding.ASCII.GetString(bytes);
  }
}

/// <summary>The world of a session or replay, with words of game state that a rollback also
/// restores. It can be changed only during a frame.</summary>
public sealed unsafe class PlayedWorld3 : World3 {
  internal PlayedWorld3(Context context, uint handle) : base(context, handle) {}

  /// <summary>Their number is in the settings.</summary>
  public void GetWords(uint[] words) {
    fixed (uint* to = words) Number.Check(C.detent_world3_words(context.Memory, Handle, to));
  }
  public void SetWords(uint[] words) {
    fixed (uint* from = words) Number.Check(C.detent_world3_set_words(context.Memory, Handle, from));
  }
}

/// <summary>A network match from a world that all peers start with. No call allocates garbage
/// except Replay and the names of events.</summary>
public sealed unsafe class Session3 {
  readonly Context context;
  public readonly uint Handle;
  public readonly PlayedWorld3 World;
  /// <summary>The inputs of all players in the open frame, concatenated.</summary>
  public readonly byte[] Inputs;
  readonly uint inputSize;

  public Session3(Context context, World3 start, SessionSettings settings) {
    this.context = context;
    uint handle, world;
    Number.Check(C.detent_session3_create(context.Memory, &settings, start.Handle, &handle));
    Handle = handle;
    Number.Check(C.detent_session3_world(context.Memory, Handle, &world));
    World = new PlayedWorld3(context, world);
    inputSize = settings.input_size;
    Inputs = new byte[C.PLAYERS * inputSize];
  }
  public void Destroy() { Number.Check(C.detent_session3_destroy(context.Memory, Handle)); }

  /// <summary>True if there is a frame to simulate: change World depending only on Inputs, step it,
  /// call EndFrame, and repeat with the same input. Otherwise frame.state says why not.</summary>
  public bool BeginFrame(byte[] pad, out Frame frame) {
    if (pad.Length != inputSize) throw new DetentException(C.BAD_ARGUMENT);
    fixed (byte* from = pad, to = Inputs) fixed (Frame* into = &frame) {
      return Number.Check(C.detent_session3_begin_frame(context.Memory, Handle, from, into, to));
    }
  }
  public void EndFrame() { Number.Check(C.detent_session3_end_frame(context.Memory, Handle)); }
  /// <summary>Takes a packet that arrived at a time in microseconds; false if it was not
  /// used.</summary>
  public bool Receive(uint peer, byte[] packet, int size, ulong now) {
    if ((uint)size > (uint)packet.Length) throw new DetentException(C.BAD_ARGUMENT);
    fixed (byte* from = packet) {
      return Number.Check(C.detent_session3_receive(context.Memory, Handle, peer, from, (uint)size, now));
    }
  }
  /// <summary>The next packet due, in an array of C.PACKET bytes.</summary>
  public bool Packet(ulong now, byte[] packet, out uint peer, out int size) {
    uint to, count;
    bool isDue;
    fixed (byte* at = packet) {
      isDue = Number.Check(C.detent_session3_packet(context.Memory, Handle, now, &to, at,
                                                      (uint)packet.Length, &count));
    }
    peer = isDue ? to : 0;
    size = isDue ? (int)count : 0;
    return isDue;
  }
  /// <summary>The next event, and the name of the field that differs, or null.</summary>
  public bool Event(out SessionEvent happened, out string field) {
    byte* name = stackalloc byte[(int)C.NAME];
    SessionEvent own;
    bool isThere = Number.Check(C.detent_session3_event(context.Memory, Handle, &own, name, C.NAME));
    happened = isThere ? own : default(SessionEvent);
    field = isThere && own.name_size != 0 ? new string((sbyte*)name, 0, (int)own.name_size) : null;
    return isThere;
  }
  public SessionStatus Status {
    get {
      SessionStatus status;
      Number.Check(C.detent_session3_status(context.Memory, Handle, &status));
      return status;
    }
  }
  /// <summary>The number of frames known to be equal at the peer and here.</summary>
  public uint Matched(uint peer) {
    uint frame;
    Number.Check(C.detent_session3_matched(context.Memory, Handle, peer, &frame));
    return frame;
  }
  public bool IsAwaited(uint player) {
    return Number.Check(C.detent_session3_is_awaited(context.Memory, Handle, player));
  }
  public void Drop(uint peer) { Number.Check(C.detent_session3_drop(context.Memory, Handle, peer)); }
  public void Pause(bool isPaused) {
    Number.Check(C.detent_session3_pause(context.Memory, Handle, isPaused ? 1u : 0u));
  }
  /// <summary>The replay of all final frames, or null if none is recorded.</summary>
  public byte[] Replay() {
    uint size;
    Number.Check(C.detent_session3_replay(context.Memory, Handle, null, 0, &size));
    if (size == 0) return null;
    var bytes = new byte[size];
    fixed (byte* to = bytes) {
      Number.Check(C.detent_session3_replay(context.Memory, Handle, to, size, &size));
    }
    return bytes;
  }
}

/// <summary>A replay to resimulate, with the inputs and words of its session.</summary>
public sealed unsafe class Replay3 {
  readonly Context context;
  public readonly uint Handle;
  public readonly PlayedWorld3 World;
  /// <summary>The inputs of all players in the open frame, concatenated.</summary>
  public readonly byte[] Inputs;

  public Replay3(Context context, World3 start, byte[] bytes, uint inputSize, uint words) {
    this.context = context;
    uint handle, world;
    fixed (byte* from = bytes) {
      Number.Check(C.detent_replay3_create(context.Memory, from, (uint)bytes.Length, start.Handle,
                                             inputSize, words, &handle));
    }
    Handle = handle;
    Number.Check(C.detent_replay3_world(context.Memory, Handle, &world));
    World = new PlayedWorld3(context, world);
    Inputs = new byte[C.PLAYERS * inputSize];
  }
  public void Destroy() { Number.Check(C.detent_replay3_destroy(context.Memory, Handle)); }
  public bool BeginFrame(out Frame frame) {
    fixed (byte* to = Inputs) fixed (Frame* into = &frame) {
      return Number.Check(C.detent_replay3_begin_frame(context.Memory, Handle, into, to));
    }
  }
  public void EndFrame() { Number.Check(C.detent_replay3_end_frame(context.Memory, Handle)); }
  public ReplayCheck Check() {
    ReplayCheck check;
    Number.Check(C.detent_replay3_check(context.Memory, Handle, &check));
    return check;
  }
}

}
