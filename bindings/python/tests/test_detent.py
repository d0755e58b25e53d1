# SPDX-License-Identifier: MIT
import array
import ctypes
import os
import re
import sys
import unittest

here = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [os.path.join(here, '..'), os.path.join(here, '..', 'examples')]
sys.dont_write_bytecode = True
import detent  # noqa: E402
import match  # noqa: E402
from detent import ONE, UNIT, d2, d3  # noqa: E402

try:
    import numpy
except ImportError:
    numpy = None


class Test(unittest.TestCase):
    def setUp(self):
        self.context = detent.Context()
        self.addCleanup(self.context.close)

    def test_the_match_ends_as_in_cpp(self):
        self.assertEqual(match.play(), os.environ['DETENT_MATCH'])

    def test_single_queries(self):
        ball = d3.sphere((10 * ONE, 0, 0), ONE)
        hit = d3.raycast(d3.ray((0, 0, 0), (UNIT, 0, 0)), ball)
        self.assertEqual((hit.distance, hit.point.x, hit.normal.x), (9 * ONE, 9 * ONE, -UNIT))
        self.assertIsNone(d3.raycast(d3.ray((0, 0, 0), (-UNIT, 0, 0)), ball))
        self.assertTrue(d3.contains(ball, (11 * ONE, 0, 0)))
        self.assertFalse(d3.contains(ball, (11 * ONE + 1, 0, 0)))
        self.assertEqual(d3.closest_point(ball, (0, 0, 0)), (9 * ONE, 0, 0))
        self.assertEqual(d3.distance(ball, (0, 0, 0)), 9 * ONE)
        box = d3.aabb((0, 0, 0), (ONE, ONE, ONE))
        self.assertEqual(d3.distance(ball, box), 8 * ONE)
        self.assertFalse(d3.overlaps(ball, box))
        self.assertTrue(d2.overlaps(d2.sphere((0, 0), ONE), d2.segment((ONE, -ONE), (ONE, ONE))))

    def test_scenes(self):
        scene = self.context.scene2()
        ids = [scene.add(d2.sphere((i * ONE, 0), ONE), layers=1 << i) for i in range(4)]
        ray = d2.ray((-5 * ONE, 0), (UNIT, 0))
        self.assertEqual([hit.id for hit in scene.raycast_all(ray)], ids)
        self.assertEqual(scene.raycast(ray, layers=6).id, ids[1])
        self.assertEqual(scene.nearest(d2.point((9 * ONE, 0)))[1], ids[3])
        self.assertEqual(len(scene.overlaps()), 5)
        self.assertTrue(scene.move(ids[3], (5 * ONE, 0)))
        self.assertEqual(len(scene.overlaps()), 3)
        saved, digest = scene.snapshot(), scene.digest()
        self.assertTrue(scene.any(d2.point((0, 0))))
        other = self.context.scene2()
        other.restore(saved)
        self.assertEqual(other.diff(scene), [])
        other.move(ids[1], (0, ONE))
        self.assertEqual(other.diff(scene), ['object {}:{} (sphere) center.y'.format(*ids[1])])
        self.assertTrue(scene.remove(ids[0]))
        self.assertFalse(scene.remove(ids[0]))
        scene.restore(saved)
        self.assertEqual((len(scene), scene.digest()), (4, digest))

    def test_lists_longer_than_their_first_room(self):
        scene = self.context.scene3()
        ids = [scene.add(d3.sphere((i, 0, 0), ONE)) for i in range(100)]
        found = scene.all(d3.point((0, 0, 0)))
        self.assertEqual(sorted(which for _, which in found), ids)

    def test_assets(self):
        corners = [(0, 0, 0), (ONE, 0, 0), (0, ONE, 0), (0, 0, ONE)]
        mesh = self.context.mesh(1, corners, [(0, 1, 2), (0, 2, 3)])
        hull = self.context.hull3(1, corners)
        field = self.context.height_field(1, (0, 0), ONE, 2, 2, [0, 0, 0, 0])
        scene = self.context.scene3()
        for x, asset in enumerate((mesh, hull, field)):
            scene.add(detent.placed(asset, (10 * x * ONE, 0, 0)))
        self.assertEqual(scene.nearest(d3.point((11 * ONE, 0, 0)))[1].index, 1)
        ray = d3.ray((20 * ONE + ONE // 4, ONE, ONE // 4), (0, -UNIT, 0))
        hit = scene.raycast(ray)
        self.assertEqual((hit.id.index, hit.triangle), (2, 0))
        with self.assertRaises(detent.Error) as caught:
            mesh.destroy()
        self.assertEqual(caught.exception.status, detent.c.DETENT_IN_USE)

    def test_scenes_that_follow_worlds(self):
        world, scene = self.context.world2(gravity=(0, 0)), self.context.scene2()
        gate = world.add(d2.obb((0, 0), (3 * ONE, ONE // 64)), motion=detent.FIXED, is_sensor=1)
        ball = world.add(d2.sphere((0, 4 * ONE), ONE // 16), is_fast=1, velocity=(0, -500 * ONE), user=7, layers=2)
        bar = self.context.compound2(1, [d2.sphere((x * ONE, 0), ONE) for x in (0, 5)])
        pair = world.add(detent.placed(bar, (20 * ONE, 0)))
        down = d2.ray((0, 9 * ONE), (0, -UNIT), 20 * ONE)
        self.assertTrue(scene.follow(world))
        self.assertEqual((scene.raycast(down).id, len(scene)), (ball, 3))
        self.assertTrue(scene.follow(world, sensors=True))
        self.assertEqual(scene.raycast_all(down)[1].id, gate)
        part = scene.raycast(d2.ray((30 * ONE, 0), (-UNIT, 0), 20 * ONE))
        self.assertEqual((world.part_of(part.id), world.part_of(ball)), ((pair, 1), (ball, 0)))
        self.assertIsNone(world.part_of(detent.Id(99, 1)))
        world.step()  # the ball passes the gate
        self.assertEqual(world.events(), [(gate, ball, True), (gate, ball, False)])
        self.assertEqual(world.body_ids(), [gate, ball, pair])
        info = world.info(ball)
        self.assertEqual((info.user, info.layers, info.is_sensor, info.part_count), (7, 2, 0, 0))
        self.assertEqual((world.info(pair).part_count, world.info(gate).motion), (2, detent.FIXED))
        self.assertIsNone(world.info(detent.Id(99, 1)))
        joint = world.add_joint(detent.DISTANCE, ball, pair, upper=99 * ONE)
        self.assertEqual(world.joint_ids(), [joint])
        self.assertTrue(world.set_velocity(ball, (0, 0)))
        self.assertTrue(world.set_position(ball, (0, 0)))
        self.assertTrue(world.set_rotation(pair, ((0, UNIT), (-UNIT, 0))))
        self.assertEqual((world.position(ball), world.joint_ids()), ((0, 0), [joint]))
        self.assertEqual(world.frame(pair)[1][0], (0, UNIT))
        world.step()
        self.assertEqual(world.touching(), [(gate, 0, ball, 0)])
        self.assertEqual((world.touching(ball), world.touching(pair)), ([(gate, 0, ball, 0)], []))

    def test_contacts_and_setters(self):
        world = self.context.world2()
        floor = world.add(d2.aabb((-5 * ONE, -ONE), (5 * ONE, 0)), motion=detent.FIXED)
        box = world.add(d2.aabb((-ONE, 0), (ONE, 2 * ONE)))
        for tick in range(30):
            world.step()
        contact, = world.contacts()
        self.assertEqual(world.contacts(box), [contact])
        self.assertEqual((contact.a, contact.b, contact.part_a, contact.triangle), (floor, box, 0, 0))
        self.assertEqual((contact.normal, contact.friction, len(contact.points)), ((0, UNIT), (0, 0), 2))
        self.assertAlmostEqual(detent.number(contact.impulse), 4 * 10 / 240, 2)  # its weight in a substep
        for point in contact.points:
            self.assertAlmostEqual(abs(detent.number(point.point[0])), 1, 3)
            self.assertAlmostEqual(point.impulse, contact.impulse / 2, delta=20)
            self.assertLess(abs(point.separation), ONE // 50)
        self.assertNotEqual(contact.points[0].feature, contact.points[1].feature)
        self.assertTrue(world.set_friction(box, ONE // 4))
        self.assertTrue(world.set_restitution(box, ONE // 2))
        self.assertTrue(world.set_sensor(box, True))
        self.assertTrue(world.set_filter(box, 2, 4))
        self.assertTrue(world.set_gravity_scale(box, -ONE))
        self.assertTrue(world.set_damping(box, 0, ONE))
        self.assertTrue(world.set_locked(box, detent.LOCK_X | detent.LOCK_TURN_Z))
        self.assertTrue(world.set_fast(box, True))
        self.assertTrue(world.set_user(box, 2 ** 64 - 2))
        info = world.info(box)
        self.assertEqual((info.layers, info.collides_with, info.is_sensor, info.user), (2, 4, 1, 2 ** 64 - 2))
        world.set_velocity(box, (ONE, 0))
        world.step()
        self.assertEqual((world.contacts(), world.events()), ([], [(floor, box, False)]))
        velocity = world.body(box).velocity
        self.assertEqual(velocity.x, 0)  # locked
        self.assertAlmostEqual(velocity.y, 10 * ONE // 60, delta=20)  # it rises, undamped
        world.set_gravity((0, 10 * ONE))
        world.step()
        self.assertAlmostEqual(world.body(box).velocity.y, 0, delta=40)  # that pulled it back
        self.assertFalse(world.set_filter(detent.Id(9, 9), 1, 1))
        with self.assertRaises(detent.Error):
            world.set_friction(box, -1)
        for linear, angular in ((-1, 0), (0, -1)):
            with self.assertRaises(detent.Error):
                world.set_damping(box, linear, angular)
        with self.assertRaises(detent.Error):
            world.set_locked(box, 64)

    def test_worlds(self):
        world = self.context.world2(gravity=(0, -20 * ONE))
        world.add(d2.aabb((-5 * ONE, -ONE), (5 * ONE, 0)), motion=detent.FIXED)
        ball = world.add(d2.sphere((0, 2 * ONE), ONE), restitution=ONE // 2)
        began = []
        for _ in range(240):
            world.step()
            began += [event for event in world.events() if event[2]]
        self.assertGreater(len(began), 1)  # it bounces
        self.assertAlmostEqual(detent.number(world.position(ball)[1]), 1, delta=0.05)
        self.assertTrue(world.set_velocity(ball, (0, ONE)))
        self.assertEqual(world.body(ball).velocity.y, ONE)
        ghost = world.add(d2.sphere((20 * ONE, 0), ONE), gravity_scale=0, density=2 * ONE)
        self.assertTrue(world.apply_impulse(ghost, (ONE, 0), (20 * ONE, ONE)))
        self.assertLess(world.body(ghost).angular_velocity[0], 0)
        self.assertTrue(world.apply_torque(ghost, (ONE,)))
        spin = world.body(ghost).angular_velocity[0]
        world.step()
        self.assertGreater(world.body(ghost).angular_velocity[0], spin)
        self.assertEqual(world.position(ghost)[1], 0)
        self.assertTrue(world.apply_force(ghost, (0, 60 * ONE)))
        world.step()
        self.assertGreater(world.body(ghost).velocity.y, 0)

    def test_pairs(self):
        box = d3.aabb((0, 0, 0), (2 * ONE, 2 * ONE, 2 * ONE))
        ball = d3.sphere((ONE, ONE // 2 + 2 * ONE, ONE), ONE)
        contact = d3.contact(box, ball)
        self.assertEqual((contact.normal, contact.depth), ((0, UNIT, 0), ONE // 2))
        self.assertEqual([point.depth for point in contact.points], [ONE // 2])
        high = d3.sphere((ONE, 5 * ONE, ONE), ONE)
        self.assertIsNone(d3.contact(box, high))
        self.assertEqual(d3.closest_points(box, high), ((ONE, 2 * ONE, ONE), (ONE, 4 * ONE, ONE)))
        hit = d3.cast(high, (0, -UNIT, 0), 10 * ONE, box)
        self.assertEqual((hit.distance, hit.point.y, hit.normal.y), (2 * ONE, 2 * ONE, UNIT))
        self.assertIsNone(d3.cast(high, (0, UNIT, 0), 10 * ONE, box))
        falls = d3.sweep((0, 0, 0), (0, -4 * ONE, 0))
        impact = d3.time_of_impact(high, falls, box)
        self.assertAlmostEqual(impact.time / UNIT, 0.5, delta=0.001)
        self.assertTrue(impact.is_hit)
        self.assertIsNone(d3.time_of_impact(high, d3.sweep((0, 0, 0), (0, ONE, 0)), box))

    def test_joints(self):
        world = self.context.world2()
        wall = world.add(d2.sphere((0, 5 * ONE), ONE // 10), motion=detent.FIXED)
        arm = world.add(d2.obb((ONE, 5 * ONE), (ONE, ONE // 10)))
        end = world.local_point(arm, (0, 5 * ONE))
        self.assertEqual(end, (-ONE, 0))
        hinge = world.add_joint(detent.HINGE, wall, arm, anchor_b=end, motor_speed=2 * ONE,
                                motor_force=50 * ONE)
        for _ in range(30):
            world.step()
        self.assertAlmostEqual(detent.number(world.body(arm).angular_velocity[0]), 2, delta=0.1)
        force = world.joint_force(hinge)
        self.assertGreater(detent.number(force[0]) ** 2 + detent.number(force[1]) ** 2, 1)
        torque, = world.joint_torque(hinge)
        self.assertGreater(torque, ONE)  # the motor lifts the arm
        joint = world.joint(hinge)
        joint.motor_speed = -2 * ONE
        joint.break_force = 1
        self.assertTrue(world.change_joint(hinge, joint))
        world.step()
        self.assertEqual(world.broken(), [hinge])
        self.assertEqual((world.joint(hinge), world.joint_force(hinge)), (None, None))
        self.assertIsNone(world.joint_torque(hinge))
        weld = world.add_joint(detent.WELD, wall, arm)
        self.assertEqual([world.remove_joint(weld), world.remove_joint(weld)], [True, False])
        self.assertIsNone(world.add_joint(detent.WELD, wall, wall))
        solid = self.context.solid2(3, [(0, 0), (ONE, 0), (0, ONE)])
        body = world.add(detent.placed(solid, (9 * ONE, 9 * ONE)))
        self.assertEqual(world.position(body), (9 * ONE + ONE // 3, 9 * ONE + ONE // 3))
        # A dumbbell of a heavy ball, a light one and the hull falls on the wall.
        dumbbell = self.context.compound2(4, [
            (d2.sphere((-ONE, 0), ONE // 2), {'density': 3 * ONE}), d2.sphere((ONE, 0), ONE // 2),
            (detent.placed(solid, (0, ONE)), {'is_sensor': 1})])
        body = world.add(detent.placed(dumbbell, (0, 20 * ONE)), is_fast=1, velocity=(0, -ONE))
        translation, axes = world.frame(body)
        self.assertEqual(translation, (0, 20 * ONE))
        self.assertEqual(axes, ((detent.UNIT, 0), (0, detent.UNIT)))
        self.assertLess(world.position(body)[0], 0)
        with self.assertRaises(detent.Error) as caught:
            solid.destroy()
        self.assertEqual(caught.exception.status, detent.c.DETENT_IN_USE)
        parts = set()
        for _ in range(240):
            world.step()
            parts |= {part for _, part_a, _, part_b, _ in world.touches() for part in (part_a, part_b)}
        self.assertIn(2, parts)

    def test_terrain(self):
        world = self.context.world3()
        floor = self.context.mesh(1, [(-9 * ONE, 0, -9 * ONE), (9 * ONE, 0, -9 * ONE), (0, 0, 9 * ONE)],
                                  [(0, 2, 1)])
        world.add(detent.placed(floor, (0, 0, 0)), motion=detent.FIXED)
        field = self.context.height_field(2, (0, 0), 4 * ONE, 3, 3, [0] * 9)
        world.add(detent.placed(field, (30 * ONE, 0, 0)), motion=detent.FIXED)
        balls = [world.add(d3.sphere((x * ONE, 2 * ONE, z * ONE), ONE // 2)) for x, z in ((0, 0), (34, 4))]
        for _ in range(120):
            world.step()
        for ball in balls:
            self.assertAlmostEqual(detent.number(world.position(ball)[1]), 0.5, delta=0.05)

    def test_camera(self):
        scene = self.context.scene3()
        ball = scene.add(d3.sphere((0, 0, 0), ONE))
        scene.add(d3.sphere((0, 0, 20 * ONE), ONE))
        camera = d3.camera((0, 0, 10 * ONE), (0, 0, 0), ONE, 50 * ONE, fov=1 << 29, aspect=ONE)
        self.assertEqual(scene.visible(d3.frustum(camera)), [(8 * ONE, ball)])
        self.assertEqual(scene.raycast(d3.pick_ray(camera, (641, 481), (320, 240))).id, ball)
        self.assertIsNone(scene.raycast(d3.pick_ray(camera, (641, 481), (0, 0))))
        self.assertIsNone(d3.camera((0, 0, 0), (0, 0, 0), ONE, 2 * ONE, fov=1 << 29, aspect=ONE))
        self.assertEqual(d3.project(camera, (640, 480), (0, 0, 0)), (320 * ONE, 240 * ONE, 10 * ONE))
        self.assertIsNone(d3.project(camera, (640, 480), (0, 0, 11 * ONE)))
        self.assertEqual(d3.unproject(camera, (641, 481), (320, 240), 10 * ONE), (0, 0, 0))
        frustum = d3.frustum(camera)
        self.assertEqual(scene.nearest(frustum), (8 * ONE, ball))
        self.assertTrue(scene.any(frustum))
        self.assertFalse(scene.any(frustum, layers=2))
        self.assertTrue(d3.contains(frustum, (0, 0, 0)))
        self.assertFalse(d3.contains(frustum, (0, 0, 10 * ONE)))
        self.assertEqual(d3.closest_point(frustum, (0, 0, 10 * ONE)), (0, 0, 9 * ONE))
        self.assertEqual(d3.distance(frustum, (0, 0, 12 * ONE)), 3 * ONE)
        self.assertEqual(d3.raycast(d3.ray((0, 0, 12 * ONE), (0, 0, -UNIT)), frustum).distance, 3 * ONE)
        near, far = d3.sphere((0, 0, 0), ONE), d3.sphere((0, 0, 20 * ONE), ONE)
        self.assertEqual([d3.overlaps(frustum, near), d3.overlaps(far, frustum)], [True, False])
        self.assertTrue(d3.overlaps_union(frustum, [far, near]))
        self.assertTrue(d3.overlaps(frustum, frustum))
        camera.aspect = 0
        with self.assertRaises(detent.Error):
            d3.frustum(camera)

    def test_union(self):
        pair = [d3.sphere((5 * ONE, 0, 0), ONE), d3.aabb((2 * ONE, -ONE, -ONE), (3 * ONE, ONE, ONE))]
        ray = d3.ray((0, 0, 0), (detent.UNIT, 0, 0), 9 * ONE)
        self.assertEqual(d3.raycast_union(ray, pair).distance, 2 * ONE)
        self.assertIsNone(d3.raycast_union(ray, []))
        self.assertTrue(d3.contains_union(pair, (5 * ONE, 0, 0)))
        self.assertFalse(d3.contains_union(pair, (0, 0, 0)))
        ball = d3.sphere((0, 0, 0), ONE)
        self.assertFalse(d3.overlaps_union(pair, [ball]))
        self.assertEqual(d3.distance_union(pair, (0, 0, 0)), 2 * ONE)
        self.assertEqual(d3.distance_union(pair, [ball]), ONE)
        self.assertEqual(d3.closest_points_union(pair, [ball]), ((2 * ONE, 0, 0), (ONE, 0, 0)))
        self.assertEqual(d3.closest_point_union(pair, (0, 0, 0)), (2 * ONE, 0, 0))
        self.assertEqual(d3.cast_union(ball, (detent.UNIT, 0, 0), 9 * ONE, pair).distance, ONE)

    def test_hulls(self):
        """Two shapes, one of them a hull of the context."""
        solid = self.context.hull3(1, [(0, 0, 0), (ONE, 0, 0), (0, ONE, 0), (0, 0, ONE)])
        hull = detent.placed(solid, (0, 0, 0))
        ball = d3.sphere((-ONE, ONE // 4, ONE // 4), 2 * ONE)
        contact = d3.contact(hull, ball, self.context)
        self.assertEqual((contact.normal, contact.depth), ((-UNIT, 0, 0), ONE))
        far = d3.sphere((-3 * ONE, ONE // 4, ONE // 4), ONE)
        self.assertIsNone(d3.contact(hull, far, self.context))
        impact = d3.time_of_impact(far, d3.sweep((0, 0, 0), (4 * ONE, 0, 0)), hull, context=self.context)
        self.assertAlmostEqual(impact.time / UNIT, 0.5, delta=0.001)
        self.assertEqual(self.context.count(), 1)

    def test_rays_as_shapes(self):
        ray = d2.ray((0, 0), (UNIT, 0), 5 * ONE)
        self.assertEqual([d2.contains(ray, (x * ONE, 0)) for x in (-1, 0, 5, 6)], [False, True, True, False])
        self.assertEqual(d2.closest_point(ray, (2 * ONE, 3 * ONE)), (2 * ONE, 0))
        self.assertEqual(d2.distance(ray, (2 * ONE, 3 * ONE)), 3 * ONE)

    def test_chosen_ids(self):
        which = detent.Id(5, 7)
        scene, world = self.context.scene2(), self.context.world2()
        for owner in (scene, world):
            self.assertEqual(owner.add(d2.sphere((0, 0), ONE), which=which), which)
            self.assertIsNone(owner.add(d2.sphere((0, 0), ONE), which=which))
        self.assertTrue(scene.set_traits(which, layers=4, user=9))
        traits = scene.object(which)[1]
        self.assertEqual((traits.layers, traits.user), (4, 9))
        other = world.add(d2.sphere((9 * ONE, 0), ONE))
        states = world.bodies([other, which, detent.Id(3, 3)])
        self.assertEqual([state.position.x for state in states], [9 * ONE, 0, 0])
        self.assertNotEqual(world.digest_of(which), world.digest_of(other))
        self.assertIsNone(world.digest_of(detent.Id(3, 3)))
        world.add_joint(detent.DISTANCE, which, other, upper=20 * ONE)
        self.assertEqual((world.joint_count(), len(world)), (1, 2))
        self.assertTrue(world.set_angular_velocity(which, (ONE,)))
        self.assertEqual(world.local_frame(which, d2._identity), d2._identity)
        changed = self.context.world2()
        changed.restore(world.snapshot())
        changed.set_velocity(which, (ONE, 0))
        self.assertEqual(world.diff(changed), ['body 5:7 (sphere) velocity.x'])
        self.assertTrue(world.remove(other))
        self.assertEqual((world.joint_count(), len(world)), (0, 1))

    def test_sessions(self):
        start = self.context.world2()
        start.add(d2.sphere((0, 0), ONE))
        sessions = [self.context.session2(start, match=1, self=i) for i in range(2)]
        now = 0

        def play(ticks):
            nonlocal now
            for _ in range(ticks):
                now += 16667
                for i, session in enumerate(sessions):
                    for _ in session.frames(b'\0'):
                        session.world.step()
                    for to, packet in session.packets(now):
                        sessions[to].receive(i, packet, now)
            return [[event.kind for event in session.events()] for session in sessions]

        names = detent.events
        self.assertEqual(play(60), [[names['connected']]] * 2)
        self.assertGreater(sessions[0].matched(1), 30)
        self.assertFalse(sessions[0].is_awaited(1))
        sessions[0].pause()
        self.assertEqual(play(30), [[], [names['peer_paused']]])
        self.assertEqual(sessions[0].state, detent.states['paused'])
        sessions[0].pause(False)
        self.assertEqual(play(30), [[], [names['peer_resumed']]])
        sessions[0].drop(1)
        self.assertIn(names['dropped'], play(60)[0])

    def test_mover(self):
        scene = self.context.scene3()
        scene.add(d3.aabb((-9 * ONE, -ONE, -9 * ONE), (9 * ONE, 0, 9 * ONE)))
        wall = scene.add(d3.aabb((3 * ONE, 0, -9 * ONE), (4 * ONE, 9 * ONE, 9 * ONE)))
        player = scene.mover((0, ONE, 0), (0, 2 * ONE, 0), ONE // 2, step_height=0)
        for _ in range(60):
            player.move((ONE // 8, -ONE // 8, 0))
        self.assertTrue(player.is_grounded)
        self.assertAlmostEqual(detent.number(player.position[0]), 2.5, delta=0.05)
        self.assertAlmostEqual(detent.number(player.position[1]), 0.5, delta=0.05)
        crate = scene.box_mover((-ONE // 2, ONE, -ONE // 2), (ONE // 2, 2 * ONE, ONE // 2), step_height=0)
        for _ in range(60):
            crate.move((ONE // 8, -ONE // 8, 0))
        self.assertTrue(crate.is_grounded)
        self.assertAlmostEqual(detent.number(crate.position[0]), 2, delta=0.05)
        box = d3.aabb((0, ONE, 0), (ONE, 2 * ONE, ONE))
        self.assertEqual(scene.cast(box, (detent.UNIT, 0, 0), 9 * ONE).distance, 2 * ONE)
        self.assertTrue(scene.cast_any(box, (0, -detent.UNIT, 0), ONE))
        self.assertFalse(scene.cast_any(box, (0, detent.UNIT, 0), ONE))
        self.assertEqual([hit.id for hit in scene.cast_all(box, (detent.UNIT, 0, 0), 9 * ONE)], [wall])
        self.assertEqual(player.clip((ONE, 0, 0)), (0, 0, 0))
        player.move((ONE, 0, 0), ignored=wall)
        self.assertGreater(player.position[0], 3 * ONE)
        hit = scene.cast(d3.sphere((0, 5 * ONE, 0), ONE), (UNIT, 0, 0), 9 * ONE)
        self.assertEqual((hit.id, hit.distance), (wall, 2 * ONE))

    def test_walk(self):
        """Walks over steps, around a ball and on a moving frame; the JavaScript test has the same
        numbers."""
        scene = self.context.scene3()
        scene.add(d3.aabb((-20 * ONE, -ONE, -20 * ONE), (20 * ONE, 0, 20 * ONE)))
        for i in range(1, 5):
            scene.add(d3.aabb((i * ONE, 0, -ONE), (9 * ONE, i * ONE // 4, ONE)))
        scene.add(d3.sphere((-4 * ONE, 0, ONE // 3), ONE))
        lift = scene.add_frame((0, 0, 6 * ONE))
        scene.add(d3.aabb((-2 * ONE, 0, -2 * ONE), (2 * ONE, ONE // 8, 2 * ONE)), frame=lift)
        ends = []
        for walker in (scene.mover((0, ONE, 0), (0, 2 * ONE, 0), ONE // 2),
                       scene.box_mover((-ONE // 3, ONE, -ONE // 3), (ONE // 3, 2 * ONE, ONE // 3))):
            digest = 0
            for tick in range(160):
                x, z = ((1, 0), (-1, 0), (0, 1), (1, -1))[tick // 40]
                scene.move_frame(lift, (tick * ONE // 64, 0, 6 * ONE))
                walker.move((x * ONE // 6, -ONE // 8, z * ONE // 6))
                for word in (*walker.position, walker.is_grounded):
                    digest = (digest * 31 + word) % (1 << 32)
            ends.append((walker.position, digest))
        self.assertEqual(ends, [((450484, 33792, 99329), 437337545), ((452882, 1024, 66561), 3168979696)])

    def test_frames(self):
        scene = self.context.scene2()
        frame = scene.add_frame((ONE, 0))
        ball = scene.add(d2.sphere((0, 0), ONE), frame=frame)
        self.assertTrue(scene.move_frame(frame, (7 * ONE, 0)))
        self.assertEqual(scene.nearest(d2.point((7 * ONE, 0))), (0, ball))
        self.assertFalse(scene.remove_frame(frame))
        inner = scene.add_frame((ONE, 0), scale=2 * ONE, parent=frame)
        self.assertEqual(scene.frame(inner), (((ONE, 0), d2._identity, 2 * ONE),
                                              ((8 * ONE, 0), d2._identity, 2 * ONE)))
        self.assertIsNone(scene.frame(detent.Id(9, 9)))
        self.assertTrue(scene.replace(ball, d2.aabb((0, 0), (ONE, ONE))))
        self.assertTrue(scene.raycast_any(d2.ray((0, ONE // 2), (UNIT, 0))))
        scene.optimize()

    def test_versions(self):
        with open(os.path.join(here, '../../../include/detent/version.hpp'), encoding='utf-8') as file:
            major, minor, patch = map(int, re.findall(r'#define DETENT_VERSION_\w+ (\d+)', file.read()))
        self.assertEqual(detent.version(), major * 10000 + minor * 100 + patch)
        self.assertGreater(detent.results_version(), 0)

    def test_errors(self):
        with self.assertRaises(detent.Error) as caught:
            d3.raycast(d3.ray((0, 0, 0), (1, 0, 0)), d3.sphere((0, 0, 0), ONE))
        self.assertEqual(caught.exception.status, detent.c.DETENT_NOT_UNIT)
        scene = self.context.scene3()
        scene.destroy()
        self.assertRaises(detent.Error, len, scene)
        self.context.close()
        self.assertRaises(detent.Error, self.context.scene3)
        self.assertEqual(detent.raw(-0.5), -32768)
        self.assertRaises(OverflowError, detent.raw, 32768)

    def test_integers_that_do_not_fit(self):
        limit = 1 << 31
        self.assertRaises(OverflowError, d3.sphere, (0, limit, 0), ONE)
        self.assertRaises(OverflowError, d3.sphere, (0, 0, 0), limit)
        self.assertRaises(OverflowError, d3.ray, (0, 0, -limit - 1), (UNIT, 0, 0))
        self.assertRaises(OverflowError, d2.obb, (0, 0), (ONE, ONE), ((UNIT, 0), (0, 1 << 40)))
        d3.sphere((limit - 1, -limit, 0), ONE)
        ball = d3.sphere((0, 0, 0), ONE)
        scene, world = self.context.scene3(), self.context.world3()
        self.assertRaises(ctypes.ArgumentError, scene.cast, ball, (UNIT, 0, 0), limit)
        self.assertRaises(ctypes.ArgumentError, scene.nearest, ball, -1)
        self.assertRaises(OverflowError, scene.add, ball, user=-1)
        body = world.add(ball)
        self.assertRaises(OverflowError, world.set_angular_velocity, body, (0, 0, limit))
        self.assertRaises(OverflowError, self.context.height_field, 1, (0, 0), ONE, 2, 2, [0, 0, 0, limit])

    def check_many(self, rays):
        box = d3.aabb((5 * ONE, -ONE, -ONE), (6 * ONE, ONE, ONE))
        scene = self.context.scene3()
        which = scene.add(box)
        distances = d3.raycast_many(rays, box)
        self.assertEqual(list(distances), [5 * ONE, -1, 6 * ONE])
        for threads in (2, 5):
            self.assertEqual(list(d3.raycast_many(rays, box, threads=threads)), list(distances))
        hits = scene.raycast_many(rays)
        words = [int(word) for word in (hits.reshape(-1) if hasattr(hits, 'reshape') else hits)]
        each = len(words) // 3
        self.assertEqual([words[0], words[each], words[2 * each]], [5 * ONE, -1, 6 * ONE])
        self.assertEqual(words[1:3], list(which))

    rows = [(0, 0, 0, UNIT, 0, 0, 100 * ONE), (0, 0, 0, 0, UNIT, 0, 100 * ONE),
            (-ONE, 0, 0, UNIT, 0, 0, 100 * ONE)]

    def test_many_rays_in_a_buffer(self):
        self.check_many(array.array('i', [word for row in self.rows for word in row]))

    @unittest.skipIf(numpy is None, 'numpy is not installed')
    def test_many_rays_in_numpy(self):
        self.check_many(numpy.array(self.rows, dtype=numpy.int32))
        self.check_many(numpy.array(self.rows, dtype=numpy.int64))
        for wrong in (1 << 31, 0.5):
            self.assertRaises(OverflowError, self.check_many, numpy.array(self.rows) + wrong)


class Recorder:
    """The library, and the names of the functions taken from it."""

    def __init__(self, library):
        self.library, self.names = library, set()

    def __getattr__(self, name):
        self.names.add(name)
        return getattr(self.library, name)


def main():
    recorder = detent._library = Recorder(detent._library)
    passed = unittest.main(exit=False).result.wasSuccessful()

    def in_3d(names):
        return {name.replace('2', '3') for name in names}

    missing = in_3d(detent.c.FUNCTIONS) - in_3d(recorder.names)
    if passed and len(sys.argv) == 1 and missing:
        print('no test calls', ', '.join(sorted(missing)), file=sys.stderr)
        passed = False
    sys.exit(not passed)


if __name__ == '__main__':
    main()
