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
const FIXED = 2
const NONE = -1000

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
