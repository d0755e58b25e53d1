// SPDX-License-Identifier: MIT
// The scripted match of every binding: boxes fall on a floor, a scene has a ball around each, rays look
// down at them. Included by the example and the test.

use detent::{d3, Context, Traits, ONE, UNIT};

struct Script {
    state: u32,
    sum: u64,
}

impl Script {
    fn draw(&mut self, count: i32) -> i32 {
        self.state = self.state.wrapping_mul(1664525).wrapping_add(1013904223);
        ((self.state >> 8) % count as u32) as i32
    }
    fn mix(&mut self, value: u64) {
        self.sum = self.sum.wrapping_mul(6364136223846793005).wrapping_add(value);
    }
}

fn play() -> detent::Result<u64> {
    const BODIES: i32 = 12;
    const TICKS: usize = 120;
    const RAYS: usize = 8;
    let mut script = Script { state: 1, sum: 0 };
    let context = Context::new()?;
    let mut world = d3::World::new(&context, &d3::default_settings())?;
    let mut scene = d3::Scene::new(&context)?;
    let options = d3::default_options();

    let floor = d3::aabb([-20 * ONE, -ONE, -20 * ONE], [20 * ONE, 0, 20 * ONE]);
    world.add(&floor, &d3::BodyOptions { motion: detent::ffi::FIXED_BODY, ..options })?;
    let mut boxes = Vec::new();
    let mut balls = Vec::new();
    for i in 0..BODIES {
        let x = script.draw(4 * ONE) - 2 * ONE;
        let center = [x, (2 + 2 * i) * ONE, script.draw(4 * ONE) - 2 * ONE];
        let mut half = [0; 3];
        for side in &mut half {
            *side = ONE / 2 + script.draw(ONE / 2);
        }
        boxes.push(world.add(&d3::obb(center, half, d3::AXES), &options)?);
        let traits = Traits { user: i as u64, ..Traits::default() };
        balls.push(scene.add(&d3::sphere(center, ONE), traits)?);
    }

    let mut saved = Vec::new();
    for tick in 0..TICKS {
        if tick % 10 == 5 {
            world.set_velocity(boxes[tick / 10], [ONE, 5 * ONE, 0])?;
        }
        world.step()?;
        for (body, ball) in boxes.iter().zip(&balls) {
            let center = world.position(*body)?.expect("it is there");
            scene.replace(*ball, &d3::sphere(center, ONE))?;
        }
        for _ in 0..RAYS {
            let x = script.draw(8 * ONE) - 4 * ONE;
            let origin = [x, 30 * ONE, script.draw(8 * ONE) - 4 * ONE];
            match scene.raycast(&d3::ray(origin, [0, -UNIT, 0], 40 * ONE), 1)? {
                Some(hit) => {
                    script.mix(u64::from(hit.distance as u32));
                    script.mix(u64::from(hit.id.index));
                    script.mix(u64::from(hit.normal.y as u32));
                }
                None => script.mix(u64::from(u32::MAX)),
            }
        }
        script.mix(world.digest()?);
        script.mix(scene.digest()?);
        if tick == TICKS / 2 {
            saved = world.snapshot()?;
            script.mix(saved.len() as u64);
        }
    }

    world.restore(&saved)?;
    for _ in 0..10 {
        world.step()?;
    }
    script.mix(world.digest()?);
    Ok(script.sum)
}
