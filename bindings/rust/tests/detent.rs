// SPDX-License-Identifier: MIT

use detent::{d2, ffi, Error};

include!("../examples/match/play.rs");

#[test]
fn the_match_ends_as_in_cpp() {
    let expected = std::env::var("DETENT_MATCH").expect("DETENT_MATCH is its digest");
    assert_eq!(format!("{:016x}", play().unwrap()), expected);
}

#[test]
fn single_queries() {
    let ball = d3::sphere([10 * ONE, 0, 0], ONE);
    let ray = d3::ray([0, 0, 0], [UNIT, 0, 0], i32::MAX);
    let hit = d3::raycast(&ray, &ball).unwrap().unwrap();
    assert_eq!((hit.distance, hit.point.x, hit.normal.x), (9 * ONE, 9 * ONE, -UNIT));
    let back = d3::ray([0, 0, 0], [-UNIT, 0, 0], i32::MAX);
    assert!(d3::raycast(&back, &ball).unwrap().is_none());
    assert_eq!(d3::raycast_many(&[ray, back], &ball), Ok(vec![9 * ONE, -1]));
    assert_eq!(d3::contains(&ball, [11 * ONE, 0, 0]), Ok(true));
    assert_eq!(d3::contains(&ball, [11 * ONE + 1, 0, 0]), Ok(false));
    assert_eq!(d3::closest_point(&ball, [0, 0, 0]), Ok([9 * ONE, 0, 0]));
    let cube = d3::aabb([0, 0, 0], [ONE, ONE, ONE]);
    assert_eq!(d3::distance_to_point(&ball, [0, 0, 0]), Ok(9 * ONE));
    assert_eq!(d3::distance(&ball, &cube), Ok(8 * ONE));
    assert_eq!(d3::overlaps(&ball, &cube), Ok(false));
    assert_eq!(
        d2::overlaps(&d2::sphere([0, 0], ONE), &d2::segment([ONE, -ONE], [ONE, ONE])),
        Ok(true)
    );
}

#[test]
fn scenes_that_follow_worlds() {
    let context = Context::new().unwrap();
    let mut scene = d2::Scene::new(&context).unwrap();
    let mut world = d2::World::new(&context, &d2::default_settings()).unwrap();
    let options = d2::default_options();
    let ball = world.add(&d2::sphere([0, 5 * ONE], ONE), &options).unwrap();
    let fixed = d2::BodyOptions { motion: ffi::FIXED_BODY, is_sensor: 1, ..options };
    let gate = world.add(&d2::aabb([-ONE, -ONE], [ONE, ONE]), &fixed).unwrap();
    let down = d2::ray([0, 9 * ONE], [0, -UNIT], 20 * ONE);
    scene.follow(&world, false).unwrap();
    assert_eq!(scene.raycast(&down, !0).unwrap().unwrap().id, ball);
    assert_eq!(scene.size(), Ok(1));
    scene.follow(&world, true).unwrap();
    assert_eq!(scene.raycast_all(&down, !0).unwrap()[1].id, gate);
    assert_eq!(world.part_of(gate), Ok(Some((gate, 0))));
    assert_eq!(world.body_ids(), Ok(vec![ball, gate]));
    assert_eq!(world.info(gate).unwrap().unwrap().is_sensor, 1);
    let joint = d2::joint(ffi::DISTANCE_JOINT, ball, gate).unwrap();
    let rope = world.add_joint(&d2::Joint { upper: 9 * ONE, ..joint }).unwrap().unwrap();
    assert_eq!(world.set_position(ball, [0, ONE]), Ok(true));
    assert_eq!(world.set_rotation(ball, [[0, UNIT], [-UNIT, 0]]), Ok(true));
    assert_eq!(world.joint_ids(), Ok(vec![rope]));
    world.step().unwrap();
    assert_eq!(world.touching(ball).unwrap().len(), 0); // joined without collision
    world.remove_joint(rope).unwrap();
    world.step().unwrap();
    assert_eq!(world.touching(ball).unwrap()[0].b, gate);
}

#[test]
fn contacts_and_setters_of_bodies() {
    let context = Context::new().unwrap();
    let mut world = d2::World::new(&context, &d2::default_settings()).unwrap();
    let options = d2::default_options();
    let fixed = d2::BodyOptions { motion: ffi::FIXED_BODY, ..options };
    let floor = world.add(&d2::aabb([-5 * ONE, -ONE], [5 * ONE, 0]), &fixed).unwrap();
    let block = world.add(&d2::aabb([-ONE, 0], [ONE, 2 * ONE]), &options).unwrap();
    for _ in 0..30 {
        world.step().unwrap();
    }
    let contacts = world.contacts(block).unwrap();
    assert_eq!(world.contacts(Default::default()), Ok(contacts.clone()));
    assert_eq!((contacts.len(), contacts[0].a, contacts[0].count), (1, floor, 2));
    assert_eq!((contacts[0].normal.x, contacts[0].normal.y), (0, UNIT));
    assert!((contacts[0].impulse - 4 * 10 * ONE / 240).abs() < 500);
    assert_eq!(world.set_friction(block, ONE / 4), Ok(true));
    assert_eq!(world.set_restitution(block, ONE / 2), Ok(true));
    assert_eq!(world.set_sensor(block, true), Ok(true));
    assert_eq!(world.set_filter(block, 2, 4), Ok(true));
    assert_eq!(world.set_gravity_scale(block, -ONE), Ok(true));
    assert_eq!(world.set_damping(block, 0, ONE), Ok(true));
    assert_eq!(world.set_locked(block, ffi::LOCK_X), Ok(true));
    assert_eq!(world.set_fast(block, true), Ok(true));
    assert_eq!(world.set_user(block, u64::MAX - 1), Ok(true));
    let info = world.info(block).unwrap().unwrap();
    assert_eq!((info.layers, info.user), (2, u64::MAX - 1));
    world.set_velocity(block, [ONE, 0]).unwrap();
    world.step().unwrap();
    assert_eq!(world.contacts(block).unwrap().len(), 0);
    let velocity = world.body(block).unwrap().unwrap().velocity;
    assert_eq!(velocity.x, 0); // locked
    assert!((velocity.y - 10 * ONE / 60).abs() < 20); // it rises, undamped
    world.set_gravity([0, 10 * ONE]).unwrap();
    world.step().unwrap();
    assert!(world.body(block).unwrap().unwrap().velocity.y.abs() < 40); // that pulled it back
}

#[test]
fn scenes() {
    let context = Context::new().unwrap();
    let mut scene = d2::Scene::new(&context).unwrap();
    let ids: Vec<_> = (0..4)
        .map(|i| {
            let traits = Traits { layers: 1 << i, ..Traits::default() };
            scene.add(&d2::sphere([i * ONE, 0], ONE), traits).unwrap()
        })
        .collect();
    let ray = d2::ray([-5 * ONE, 0], [UNIT, 0], i32::MAX);
    let hits = scene.raycast_all(&ray, !0).unwrap();
    assert_eq!(hits.iter().map(|hit| hit.id).collect::<Vec<_>>(), ids);
    assert_eq!(scene.raycast(&ray, 6).unwrap().unwrap().id, ids[1]);
    assert_eq!(scene.nearest(&d2::point([9 * ONE, 0]), !0).unwrap().unwrap().id, ids[3]);
    assert_eq!(scene.overlaps().unwrap().len(), 5);
    assert_eq!(scene.move_by(ids[3], [5 * ONE, 0]), Ok(true));
    assert_eq!(scene.overlaps().unwrap().len(), 3);
    let (saved, digest) = (scene.snapshot().unwrap(), scene.digest().unwrap());
    assert_eq!(scene.remove(ids[0]), Ok(true));
    assert_eq!(scene.remove(ids[0]), Ok(false));
    scene.restore(&saved).unwrap();
    assert_eq!((scene.size(), scene.digest()), (Ok(4), Ok(digest)));
}

#[test]
fn lists_longer_than_their_first_room() {
    let context = Context::new().unwrap();
    let mut scene = d3::Scene::new(&context).unwrap();
    for i in 0..100 {
        scene.add(&d3::sphere([i, 0, 0], ONE), Traits::default()).unwrap();
    }
    assert_eq!(scene.all(&d3::point([0, 0, 0]), !0).unwrap().len(), 100);
}

#[test]
fn assets() {
    let context = Context::new().unwrap();
    let corners = [[0, 0, 0], [ONE, 0, 0], [0, ONE, 0], [0, 0, ONE]];
    let mesh = context.mesh(1, &corners, &[[0, 1, 2], [0, 2, 3]]).unwrap();
    let hull = d3::hull(&context, 1, &corners).unwrap();
    let field = context.height_field(1, [0, 0], ONE, 2, 2, &[0; 4]).unwrap();
    let mut scene = d3::Scene::new(&context).unwrap();
    for (x, asset) in [&mesh, &hull, &field].iter().enumerate() {
        let shape = d3::placed(asset, [10 * x as i32 * ONE, 0, 0], d3::AXES, ONE);
        scene.add(&shape, Traits::default()).unwrap();
    }
    assert_eq!(scene.nearest(&d3::point([11 * ONE, 0, 0]), !0).unwrap().unwrap().id.index, 1);
    let ray = d3::ray([20 * ONE + ONE / 4, ONE, ONE / 4], [0, -UNIT, 0], i32::MAX);
    let hit = scene.raycast(&ray, !0).unwrap().unwrap();
    assert_eq!((hit.id.index, hit.has_triangle, hit.triangle), (2, 1, 0));
    assert_eq!(mesh.destroy(), Err(Error(ffi::IN_USE)));
    drop(scene);
    assert_eq!(mesh.destroy(), Ok(()));
    assert_eq!(mesh.destroy(), Err(Error(ffi::BAD_HANDLE)));
}

#[test]
fn worlds() {
    let context = Context::new().unwrap();
    let mut settings = d2::default_settings();
    settings.gravity.y = -20 * ONE;
    let mut world = d2::World::new(&context, &settings).unwrap();
    let options = d2::default_options();
    let floor = d2::aabb([-5 * ONE, -ONE], [5 * ONE, 0]);
    world.add(&floor, &d2::BodyOptions { motion: ffi::FIXED_BODY, ..options }).unwrap();
    let bouncy = d2::BodyOptions { restitution: ONE / 2, ..options };
    let ball = world.add(&d2::sphere([0, 2 * ONE], ONE), &bouncy).unwrap();
    let mut began = 0;
    for _ in 0..240 {
        world.step().unwrap();
        began += world.events().unwrap().iter().filter(|touch| touch.begins == 1).count();
    }
    assert!(began > 1); // it bounces
    let height = world.position(ball).unwrap().unwrap()[1];
    assert!((height - ONE).abs() < ONE / 20);
    assert_eq!(world.set_velocity(ball, [0, ONE]), Ok(true));
    assert_eq!(world.body(ball).unwrap().unwrap().velocity.y, ONE);
    let light = d2::BodyOptions { gravity_scale: 0, ..options };
    let ghost = world.add(&d2::sphere([20 * ONE, 0], ONE), &light).unwrap();
    assert_eq!(world.apply_impulse(ghost, [ONE, 0], Some([20 * ONE, ONE])), Ok(true));
    let spin = world.body(ghost).unwrap().unwrap().angular_velocity[0];
    assert!(spin < 0);
    assert_eq!(world.apply_torque(ghost, [ONE]), Ok(true));
    assert_eq!(world.apply_force(ghost, [0, 60 * ONE], None), Ok(true));
    world.step().unwrap();
    let body = world.body(ghost).unwrap().unwrap();
    assert!(body.angular_velocity[0] > spin && body.velocity.y > 0);
    settings.substeps = 0;
    assert_eq!(d2::World::new(&context, &settings).err(), Some(Error(ffi::BAD_ARGUMENT)));
}

#[test]
fn pairs() {
    let cube = d3::aabb([0, 0, 0], [2 * ONE, 2 * ONE, 2 * ONE]);
    let ball = d3::sphere([ONE, 2 * ONE + ONE / 2, ONE], ONE);
    let contact = d3::contact(&cube, &ball).unwrap().unwrap();
    assert_eq!((contact.normal.y, contact.depth, contact.count), (UNIT, ONE / 2, 1));
    let high = d3::sphere([ONE, 5 * ONE, ONE], ONE);
    assert!(d3::contact(&cube, &high).unwrap().is_none());
    let closest = d3::closest_points(&cube, &high);
    assert_eq!(closest, Ok(([ONE, 2 * ONE, ONE], [ONE, 4 * ONE, ONE])));
    let hit = d3::cast(&high, [0, -UNIT, 0], 10 * ONE, &cube).unwrap().unwrap();
    assert_eq!((hit.distance, hit.normal.y), (2 * ONE, UNIT));
    let falls = d3::sweep([0, 0, 0], [0, -4 * ONE, 0]);
    let impact = d3::time_of_impact(&high, &falls, &cube, None, 8).unwrap().unwrap();
    assert!((impact.time - UNIT / 2).abs() < UNIT / 1000 && impact.is_hit == 1);
}

#[test]
fn joints_and_frames() {
    let context = Context::new().unwrap();
    let mut world = d2::World::new(&context, &d2::default_settings()).unwrap();
    let options = d2::default_options();
    let fixed = d2::BodyOptions { motion: ffi::FIXED_BODY, ..options };
    let wall = world.add(&d2::sphere([0, 5 * ONE], ONE / 8), &fixed).unwrap();
    let arm = d2::obb([ONE, 5 * ONE], [ONE, ONE / 8], d2::AXES);
    let arm = world.add(&arm, &options).unwrap();
    assert_eq!(world.local_point(arm, [0, 5 * ONE]), Ok(Some([-ONE, 0])));
    let mut joint = d2::joint(ffi::HINGE_JOINT, wall, arm).unwrap();
    joint.anchor_b.x = -ONE;
    joint.motor_speed = 2 * ONE;
    joint.motor_force = 50 * ONE;
    let hinge = world.add_joint(&joint).unwrap().unwrap();
    for _ in 0..30 {
        world.step().unwrap();
    }
    let spin = world.body(arm).unwrap().unwrap().angular_velocity[0];
    assert!((spin - 2 * ONE).abs() < ONE / 10);
    let force = world.joint_force(hinge).unwrap().unwrap();
    assert!(force[0].abs() + force[1].abs() > ONE);
    let torque = world.joint_torque(hinge).unwrap().unwrap();
    assert!(torque[0] > ONE); // the motor lifts the arm
    joint.break_force = 1;
    assert_eq!(world.change_joint(hinge, &joint), Ok(true));
    assert_eq!(world.joint(hinge), Ok(Some(joint)));
    world.step().unwrap();
    assert_eq!(world.broken(), Ok(vec![hinge]));
    assert_eq!((world.remove_joint(hinge), world.joint_force(hinge)), (Ok(false), Ok(None)));
    assert_eq!(world.joint_torque(hinge), Ok(None));
    let solid = d2::solid(&context, 3, &[[0, 0], [ONE, 0], [0, ONE]]).unwrap();
    let body = d2::placed(&solid, [9 * ONE, 9 * ONE], d2::AXES, ONE);
    world.add(&body, &options).unwrap();
    assert_eq!(solid.destroy(), Err(Error(ffi::IN_USE)));
    let heavy = d2::Part { density: 3 * ONE, ..d2::part(d2::sphere([-ONE, 0], ONE / 2)) };
    let parts = [heavy, d2::part(d2::sphere([ONE, 0], ONE / 2)),
                 d2::part(d2::placed(&solid, [0, ONE], d2::AXES, ONE))];
    let dumbbell = d2::compound(&context, 4, &parts).unwrap();
    let body = d2::placed(&dumbbell, [0, 20 * ONE], d2::AXES, ONE);
    let body = world.add(&body, &options).unwrap();
    let frame = world.frame(body).unwrap().unwrap();
    assert_eq!((frame.translation.x, frame.translation.y), (0, 20 * ONE));
    assert_eq!(dumbbell.destroy(), Err(Error(ffi::IN_USE)));

    let mut scene = d2::Scene::new(&context).unwrap();
    let frame = scene.add_frame([ONE, 0], d2::AXES, ONE, Id::default()).unwrap().unwrap();
    let traits = Traits { frame, ..Traits::default() };
    scene.add(&d2::sphere([0, 0], ONE), traits).unwrap();
    assert_eq!(scene.move_frame(frame, [7 * ONE, 0], d2::AXES, ONE), Ok(true));
    assert!(scene.nearest(&d2::point([7 * ONE, 0]), !0).unwrap().unwrap().distance == 0);
    assert_eq!(scene.remove_frame(frame), Ok(false));
}

#[test]
fn characters() {
    let context = Context::new().unwrap();
    let mut scene = d2::Scene::new(&context).unwrap();
    scene.add(&d2::aabb([-9 * ONE, -ONE], [9 * ONE, 0]), Traits::default()).unwrap();
    let wall = d2::aabb([3 * ONE, 0], [4 * ONE, 9 * ONE]);
    let wall = scene.add(&wall, Traits::default()).unwrap();
    let mut player = d2::mover([0, ONE], [0, 2 * ONE], ONE / 2);
    let settings = d2::mover_settings();
    let mut last = d2::Move::default();
    for _ in 0..60 {
        let by = [ONE / 8, -ONE / 8];
        last = scene.move_character(&mut player, by, &settings, !0, Id::default()).unwrap();
    }
    assert_eq!(player.is_grounded, 1);
    assert!((unsafe { player.shape.of.capsule.a.x } - 5 * ONE / 2).abs() < ONE / 20);
    assert_eq!(d2::clip_velocity([ONE, 0], &last), Ok([0, 0]));
    let ball = d2::sphere([0, 5 * ONE], ONE);
    let hit = scene.cast(&ball, [UNIT, 0], 9 * ONE, !0).unwrap().unwrap();
    assert_eq!((hit.id, hit.distance), (wall, 2 * ONE));
    let crate_ = d2::aabb([0, 5 * ONE], [ONE, 6 * ONE]);
    let hits = scene.cast_all(&crate_, [UNIT, 0], 9 * ONE, !0).unwrap();
    assert_eq!((hits.len(), hits[0].id, hits[0].distance), (1, wall, 2 * ONE));
    assert_eq!(scene.cast_any(&crate_, [0, UNIT], ONE, !0), Ok(false));
    let mut walker = d2::box_mover([0, ONE], [ONE, 2 * ONE]);
    for _ in 0..60 {
        let by = [ONE / 8, -ONE / 8];
        scene.move_character(&mut walker, by, &settings, !0, Id::default()).unwrap();
    }
    assert_eq!(walker.is_grounded, 1);
}

#[test]
fn errors() {
    let ball = d3::sphere([0, 0, 0], ONE);
    let said = d3::raycast(&d3::ray([0, 0, 0], [1, 0, 0], ONE), &ball);
    assert_eq!(said.unwrap_err(), Error(ffi::NOT_UNIT));
    assert_eq!(Error(ffi::NOT_UNIT).to_string(), "the length of a direction is not 1");
    assert_eq!(detent::raw(-0.5), Some(-32768));
    assert_eq!(detent::raw(32768.0), None);
    assert_eq!(detent::raw(f64::NAN), None);
}
