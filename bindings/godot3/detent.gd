# SPDX-License-Identifier: MIT
# Simulates the collision nodes of a Godot 3 scene in a world of detent. Each physics body below a
# node becomes a body: a fixed one for a StaticBody, a dynamic one for a RigidBody, with the shape
# of its first CollisionShape, a sphere or an unrotated box. Godot's own physics does not run;
# `show` moves the nodes.
#
# Numbers are integers; a length of 1 is 65536. Node positions are rounded to them once, at the
# start. Everything after that is the same on every machine.
extends Reference

const ONE = 65536
const UNIT = 1 << 30
const SPHERE = 1
const OBB = 3
const MOVING = 0
const KINEMATIC = 1
const FIXED = 2
const NONE = -1000

const LOCK_X = 1
const LOCK_Y = 2
const LOCK_Z = 4
const LOCK_TURN_X = 8
const LOCK_TURN_Y = 16
const LOCK_TURN_Z = 32

const DISTANCE_JOINT = 1
const BALL_JOINT = 2
const HINGE_JOINT = 3
const WELD_JOINT = 4
const SLIDER_JOINT = 5
const WHEEL_JOINT = 6
const CONE_JOINT = 7

# The fields of a joint, those of detent_joint3, and how many numbers each has. Lengths, angles, speeds
# and forces are in steps of 1 / ONE, frames in steps of 1 / UNIT; collide and has_limits are flags.
const JOINT_FIELDS = {"kind": 1, "a": 1, "b": 1, "anchor_a": 3, "anchor_b": 3, "frame_a": 9, "frame_b": 9,
		"collide": 1, "break_force": 1, "has_limits": 1, "lower": 1, "upper": 1, "motor_speed": 1,
		"motor_force": 1, "length": 1, "frequency": 1, "damping_ratio": 1, "cone_angle": 1}

# Axes of a joint. Sliders and wheels move along axis 0; hinges, wheels and cones turn about axis 2.
const AXES_XYZ = [UNIT, 0, 0, 0, UNIT, 0, 0, 0, UNIT]
const AXES_YZX = [0, UNIT, 0, 0, 0, UNIT, UNIT, 0, 0]
const AXES_ZXY = [0, 0, UNIT, UNIT, 0, 0, 0, UNIT, 0]

var native = GDNative.new()

func open():
	native.library = load("res://detent.gdnlib")
	return native.initialize()

func close():
	native.terminate()

# Calls a procedure of detent_godot.c by name.
func run(name, arguments = []):
	return native.call_native("standard_varcall", "detent_godot_" + name, arguments)

static func raw(length):
	return int(round(length * ONE))

static func raws(vector):
	return [raw(vector.x), raw(vector.y), raw(vector.z)]

# A body's shape as numbers: its kind, its center, and a radius or half extents.
func shape_of(body):
	for child in body.get_children():
		if child is CollisionShape:
			var center = raws(child.global_transform.origin)
			if child.shape is SphereShape:
				return [SPHERE] + center + [raw(child.shape.radius)]
			if child.shape is BoxShape:
				return [OBB] + center + raws(child.shape.extents)
	return []

# Adds the bodies below a node to a world, in scene order. Returns their ids by node.
func add_bodies(world, node, ids = {}):
	for child in node.get_children():
		if child is StaticBody or child is RigidBody:
			var motion = FIXED if child is StaticBody else MOVING
			ids[child] = run("add_body", [world, motion] + shape_of(child))
		else:
			add_bodies(world, child, ids)
	return ids

# The position of a body as three numbers.
func position(world, body):
	var bytes = run("body", [world, body])
	return [word(bytes, 0), word(bytes, 1), word(bytes, 2)]

# A joint of two bodies at a point of the world, or between that point of a and another of b: a
# Dictionary. Change its fields, then add it. NONE if one of the bodies is missing.
func joint_at(world, kind, a, b, point, axes = AXES_XYZ, point_of_b = []):
	return joint_of(run("joint_at", [world, kind, a, b] + point + (point_of_b if point_of_b else point) + axes))

# Returns the joint's id, or NONE if one of the bodies is missing.
func add_joint(world, joint):
	return run("add_joint", [world] + numbers_of(joint))

func change_joint(world, id, joint):
	return run("change_joint", [world, id] + numbers_of(joint))

# A joint as it was added or last changed, or NONE.
func joint(world, id):
	return joint_of(run("joint", [world, id]))

# Converts the numbers of a joint to its fields; keeps a status.
static func joint_of(numbers):
	if not numbers is Array:
		return numbers
	var joint = {}
	var i = 0
	for field in JOINT_FIELDS:
		var size = JOINT_FIELDS[field]
		joint[field] = numbers[i] if size == 1 else numbers.slice(i, i + size - 1)
		i += size
	return joint

static func numbers_of(joint):
	var numbers = []
	for field in joint:
		if not JOINT_FIELDS.has(field):
			push_error("a joint has no field " + str(field))
			return []
	for field in JOINT_FIELDS:
		numbers += [joint[field]] if JOINT_FIELDS[field] == 1 else joint[field]
	return numbers

# Moves the nodes to their bodies' positions.
func show(world, ids):
	for node in ids:
		if node is RigidBody:
			var at = position(world, ids[node])
			node.global_transform.origin = Vector3(at[0], at[1], at[2]) / ONE

# Reads a signed 32-bit number from bytes.
static func word(bytes, i):
	var value = bytes[4 * i] | bytes[4 * i + 1] << 8 | bytes[4 * i + 2] << 16 | bytes[4 * i + 3] << 24
	return value - (1 << 32) if value >= 1 << 31 else value
