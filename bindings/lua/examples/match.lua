-- SPDX-License-Identifier: MIT
-- The scripted match that every binding plays: boxes fall on a floor, a scene holds a ball around
-- each, and rays are cast down at them. Prints a digest of all results, 16 digits equal to those of
-- tests/c/match.cpp.
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

-- A player's input; it takes effect two frames later.
local function press(frame, player)
  if frame >= 80 then return '\0\0' end
  return string.char(math.floor(frame / (7 + 4 * player)) % 5, math.floor(frame / 3) % 4)
end

local function simulate(world, balls, inputs)
  local words = world:words()
  for player = 0, 1 do
    local speed, which = inputs[player + 1]:byte(1, 2)
    words[player] = words[player] + speed
    if speed ~= 0 then
      world:set_velocity(balls[2 * player + which % 2], d3.vec((speed - 2) * ONE, which * ONE, 0))
    end
  end
  world:set_words(words)
  world:step()
end

-- A two-player match between two sessions in one program. Packets are delayed; every fifth is lost.
local function play_for_two(context)
  local FRAMES = 120
  local start = context:world3()
  local ground = start:options()
  ground.motion = detent.c.DETENT_FIXED_BODY
  start:add(d3.aabb({ -20 * ONE, -ONE, -20 * ONE }, { 20 * ONE, 0, 20 * ONE }), ground)
  local balls, sessions = {}, {}
  for i = 0, 3 do balls[i] = start:add(d3.sphere({ (2 * i - 3) * ONE, 2 * ONE, 0 }, ONE / 2)) end
  local settings = detent.session_settings()
  settings.match, settings.input_size, settings.words = 4711, 2, 2
  for i = 0, 1 do
    settings.self, settings.replay_every = i, 10 * (1 - i)
    sessions[i] = context:session3(start, settings)
  end
  local wire, first, sent, now = {}, 1, 0, 0
  while sessions[0]:status().frame < FRAMES or sessions[1]:status().frame < FRAMES do
    while #wire - first + 1 > 8 do
      local to, packet = unpack(wire[first])
      first = first + 1
      sessions[to]:receive(1 - to, packet, now)
    end
    for player = 0, 1 do
      local session = sessions[player]
      local frame = session:status().frame
      if frame < FRAMES then
        for inputs in session:frames(press(frame, player)) do simulate(session.world, balls, inputs) end
      end
      for to, packet in session:packets(now) do
        sent = sent + 1
        if sent % 5 ~= 0 then wire[#wire + 1] = { to, packet } end
      end
    end
    now = now + 16667
  end
  for player = 0, 1 do
    local happened = 0
    for event in sessions[player]:events() do
      assert(event.kind == detent.c.DETENT_CONNECTED)
      happened = happened + 1
    end
    assert(happened == 1 and sessions[player]:status().resimulated > 0)
  end
  mix(sessions[0].world:digest())
  assert(#sessions[0].world:diff(sessions[1].world) == 0)
  local words = sessions[1].world:words()
  mix(words[0])
  mix(words[1])

  local replay = context:replay3(sessions[0]:replay(), start, settings)
  for inputs in replay:frames() do simulate(replay.world, balls, inputs) end
  local check = replay:check()
  assert(check.is_equal == 1 and check.frames > 100)
  assert(check.frames == sessions[0]:status().final_frame)
end

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
  play_for_two(context)
  context:close()
  return require('bit').tohex(sum, 16)
end

if not pcall(debug.getlocal, 4, 1) then print(play()) end  -- not from require
return { play = play }
