-- SPDX-License-Identifier: MIT
-- Tests of the Lua binding: every function of this table. Prints the name of each failing test.
local detent = require('detent')
local ffi = require('ffi')
local ONE, UNIT, d2, d3 = detent.ONE, detent.UNIT, detent.d2, detent.d3
local tests = {}

function tests.the_match_ends_as_in_cpp()
  local expected = assert(os.getenv('DETENT_MATCH'), 'DETENT_MATCH is not set')
  local match = dofile('bindings/lua/examples/match.lua')
  assert(match.play() == expected, match.play() .. ' instead of ' .. expected)
end

function tests.queries_of_single_shapes()
  local ball = d3.sphere({ 10 * ONE, 0, 0 }, ONE)
  local hit = d3.raycast(d3.ray({ 0, 0, 0 }, { UNIT, 0, 0 }), ball)
  assert(hit.distance == 9 * ONE and hit.normal.x == -UNIT and hit.point.x == 9 * ONE)
  assert(d3.raycast(d3.ray({ 0, 0, 0 }, { -UNIT, 0, 0 }), ball) == nil)
  assert(d3.contains(ball, { 11 * ONE, 0, 0 }) and not d3.contains(ball, { 11 * ONE + 1, 0, 0 }))
  assert(d2.overlaps(d2.aabb({ 0, 0 }, { ONE, ONE }), d2.obb({ 2 * ONE, 0 }, { ONE, ONE })))
  assert(not d2.overlaps(d2.aabb({ 0, 0 }, { ONE, ONE }), d2.obb({ 2 * ONE + 1, 0 }, { ONE, ONE })))
  assert(d2.distance(d2.sphere({ 0, 0 }, ONE), d2.capsule({ 5 * ONE, 0 }, { 9 * ONE, 0 }, ONE)) == 3 * ONE)
  assert(d3.overlaps(d3.plane({ 0, UNIT, 0 }, 0), d3.triangle({ 0, 0, 0 }, { 0, 1, 0 }, { 1, 1, 0 })))
end

function tests.scenes()
  local context = detent.open()
  local scene = context:scene3()
  local ball = scene:add(d3.sphere({ 0, 0, 0 }, ONE), { user = 7, layers = 2 })
  assert(scene:size() == 1 and scene:nearest(d3.point({ 3 * ONE, 0, 0 })).distance == 2 * ONE)
  local ray = d3.ray({ -5 * ONE, 0, 0 }, { UNIT, 0, 0 })
  assert(scene:raycast(ray).id.index == ball.index and scene:raycast(ray, 1) == nil)
  assert(scene:raycast_any(ray, 2) and not scene:raycast_any(ray, 4))
  local before, saved = scene:digest(), scene:snapshot()
  assert(scene:move(ball, d3.vec(0, ONE, 0)) and scene:digest() ~= before)
  assert(scene:restore(saved) and scene:digest() == before)
  local traits = ffi.new('detent_traits')
  assert(scene:object(ball, nil, traits) and traits.user == 7)
  assert(scene:remove(ball) and not scene:remove(ball) and scene:size() == 0)
  context:close()
end

function tests.scenes_that_follow_worlds()
  local context = detent.open()
  local scene, world = context:scene2(), context:world2()
  local ball = world:add(d2.sphere({ 0, 5 * ONE }, ONE))
  assert(scene:follow(world) and scene:size() == 1)
  assert(scene:raycast(d2.ray({ 0, 0 }, { 0, UNIT })).id.index == ball.index)
  assert(world:set_position(ball, d2.vec(0, 9 * ONE)) and world:body(ball).position.y == 9 * ONE)
  context:close()
end

function tests.contacts_and_setters_of_bodies()
  local context = detent.open()
  local world = context:world2()
  local options = world:options()
  options.motion = detent.c.DETENT_FIXED_BODY
  local floor = world:add(d2.aabb({ -5 * ONE, -ONE }, { 5 * ONE, 0 }), options)
  local box = world:add(d2.aabb({ -ONE, 0 }, { ONE, 2 * ONE }))
  for _ = 1, 30 do world:step() end
  local contact = world:contacts(box)[1]
  assert(#world:contacts() == 1 and contact.a.index == floor.index and contact.count == 2)
  assert(contact.normal.y == UNIT and math.abs(contact.impulse - 4 * 10 * ONE / 240) < 500)
  assert(world:set_friction(box, ONE / 4) and world:set_restitution(box, ONE / 2))
  assert(world:set_sensor(box, 1) and world:set_filter(box, 2, 4))
  assert(world:set_gravity_scale(box, -ONE) and world:set_damping(box, 0, ONE))
  assert(world:set_locked(box, detent.c.DETENT_LOCK_X) and world:set_fast(box, 1) and world:set_user(box, 7))
  world:set_velocity(box, d2.vec(ONE, 0))
  world:step()
  assert(#world:contacts() == 0)
  local velocity = world:body(box).velocity  -- locked along x; it rises, undamped
  assert(velocity.x == 0 and math.abs(velocity.y - 10 * ONE / 60) < 20)
  assert(world:set_gravity(d2.vec(0, 10 * ONE)))
  world:step()
  assert(math.abs(world:body(box).velocity.y) < 40)  -- that pulled it back
  context:close()
end

function tests.worlds()
  local context = detent.open()
  local world = context:world2()
  local options = world:options()
  options.velocity.x = ONE
  local body = world:add(d2.sphere({ 0, 0 }, ONE), options)
  for _ = 1, 60 do world:step() end
  local state = world:body(body)
  assert(state.position.x == ONE and state.position.y < -4 * ONE and state.velocity.y < -9 * ONE)
  assert(world:remove(body) and world:body(body) == nil)
  context:close()
end

function tests.errors_have_a_status_and_words()
  local context = detent.open()
  local scene = context:scene3()
  local fine, wrong = pcall(scene.raycast, scene, d3.ray({ 0, 0, 0 }, { UNIT, UNIT, 0 }))
  assert(not fine and wrong.status == detent.c.DETENT_NOT_UNIT and #tostring(wrong) > 5)
  fine, wrong = pcall(scene.restore, scene, 'no snapshot at all')
  assert(not fine and wrong.status == detent.c.DETENT_NO_SNAPSHOT)
  context:close()
  fine, wrong = pcall(scene.digest, scene)
  assert(not fine and wrong.status == detent.c.DETENT_BAD_CONTEXT)
  assert(not pcall(function() return scene:no_such_function() end))
end

function tests.numbers()
  assert(detent.raw(1.5) == 98304 and detent.number(98304) == 1.5)
  assert(detent.raw(2.5 / ONE) == 2 and detent.raw(3.5 / ONE) == 4 and detent.raw(-2.5 / ONE) == -2)
  assert(not pcall(detent.raw, 32768) and detent.raw(-32768) == -2147483648)
  local limit = 2147483648
  assert(d3.vec(limit - 1, -limit, 0).y == -limit and d3.vec({ 1, 2, 3 }).z == 3)
  for _, wrong in ipairs({ limit, -limit - 1, 0.5, 0 / 0 }) do
    assert(not pcall(d3.vec, 0, wrong, 0) and not pcall(d3.sphere, { 0, 0, wrong }, ONE))
    assert(not pcall(d3.sphere, { 0, 0, 0 }, wrong) and not pcall(d3.plane, { UNIT, 0, 0 }, wrong))
    assert(not pcall(d3.ray, { 0, 0, 0 }, { UNIT, 0, 0 }, wrong))
  end
end

local count, failed = 0, 0
for name, test in pairs(tests) do
  local fine, message = xpcall(test, debug.traceback)
  count = count + 1
  if not fine then
    failed = failed + 1
    print(name, message)
  end
end
print(count .. ' tests, ' .. failed .. ' failed')
os.exit(failed == 0 and 0 or 1)
