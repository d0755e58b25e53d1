# SPDX-License-Identifier: MIT
# Calls the procedures of detent_godot.c in Godot 3 and checks what they do. The names of all
# procedures are in the environment variable PROCEDURES. Prints "all checks hold" at the end.
extends SceneTree

const Detent = preload("res://detent.gd")
const ONE = 65536

var detent = Detent.new()
var world
var floor_body
var failed = false

func require(is_so, what):
	if not is_so:
		failed = true
		print("failed: ", what)

func run(name, arguments = []):
	return detent.run(name, [world] + arguments)

func new_world():
	world = detent.run("world")
	floor_body = box(detent.FIXED, [0, -ONE, 0], [100 * ONE, ONE, 100 * ONE])

func box(motion, center, half):
	return run("add_body", [motion, detent.OBB] + center + half)

func ball(motion, x, y):
	return run("add_body", [motion, detent.SPHERE, x, y, 0, ONE / 2])

func steps(count):
	for _i in range(count):
		run("step")

func at(body, axis):
	return detent.position(world, body)[axis]

func near(value, expected, tolerance = ONE / 100):
	return abs(value - expected) <= tolerance

func bodies():
	new_world()
	var low = ball(detent.MOVING, 0, ONE / 2)
	var high = ball(detent.MOVING, 5 * ONE, 9 * ONE)
	require(run("body_ids") == [floor_body, low, high], "body_ids are the bodies")
	require(run("is_asleep", [low]) == 0, "a new body is awake")
	steps(20)
	require(at(high, 1) < 9 * ONE, "a ball falls")
	steps(200)
	require(run("is_asleep", [low]) == 1, "a ball at rest sleeps")
	require(run("set_gravity", [0, 10 * ONE, 0]) == 1, "set_gravity")
	require(run("is_asleep", [low]) == 0, "set_gravity wakes bodies")
	steps(60)
	require(at(low, 1) > 5 * ONE and at(high, 1) > 5 * ONE, "bodies fall up")
	require(run("set_position", [low, ONE, 2 * ONE, 3 * ONE]) == 1, "set_position")
	require(detent.position(world, low) == [ONE, 2 * ONE, 3 * ONE], "a body is where it was put")
	require(run("remove_body", [high]) == 1, "remove_body")
	require(run("body_ids") == [floor_body, low], "a removed body is gone")
	require(run("remove_body", [high]) == 0 and run("set_friction", [high, ONE]) == 0, "it cannot be changed")
	require(run("is_asleep", [high]) == detent.NONE and run("velocity", [high]) == detent.NONE, "it has no state")
	require(run("body", [high]).size() == 0, "it has no position")

func setters():
	new_world()
	var slow = box(detent.MOVING, [0, ONE / 2, 0], [ONE / 2, ONE / 2, ONE / 2])
	var slides = box(detent.MOVING, [0, ONE / 2, 5 * ONE], [ONE / 2, ONE / 2, ONE / 2])
	require(run("set_friction", [slides, 0]) == 1, "set_friction")
	for body in [slow, slides]:
		run("set_velocity", [body, 3 * ONE, 0, 0])
	steps(120)
	require(at(slow, 0) < 2 * ONE and near(at(slides, 0), 6 * ONE, ONE / 10), "without friction a box slides")

	new_world()
	var dull = ball(detent.MOVING, 0, 5 * ONE)
	var bouncy = ball(detent.MOVING, 5 * ONE, 5 * ONE)
	require(run("set_restitution", [bouncy, ONE]) == 1, "set_restitution")
	var top = 0
	for tick in range(110):
		run("step")
		if tick > 70:
			require(at(dull, 1) < ONE, "a ball stays on the floor")
			top = max(top, at(bouncy, 1))
	require(top > 3 * ONE, "a ball bounces")

	new_world()
	var passes = ball(detent.MOVING, 0, 2 * ONE)
	var ghost = ball(detent.MOVING, 5 * ONE, 2 * ONE)
	var floats = ball(detent.MOVING, 10 * ONE, 2 * ONE)
	var pinned = ball(detent.MOVING, 15 * ONE, 2 * ONE)
	require(run("set_filter", [passes, 0xfffffffe, 6]) == 1, "set_filter")
	require(run("set_sensor", [ghost, true]) == 1, "set_sensor")
	require(run("set_gravity_scale", [floats, 0]) == 1, "set_gravity_scale")
	require(run("set_locked", [pinned, detent.LOCK_Y | detent.LOCK_TURN_Z]) == 1, "set_locked")
	require(run("set_user", [pinned, -5000000000]) == 1, "set_user")
	require(run("info", [passes]) == [0, 0xfffffffe, 6, detent.MOVING, 0], "info has the layers")
	require(run("info", [ghost])[4] == 1 and run("info", [floor_body])[3] == detent.FIXED, "info has the motion")
	require(run("info", [pinned])[0] == -5000000000, "info has the user word")
	run("set_angular_velocity", [pinned, ONE, 0, ONE])
	steps(1)
	var velocity = run("velocity", [pinned])
	require(velocity[1] == 0 and near(velocity[3], ONE) and velocity[5] == 0, "locked axes do not move")
	steps(99)
	require(at(passes, 1) < -5 * ONE, "a body in another layer falls through the floor")
	require(at(ghost, 1) < -5 * ONE, "a sensor falls through the floor")
	require(at(floats, 1) == 2 * ONE, "a body without gravity floats")
	require(at(pinned, 1) == 2 * ONE, "a locked body stays")
	require(run("set_damping", [floats, 2 * ONE, 3 * ONE]) == 1, "set_damping")
	run("set_velocity", [floats, 4 * ONE, 0, 0])
	run("set_angular_velocity", [floats, 0, 4 * ONE, 0])
	steps(60)
	velocity = run("velocity", [floats])
	require(velocity[0] < ONE and velocity[0] > 0 and velocity[4] < velocity[0] and velocity[4] > 0, "damping")

	new_world()
	run("set_gravity", [0, 0, 0])
	box(detent.FIXED, [20 * ONE, 10 * ONE, 0], [ONE / 64, 5 * ONE, 5 * ONE])
	var tunnels = ball(detent.MOVING, 0, 8 * ONE)
	var stops = ball(detent.MOVING, 0, 12 * ONE)
	require(run("set_fast", [stops, 1]) == 1, "set_fast")
	for body in [tunnels, stops]:
		run("set_velocity", [body, 500 * ONE, 0, 0])
	steps(10)
	require(at(tunnels, 0) > 20 * ONE and at(stops, 0) < 20 * ONE, "a fast body does not tunnel")

func pushes():
	new_world()
	run("set_gravity", [0, 0, 0])
	var pushed = []
	for i in range(5):
		pushed.append(ball(detent.MOVING, 5 * i * ONE, 5 * ONE))
	var mass = 0.5236 * ONE  # of a ball with diameter and density 1
	var impulse = int(mass)
	require(run("apply_impulse", [pushed[0], impulse, 0, 0]) == 1, "apply_impulse")
	require(run("apply_impulse", [pushed[1], impulse, 0, 0, 5 * ONE, 5 * ONE + ONE / 2, 0]) == 1, "at a point")
	require(run("apply_force", [pushed[2], 0, 60 * impulse, 0]) == 1, "apply_force")
	require(run("apply_force", [pushed[3], 0, 60 * impulse, 0, 16 * ONE, 5 * ONE, 0]) == 1, "at a point")
	require(run("apply_torque", [pushed[4], 0, 0, 6 * impulse]) == 1, "apply_torque")
	steps(2)
	var velocities = []
	for body in pushed:
		velocities.append(run("velocity", [body]))
	for i in range(2):
		require(near(velocities[i][0], ONE), "an impulse changes the velocity")
		require(near(velocities[2 + i][1], ONE), "a force lasts for one step")
	require(velocities[0][5] == 0 and velocities[1][5] < -ONE, "an impulse beside the center turns the body")
	require(velocities[2][5] == 0 and velocities[3][5] > ONE, "so does a force")
	require(near(velocities[4][5], ONE) and velocities[4][0] == 0, "a torque turns a body")

func touches():
	new_world()
	var falls = ball(detent.MOVING, 0, ONE)
	var sensor = ball(detent.FIXED, 0, ONE)
	run("set_sensor", [sensor, 1])
	run("step")
	require(run("touch_events") == [[falls, sensor, 1]], "it touches the sensor")
	run("step")
	require(run("touch_events") == [], "it still does: nothing new happens")
	var begins = 0
	for _i in range(60):
		run("step")
		for touch in run("touch_events"):
			require(touch == [floor_body, falls, 1], "it touches the floor")
			begins += 1
	require(begins == 1, "once")
	require(run("touching") == [[floor_body, falls, 1], [falls, sensor, 1]], "touching has all pairs")
	require(run("touching", [sensor]) == [[falls, sensor, 1]], "or those of a body")
	run("set_velocity", [falls, 0, 9 * ONE, 0])
	var ends = []
	for _i in range(30):
		run("step")
		ends += run("touch_events")
	require(ends == [[floor_body, falls, 0], [falls, sensor, 0]], "it leaves both")

func hinge():
	new_world()
	var post = ball(detent.FIXED, 0, 5 * ONE)
	var arm = box(detent.MOVING, [ONE, 5 * ONE, 0], [ONE, ONE / 8, ONE / 8])
	var joint = detent.joint_at(world, detent.HINGE_JOINT, post, arm, [0, 5 * ONE, 0])
	require(joint.anchor_a == [0, 0, 0] and joint.anchor_b == [-ONE, 0, 0], "joint_at has the anchors")
	require(joint.frame_a == detent.AXES_XYZ and joint.frame_b == detent.AXES_XYZ, "and the frames")
	joint.motor_speed = 2 * ONE
	joint.motor_force = 50 * ONE
	var id = detent.add_joint(world, joint)
	require(id != detent.NONE and run("joint_ids") == [id], "add_joint")
	require(str(detent.joint(world, id)) == str(joint), "joint is the joint that was added")
	steps(30)
	require(at(arm, 1) > 5 * ONE + ONE / 2, "a motor lifts an arm")
	joint.motor_speed = 0
	require(detent.change_joint(world, id, joint) == 1, "change_joint")
	require(detent.joint(world, id).motor_speed == 0, "the joint was changed")
	var height = at(arm, 1)
	steps(60)
	require(near(at(arm, 1), height, ONE / 20), "a motor at rest holds it")
	var weight = 2 * 0.25 * 0.25 * 10 * ONE
	var force = run("joint_force", [id])
	require(near(force[0], 0) and near(force[1], weight) and force[2] == 0, "joint_force is its weight")
	var torque = run("joint_torque", [id])
	require(near(torque[2], weight * at(arm, 0) / ONE) and near(torque[0], 0), "joint_torque is that of the motor")
	joint.kind = detent.BALL_JOINT
	require(detent.change_joint(world, id, joint) == 0, "its kind stays")
	joint.motor_force = -1
	require(detent.add_joint(world, joint) == -1, "a negative force is an error")
	require(run("remove_joint", [id]) == 1 and run("joint_ids") == [], "remove_joint")
	require(run("remove_joint", [id]) == 0 and run("joint", [id]) == detent.NONE, "it is gone")
	require(run("joint_force", [id]) == detent.NONE and run("joint_torque", [id]) == detent.NONE, "with its force")
	run("set_sensor", [post, 1])
	steps(60)
	require(at(arm, 1) < 2 * ONE, "the arm falls")

func joints():
	new_world()
	var anchor = ball(detent.FIXED, 0, 20 * ONE)
	var ids = []
	var hung = []
	for kind in range(detent.DISTANCE_JOINT, detent.CONE_JOINT + 1):
		var x = 4 * kind * ONE
		hung.append(ball(detent.MOVING, x, 18 * ONE))
		var point = [x, 20 * ONE, 0]
		var joint = detent.joint_at(world, kind, anchor, hung[-1], point, detent.AXES_YZX, [x, 18 * ONE, 0])
		joint.anchor_b = [0, 2 * ONE, 0] if kind != detent.DISTANCE_JOINT else [0, 0, 0]
		joint.lower = 2 * ONE if kind == detent.DISTANCE_JOINT else 0
		joint.upper = joint.lower
		joint.has_limits = kind != detent.DISTANCE_JOINT
		ids.append(detent.add_joint(world, joint))
	require(run("joint_ids") == ids, "joints of all kinds")
	steps(120)
	for body in hung:
		require(near(at(body, 1), 18 * ONE), "each joint carries its ball")

	new_world()
	anchor = ball(detent.FIXED, 0, 20 * ONE)
	var light = ball(detent.MOVING, 0, 18 * ONE)
	var heavy = box(detent.MOVING, [5 * ONE, 18 * ONE, 0], [ONE, ONE, ONE])
	var holds = detent.joint_at(world, detent.BALL_JOINT, anchor, light, [0, 19 * ONE, 0])
	var breaks = detent.joint_at(world, detent.BALL_JOINT, anchor, heavy, [5 * ONE, 19 * ONE, 0])
	for joint in [holds, breaks]:
		joint.break_force = 20 * ONE
	ids = [detent.add_joint(world, holds), detent.add_joint(world, breaks)]
	require(run("broken") == [], "no joint is broken")
	var broken = []
	for _i in range(60):
		run("step")
		broken += run("broken")
	require(broken == [ids[1]] and run("joint_ids") == [ids[0]], "the joint of a heavy box breaks")
	require(near(at(light, 1), 18 * ONE) and at(heavy, 1) < 15 * ONE, "the box falls")
	run("remove_body", [heavy])
	require(detent.add_joint(world, breaks) == detent.NONE, "no joint without a body")
	require(detent.joint_at(world, detent.BALL_JOINT, anchor, heavy, [0, 0, 0]) == detent.NONE, "joint_at neither")
	breaks.motor_sped = ONE
	require(detent.add_joint(world, breaks) == -1, "an unknown field is an error")

# Wrong calls return an error and do nothing.
func wrong_calls():
	new_world()
	var body = ball(detent.MOVING, 0, ONE)
	var digest = run("world_digest")
	for name in OS.get_environment("PROCEDURES").split(" "):
		for filler in [null, "1", 1.0, Vector3(), [], {}, self, PoolIntArray([1])]:
			for count in [1, 2, 3, 7, 39]:
				var arguments = []
				for _i in range(count):
					arguments.append(filler)
				require(detent.run(name, arguments) == -1, name + " with wrong types")
		require(name in ["world", "scene"] or detent.run(name) == -1, name + " without arguments")
		var many = []
		for i in range(60):
			many.append(i)
		require(detent.run(name, many) == -1, name + " with too many arguments")
	require(run("set_friction", [body]) == -1 and run("set_friction", [body, ONE, ONE]) == -1, "a wrong number")
	require(run("set_friction", [body, 1 << 31]) == -1 and run("set_friction", [body, -1]) == -1, "out of range")
	require(run("set_sensor", [body, 2]) == -1 and run("set_locked", [body, 64]) == -1, "out of range")
	require(run("apply_impulse", [body, 1, 2, 3, 4]) == -1, "half a point")
	require(run("add_body", [detent.MOVING, 10, 0, 0, 0, ONE]) == -1, "an unknown kind of shape")
	require(run("joint_at", [9, body, body, 0, 0, 0, 0, 0, 0] + detent.AXES_XYZ) == -1, "an unknown kind of joint")
	require(run("joint_at", [3, body, body, 0, 0, 0, 0, 0, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9]) == -4, "axes of length 1")
	require(run("world_digest") == digest, "nothing changed")
	var scene = detent.run("scene")
	for other in [0, 0xffffffff, scene]:
		require(detent.run("set_gravity", [other, 0, 0, 0]) == -3, "a handle that is no world")
	require(run("destroy_world") == 1 and run("destroy_world") == -3, "destroy_world")
	for name in ["step", "touch_events", "touching", "body_ids", "joint_ids", "broken", "world_digest"]:
		require(run(name) == -3, name + " in a destroyed world")
	for name in ["remove_body", "body", "velocity", "is_asleep", "info", "remove_joint", "joint", "joint_force",
			"joint_torque"]:
		require(run(name, [body]) == -3, name + " in a destroyed world")
	require(ball(detent.MOVING, 0, 0) == -3, "no bodies in a destroyed world")

func _init():
	if not detent.open():
		print("failed: the library does not load")
		quit(1)
		return
	bodies()
	setters()
	pushes()
	touches()
	hinge()
	joints()
	wrong_calls()
	detent.close()
	if not failed:
		print("all checks hold")
	quit(1 if failed else 0)
