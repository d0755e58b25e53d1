# SPDX-License-Identifier: MIT
# The scripted match that every binding plays: boxes fall on a floor, a scene holds a ball around
# each, and rays are cast down at them. Two sessions then play a match with the collision nodes of
# this scene, while every fifth packet is lost. Prints a digest of all results, 16 digits equal to
# those of tests/c/match.cpp.
extends Spatial

const Detent = preload("res://detent.gd")
const ONE = 65536
const BODIES = 12
const TICKS = 120
const RAYS = 8
const FRAMES = 120

var detent = Detent.new()
var state = 1
var sum = 0
var failed = false

func draw(count):
	state = (state * 1664525 + 1013904223) & 0xffffffff
	return (state >> 8) % count

func mix(value):
	sum = sum * 6364136223846793005 + value

func require(is_so, what):
	if not is_so:
		failed = true
		print("failed: ", what)

# Adds a physics body with a shape around its center below a node.
func add_node(kind, parent, shape, center):
	var body = kind.new()
	var collision = CollisionShape.new()
	collision.shape = shape
	body.add_child(collision)
	parent.add_child(body)
	body.translation = Vector3(center[0], center[1], center[2]) / ONE
	return body

func play():
	var level = Spatial.new()
	add_child(level)
	var ground = BoxShape.new()
	ground.extents = Vector3(20, 0.5, 20)
	add_node(StaticBody, level, ground, [0, -ONE / 2, 0])
	var boxes = []
	for i in range(BODIES):
		var x = draw(4 * ONE) - 2 * ONE
		var center = [x, (2 + 2 * i) * ONE, draw(4 * ONE) - 2 * ONE]
		var half = []
		for _k in range(3):
			half.append(ONE / 2 + draw(ONE / 2))
		var shape = BoxShape.new()
		shape.extents = Vector3(half[0], half[1], half[2]) / ONE
		boxes.append(add_node(RigidBody, level, shape, center))
	var world = detent.run("world")
	var ids = detent.add_bodies(world, level)
	var scene = detent.run("scene")
	var balls = []
	for i in range(BODIES):
		var ball = [detent.SPHERE] + detent.position(world, ids[boxes[i]]) + [ONE]
		balls.append(detent.run("add_object", [scene, i] + ball))

	var saved
	for tick in range(TICKS):
		if tick % 10 == 5:
			detent.run("set_velocity", [world, ids[boxes[tick / 10]], ONE, 5 * ONE, 0])
		detent.run("step", [world])
		detent.show(world, ids)
		for i in range(BODIES):
			var at = detent.position(world, ids[boxes[i]])
			detent.run("replace_object", [scene, balls[i], detent.SPHERE] + at + [ONE])
		for _i in range(RAYS):
			var x = draw(8 * ONE) - 4 * ONE
			var hit = detent.run("raycast", [scene, x, 30 * ONE, draw(8 * ONE) - 4 * ONE, 0, -detent.UNIT, 0,
					40 * ONE])
			if hit.size() > 0:
				mix(detent.word(hit, 2) & 0xffffffff)
				mix(detent.word(hit, 0))
				mix(detent.word(hit, 4) & 0xffffffff)
			else:
				mix(0xffffffff)
		mix(detent.run("world_digest", [world]))
		mix(detent.run("scene_digest", [scene]))
		if tick == TICKS / 2:
			saved = detent.run("world_snapshot", [world])
			mix(saved.size())
	detent.run("world_restore", [world, saved])
	for _tick in range(10):
		detent.run("step", [world])
	mix(detent.run("world_digest", [world]))
	remove_child(level)
	level.free()

# A player's input; it takes effect two frames later.
func press(frame, player):
	if frame >= 80:
		return PoolByteArray([0, 0])
	return PoolByteArray([frame / (7 + 4 * player) % 5, frame / 3 % 4])

func simulate(world, balls, inputs):
	for player in range(2):
		var speed = inputs[2 * player]
		var which = inputs[2 * player + 1]
		detent.run("set_word", [world, player, detent.run("word", [world, player]) + speed])
		if speed != 0:
			detent.run("set_velocity", [world, balls[2 * player + which % 2], (speed - 2) * ONE, which * ONE, 0])
	detent.run("step", [world])

func play_for_two():
	var start = detent.run("world")
	var ids = detent.add_bodies(start, self)
	var balls = []
	for i in range(4):
		balls.append(ids[get_node("Ball%d" % i)])
	var sessions = []
	var worlds = []
	for player in range(2):
		sessions.append(detent.run("session", [start, 4711, player, 2, 2, 2]))
		worlds.append(detent.run("session_world", [sessions[player]]))
	var wire = []
	var sent = 0
	var now = 0
	var frames = [0, 0]
	while frames[0] < FRAMES or frames[1] < FRAMES:
		while wire.size() > 8:
			var packet = wire.pop_front()
			var to = packet[0]
			detent.run("receive", [sessions[to], 1 - to, packet.subarray(1, packet.size() - 1), now])
		for player in range(2):
			var pad = press(frames[player], player)
			while frames[player] < FRAMES:
				var inputs = detent.run("begin_frame", [sessions[player], pad])
				if inputs.size() == 0:
					break
				simulate(worlds[player], balls, inputs)
				detent.run("end_frame", [sessions[player]])
			frames[player] = detent.run("session_status", [sessions[player], 0])
			while true:
				var packet = detent.run("packet", [sessions[player], now])
				if packet.size() == 0:
					break
				sent += 1
				if sent % 5 != 0:
					wire.append(packet)
		detent.show(worlds[0], ids)
		now += 16667
	for session in sessions:
		var event = detent.run("event", [session])
		require(event.size() == 6 and event[0] == 0, "both connect")
		require(detent.run("event", [session]).size() == 0, "nothing else happens")
		require(detent.run("session_status", [session, 2]) > 0, "frames are simulated again")
	var digest = detent.run("world_digest", [worlds[0]])
	require(digest == detent.run("world_digest", [worlds[1]]), "both have the same world")
	mix(digest)
	for player in range(2):
		mix(detent.run("word", [worlds[1], player]))
	for ball in range(4):
		var node = get_node("Ball%d" % ball)
		var at = detent.position(worlds[0], balls[ball])
		require(detent.raws(node.global_transform.origin) == at, "the nodes are where the bodies are")

func _ready():
	if not detent.open():
		print("failed: the library does not load")
		get_tree().quit(1)
		return
	play()
	play_for_two()
	print("%08x%08x" % [(sum >> 32) & 0xffffffff, sum & 0xffffffff])
	detent.close()
	get_tree().quit(1 if failed else 0)
