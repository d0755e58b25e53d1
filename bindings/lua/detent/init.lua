-- SPDX-License-Identifier: MIT
-- Scenes and worlds for LuaJIT, through its FFI. Lengths are integers in steps of 2^-16, directions in
-- steps of 2^-30. The library is the file named by DETENT_LIBRARY, or the installed libdetent.so.
--
-- Methods of scenes and worlds have the names of the C functions: world:set_velocity(id, v) is
-- detent_world3_set_velocity. They return true for yes or done and false for no; those below that find
-- something return it, or nil. Errors of C are errors of Lua: tables with `status` and `message`.
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

-- The length nearest to a number of units, ties to even; an error out of range.
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

-- Shapes, rays and queries of one dimension: detent.d2 and detent.d3.
local function space(dimension)
  local function name(what) return 'detent_' .. what:gsub('{N}', dimension) end
  local vec, direction = ffi.typeof(name('vec{N}')), ffi.typeof(name('direction{N}'))
  local ray, shape = ffi.typeof(name('ray{N}')), ffi.typeof(name('shape{N}'))
  local hit, number = ffi.typeof(name('hit{N}')), ffi.typeof('int32_t[1]')
  local d = { dimension = dimension, vec = vec, direction = direction }

  local function made(kind)
    local new = shape()
    new.kind = kind
    return new
  end
  function d.ray(origin, along, max_distance)
    return ray(vec(origin), direction(along), max_distance or 2147483647)
  end
  function d.sphere(center, radius)
    local new = made(c.DETENT_SPHERE)
    new.as.sphere.center, new.as.sphere.radius = vec(center), radius
    return new
  end
  function d.aabb(least, greatest)
    local new = made(c.DETENT_AABB)
    new.as.aabb.min, new.as.aabb.max = vec(least), vec(greatest)
    return new
  end
  -- `axes`: directions, those of the world if left out.
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
    new.as.plane.normal, new.as.plane.offset = direction(normal), offset
    return new
  end
  function d.capsule(start, stop, radius)
    local new = made(c.DETENT_CAPSULE)
    new.as.capsule.a, new.as.capsule.b, new.as.capsule.radius = vec(start), vec(stop), radius
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
  -- Where the ray first touches the shape, or nil: distance, point and normal.
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

-- Methods of what a context holds. What is not here is the C function of that name.
local count, word, bytes = ffi.typeof('uint32_t[1]'), ffi.typeof('uint64_t[1]'), ffi.typeof('uint8_t[?]')
local special = {}

function special.size(self)
  local size = count()
  self:call('size', size)
  return size[0]
end

-- 64 bits of everything in it, equal on every machine.
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

-- Scenes: add(shape, traits) with `layers`, `user` and `motion`; worlds: add(shape, options), where
-- options come from world:options(). Both return an id.
function special.add(self, shape, with)
  local id = ffi.new('detent_id')
  if type(with) == 'table' then
    with = ffi.new('detent_traits', { user = with.user or 0, layers = with.layers or 1,
      motion = with.motion or c.DETENT_MOVING })
  end
  return self:call('add', shape, with, id) and id or nil
end

-- Of a scene: the first object that the ray touches, or nil.
function special.raycast(self, ray, layers)
  local hit = self.hit()
  return self:call('raycast', ray, layers or detent.ALL_LAYERS, hit) and hit or nil
end

-- Of a scene: the nearest object to a point, or of those that a shape overlaps; or nil.
function special.nearest(self, question, layers)
  local found = ffi.new('detent_found')
  return self:call('nearest', question, layers or detent.ALL_LAYERS, found) and found or nil
end

-- Of a world: position, rotation and velocities of a body, or nil.
function special.body(self, id)
  local body = self.state()
  return self:call('body', id, body) and body or nil
end

function special.options(self)
  local options = ffi.new('detent_body' .. self.dimension .. '_options')
  check(c['detent_body' .. self.dimension .. '_default_options'](options))
  return options
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

local function held(context, kind, dimension, ...)
  local prefix = 'detent_' .. kind .. dimension .. '_'
  local handle = ffi.new('detent_handle[1]')
  -- worlds take settings, or nil
  if kind == 'world' then
    check(c[prefix .. 'create'](context, (...), handle))
  else
    check(c[prefix .. 'create'](context, handle))
  end
  return setmetatable({ context = context, handle = handle[0], prefix = prefix, calls = {},
    dimension = dimension, hit = ffi.typeof('detent_object_hit' .. dimension),
    state = ffi.typeof('detent_body' .. dimension) }, Held)
end

local Context = {}
Context.__index = Context
function Context:scene2() return held(self.memory, 'scene', 2) end
function Context:scene3() return held(self.memory, 'scene', 3) end
function Context:world2(settings) return held(self.memory, 'world', 2, settings) end
function Context:world3(settings) return held(self.memory, 'world', 3, settings) end
-- Destroys everything in it; without a call the garbage collector does it.
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
