# SPDX-License-Identifier: MIT
"""Calls every function of the C interface wrongly, from its description: with contexts that are null, never
opened, copied or closed, with handles that are 0, stale, of another type or any number, and with null for each
pointer. Each call returns, with an error wherever a context or a handle is wrong."""
import ctypes
import sys
from ctypes import byref

import detent
from description import Description
from detent import ONE, _interface as c, d2, d3

library = detent._library
described = Description('bindings/detent.h.in')
functions = [one for one in described.functions if one.result == 'detent_status']
statuses = {one.value for one in described.constants
            if -100 < one.value <= 1 and one.name in ('DETENT_OK', 'DETENT_NO') or one.value < 0}
wrong = []
ROOM = 1 << 16  # more than any structure or list takes


def opened():
    context = c.detent_context()
    assert library.detent_open(byref(context), None) == c.DETENT_OK
    return context


def made(context):
    """A handle of each type, keyed by the name of its `create` function without `_create`."""
    handles, out = {}, ctypes.c_uint32()

    def make(name, *arguments):
        status = getattr(library, f'detent_{name}_create')(byref(context), *arguments, byref(out))
        assert status == c.DETENT_OK, (name, status)
        handles[name] = out.value

    for n, space in ((2, d2), (3, d3)):
        vec = getattr(c, f'detent_vec{n}')
        corners = (vec * (n + 1))(*[vec(*[ONE * (i == k) for k in range(n)]) for i in range(n + 1)])
        make(f'scene{n}')
        make(f'world{n}', None)
        make(f'hull{n}', 1, corners, n + 1)
        make(f'solid{n}', 2, corners, n + 1)
        part = getattr(c, f'detent_part{n}')()
        assert getattr(library, f'detent_part{n}_defaults')(byref(part)) == c.DETENT_OK
        part.shape = space.sphere((0,) * n, ONE)
        make(f'compound{n}', 3, byref(part), 1)
        settings = c.detent_session_settings()
        assert library.detent_session_default_settings(byref(settings)) == c.DETENT_OK
        make(f'session{n}', byref(settings), handles[f'world{n}'])
    faces = (ctypes.c_uint32 * 3)(0, 1, 2)
    make('mesh', 4, corners, 3, faces, 1)
    heights = (ctypes.c_int32 * 4)()
    make('height_field', 5, byref(c.detent_vec2()), ONE, 2, 2, heights)
    return handles


def call(function, context, handle, null=None):
    """Calls the function with this context (a pointer or None) and `handle` for each handle. The pointer named
    `null` is null, all others point to zeros; counts are 1, other numbers 0. Where the function takes hulls,
    its shapes are hulls: they belong to a context. With other shapes the context may be null."""
    kind_of_shapes = c.DETENT_HULL if function.name in takes_hulls else c.DETENT_SPHERE
    arguments = []
    for one in function.arguments:
        if one.type == 'detent_context' and one.pointer:
            arguments.append(context)
        elif one.pointer:
            room = None if one.name == null else ctypes.create_string_buffer(ROOM)
            if room and one.const and one.type in ('detent_shape2', 'detent_shape3'):
                getattr(c, one.type).from_buffer(room).kind = kind_of_shapes
            arguments.append(ctypes.cast(room, ctypes.c_void_p) if room else None)
            keep.append(room)
        elif one.type == 'detent_handle':
            arguments.append(handle)
        elif one.type == 'detent_id':
            arguments.append(c.detent_id())
        else:
            kind = ctypes.c_uint64 if described.aliases.get(one.type, one.type) == 'uint64_t' else ctypes.c_uint32
            arguments.append(kind(one.name.endswith(('count', 'room', 'most', 'size'))))
    raw = getattr(plain, function.name)
    raw.restype = ctypes.c_int32
    status = raw(*arguments)
    keep.clear()
    if status not in statuses:
        wrong.append(f'{function.name} returns {status}')
    return status


takes_hulls = {one.name for one in functions
               if one.name.startswith(('detent_shapes', 'detent_frustum3_overlaps'))}
keep = []
plain = ctypes.CDLL(library._name)  # without types, so that anything can be passed
calls = 0
stale_context = opened()
stale = made(stale_context)
for name in ('session2', 'session3', 'scene2', 'scene3', 'world2', 'world3'):
    assert getattr(library, f'detent_{name}_destroy')(byref(stale_context), stale[name]) == c.DETENT_OK
closed = opened()
assert library.detent_close(byref(closed)) == c.DETENT_OK
open_one = opened()
copied = c.detent_context.from_buffer_copy(open_one)
good_context = opened()
good = made(good_context)

for function in functions:
    takes = [one.type for one in function.arguments if not one.pointer or one.type == 'detent_context']
    if 'detent_context' in takes and function.name != 'detent_open':
        for pointer in (None, byref(c.detent_context()), byref(closed), byref(copied)):
            calls += 1
            status = call(function, pointer, good['scene3'])
            if status >= 0:
                wrong.append(f'{function.name} takes a wrong context: {status}')
    if 'detent_handle' in takes:
        for handle in (0, 0xffffffff, 0x12345678, *stale.values()):
            calls += 1
            # In a context where all of the right type are stale, or which has assets only.
            if handle in stale.values() and 'asset' in function.name:
                continue
            status = call(function, byref(stale_context), handle)
            if status >= 0:
                wrong.append(f'{function.name} takes a wrong handle {handle:#x}: {status}')
    if function.name in ('detent_open', 'detent_close') or function.name.endswith('_destroy'):
        continue
    for one in function.arguments:
        if one.pointer and one.type != 'detent_context':
            for handle in good.values() if 'detent_handle' in takes else (0,):
                calls += 1
                call(function, byref(good_context), handle, null=one.name)

print('\n'.join(wrong) or f'{calls} wrong calls of {len(functions)} functions return')
sys.exit(bool(wrong))
