// SPDX-License-Identifier: MIT
// The scripted match that every binding plays: boxes fall on a floor, a scene holds a ball around
// each, and rays are cast down at them. Included by the example and the test.

use detent::{d3, Context, Frame, Id, SessionSettings, Traits, ONE, UNIT};

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

/// A player's input; it takes effect two frames later.
fn press(frame: u32, player: usize) -> [u8; 2] {
    if frame >= 80 {
        return [0, 0];
    }
    [(frame / (7 + 4 * player as u32) % 5) as u8, (frame / 3 % 4) as u8]
}

fn simulate(world: &mut d3::World, balls: &[Id], frame: &Frame) -> detent::Result<()> {
    let mut words = world.words()?;
    for player in 0..frame.players() {
        let pad = frame.input(player).unwrap_or(&[0, 0]);
        let (speed, which) = (i32::from(pad[0]), i32::from(pad[1]));
        words[player] += speed as u32;
        if speed != 0 {
            let ball = balls[2 * player + which as usize % 2];
            world.set_velocity(ball, [(speed - 2) * ONE, which * ONE, 0])?;
        }
    }
    world.set_words(&words)?;
    world.step()
}

/// A two-player match between two sessions in one program. Packets are delayed; every fifth is
/// lost.
fn play_for_two(context: &Context, script: &mut Script) -> detent::Result<()> {
    const FRAMES: u32 = 120;
    let options = d3::default_options();
    let mut start = d3::World::new(context, &d3::default_settings())?;
    let floor = d3::aabb([-20 * ONE, -ONE, -20 * ONE], [20 * ONE, 0, 20 * ONE]);
    start.add(&floor, &d3::BodyOptions { motion: detent::ffi::FIXED_BODY, ..options })?;
    let mut balls = Vec::new();
    for i in 0..4 {
        let ball = d3::sphere([(2 * i - 3) * ONE, 2 * ONE, 0], ONE / 2);
        balls.push(start.add(&ball, &options)?);
    }
    let ordinary = detent::session_settings();
    let settings = SessionSettings { match_: 4711, input_size: 2, words: 2, ..ordinary };
    let mut sessions = [
        d3::Session::new(&start, &SessionSettings { self_: 0, replay_every: 10, ..settings })?,
        d3::Session::new(&start, &SessionSettings { self_: 1, ..settings })?,
    ];
    let mut wire = std::collections::VecDeque::new();
    let (mut now, mut sent) = (0, 0);
    while sessions[0].status()?.frame < FRAMES || sessions[1].status()?.frame < FRAMES {
        while wire.len() > 8 {
            let (to, packet): (u32, Vec<u8>) = wire.pop_front().unwrap();
            sessions[to as usize].receive(1 - to, &packet, now)?;
        }
        for (player, session) in sessions.iter_mut().enumerate() {
            let frame = session.status()?.frame;
            if frame < FRAMES {
                let run = |world: &mut _, frame: &_| simulate(world, &balls, frame);
                session.advance(&press(frame, player), run)?;
            }
            session.poll(now, |to, packet| {
                sent += 1;
                if sent % 5 != 0 {
                    wire.push_back((to, packet.to_vec()));
                }
            })?;
        }
        now += 16667;
    }
    for session in &mut sessions {
        assert_eq!(session.event()?.unwrap().kind, detent::ffi::CONNECTED);
        assert!(session.event()?.is_none());
        assert!(session.status()?.resimulated > 0);
    }
    script.mix(sessions[0].world().digest()?);
    assert!(sessions[0].world().diff(sessions[1].world(), 1)?.is_empty());
    let words = sessions[1].world().words()?;
    script.mix(u64::from(words[0]));
    script.mix(u64::from(words[1]));

    let mut replay = d3::Replay::new(&start, &sessions[0].replay()?, 2, 2)?;
    let check = replay.play(|world, frame| simulate(world, &balls, frame))?;
    assert!(check.is_equal == 1 && check.frames > 100);
    assert_eq!(check.frames, sessions[0].status()?.final_frame);
    Ok(())
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
    play_for_two(&context, &mut script)?;
    Ok(script.sum)
}
