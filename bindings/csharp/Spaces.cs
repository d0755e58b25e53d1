// SPDX-License-Identifier: MIT
// Written by bindings/generate from bindings/csharp/spaces.cs.in: change that file instead.
// Shapes, scenes and worlds of both dimensions. Calls make no garbage but for Snapshot.
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

/// <summary>Objects, and queries over all of them. What is not here is in C, with Handle.</summary>
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
}

/// <summary>Bodies that move. What is not here is in C, with Handle.</summary>
public sealed unsafe class World2 {
  readonly Context context;
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

/// <summary>Objects, and queries over all of them. What is not here is in C, with Handle.</summary>
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
}

/// <summary>Bodies that move. What is not here is in C, with Handle.</summary>
public sealed unsafe class World3 {
  readonly Context context;
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
}

}
