# SPDX-License-Identifier: MIT
"""Correctly rounded collision queries, scenes and worlds with the same bits on every machine.

All numbers are raw integers: a length of 1 is `ONE`, a direction's component of 1 is `UNIT`.
`raw(1.5)` rounds a float to a length, and `number(n)` converts a length to a float. An integer that
does not fit raises OverflowError in a shape, and ctypes.ArgumentError as an argument. `d2` and `d3`
make shapes, rays and queries; a `Context` makes scenes and worlds:

    import detent
    from detent import ONE, d3

    with detent.Context() as context:
        scene = context.scene3()
        ball = scene.add(d3.sphere((10 * ONE, 0, 0), ONE), user=7)
        hit = scene.raycast(d3.ray((0, 0, 0), (detent.UNIT, 0, 0), 100 * ONE))
        print(hit.id == ball, detent.number(hit.distance))  # True 9.0

The library is the file named by DETENT_LIBRARY, the one in the wheel, or else the installed
libdetent.so.
"""
import array
import concurrent.futures
import ctypes
import ctypes.util
import os
import weakref
from collections import namedtuple
from ctypes import byref

from . import _interface as c
from ._checked import int32_array

ONE = 1 << 16
UNIT = 1 << 30
ALL_LAYERS = 0xffffffff
DYNAMIC, KINEMATIC, FIXED = 0, 1, 2
LOCK_X, LOCK_Y, LOCK_Z, LOCK_TURN_X, LOCK_TURN_Y, LOCK_TURN_Z = 1, 2, 4, 8, 16, 32  # locked axes
DISTANCE, BALL, HINGE, WELD, SLIDER, WHEEL, CONE = range(1, 8)  # kinds of joint


def _load():
    in_wheel = os.path.join(os.path.dirname(__file__), 'libdetent.so')
    path = (os.environ.get('DETENT_LIBRARY') or (in_wheel if os.path.exists(in_wheel) else None)
            or ctypes.util.find_library('detent'))
    if not path:
        raise ImportError('libdetent.so is not installed; DETENT_LIBRARY can name its file')
    library = ctypes.CDLL(path)
    for name, (result, arguments) in c.FUNCTIONS.items():
        function = getattr(library, name)
        function.restype, function.argtypes = result, arguments
    return library


_library = _load()


class Error(Exception):
    """A failed call. `status` is one of the negative constants."""

    def __init__(self, status):
        super().__init__(_library.detent_describe(status).decode())
        self.status = status


def _check(status):
    """True for yes or done, False for no or none."""
    if status < 0:
        raise Error(status)
    return status == c.DETENT_OK


def raw(value):
    """A float rounded to the nearest length, ties to even. Raises OverflowError out of range."""
    result = round(value * ONE)
    if not -1 << 31 <= result < 1 << 31:
        raise OverflowError(f'{value} is not in [-32768, 32768)')
    return result


def number(length):
    """The exact value of a length as a float."""
    return length / ONE


def version():
    """The version of the library: major * 10000 + minor * 100 + patch."""
    return _library.detent_version()


def results_version():
    """Changes whenever any result changes by a bit."""
    return _library.detent_results_version()


class Id(tuple):
    """The id of an object or a body: an index and a generation."""
    __slots__ = ()

    def __new__(cls, index, generation):
        return super().__new__(cls, (index, generation))

    index = property(lambda self: self[0])
    generation = property(lambda self: self[1])

    def _in_c(self):
        return c.detent_id(*self)


def _id(given):
    return Id(given.index, given.generation)


def _int32(values):
    """A pointer to the int32 values of a numpy array or buffer, their count, and an object that
    keeps them alive."""
    if hasattr(values, '__array_interface__'):
        import numpy
        given = numpy.asarray(values)
        values = numpy.ascontiguousarray(given, dtype=numpy.int32)
        if given.dtype != values.dtype and not numpy.array_equal(given, values):
            raise OverflowError('int32 numbers are needed')
        return values.ctypes.data, values.size, values
    view = memoryview(values)
    if view.nbytes % 4 or view.readonly:
        raise TypeError('int32 numbers in a writable buffer are needed')
    view = view.cast('B')
    return ctypes.addressof(ctypes.c_char.from_buffer(view)), view.nbytes // 4, view


def _like(values, count):
    """An int32 array of the same kind as the input (numpy or array), and a pointer to it."""
    if hasattr(values, '__array_interface__'):
        import numpy
        room = numpy.empty(count, dtype=numpy.int32)
        return room, room.ctypes.data
    room = array.array('i', bytes(4 * count))
    return room, room.buffer_info()[0]


Contact = namedtuple('Contact', 'normal depth points')
Contact.__doc__ = 'How shapes a and b are separated: b by `depth` along `normal`, from a to b.'
ContactPoint = namedtuple('ContactPoint', 'point depth feature')
Impact = namedtuple('Impact', 'time distance is_hit')
WorldContact = namedtuple('WorldContact', 'a b part_a part_b triangle normal impulse friction points')
WorldContact.__doc__ = 'How two bodies touch: the normal from a to b, and the impulses on b.'
WorldContactPoint = namedtuple('WorldContactPoint', 'point separation impulse feature')
Impact.__doc__ = 'When moving shapes meet: `time` is in steps of 2^-30.'


class _Space:
    """Shapes, rays and queries of one dimension."""

    def __init__(self, dimension):
        self.dimension = dimension
        self._identity = tuple(tuple(UNIT if i == k else 0 for i in range(dimension))
                               for k in range(dimension))
        for name in ('vec', 'direction', 'rotation', 'transform', 'ray', 'shape', 'hit', 'object_hit',
                     'body', 'manifold', 'sweep', 'joint', 'part'):
            setattr(self, f'_{name}', getattr(c, f'detent_{name}{dimension}'))
        self._words = ctypes.sizeof(self._ray) // 4

    def _call(self, name):
        return getattr(_library, 'detent_' + name.replace('{N}', str(self.dimension)))

    def _rotated(self, axes):
        result = self._rotation()
        for i, axis in enumerate(axes or self._identity):
            result.axis[i] = self._direction(*axis)
        return result

    def _made(self, kind, name, *fields):
        shape = self._shape()
        shape.kind = kind
        member = getattr(shape.as_, name)
        for (field, _), value in zip(member._fields_, fields):
            setattr(member, field, value)
        return shape

    def ray(self, origin, direction, max_distance=(1 << 31) - 1):
        return self._ray(self._vec(*origin), self._direction(*direction), max_distance)

    def sphere(self, center, radius):
        return self._made(c.DETENT_SPHERE, 'sphere', self._vec(*center), radius)

    def aabb(self, least, greatest):
        return self._made(c.DETENT_AABB, 'aabb', self._vec(*least), self._vec(*greatest))

    def obb(self, center, half_extents, axes=None):
        """`axes` are directions; by default the world axes."""
        return self._made(c.DETENT_OBB, 'obb', self._vec(*center), self._vec(*half_extents),
                          self._rotated(axes))

    def plane(self, normal, offset):
        return self._made(c.DETENT_PLANE, 'plane', self._direction(*normal), offset)

    def triangle(self, first, second, third):
        return self._made(c.DETENT_TRIANGLE, 'triangle', self._vec(*first), self._vec(*second),
                          self._vec(*third))

    def capsule(self, start, end, radius):
        return self._made(c.DETENT_CAPSULE, 'capsule', self._vec(*start), self._vec(*end), radius)

    def segment(self, start, end):
        return self._made(c.DETENT_SEGMENT, 'segment', self._vec(*start), self._vec(*end))

    def point(self, at):
        """The shape of a scene query."""
        shape = self._shape()
        shape.kind = c.DETENT_POINT
        shape.as_.point = self._vec(*at)
        return shape

    # Queries of one shape. Those of a point also take a ray or, in 3D, a frustum as the shape.

    def _query(self, name, shape):
        if isinstance(shape, self._ray):
            return self._call('ray{N}_' + name)
        if isinstance(shape, c.detent_frustum3):
            return self._call('frustum3_' + name)
        return self._call(name + '{N}')

    def raycast(self, ray, shape):
        """Where the ray first touches a shape or frustum, or None: distance, point and normal."""
        hit = self._hit()
        return hit if _check(self._query('raycast', shape)(ray, shape, hit)) else None

    def raycast_many(self, rays, shape, threads=1):
        """Distances of many rays, -1 for a miss. The rays are a numpy array or a buffer of int32,
        one row of origin, direction and max_distance each; the result is a numpy array or an array
        of int32 to match. `threads` splits the rays without changing the result."""
        pointer, count, keep = _int32(rays)
        if count % self._words:
            raise ValueError(f'a ray has {self._words} numbers')
        room, to = _like(rays, count // self._words)
        call, count = self._call('raycast{N}_many'), count // self._words

        def cast(part):
            first, last = count * part // threads, count * (part + 1) // threads
            return call(ctypes.cast(pointer + 4 * self._words * first, ctypes.POINTER(self._ray)),
                        last - first, shape,
                        ctypes.cast(to + 4 * first, ctypes.POINTER(ctypes.c_int32)))
        if threads == 1:
            _check(cast(0))
        else:
            # ctypes releases the GIL during a call.
            with concurrent.futures.ThreadPoolExecutor(threads) as pool:
                for status in pool.map(cast, range(threads)):
                    _check(status)
        del keep
        return room

    def contains(self, shape, point):
        return _check(self._query('contains', shape)(shape, self._vec(*point)))

    def overlaps(self, one, other):
        """Whether two shapes share a point. In 3D each may be a frustum."""
        if isinstance(one, c.detent_frustum3) and isinstance(other, c.detent_frustum3):
            return _check(self._call('frustum3_overlaps_frustum')(one, other))
        if isinstance(one, c.detent_frustum3):
            return self.overlaps_union(one, [other])
        if isinstance(other, c.detent_frustum3):
            return self.overlaps_union(other, [one])
        return _check(self._call('overlaps{N}')(one, other))

    def closest_point(self, shape, point):
        closest = self._vec()
        _check(self._query('closest_point', shape)(shape, self._vec(*point), closest))
        return self._tuple(closest)

    def distance(self, shape, other):
        """The distance between two shapes, or between a shape and a point (a tuple)."""
        distance = ctypes.c_int32()
        if isinstance(other, tuple):
            _check(self._query('distance_to_point', shape)(shape, self._vec(*other), byref(distance)))
        else:
            _check(self._call('distance{N}')(shape, other, byref(distance)))
        return distance.value

    def contact(self, one, other, context=None):
        """The `Contact` of two overlapping shapes, or None. Hulls belong to `context`."""
        found = self._manifold()
        if not (self._of_list('contact', context, one, other, found) if context
                else _check(self._call('contact{N}')(one, other, found))):
            return None
        return Contact(self._tuple(found.normal), found.depth,
                       [ContactPoint(self._tuple(point.point), point.depth, point.feature)
                        for point in found.points[:found.count]])

    def closest_points(self, one, other):
        """The closest points of two shapes."""
        first, second = self._vec(), self._vec()
        _check(self._call('closest_points{N}')(one, other, first, second))
        return self._tuple(first), self._tuple(second)

    def cast(self, shape, direction, max_distance, target):
        """The first contact of a moving shape with a target, or None: distance, point and
        normal."""
        hit = self._hit()
        return hit if _check(self._call('cast{N}')(shape, self._direction(*direction), max_distance,
                                                   target, hit)) else None

    # A list of shapes is their union; its hulls belong to `context`.

    def raycast_union(self, ray, shapes, context=None):
        """Where the ray first touches any of the shapes, or None: distance, point and normal."""
        hit = self._hit()
        return hit if self._of_list('raycast', context, ray, *self._list_of(shapes), hit) else None

    def contains_union(self, shapes, point, context=None):
        return self._of_list('contains', context, *self._list_of(shapes), self._vec(*point))

    def overlaps_union(self, one, other, context=None):
        """Whether shapes of two lists share a point. In 3D the first may be a frustum."""
        if isinstance(one, c.detent_frustum3):
            return _check(self._call('frustum3_overlaps')(context and context._open, one,
                                                          *self._list_of(other)))
        return self._of_list('overlaps', context, *self._list_of(one), *self._list_of(other))

    def closest_point_union(self, shapes, point, context=None):
        """The closest point of the nearest shape; the point itself if there are no shapes."""
        closest = self._vec()
        self._of_list('closest_point', context, *self._list_of(shapes), self._vec(*point), closest)
        return self._tuple(closest)

    def distance_union(self, shapes, other, context=None):
        """The least distance between shapes of two lists, or from a list to a point (a tuple)."""
        distance = ctypes.c_int32()
        if isinstance(other, tuple):
            self._of_list('distance_to_point', context, *self._list_of(shapes), self._vec(*other),
                          byref(distance))
        else:
            self._of_list('distance', context, *self._list_of(shapes), *self._list_of(other),
                          byref(distance))
        return distance.value

    def closest_points_union(self, one, other, context=None):
        """The closest points of the nearest two shapes of both lists."""
        first, second = self._vec(), self._vec()
        self._of_list('closest_points', context, *self._list_of(one), *self._list_of(other), first, second)
        return self._tuple(first), self._tuple(second)

    def cast_union(self, shape, direction, max_distance, targets, context=None):
        """The first contact of a moving shape with any of the targets, or None."""
        hit = self._hit()
        return hit if self._of_list('cast', context, shape, self._direction(*direction), max_distance,
                                    *self._list_of(targets), hit) else None

    def _list_of(self, shapes):
        shapes = list(shapes)
        return (self._shape * len(shapes))(*shapes), len(shapes)

    def _of_list(self, name, context, *arguments):
        return _check(self._call(f'shapes{{N}}_{name}')(context and context._open, *arguments))

    def sweep(self, start, end, start_axes=None, end_axes=None):
        """The motion of a frame, for `time_of_impact`."""
        return self._sweep(self._vec(*start), self._vec(*end), self._rotated(start_axes),
                           self._rotated(end_axes))

    def time_of_impact(self, one, sweep, other, other_sweep=None, target=8, context=None):
        """When two moving shapes first come closer than `target`, as an `Impact`, or None. Hulls
        belong to `context`."""
        impact = c.detent_impact()
        given = one, sweep, other, other_sweep, target, impact
        if not (self._of_list('time_of_impact', context, *given) if context
                else _check(self._call('time_of_impact{N}')(*given))):
            return None
        return Impact(impact.time, impact.distance, bool(impact.is_hit))

    @staticmethod
    def _tuple(v):
        return tuple(getattr(v, field) for field, _ in v._fields_)

    def _pose(self, transform):
        return (self._tuple(transform.translation),
                tuple(self._tuple(axis) for axis in transform.rotation.axis))


class _Space3(_Space):
    """The 3D-only functions: cameras. Their `size` is that of an image, (width, height) in pixels."""

    def camera(self, eye, target, near_distance, far_distance, up=(0, ONE, 0), **lens):
        """A camera at `eye` that looks at `target`, with `fov` (in 2^-32 of a turn) and `aspect`,
        or with `half_width` and `half_height`. None if it has no direction of view."""
        camera = c.detent_camera3(near_distance=near_distance, far_distance=far_distance,
                                  has_perspective=int('fov' in lens), **lens)
        vectors = (self._vec(*v) for v in (eye, target, up))
        return camera if _check(_library.detent_camera3_look_at(*vectors, camera.pose)) else None

    def frustum(self, camera):
        """The view volume of a camera, for queries and `Scene.visible`."""
        frustum = c.detent_frustum3()
        _check(_library.detent_camera3_frustum(camera, frustum))
        return frustum

    def pick_ray(self, camera, size, pixel):
        """The ray through the middle of pixel (column, row)."""
        ray = self._ray()
        _check(_library.detent_camera3_pick_ray(camera, *size, *pixel, ray))
        return ray

    def project(self, camera, size, point):
        """Where the point is seen, or None: x, y in steps of 2^-16 of a pixel, and depth, a length."""
        seen = c.detent_screen_point3()
        done = _check(_library.detent_camera3_project(camera, *size, self._vec(*point), seen))
        return self._tuple(seen) if done else None

    def unproject(self, camera, size, pixel, depth):
        """The point seen in the middle of pixel (column, row) at a depth."""
        point = self._vec()
        _check(_library.detent_camera3_unproject(camera, *size, *pixel, depth, point))
        return self._tuple(point)


d2 = _Space(2)
d3 = _Space3(3)


class _Owned:
    """A scene, world or asset of a context. Destroyed with the context, or by `destroy`."""

    def __init__(self, context, handle, destroy):
        self._context = context
        self.handle = handle
        self._destroy = destroy

    def destroy(self):
        _check(self._destroy(self._context._open, self.handle))


class _Held(_Owned):
    """The common base of scenes and worlds."""

    def __init__(self, context, space, kind, *arguments):
        self._space = space
        self._kind = kind
        handle = ctypes.c_uint32()
        _check(self._function('create')(context._open, *arguments, byref(handle)))
        super().__init__(context, handle.value, self._function('destroy'))

    def _function(self, name):
        return self._space._call(f'{self._kind}{{N}}_{name}')

    def _call(self, name, *arguments):
        return _check(self._function(name)(self._context._open, self.handle, *arguments))

    def __len__(self):
        size = ctypes.c_uint32()
        self._call('size', byref(size))
        return size.value

    def digest(self):
        """A 64-bit digest of the contents, equal on every machine."""
        digest = ctypes.c_uint64()
        self._call('digest', byref(digest))
        return digest.value

    def remove(self, which):
        return self._call('remove', which._in_c())

    def snapshot(self):
        size = ctypes.c_uint32()
        self._call('snapshot', None, 0, byref(size))
        room = ctypes.create_string_buffer(size.value)
        self._call('snapshot', room, size.value, byref(size))
        return room.raw

    def restore(self, snapshot):
        self._call('restore', snapshot, len(snapshot))

    def diff(self, other, most=16):
        """The names of the first fields that differ, such as `body 3:17 (sphere) velocity.y`."""
        size = ctypes.c_uint32()
        self._call('diff', other.handle, most, None, 0, byref(size))
        room = ctypes.create_string_buffer(size.value)
        self._call('diff', other.handle, most, room, size.value, byref(size))
        return room.raw.decode().splitlines()

    def _add(self, which, shape, traits):
        if which is not None:
            return which if self._call('add_as', which._in_c(), shape, traits) else None
        made = c.detent_id()
        return _id(made) if self._call('add', shape, traits, byref(made)) else None

    def _list(self, name, kind, *arguments):
        room = 64
        while True:
            items, count = (kind * room)(), ctypes.c_uint32()
            self._call(name, *arguments, items, room, byref(count))
            if count.value <= room:
                return items[:count.value]
            room = count.value


class Scene(_Held):
    """Objects and queries over them. A query ignores objects that are in none of its layers."""

    def __init__(self, context, space):
        super().__init__(context, space, 'scene')

    def add(self, shape, layers=1, user=0, fixed=False, frame=Id(0, 0), which=None):
        """The id of a new object, or None if its frame does not exist. `which` is an id chosen by
        the caller; None if its index is taken."""
        traits = c.detent_traits(user, layers, int(fixed), frame._in_c())
        return self._add(which, shape, traits)

    def set_traits(self, which, layers=1, user=0):
        return self._call('set_traits', which._in_c(), c.detent_traits(user, layers))

    def replace(self, which, shape):
        return self._call('replace', which._in_c(), shape)

    def move(self, which, by):
        return self._call('move', which._in_c(), self._space._vec(*by))

    def object(self, which):
        """The shape and the traits of an object, or None."""
        shape, traits = self._space._shape(), c.detent_traits()
        return (shape, traits) if self._call('object', which._in_c(), shape, traits) else None

    def optimize(self):
        self._call('optimize')

    def follow(self, world, sensors=False):
        """Holds the shapes of the world's bodies, with their ids, and nothing else: call it after each
        step, or whenever queries are due. False if parts of compounds had no room."""
        status = self._space._call('scene{N}_follow')(self._context._open, self.handle, world.handle,
                                                      int(sensors))
        return status != c.DETENT_FULL and _check(status)

    def _placed(self, translation, axes, scale):
        return self._space._transform(self._space._vec(*translation), self._space._rotated(axes), scale)

    def add_frame(self, translation, axes=None, scale=ONE, parent=Id(0, 0)):
        """A frame that carries objects, or None if its parent does not exist."""
        made = c.detent_id()
        done = self._call('add_frame', self._placed(translation, axes, scale), parent._in_c(),
                          byref(made))
        return _id(made) if done else None

    def move_frame(self, frame, translation, axes=None, scale=ONE):
        return self._call('move_frame', frame._in_c(), self._placed(translation, axes, scale))

    def remove_frame(self, frame):
        """False if the frame is not empty."""
        return self._call('remove_frame', frame._in_c())

    def frame(self, frame):
        """The poses of a frame in its parent and in the world, or None: each is a translation, axes
        and a scale."""
        poses = self._space._transform(), self._space._transform()
        if not self._call('frame', frame._in_c(), *poses):
            return None
        return tuple((*self._space._pose(pose), pose.scale) for pose in poses)

    def raycast(self, ray, layers=ALL_LAYERS):
        """The first object that the ray touches, as a `Hit`, or None."""
        hit = self._space._object_hit()
        return Hit(hit) if self._call('raycast', ray, layers, hit) else None

    def raycast_any(self, ray, layers=ALL_LAYERS):
        return self._call('raycast_any', ray, layers)

    def raycast_all(self, ray, layers=ALL_LAYERS):
        """All objects that the ray touches, sorted by distance, then id."""
        return [Hit(hit) for hit in self._list('raycast_all', self._space._object_hit, ray, layers)]

    def raycast_many(self, rays, layers=ALL_LAYERS):
        """The first hits of many rays (as for `d3.raycast_many`): one row of the words of
        object_hit per ray."""
        pointer, count, keep = _int32(rays)
        if count % self._space._words:
            raise ValueError(f'a ray has {self._space._words} numbers')
        count //= self._space._words
        words = ctypes.sizeof(self._space._object_hit) // 4
        room, to = _like(rays, count * words)
        self._call('raycast_many', ctypes.cast(pointer, ctypes.POINTER(self._space._ray)), count,
                   layers, ctypes.cast(to, ctypes.POINTER(self._space._object_hit)))
        del keep
        return room.reshape(count, words) if hasattr(room, 'reshape') else room

    def cast(self, shape, direction, max_distance, layers=ALL_LAYERS):
        """The first object that a moving sphere, AABB, OBB, capsule or segment touches, as a `Hit`, or
        None."""
        hit = self._space._object_hit()
        return Hit(hit) if self._call('cast', shape, self._space._direction(*direction), max_distance,
                                      layers, hit) else None

    def cast_any(self, shape, direction, max_distance, layers=ALL_LAYERS):
        return self._call('cast_any', shape, self._space._direction(*direction), max_distance, layers)

    def cast_all(self, shape, direction, max_distance, layers=ALL_LAYERS):
        """All objects that the moving shape touches, as `Hit`s, sorted by distance, then id."""
        return [Hit(hit) for hit in self._list('cast_all', self._space._object_hit, shape,
                                               self._space._direction(*direction), max_distance, layers)]

    def mover(self, start, end, radius, **settings):
        """A capsule character. Keywords are the fields of its settings."""
        return Mover(self, self._space.capsule(start, end, radius), settings)

    def box_mover(self, least, greatest, **settings):
        """An AABB character."""
        return Mover(self, self._space.aabb(least, greatest), settings)

    def nearest(self, question, layers=ALL_LAYERS):
        """(distance, id) of the object nearest to a point, or of the nearest that a shape or frustum
        overlaps; or None."""
        found = c.detent_found()
        if not self._call(self._ask('nearest', question), question, layers, found):
            return None
        return found.distance, _id(found.id)

    def any(self, question, layers=ALL_LAYERS):
        return self._call(self._ask('any', question), question, layers)

    def all(self, question, layers=ALL_LAYERS):
        """(distance, id) of all objects that the shape overlaps, sorted by distance, then id."""
        return [(found.distance, _id(found.id))
                for found in self._list(self._ask('all', question), c.detent_found, question, layers)]

    def visible(self, frustum, layers=ALL_LAYERS):
        """`all` for a frustum, sorted by distance from the center of its near corners, then id. 3D
        only."""
        return self.all(frustum, layers)

    @staticmethod
    def _ask(name, question):
        return f'frustum_{name}' if isinstance(question, c.detent_frustum3) else name

    def overlaps(self):
        """All pairs of overlapping objects."""
        return [(_id(pair.first), _id(pair.second))
                for pair in self._list('overlaps', c.detent_pair)]


class Hit:
    """The first point of an object that a ray touches: distance, id, point, normal; triangle or
    None."""
    __slots__ = ('distance', 'id', 'point', 'normal', 'triangle')

    def __init__(self, hit):
        self.distance = hit.distance
        self.id = _id(hit.id)
        self.point = _Space._tuple(hit.point)
        self.normal = _Space._tuple(hit.normal)
        self.triangle = hit.triangle if hit.has_triangle else None


class Mover:
    """A character: a capsule or AABB that walks, slides along walls, climbs steps and is carried by
    frames. `state` is its whole state; bytes(state) saves it."""

    def __init__(self, scene, shape, settings):
        self._scene, self._space = scene, scene._space
        n = self._space.dimension
        self.state = getattr(c, f'detent_mover{n}')()
        self.state.shape = shape
        self.settings = getattr(c, f'detent_mover{n}_settings')()
        self.last_move = getattr(c, f'detent_move{n}')()
        _check(self._space._call('mover{N}_default_settings')(self.settings))
        _set(self.settings, settings, self._space)

    is_grounded = property(lambda self: bool(self.state.is_grounded))

    @property
    def position(self):
        """The first end of the capsule, or the least corner of the box."""
        shape = self.state.shape
        is_box = shape.kind == c.DETENT_AABB
        return _Space._tuple(shape.as_.aabb.min if is_box else shape.as_.capsule.a)


    def move(self, by, layers=ALL_LAYERS, ignored=Id(0, 0)):
        """Moves by a vector, gravity included, as far as objects allow. Returns the
        displacement."""
        _check(self._space._call('mover{N}_move')(
            self._scene._context._open, self._scene.handle, self.state, self._space._vec(*by),
            self.settings, layers, ignored._in_c(), self.last_move))
        return _Space._tuple(self.last_move.moved)

    def clip(self, velocity):
        """The part of a velocity that does not lead into what the last move touched."""
        clipped = self._space._vec()
        _check(self._space._call('mover{N}_clip_velocity')(self._space._vec(*velocity), self.last_move,
                                                          clipped))
        return _Space._tuple(clipped)


class World(_Held):
    """Bodies that fall, collide and come to rest. Keywords are the fields of its settings."""

    def __init__(self, context, space, **settings):
        given = getattr(c, f'detent_world{space.dimension}_settings')()
        _check(space._call('world{N}_default_settings')(given))
        _set(given, settings, space)
        super().__init__(context, space, 'world', given)

    def add(self, shape, which=None, **options):
        """Adds a sphere, AABB, OBB, capsule, or something `placed`: a solid hull, a compound or, in
        3D, a mesh or height field. Keywords are the fields of a body's options. `which` is an id
        chosen by the caller, such as that of a removed body; None if its index is taken."""
        given = getattr(c, f'detent_body{self._space.dimension}_options')()
        _check(self._space._call('body{N}_default_options')(given))
        _set(given, options, self._space)
        return self._add(which, shape, given)

    def step(self):
        """Simulates one tick."""
        self._call('step')

    def body(self, which):
        """The state of a body, or None."""
        body = self._space._body()
        return body if self._call('body', which._in_c(), body) else None

    def bodies(self, which):
        """The states of many bodies in one call, as an array that numpy can view; zeros for ids that
        do not exist."""
        ids = [one._in_c() for one in which]
        bodies = (self._space._body * len(ids))()
        self._call('bodies', (c.detent_id * len(ids))(*ids), len(ids), bodies)
        return bodies

    def body_ids(self):
        """The ids of all bodies."""
        return [_id(which) for which in self._list('body_ids', c.detent_id)]

    def info(self, which):
        """The properties of a body: user, layers, collides_with, motion, is_sensor, is_asleep,
        part_count. Or None."""
        info = c.detent_body_info()
        return info if self._call('info', which._in_c(), byref(info)) else None

    def part_of(self, which):
        """(body, part) of an object of a scene that follows this world, or None."""
        body, part = c.detent_id(), ctypes.c_uint32()
        found = self._call('part_of', which._in_c(), byref(body), byref(part))
        return (_id(body), part.value) if found else None

    def digest_of(self, which):
        """A 64-bit digest of one body, or None."""
        digest = ctypes.c_uint64()
        return digest.value if self._call('digest_of', which._in_c(), byref(digest)) else None

    def position(self, which):
        body = self.body(which)
        return _Space._tuple(body.position) if body else None

    def set_position(self, which, position):
        """Puts a body elsewhere at once; it keeps its joints. False if no body has this id."""
        return self._call('set_position', which._in_c(), self._space._vec(*position))

    def set_rotation(self, which, axes):
        """Turns a body about its center at once; it keeps its joints."""
        return self._call('set_rotation', which._in_c(), self._space._rotated(axes))

    def set_filter(self, which, layers, collides_with):
        """Sets the layers of a body and those it collides with. False if no body has this id."""
        return self._call('set_filter', which._in_c(), layers, collides_with)

    def set_friction(self, which, friction):
        return self._call('set_friction', which._in_c(), friction)

    def set_restitution(self, which, restitution):
        return self._call('set_restitution', which._in_c(), restitution)

    def set_sensor(self, which, is_sensor):
        """Makes a body a sensor or solid."""
        return self._call('set_sensor', which._in_c(), int(is_sensor))

    def set_gravity_scale(self, which, scale):
        return self._call('set_gravity_scale', which._in_c(), scale)

    def set_damping(self, which, linear, angular):
        return self._call('set_damping', which._in_c(), linear, angular)

    def set_locked(self, which, locked):
        """Sets the locked axes: LOCK_X | ..."""
        return self._call('set_locked', which._in_c(), locked)

    def set_fast(self, which, is_fast):
        return self._call('set_fast', which._in_c(), int(is_fast))

    def set_user(self, which, user):
        """Sets the user word of a body; wakes nothing."""
        return self._call('set_user', which._in_c(), user)

    def set_gravity(self, gravity):
        """Sets the gravity of the world and wakes all bodies."""
        self._call('set_gravity', self._space._vec(*gravity))

    def set_velocity(self, which, velocity):
        return self._call('set_velocity', which._in_c(), self._space._vec(*velocity))

    def _axial(self, numbers):
        return int32_array(numbers, 1 if self._space.dimension == 2 else 3)

    def set_angular_velocity(self, which, velocity):
        return self._call('set_angular_velocity', which._in_c(), self._axial(velocity))

    def apply_impulse(self, which, impulse, at=None):
        """Applies an impulse at a world point, by default at the center of mass."""
        return self._call('apply_impulse', which._in_c(), self._space._vec(*impulse),
                          self._space._vec(*at) if at else None)

    def apply_force(self, which, force, at=None):
        """Applies a force during the next step."""
        return self._call('apply_force', which._in_c(), self._space._vec(*force),
                          self._space._vec(*at) if at else None)

    def apply_torque(self, which, torque):
        """Applies a torque during the next step."""
        return self._call('apply_torque', which._in_c(), self._axial(torque))

    def _joint(self, kind, a, b, fields):
        joint = self._space._joint()
        _check(self._space._call('joint{N}_defaults')(kind, joint))
        joint.a, joint.b = a._in_c(), b._in_c()
        for name in ('frame_a', 'frame_b'):
            if name in fields:
                setattr(joint, name, self._space._rotated(fields.pop(name)))
        _set(joint, fields, self._space)
        return joint

    def add_joint(self, kind, a, b, **fields):
        """Joins two bodies, for example by a HINGE. Keywords are the fields of a joint. Returns its
        id, or None if a body does not exist."""
        made = c.detent_id()
        return _id(made) if self._call('add_joint', self._joint(kind, a, b, fields),
                                       byref(made)) else None

    def change_joint(self, which, joint):
        """Replaces a joint by another of the same kind, such as `joint(which)` with another
        motor."""
        return self._call('change_joint', which._in_c(), joint)

    def remove_joint(self, which):
        return self._call('remove_joint', which._in_c())

    def joint(self, which):
        """The fields of a joint, or None."""
        joint = self._space._joint()
        return joint if self._call('joint', which._in_c(), joint) else None

    def joint_force(self, which):
        """The force of a joint on its body b in the last step. None without the joint."""
        force = self._space._vec()
        return _Space._tuple(force) if self._call('joint_force', which._in_c(), force) else None

    def joint_torque(self, which):
        """The torque of a joint on its body b in the last step, three numbers in 3D, one in 2D. None
        without the joint."""
        torque = self._axial(())
        return tuple(torque) if self._call('joint_torque', which._in_c(), torque) else None

    def joint_count(self):
        count = ctypes.c_uint32()
        self._call('joint_count', byref(count))
        return count.value

    def joint_ids(self):
        """The ids of all joints."""
        return [_id(which) for which in self._list('joint_ids', c.detent_id)]

    def broken(self):
        """The joints that broke in the last step."""
        return [_id(which) for which in self._list('broken', c.detent_id)]

    def local_point(self, which, point):
        """Converts a world point to a body's frame, for the anchor of a joint. None without the
        body."""
        local = self._space._vec()
        done = self._call('local_point', which._in_c(), self._space._vec(*point), local)
        return _Space._tuple(local) if done else None

    def local_frame(self, which, axes):
        """Converts world axes to a body's frame, for the frame of a joint. None without the
        body."""
        local = self._space._rotation()
        done = self._call('local_frame', which._in_c(), self._space._rotated(axes), local)
        return tuple(_Space._tuple(axis) for axis in local.axis) if done else None

    def events(self):
        """(a, b, begins) for each pair that began or ceased to touch in the last step."""
        return [(_id(touch.a), _id(touch.b), bool(touch.begins))
                for touch in self._list('events', c.detent_touch)]

    def touching(self, which=Id(0, 0)):
        """(a, part_a, b, part_b) for each pair that touches, of one body or of all."""
        return [(_id(touch.a), touch.part_a, _id(touch.b), touch.part_b)
                for touch in self._list('touching', c.detent_touch, which._in_c())]

    def contacts(self, which=Id(0, 0)):
        """A `WorldContact` for each contact that touches, of one body or of all; none of sensors."""
        kind, vec = getattr(c, f'detent_world{self._space.dimension}_contact'), _Space._tuple
        return [WorldContact(_id(one.a), _id(one.b), one.part_a, one.part_b, one.triangle,
                             vec(one.normal), one.impulse, vec(one.friction),
                             [WorldContactPoint(vec(point.point), point.separation, point.impulse,
                                                point.feature) for point in one.points[:one.count]])
                for one in self._list('contacts', kind, which._in_c())]

    def touches(self):
        """`touches` with the parts of compounds: (a, part_a, b, part_b, begins)."""
        return [(_id(touch.a), touch.part_a, _id(touch.b), touch.part_b, bool(touch.begins))
                for touch in self._list('events', c.detent_touch)]

    def frame(self, which):
        """The frame in which a compound's parts or a hull's points were given: translation and
        axes. None without the body."""
        frame = self._space._transform()
        if not self._call('frame', which._in_c(), frame):
            return None
        return self._space._pose(frame)


Frame = namedtuple('Frame', 'number inputs')
Frame.__doc__ = 'A frame to simulate: the bytes of each player, None for one that takes no part.'
Event = namedtuple('Event', 'kind peer frame field object')
Event.__doc__ = 'What happened in a session: `kind` is one of `events`.'
# The kinds of events, and the reasons why a session has no frame to simulate.
events = {name[7:].lower(): getattr(c, name) for name in (
    'DETENT_CONNECTED', 'DETENT_SILENT', 'DETENT_HEARD_AGAIN', 'DETENT_PEER_PAUSED', 'DETENT_PEER_RESUMED',
    'DETENT_DROPPED', 'DETENT_EXPELLED', 'DETENT_LEFT', 'DETENT_TOO_SLOW', 'DETENT_CONTRADICTION',
    'DETENT_DESYNC', 'DETENT_DESYNC_FIELD', 'DETENT_ARRIVED', 'DETENT_LOADED', 'DETENT_NO_SUCH_WORLD',
    'DETENT_JOINED')}
states = {name[7:].lower(): getattr(c, name) for name in (
    'DETENT_PLAYED', 'DETENT_CONNECTING', 'DETENT_CATCHING_UP', 'DETENT_STARVED', 'DETENT_AHEAD',
    'DETENT_PAUSED', 'DETENT_OVER', 'DETENT_JOINING')}


class PlayedWorld(World):
    """The world of a session or replay. It can be changed only during a frame."""

    def __init__(self, owner, word_count):
        handle = ctypes.c_uint32()
        _check(owner._function('world')(owner._context._open, owner.handle, byref(handle)))
        self._space, self._kind, self._owner = owner._space, 'world', owner
        self._word_count = word_count
        _Owned.__init__(self, owner._context, handle.value, self._function('destroy'))

    @property
    def words(self):
        """Other game state that a rollback restores: unsigned 32-bit numbers, initially 0."""
        words = (ctypes.c_uint32 * self._word_count)()
        self._call('words', words)
        return list(words)

    @words.setter
    def words(self, values):
        if len(values) != self._word_count:
            raise ValueError(f'there are {self._word_count} words')
        self._call('set_words', (ctypes.c_uint32 * self._word_count)(*values))


class _Played(_Held):
    """The common base of sessions and replays."""

    def _setup(self, input_size, words):
        self._input_size = input_size
        self._inputs = (ctypes.c_uint8 * (c.DETENT_PLAYERS * input_size))()
        self.world = PlayedWorld(self, words)

    def _frames(self, *given):
        frame = c.detent_frame()
        while self._call('begin_frame', *given, frame, self._inputs):
            size = self._input_size
            yield Frame(frame.number, [bytes(self._inputs[i * size:(i + 1) * size])
                                       if frame.present >> i & 1 else None for i in range(frame.players)])
            self._call('end_frame')
        self.state = frame.state


class Session(_Played):
    """A network match from a world that all peers start with. Keywords are the fields of its settings:
    `match`, `self`, `players`, `input_size`, `words` and others.

        for frame in session.frames(pad):     # sixty times a second
            simulate(session.world, frame.inputs)
        for peer, packet in session.packets(now):
            send(peer, packet)

    A frame that raises an exception is played again. `state` says why there are no more frames."""

    def __init__(self, context, space, world, settings):
        given = c.detent_session_settings()
        _check(_library.detent_session_default_settings(given))
        _set(given, settings, space)
        super().__init__(context, space, 'session', given, world.handle)
        self._setup(given.input_size, given.words)
        self.state = c.DETENT_CONNECTING

    def frames(self, pad):
        """The frames to simulate now; the new one uses the input `pad`, of `input_size` bytes."""
        if len(pad) != self._input_size:
            raise ValueError(f'an input has {self._input_size} bytes')
        return self._frames(bytes(pad))

    def receive(self, peer, packet, now):
        """Takes a packet that arrived at `now`, in microseconds. False if it was not used."""
        return self._call('receive', peer, bytes(packet), len(packet), now)

    def packets(self, now):
        """The packets due to be sent, as (peer, bytes)."""
        peer, size = ctypes.c_uint32(), ctypes.c_uint32()
        room = ctypes.create_string_buffer(c.DETENT_PACKET)
        while self._call('packet', now, byref(peer), room, c.DETENT_PACKET, byref(size)):
            yield peer.value, room.raw[:size.value]

    def events(self):
        """The new events, oldest first."""
        event, room = c.detent_session_event(), ctypes.create_string_buffer(c.DETENT_NAME)
        while self._call('event', event, room, c.DETENT_NAME):
            yield Event(event.kind, event.peer, event.frame, room.raw[:event.name_size].decode(),
                        _id(event.object) if event.has_object else None)

    @property
    def status(self):
        """The progress: `frame`, `final_frame`, `digest` and others."""
        status = c.detent_session_status()
        self._call('status', status)
        return status

    def matched(self, peer):
        """The number of frames known to be equal at the peer and here."""
        frame = ctypes.c_uint32()
        self._call('matched', peer, byref(frame))
        return frame.value

    def is_awaited(self, player):
        return self._call('is_awaited', player)

    def drop(self, peer):
        self._call('drop', peer)

    def pause(self, is_paused=True):
        self._call('pause', int(is_paused))

    def replay(self):
        """The replay of all final frames, or None if none is recorded (`replay_every`)."""
        size = ctypes.c_uint32()
        self._call('replay', None, 0, byref(size))
        room = ctypes.create_string_buffer(size.value)
        return room.raw if self._call('replay', room, size.value, byref(size)) else None


class Replay(_Played):
    """A replay, resimulated by `frames`. `check` says whether its digests are reproduced."""

    def __init__(self, context, space, data, world, input_size, words):
        super().__init__(context, space, 'replay', bytes(data), len(data), world.handle, input_size, words)
        self._setup(input_size, words)

    def frames(self):
        return self._frames()

    def check(self):
        check = c.detent_replay_check()
        self._call('check', check)
        return check


def _set(fields, values, space):
    for name, value in values.items():
        kind = dict(fields._fields_)[name]
        if isinstance(value, (tuple, list)):
            value = kind(*value)
        setattr(fields, name, value)


class Context:
    """Makes scenes, worlds and assets. `close`, or the end of a `with`, destroys them."""

    def __init__(self):
        self._open = c.detent_context()  # must not move while open
        _check(_library.detent_open(self._open, None))
        self._finish = weakref.finalize(self, _library.detent_close, self._open)

    def close(self):
        self._finish()

    def count(self):
        """The number of scenes, worlds and assets in it."""
        count = ctypes.c_uint32()
        _check(_library.detent_count(self._open, byref(count)))
        return count.value

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()

    def scene2(self):
        return Scene(self, d2)

    def scene3(self):
        return Scene(self, d3)

    def world2(self, **settings):
        return World(self, d2, **settings)

    def world3(self, **settings):
        return World(self, d3, **settings)

    def session2(self, world, /, **settings):
        return Session(self, d2, world, settings)

    def session3(self, world, /, **settings):
        return Session(self, d3, world, settings)

    def replay2(self, data, world, input_size=1, words=0):
        return Replay(self, d2, data, world, input_size, words)

    def replay3(self, data, world, input_size=1, words=0):
        return Replay(self, d3, data, world, input_size, words)

    def _asset(self, create, *arguments):
        handle = ctypes.c_uint32()
        _check(create(self._open, *arguments, byref(handle)))
        return _Owned(self, handle.value, _library.detent_asset_destroy)

    def mesh(self, name, vertices, faces):
        """A mesh: tuples of vertices, and of triangles with three vertex indices each. `name` is
        its id in snapshots."""
        indices = [index for face in faces for index in face]
        return self._asset(_library.detent_mesh_create, name,
                           (c.detent_vec3 * len(vertices))(*[c.detent_vec3(*v) for v in vertices]),
                           len(vertices), (ctypes.c_uint32 * len(indices))(*indices),
                           len(indices) // 3)

    def _points(self, create, vec, name, points):
        return self._asset(create, name, (vec * len(points))(*[vec(*p) for p in points]), len(points))

    def hull3(self, name, points):
        return self._points(_library.detent_hull3_create, c.detent_vec3, name, points)

    def hull2(self, name, points):
        return self._points(_library.detent_hull2_create, c.detent_vec2, name, points)

    def solid3(self, name, points):
        """A convex hull for bodies."""
        return self._points(_library.detent_solid3_create, c.detent_vec3, name, points)

    def solid2(self, name, points):
        return self._points(_library.detent_solid2_create, c.detent_vec2, name, points)

    def _compound(self, space, name, parts):
        given = (space._part * len(parts))()
        for part, one in zip(given, parts):
            _check(space._call('part{N}_defaults')(part))
            one, options = one if isinstance(one, tuple) else (one, {})
            part.shape = one
            _set(part, dict(options), space)
        return self._asset(space._call('compound{N}_create'), name, given, len(parts))

    def compound3(self, name, parts):
        """Shapes that move as one body. Each is a sphere, AABB, OBB, capsule or placed solid hull,
        or a tuple of one and a dict with its density, friction, restitution, rolling_resistance and
        is_sensor."""
        return self._compound(d3, name, parts)

    def compound2(self, name, parts):
        return self._compound(d2, name, parts)

    def height_field(self, name, corner, cell, columns, rows, heights):
        if len(heights) != columns * rows:
            raise ValueError('there must be columns * rows heights')
        return self._asset(_library.detent_height_field_create, name, c.detent_vec2(*corner), cell,
                           columns, rows, int32_array(heights, len(heights)))


def placed(asset, translation, axes=None, scale=ONE):
    """An asset as a shape. In a scene: a transformed mesh or hull, or a translated height field. In
    a world also a solid hull or a compound."""
    kind = {5: c.DETENT_MESH, 8: c.DETENT_HEIGHT_FIELD, 11: c.DETENT_COMPOUND,
            12: c.DETENT_COMPOUND}.get(asset.handle & 31, c.DETENT_HULL)
    space = d2 if asset.handle & 31 in (6, 9, 11) else d3
    shape = space._shape()
    shape.kind, shape.asset = kind, asset.handle
    if kind == c.DETENT_HEIGHT_FIELD:
        shape.as_.point = space._vec(*translation)
    else:
        shape.as_.placed = space._transform(space._vec(*translation), space._rotated(axes), scale)
    return shape
