-- SPDX-License-Identifier: MIT
-- Scenes and worlds for LuaJIT, through its FFI. Lengths are integers in steps of 2^-16, directions
-- in steps of 2^-30. The library is the file named by DETENT_LIBRARY, or the installed
-- libdetent.so.
--
-- Methods of scenes and worlds are named after the C functions: world:set_velocity(id, v) is
-- detent_world3_set_velocity. They return true for yes or done and false for no. The methods below
-- that find something return it, or nil. C errors raise Lua errors: tables with `status` and
-- `message`.
local ffi = require('ffi')
require('detent.interface')

local c = ffi.load(os.getenv('DETENT_LIBRARY') or 'detent')
local detent = { c = c, ONE = 65536, UNIT = 1073741824, ALL_LAYERS = 0xffffffff }

local Error = { __tostring = function(self) return self.message end }

local function check(status)
  if status < 0 then
    error(setmetatable({ status = status, message = ffi.string(c.detent_describe(status)) }, Error), 3)
  end
  return status == c.DETENT_OK
end

-- A number rounded to the nearest length, ties to even; raises an error out of range.
function detent.raw(units)
  local scaled = units * detent.ONE
  local below = math.floor(scaled)
  local rest = scaled - below
  if rest > 0.5 or (rest == 0.5 and below % 2 == 1) then below = below + 1 end
  assert(below >= -2147483648 and below < 2147483648, 'a length out of range')
  return below
end

function detent.number(length) return length / detent.ONE end

function detent.results_version() return c.detent_results_version() end

-- The number, if it is an integer of 32 bits; the FFI would keep any bits of another one.
local function whole(value, level)
  if not (value % 1 == 0 and value >= -2147483648 and value < 2147483648) then
    error(value .. ' is no integer from -2^31 to 2^31 - 1', level or 3)
  end
  return value
end

-- Makes vectors of this type from two or three numbers, a table of them, or another vector.
local function vectors(kind)
  return function(first, ...)
    local numbers = type(first) == 'number' and { first, ... } or first
    if type(numbers) == 'table' then
      for _, number in ipairs(numbers) do whole(number, 4) end
    end
    return numbers and kind(numbers) or kind()
  end
end

-- Shapes, rays and queries of one dimension: detent.d2 and detent.d3.
local function space(dimension)
  local function name(what) return 'detent_' .. what:gsub('{N}', dimension) end
  local vec = vectors(ffi.typeof(name('vec{N}')))
  local direction = vectors(ffi.typeof(name('direction{N}')))
  local ray, shape = ffi.typeof(name('ray{N}')), ffi.typeof(name('shape{N}'))
  local hit, number = ffi.typeof(name('hit{N}')), ffi.typeof('int32_t[1]')
  local d = { dimension = dimension, vec = vec, direction = direction }

  local function made(kind)
    local new = shape()
    new.kind = kind
    return new
  end
  function d.ray(origin, along, max_distance)
    return ray(vec(origin), direction(along), whole(max_distance or 2147483647))
  end
  function d.sphere(center, radius)
    local new = made(c.DETENT_SPHERE)
    new.as.sphere.center, new.as.sphere.radius = vec(center), whole(radius)
    return new
  end
  function d.aabb(least, greatest)
    local new = made(c.DETENT_AABB)
    new.as.aabb.min, new.as.aabb.max = vec(least), vec(greatest)
    return new
  end
  -- `axes` are directions; by default the world axes.
  function d.obb(center, half_extents, axes)
    local new = made(c.DETENT_OBB)
    new.as.obb.center, new.as.obb.half_extents = vec(center), vec(half_extents)
    for i = 0, dimension - 1 do
      local axis = axes and axes[i + 1] or { 0, 0, dimension == 3 and 0 or nil }
      if not axes then axis[i + 1] = detent.UNIT end
      new.as.obb.rotation.axis[i] = direction(axis)
    end
    return new
  end
  function d.plane(normal, offset)
    local new = made(c.DETENT_PLANE)
    new.as.plane.normal, new.as.plane.offset = direction(normal), whole(offset)
    return new
  end
  function d.capsule(start, stop, radius)
    local new = made(c.DETENT_CAPSULE)
    new.as.capsule.a, new.as.capsule.b, new.as.capsule.radius = vec(start), vec(stop), whole(radius)
    return new
  end
  function d.triangle(first, second, third)
    local new = made(c.DETENT_TRIANGLE)
    new.as.triangle.a, new.as.triangle.b, new.as.triangle.c = vec(first), vec(second), vec(third)
    return new
  end
  function d.point(at)
    local new = made(c.DETENT_POINT)
    new.as.point = vec(at)
    return new
  end

  local raycast, overlaps = c[name('raycast{N}')], c[name('overlaps{N}')]
  local contains, distance = c[name('contains{N}')], c[name('distance{N}')]
  -- The first point where the ray touches the shape, or nil: distance, point and normal.
  function d.raycast(given, target)
    local found = hit()
    return check(raycast(given, target, found)) and found or nil
  end
  function d.overlaps(a, b) return check(overlaps(a, b)) end
  function d.contains(target, at) return check(contains(target, vec(at))) end
  function d.distance(a, b)
    local result = number()
    check(distance(a, b, result))
    return result[0]
  end
  return d
end
detent.d2, detent.d3 = space(2), space(3)

-- Methods of a context's objects. A name that is missing here calls the C function of that name.
local count, word, bytes = ffi.typeof('uint32_t[1]'), ffi.typeof('uint64_t[1]'), ffi.typeof('uint8_t[?]')
local special = {}

function special.size(self)
  local size = count()
  self:call('size', size)
  return size[0]
end

-- A 64-bit digest of the contents, equal on every machine.
function special.digest(self)
  local digest = word()
  self:call('digest', digest)
  return digest[0]
end

function special.snapshot(self)
  local size = count()
  self:call('snapshot', nil, 0, size)
  local room = bytes(size[0])
  self:call('snapshot', room, size[0], size)
  return ffi.string(room, size[0])
end

function special.restore(self, snapshot) return self:call('restore', snapshot, #snapshot) end

-- add(shape, traits) of scenes takes `layers`, `user` and `motion`; add(shape, options) of worlds
-- takes options from world:options(). Both return an id.
function special.add(self, shape, with)
  local id = ffi.new('detent_id')
  if type(with) == 'table' then
    with = ffi.new('detent_traits', { user = with.user or 0, layers = with.layers or 1,
      motion = with.motion or c.DETENT_MOVING })
  end
  return self:call('add', shape, with, id) and id or nil
end

-- Scenes: the first object that the ray touches, or nil.
function special.raycast(self, ray, layers)
  local hit = self.hit()
  return self:call('raycast', ray, layers or detent.ALL_LAYERS, hit) and hit or nil
end

-- Scenes: the object nearest to a point, or the nearest that a shape overlaps; or nil.
function special.nearest(self, question, layers)
  local found = ffi.new('detent_found')
  return self:call('nearest', question, layers or detent.ALL_LAYERS, found) and found or nil
end

-- Worlds: position, rotation and velocities of a body, or nil.
function special.body(self, id)
  local body = self.state()
  return self:call('body', id, body) and body or nil
end

function special.options(self)
  local options = ffi.new('detent_body' .. self.dimension .. '_options')
  check(c['detent_body' .. self.dimension .. '_default_options'](options))
  return options
end

-- A scene holds the shapes of the bodies of a world, and nothing else.
function special.follow(self, world, sensors)
  return self:call('follow', world.handle, sensors and 1 or 0)
end

-- Worlds: the contacts that touch, of the body with this id or of all; none of sensors.
function special.contacts(self, id)
  local kind = ffi.typeof('detent_world' .. self.dimension .. '_contact[?]')
  local size = count()
  id = id or ffi.new('detent_id')
  self:call('contacts', id, nil, 0, size)
  local room, contacts = kind(size[0]), {}
  self:call('contacts', id, room, size[0], size)
  for i = 0, size[0] - 1 do contacts[i + 1] = room[i] end
  contacts.memory = room  -- keeps it alive
  return contacts
end

-- The names of the first fields in which two scenes or worlds differ.
function special.diff(self, other, most)
  local size = count()
  self:call('diff', other.handle, most or 16, nil, 0, size)
  local room, names = bytes(size[0]), {}
  self:call('diff', other.handle, most or 16, room, size[0], size)
  for name in ffi.string(room, size[0]):gmatch('[^\n]+') do names[#names + 1] = name end
  return names
end

-- Worlds of sessions or replays: a uint32_t[] of other game state that a rollback restores.
function special.words(self)
  local words = ffi.new('uint32_t[256]')
  self:call('words', words)
  return words
end

-- Sessions (given this player's input, a string) and replays: an iterator over the frames to
-- simulate, each with the input string of every player, or false for one that takes no part.
-- `state` says why there are no more.
function special.frames(self, pad)
  local frame, inputs = ffi.new('detent_frame'), bytes(8 * self.input_size)
  local is_open = false
  return function()
    if is_open then self:call('end_frame') end
    if pad then
      assert(#pad == self.input_size, 'an input of another size')
      is_open = self:call('begin_frame', pad, frame, inputs)
    else
      is_open = self:call('begin_frame', frame, inputs)
    end
    self.state = frame.state
    if not is_open then return nil end
    local pressed = {}
    for i = 0, frame.players - 1 do
      local is_in = require('bit').band(frame.present, 2 ^ i) ~= 0
      pressed[i + 1] = is_in and ffi.string(inputs + i * self.input_size, self.input_size)
    end
    return pressed, frame.number
  end
end

-- Sessions: takes a packet (a string) that arrived at a time in microseconds. False if it was not
-- used.
function special.receive(self, peer, packet, now) return self:call('receive', peer, packet, #packet, now) end

-- Sessions: an iterator over the packets due to be sent, as peer and string.
function special.packets(self, now)
  local peer, size, room = count(), count(), bytes(c.DETENT_PACKET)
  return function()
    if not self:call('packet', now, peer, room, c.DETENT_PACKET, size) then return nil end
    return peer[0], ffi.string(room, size[0])
  end
end

-- Sessions: an iterator over new events and the names of fields.
function special.events(self)
  local event, name = ffi.new('detent_session_event'), bytes(c.DETENT_NAME)
  return function()
    if not self:call('event', event, name, c.DETENT_NAME) then return nil end
    return event, ffi.string(name, event.name_size)
  end
end

-- Sessions: a structure with the progress.
function special.status(self)
  local status = ffi.new('detent_session_status')
  self:call('status', status)
  return status
end

function special.matched(self, peer)
  local frame = count()
  self:call('matched', peer, frame)
  return frame[0]
end

-- Sessions: the replay of all final frames, or nil if none is recorded.
function special.replay(self)
  local size = count()
  self:call('replay', nil, 0, size)
  local room = bytes(size[0])
  return self:call('replay', room, size[0], size) and ffi.string(room, size[0]) or nil
end

-- Replays: the result of the resimulation so far.
function special.check(self)
  local check_ = ffi.new('detent_replay_check')
  self:call('check', check_)
  return check_
end

local Held = {}
function Held.__index(self, name)
  if name == 'call' then return Held.call end
  if special[name] then return special[name] end
  local function method(held, ...) return held:call(name, ...) end
  rawset(self, name, method)
  return method
end

function Held.call(self, name, ...)
  local calls = rawget(self, 'calls')
  local call = calls[name]
  if not call then
    call = c[self.prefix .. name]
    calls[name] = call
  end
  return check(call(self.context, self.handle, ...))
end

local function wrapped(context, kind, dimension, handle)
  return setmetatable({ context = context, handle = handle, prefix = 'detent_' .. kind .. dimension .. '_',
    calls = {}, dimension = dimension, hit = ffi.typeof('detent_object_hit' .. dimension),
    state = kind == 'world' and ffi.typeof('detent_body' .. dimension) or nil }, Held)
end

-- Worlds take settings or nil; sessions take settings and a world.
local function held(context, kind, dimension, ...)
  local handle = ffi.new('detent_handle[1]')
  local create = c['detent_' .. kind .. dimension .. '_create']
  local given = { ... }
  local many = kind == 'world' and 1 or select('#', ...)
  given[many + 1] = handle
  check(create(context, unpack(given, 1, many + 1)))
  return wrapped(context, kind, dimension, handle[0])
end

-- A session or replay, with its world.
local function played(context, kind, dimension, input_size, ...)
  local made = held(context, kind, dimension, ...)
  local handle = ffi.new('detent_handle[1]')
  made:call('world', handle)
  rawset(made, 'world', wrapped(context, 'world', dimension, handle[0]))
  rawset(made, 'input_size', input_size)
  rawset(made, 'state', c.DETENT_CONNECTING)
  return made
end

-- The default settings of a session, to be modified.
function detent.session_settings()
  local settings = ffi.new('detent_session_settings')
  check(c.detent_session_default_settings(settings))
  return settings
end

local Context = {}
Context.__index = Context
function Context:scene2() return held(self.memory, 'scene', 2) end
function Context:scene3() return held(self.memory, 'scene', 3) end
function Context:world2(settings) return held(self.memory, 'world', 2, settings) end
function Context:world3(settings) return held(self.memory, 'world', 3, settings) end
-- A network match from a world that all peers start with.
function Context:session2(start, settings)
  return played(self.memory, 'session', 2, settings.input_size, settings, start.handle)
end
function Context:session3(start, settings)
  return played(self.memory, 'session', 3, settings.input_size, settings, start.handle)
end
-- A replay, with the settings of its session.
function Context:replay2(data, start, settings)
  return played(self.memory, 'replay', 2, settings.input_size, data, #data, start.handle,
    settings.input_size, settings.words)
end
function Context:replay3(data, start, settings)
  return played(self.memory, 'replay', 3, settings.input_size, data, #data, start.handle,
    settings.input_size, settings.words)
end
-- Destroys everything in the context; if never called, the garbage collector does it.
function Context:close()
  ffi.gc(self.memory, nil)
  return check(c.detent_close(self.memory))
end

function detent.open()
  local memory = ffi.new('detent_context')
  check(c.detent_open(memory, nil))
  return setmetatable({ memory = ffi.gc(memory, c.detent_close) }, Context)
end

return detent
