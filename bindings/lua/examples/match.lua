-- SPDX-License-Identifier: MIT
-- The scripted match of every binding: boxes fall on a floor, a scene has a ball around each, rays look
-- down at them. Prints 16 digits that follow from every answer: those of tests/c/match.cpp.
local detent = require('detent')
local ONE, UNIT, d3 = detent.ONE, detent.UNIT, detent.d3
local BODIES, TICKS, RAYS = 12, 120, 8

local state, sum = 1, 0ULL
local function draw(count)
  state = (state * 1664525 + 1013904223) % 4294967296
  return math.floor(state / 256) % count
end
local function mix(value) sum = sum * 6364136223846793005ULL + value end
local function word(length) return length % 4294967296 end

local function play()
  state, sum = 1, 0ULL
  local context = detent.open()
  local world, scene = context:world3(), context:scene3()
  local ground = world:options()
  ground.motion = detent.c.DETENT_FIXED_BODY
  world:add(d3.aabb({ -20 * ONE, -ONE, -20 * ONE }, { 20 * ONE, 0, 20 * ONE }), ground)
  local boxes, balls = {}, {}
  for i = 0, BODIES - 1 do
    local x = draw(4 * ONE) - 2 * ONE
    local center = { x, (2 + 2 * i) * ONE, draw(4 * ONE) - 2 * ONE }
    local half = {}
    for k = 1, 3 do half[k] = ONE / 2 + draw(ONE / 2) end
    boxes[i] = world:add(d3.obb(center, half))
    balls[i] = scene:add(d3.sphere(center, ONE), { user = i })
  end

  local saved
  local up = d3.vec(ONE, 5 * ONE, 0)
  for tick = 0, TICKS - 1 do
    if tick % 10 == 5 then world:set_velocity(boxes[math.floor(tick / 10)], up) end
    world:step()
    for i = 0, BODIES - 1 do
      scene:replace(balls[i], d3.sphere(world:body(boxes[i]).position, ONE))
    end
    for _ = 1, RAYS do
      local x = draw(8 * ONE) - 4 * ONE
      local origin = { x, 30 * ONE, draw(8 * ONE) - 4 * ONE }
      local hit = scene:raycast(d3.ray(origin, { 0, -UNIT, 0 }, 40 * ONE), 1)
      if hit then
        mix(word(hit.distance))
        mix(hit.id.index)
        mix(word(hit.normal.y))
      else
        mix(0xffffffff)
      end
    end
    mix(world:digest())
    mix(scene:digest())
    if tick == TICKS / 2 then
      saved = world:snapshot()
      mix(#saved)
    end
  end

  world:restore(saved)
  for _ = 1, 10 do world:step() end
  mix(world:digest())
  context:close()
  return require('bit').tohex(sum, 16)
end

if not pcall(debug.getlocal, 4, 1) then print(play()) end  -- not from require
return { play = play }
