// SPDX-License-Identifier: MIT
// Written by bindings/generate from bindings/csharp/spaces.cs.in: change that file instead.
// Shapes, scenes and worlds of both dimensions. No call allocates garbage, except those that give an
// array or a string.
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

/// <summary>Moving bodies and their joints.</summary>
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
  /// <summary>A joint to add, of a kind such as C.HINGE_JOINT, at the centers of the bodies, without
  /// limits, motor or spring. A distance joint has the limits 0 and 1.</summary>
  public static Joint2 DefaultJoint(uint kind, Id a, Id b) {
    Joint2 joint;
    Number.Check(C.detent_joint2_defaults(kind, &joint));
    joint.a = a;
    joint.b = b;
    return joint;
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
  /// <summary>Adds a body with an id of your choice; false if it is taken or cannot be used.</summary>
  public bool AddAs(Id id, Shape2 shape, Body2Options options) {
    return Number.Check(C.detent_world2_add_as(context.Memory, Handle, id, &shape, &options));
  }
  public bool Remove(Id id) { return Number.Check(C.detent_world2_remove(context.Memory, Handle, id)); }
  public void Step() { Number.Check(C.detent_world2_step(context.Memory, Handle)); }
  public bool Get(Id id, out Body2 body) {
    fixed (Body2* to = &body) return Number.Check(C.detent_world2_body(context.Memory, Handle, id, to));
  }
  /// <summary>Writes the states of the first `count` ids; zeros for those that do not exist.</summary>
  public void Bodies(Id[] ids, Body2[] bodies, int count) {
    if ((uint)count > (uint)ids.Length || count > bodies.Length) throw new DetentException(C.BAD_ARGUMENT);
    fixed (Id* from = ids) fixed (Body2* to = bodies) {
      Number.Check(C.detent_world2_bodies(context.Memory, Handle, from, (uint)count, to));
    }
  }
  /// <summary>Writes as many ids of bodies as there is room for. Returns how many there are, like
  /// Size.</summary>
  public int BodyIds(Id[] ids) {
    uint count;
    fixed (Id* to = ids) {
      Number.Check(C.detent_world2_body_ids(context.Memory, Handle, to, (uint)ids.Length, &count));
    }
    return (int)count;
  }
  /// <summary>The layers, motion and other properties of a body.</summary>
  public bool GetInfo(Id id, out BodyInfo info) {
    fixed (BodyInfo* to = &info) return Number.Check(C.detent_world2_info(context.Memory, Handle, id, to));
  }
  /// <summary>The frame in which a compound's parts or a hull's points were given.</summary>
  public bool GetFrame(Id id, out Transform2 frame) {
    fixed (Transform2* to = &frame) {
      return Number.Check(C.detent_world2_frame(context.Memory, Handle, id, to));
    }
  }
  /// <summary>The body of an object of a scene that follows this world, and the part of a
  /// compound.</summary>
  public bool PartOf(Id found, out Id body, out uint part) {
    fixed (Id* to = &body) fixed (uint* index = &part) {
      return Number.Check(C.detent_world2_part_of(context.Memory, Handle, found, to, index));
    }
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
  /// <summary>Writes as many pairs that touch as there is room for, of one body; new Id() for those
  /// of all. Returns how many there are.</summary>
  public int Touching(Id id, Touch[] touches) {
    uint count;
    fixed (Touch* to = touches) {
      Number.Check(C.detent_world2_touching(context.Memory, Handle, id, to, (uint)touches.Length, &count));
    }
    return (int)count;
  }
  /// <summary>Writes as many pairs that began or ceased to touch in the last step as there is room
  /// for. Returns how many there are.</summary>
  public int Events(Touch[] touches) {
    uint count;
    fixed (Touch* to = touches) {
      Number.Check(C.detent_world2_events(context.Memory, Handle, to, (uint)touches.Length, &count));
    }
    return (int)count;
  }
  public bool SetVelocity(Id id, Vec2 velocity) {
    return Number.Check(C.detent_world2_set_velocity(context.Memory, Handle, id, &velocity));
  }
  /// <summary>In radians per second, in steps of 2^-16.</summary>
  public bool SetAngularVelocity(Id id, int velocity) {
    return Number.Check(C.detent_world2_set_angular_velocity(context.Memory, Handle, id, (int*)&velocity));
  }
  /// <summary>Applies an impulse at the center of mass.</summary>
  public bool ApplyImpulse(Id id, Vec2 impulse) {
    return Number.Check(C.detent_world2_apply_impulse(context.Memory, Handle, id, &impulse, null));
  }
  public bool ApplyImpulse(Id id, Vec2 impulse, Vec2 at) {
    return Number.Check(C.detent_world2_apply_impulse(context.Memory, Handle, id, &impulse, &at));
  }
  /// <summary>Applies a force at the center of mass during the next step.</summary>
  public bool ApplyForce(Id id, Vec2 force) {
    return Number.Check(C.detent_world2_apply_force(context.Memory, Handle, id, &force, null));
  }
  public bool ApplyForce(Id id, Vec2 force, Vec2 at) {
    return Number.Check(C.detent_world2_apply_force(context.Memory, Handle, id, &force, &at));
  }
  /// <summary>Applies a torque during the next step.</summary>
  public bool ApplyTorque(Id id, int torque) {
    return Number.Check(C.detent_world2_apply_torque(context.Memory, Handle, id, (int*)&torque));
  }

  /// <summary>Joins two bodies; see DefaultJoint. False if one does not exist or both are the
  /// same.</summary>
  public bool AddJoint(Joint2 joint, out Id id) {
    fixed (Id* to = &id) return Number.Check(C.detent_world2_add_joint(context.Memory, Handle, &joint, to));
  }
  /// <summary>Replaces a joint by another of the same kind, such as that of GetJoint with another
  /// motor.</summary>
  public bool ChangeJoint(Id id, Joint2 joint) {
    return Number.Check(C.detent_world2_change_joint(context.Memory, Handle, id, &joint));
  }
  public bool RemoveJoint(Id id) {
    return Number.Check(C.detent_world2_remove_joint(context.Memory, Handle, id));
  }
  /// <summary>A joint as it was added or last changed.</summary>
  public bool GetJoint(Id id, out Joint2 joint) {
    fixed (Joint2* to = &joint) {
      return Number.Check(C.detent_world2_joint(context.Memory, Handle, id, to));
    }
  }
  /// <summary>The force of a joint on its body b in the last step.</summary>
  public bool JointForce(Id id, out Vec2 force) {
    fixed (Vec2* to = &force) {
      return Number.Check(C.detent_world2_joint_force(context.Memory, Handle, id, to));
    }
  }
  /// <summary>The torque on body b in the last step by a joint's motor, limits and alignment, without
  /// that of its force.</summary>
  public bool JointTorque(Id id, out int torque) {
    fixed (int* to = &torque) {
      return Number.Check(C.detent_world2_joint_torque(context.Memory, Handle, id, (int*)to));
    }
  }
  public int JointCount {
    get {
      uint count;
      Number.Check(C.detent_world2_joint_count(context.Memory, Handle, &count));
      return (int)count;
    }
  }
  /// <summary>Writes as many ids of joints as there is room for. Returns how many there are, like
  /// JointCount.</summary>
  public int JointIds(Id[] ids) {
    uint count;
    fixed (Id* to = ids) {
      Number.Check(C.detent_world2_joint_ids(context.Memory, Handle, to, (uint)ids.Length, &count));
    }
    return (int)count;
  }
  /// <summary>Writes as many ids of joints that broke in the last step, and so were removed, as there
  /// is room for. Returns how many there are.</summary>
  public int Broken(Id[] ids) {
    uint count;
    fixed (Id* to = ids) {
      Number.Check(C.detent_world2_broken(context.Memory, Handle, to, (uint)ids.Length, &count));
    }
    return (int)count;
  }
  /// <summary>Converts a world point to a body's frame, for the anchor of a joint.</summary>
  public bool LocalPoint(Id id, Vec2 point, out Vec2 local) {
    fixed (Vec2* to = &local) {
      return Number.Check(C.detent_world2_local_point(context.Memory, Handle, id, &point, to));
    }
  }
  /// <summary>Converts world axes to a body's frame, for the frame of a joint.</summary>
  public bool LocalFrame(Id id, Rotation2 axes, out Rotation2 local) {
    fixed (Rotation2* to = &local) {
      return Number.Check(C.detent_world2_local_frame(context.Memory, Handle, id, &axes, to));
    }
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
  /// <summary>The digest of one body.</summary>
  public bool DigestOf(Id id, out ulong digest) {
    fixed (ulong* to = &digest) return Number.Check(C.detent_world2_digest_of(context.Memory, Handle, id, to));
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

/// <summary>Moving bodies and their joints.</summary>
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
  /// <summary>A joint to add, of a kind such as C.HINGE_JOINT, at the centers of the bodies, without
  /// limits, motor or spring. A distance joint has the limits 0 and 1.</summary>
  public static Joint3 DefaultJoint(uint kind, Id a, Id b) {
    Joint3 joint;
    Number.Check(C.detent_joint3_defaults(kind, &joint));
    joint.a = a;
    joint.b = b;
    return joint;
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
  /// <summary>Adds a body with an id of your choice; false if it is taken or cannot be used.</summary>
  public bool AddAs(Id id, Shape3 shape, Body3Options options) {
    return Number.Check(C.detent_world3_add_as(context.Memory, Handle, id, &shape, &options));
  }
  public bool Remove(Id id) { return Number.Check(C.detent_world3_remove(context.Memory, Handle, id)); }
  public void Step() { Number.Check(C.detent_world3_step(context.Memory, Handle)); }
  public bool Get(Id id, out Body3 body) {
    fixed (Body3* to = &body) return Number.Check(C.detent_world3_body(context.Memory, Handle, id, to));
  }
  /// <summary>Writes the states of the first `count` ids; zeros for those that do not exist.</summary>
  public void Bodies(Id[] ids, Body3[] bodies, int count) {
    if ((uint)count > (uint)ids.Length || count > bodies.Length) throw new DetentException(C.BAD_ARGUMENT);
    fixed (Id* from = ids) fixed (Body3* to = bodies) {
      Number.Check(C.detent_world3_bodies(context.Memory, Handle, from, (uint)count, to));
    }
  }
  /// <summary>Writes as many ids of bodies as there is room for. Returns how many there are, like
  /// Size.</summary>
  public int BodyIds(Id[] ids) {
    uint count;
    fixed (Id* to = ids) {
      Number.Check(C.detent_world3_body_ids(context.Memory, Handle, to, (uint)ids.Length, &count));
    }
    return (int)count;
  }
  /// <summary>The layers, motion and other properties of a body.</summary>
  public bool GetInfo(Id id, out BodyInfo info) {
    fixed (BodyInfo* to = &info) return Number.Check(C.detent_world3_info(context.Memory, Handle, id, to));
  }
  /// <summary>The frame in which a compound's parts or a hull's points were given.</summary>
  public bool GetFrame(Id id, out Transform3 frame) {
    fixed (Transform3* to = &frame) {
      return Number.Check(C.detent_world3_frame(context.Memory, Handle, id, to));
    }
  }
  /// <summary>The body of an object of a scene that follows this world, and the part of a
  /// compound.</summary>
  public bool PartOf(Id found, out Id body, out uint part) {
    fixed (Id* to = &body) fixed (uint* index = &part) {
      return Number.Check(C.detent_world3_part_of(context.Memory, Handle, found, to, index));
    }
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
  /// <summary>Writes as many pairs that touch as there is room for, of one body; new Id() for those
  /// of all. Returns how many there are.</summary>
  public int Touching(Id id, Touch[] touches) {
    uint count;
    fixed (Touch* to = touches) {
      Number.Check(C.detent_world3_touching(context.Memory, Handle, id, to, (uint)touches.Length, &count));
    }
    return (int)count;
  }
  /// <summary>Writes as many pairs that began or ceased to touch in the last step as there is room
  /// for. Returns how many there are.</summary>
  public int Events(Touch[] touches) {
    uint count;
    fixed (Touch* to = touches) {
      Number.Check(C.detent_world3_events(context.Memory, Handle, to, (uint)touches.Length, &count));
    }
    return (int)count;
  }
  public bool SetVelocity(Id id, Vec3 velocity) {
    return Number.Check(C.detent_world3_set_velocity(context.Memory, Handle, id, &velocity));
  }
  /// <summary>In radians per second, in steps of 2^-16.</summary>
  public bool SetAngularVelocity(Id id, Vec3 velocity) {
    return Number.Check(C.detent_world3_set_angular_velocity(context.Memory, Handle, id, (int*)&velocity));
  }
  /// <summary>Applies an impulse at the center of mass.</summary>
  public bool ApplyImpulse(Id id, Vec3 impulse) {
    return Number.Check(C.detent_world3_apply_impulse(context.Memory, Handle, id, &impulse, null));
  }
  public bool ApplyImpulse(Id id, Vec3 impulse, Vec3 at) {
    return Number.Check(C.detent_world3_apply_impulse(context.Memory, Handle, id, &impulse, &at));
  }
  /// <summary>Applies a force at the center of mass during the next step.</summary>
  public bool ApplyForce(Id id, Vec3 force) {
    return Number.Check(C.detent_world3_apply_force(context.Memory, Handle, id, &force, null));
  }
  public bool ApplyForce(Id id, Vec3 force, Vec3 at) {
    return Number.Check(C.detent_world3_apply_force(context.Memory, Handle, id, &force, &at));
  }
  /// <summary>Applies a torque during the next step.</summary>
  public bool ApplyTorque(Id id, Vec3 torque) {
    return Number.Check(C.detent_world3_apply_torque(context.Memory, Handle, id, (int*)&torque));
  }

  /// <summary>Joins two bodies; see DefaultJoint. False if one does not exist or both are the
  /// same.</summary>
  public bool AddJoint(Joint3 joint, out Id id) {
    fixed (Id* to = &id) return Number.Check(C.detent_world3_add_joint(context.Memory, Handle, &joint, to));
  }
  /// <summary>Replaces a joint by another of the same kind, such as that of GetJoint with another
  /// motor.</summary>
  public bool ChangeJoint(Id id, Joint3 joint) {
    return Number.Check(C.detent_world3_change_joint(context.Memory, Handle, id, &joint));
  }
  public bool RemoveJoint(Id id) {
    return Number.Check(C.detent_world3_remove_joint(context.Memory, Handle, id));
  }
  /// <summary>A joint as it was added or last changed.</summary>
  public bool GetJoint(Id id, out Joint3 joint) {
    fixed (Joint3* to = &joint) {
      return Number.Check(C.detent_world3_joint(context.Memory, Handle, id, to));
    }
  }
  /// <summary>The force of a joint on its body b in the last step.</summary>
  public bool JointForce(Id id, out Vec3 force) {
    fixed (Vec3* to = &force) {
      return Number.Check(C.detent_world3_joint_force(context.Memory, Handle, id, to));
    }
  }
  /// <summary>The torque on body b in the last step by a joint's motor, limits and alignment, without
  /// that of its force.</summary>
  public bool JointTorque(Id id, out Vec3 torque) {
    fixed (Vec3* to = &torque) {
      return Number.Check(C.detent_world3_joint_torque(context.Memory, Handle, id, (int*)to));
    }
  }
  public int JointCount {
    get {
      uint count;
      Number.Check(C.detent_world3_joint_count(context.Memory, Handle, &count));
      return (int)count;
    }
  }
  /// <summary>Writes as many ids of joints as there is room for. Returns how many there are, like
  /// JointCount.</summary>
  public int JointIds(Id[] ids) {
    uint count;
    fixed (Id* to = ids) {
      Number.Check(C.detent_world3_joint_ids(context.Memory, Handle, to, (uint)ids.Length, &count));
    }
    return (int)count;
  }
  /// <summary>Writes as many ids of joints that broke in the last step, and so were removed, as there
  /// is room for. Returns how many there are.</summary>
  public int Broken(Id[] ids) {
    uint count;
    fixed (Id* to = ids) {
      Number.Check(C.detent_world3_broken(context.Memory, Handle, to, (uint)ids.Length, &count));
    }
    return (int)count;
  }
  /// <summary>Converts a world point to a body's frame, for the anchor of a joint.</summary>
  public bool LocalPoint(Id id, Vec3 point, out Vec3 local) {
    fixed (Vec3* to = &local) {
      return Number.Check(C.detent_world3_local_point(context.Memory, Handle, id, &point, to));
    }
  }
  /// <summary>Converts world axes to a body's frame, for the frame of a joint.</summary>
  public bool LocalFrame(Id id, Rotation3 axes, out Rotation3 local) {
    fixed (Rotation3* to = &local) {
      return Number.Check(C.detent_world3_local_frame(context.Memory, Handle, id, &axes, to));
    }
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
  /// <summary>The digest of one body.</summary>
  public bool DigestOf(Id id, out ulong digest) {
    fixed (ulong* to = &digest) return Number.Check(C.detent_world3_digest_of(context.Memory, Handle, id, to));
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
