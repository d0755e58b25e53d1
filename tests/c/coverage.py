# SPDX-License-Identifier: MIT
"""Calls the C interface for every query and shape that C++ has: the cells of README's query matrix (another
test compares that table with the code), times of impact, and the queries of scenes. The table "not in C" of
docs/bindings.md must list exactly the queries that C lacks. Also checks that a test calls every function of the
C interface."""
import ctypes
import os
import re
import sys
from ctypes import byref

import detent
from description import Description
from detent import ONE, UNIT, _interface as c, d3

library = detent._library
functions = {one.name: one for one in Description('bindings/detent.h.in').functions}
context = detent.Context()
wrong = []


def read(path):
    with open(path, encoding='utf-8') as file:
        return file.read()


def hull():
    points = (c.detent_vec3 * 4)(*[c.detent_vec3(*p) for p in ((0, 0, 0), (ONE, 0, 0), (0, ONE, 0), (0, 0, ONE))])
    handle = ctypes.c_uint32()
    assert library.detent_hull3_create(context._open, 1, points, 4, byref(handle)) == c.DETENT_OK
    shape = c.detent_shape3(kind=c.DETENT_HULL, asset=handle.value)
    shape.as_.placed.scale = ONE
    shape.as_.placed.rotation = d3._rotated(None)
    return shape


ZERO, POINT = (0, 0, 0), (ONE, 2 * ONE, 3 * ONE)
RAY = d3.ray(POINT, (UNIT, 0, 0), 9 * ONE)
SHAPES = {
    'Sphere': d3.sphere(ZERO, ONE), 'Aabb': d3.aabb(ZERO, POINT), 'Obb': d3.obb(ZERO, POINT),
    'Plane': d3.plane((0, UNIT, 0), 0), 'Triangle': d3.triangle(ZERO, POINT, (ONE, 0, 0)),
    'Capsule': d3.capsule(ZERO, POINT, ONE), 'Segment': d3.segment(ZERO, POINT), 'ConvexHull': hull(),
}
FRUSTUM = d3.frustum(d3.camera(POINT, ZERO, ONE, 9 * ONE, fov=1 << 29, aspect=ONE))
SWEEP = d3.sweep(ZERO, POINT)


def call(name, *given):
    """Returns whether the function exists and answers. It gets the shapes in turn, one per list,
    and all its other arguments."""
    if name not in functions:
        return False
    given, arguments = list(given), []
    for one in functions[name].arguments:
        kind = getattr(c, one.type, None)
        if one.type == 'detent_context':
            arguments.append(context._open)
        elif one.type in ('detent_shape3', 'detent_frustum3') and one.const:
            arguments.append(given.pop(0))
        elif one.type == 'detent_ray3' and one.const:
            arguments.append(RAY)
        elif one.type == 'detent_sweep3':
            arguments.append(SWEEP if one.name == 'sweep_a' else None)
        elif one.type == 'detent_direction3':
            arguments.append(c.detent_direction3(UNIT, 0, 0))
        elif one.type == 'detent_vec3' and one.const:
            arguments.append(c.detent_vec3(*POINT))
        elif one.pointer:
            arguments.append(kind() if kind else byref(ctypes.c_int32()))
        else:
            arguments.append(1)  # a list length or a distance
    assert not given, name
    return getattr(library, name)(*arguments) in (c.DETENT_OK, c.DETENT_NO)


def is_answered(query, *shapes):
    """A query of shapes by name; of one shape with a point or ray."""
    if query == 'intersects':
        query, shapes = 'overlaps', ('Segment', *shapes)
    elif query == 'distance' and len(shapes) == 1:
        query = 'distance_to_point'
    if 'Ray' in shapes:
        return call(f'detent_ray3_{query}')
    frusta = [shape for shape in shapes if shape == 'Frustum']
    others = [SHAPES[shape] for shape in shapes if shape != 'Frustum']
    if len(frusta) == 2:
        return call('detent_frustum3_overlaps_frustum', FRUSTUM, FRUSTUM)
    if frusta:
        return call(f'detent_frustum3_{query}', FRUSTUM, *others)
    own = 'detent_shapes3' if 'ConvexHull' in shapes else 'detent'
    return call(f'{own}_{query}' + ('3' if own == 'detent' else ''), *others)


def cells():
    """The queries and shapes in README's matrix."""
    matrix = re.search(r'<!-- query matrix.*?<!-- end', read('README.md'), re.S)[0]
    for table in matrix.split('\n\n'):
        head, _, *rows = [[cell.strip(' `') for cell in line.strip('|').split('|')]
                          for line in table.splitlines() if line.startswith('|')]
        for name, *bits in rows:
            for column, number in zip(head[1:], bits):
                if not number.isdigit():
                    continue
                if head[0] == 'overlaps':
                    yield 'overlaps', (name, column)
                elif head[0] == 'two shapes':
                    yield column, (name, 'Obb')
                    yield column, (name, 'Capsule')
                    if column != 'cast' or 'Plane' not in name:
                        yield column, (name, 'ConvexHull')
                else:
                    yield column, (name,)
    for name in SHAPES:
        if name not in ('Segment', 'Plane'):
            yield 'time_of_impact', (name, 'ConvexHull')
            yield 'time_of_impact', (name, 'Plane')


page = re.search(r'\| not in C \|.*?\n\n', read('docs/bindings.md'), re.S)[0]
excepted = set(re.findall(r'`([^`]+)`', ' '.join(line.split('|')[1] for line in page.split('\n') if line)))
checked = set()
for query, shapes in cells():
    checked.add(query)
    name = f'{query} of {" and ".join(shapes)}'
    if query in excepted:
        wrong.append(f'{query} is in a table of README, but docs/bindings.md lists it as missing from C')
    elif not is_answered(query, *shapes):
        wrong.append(f'C does not answer: {name}')

# Query headers outside the matrix: in C under these names, or excepted.
for header in sorted(os.listdir('include/detent/query')):
    name = header.removesuffix('.hpp')
    if header == name or name in checked or name in ('query', 'wrong_call'):
        continue
    if (f'detent_{name}3' in functions) == (name in excepted):
        wrong.append(f'{header}: docs/bindings.md must list `{name}` as missing from C exactly if it is')

# The regions of scene queries: those that an overload of `reference` names, and the round shapes: they have a `core`.
scene = context.scene3()
questions = read('include/detent/scene/question.hpp')
regions = set(re.findall(r'reference\(const (\w+)<S(?:, N)?>&', questions))
for header in os.listdir('include/detent/shape'):
    regions |= set(re.findall(r' core\(const (\w+)<S, N>&', read(f'include/detent/shape/{header}')))
for region in sorted(regions):
    for name in ('nearest', 'any', 'all'):
        if region == 'Frustum':
            function, shape = f'detent_scene3_frustum_{name}', FRUSTUM
        else:
            function = f'detent_scene3_{name}'
            shape = d3.point(POINT) if region == 'Vec' else SHAPES[region]
        more = {'nearest': (None,), 'any': (), 'all': (None, 0, byref(ctypes.c_uint32()))}[name]
        status = getattr(library, function)(context._open, scene.handle, shape, 1, *more)
        if status not in (c.DETENT_OK, c.DETENT_NO):
            wrong.append(f'C does not answer: {name} of scenes with {region}')
if not {'Vec', 'Sphere', 'Frustum'} <= regions or not {'contact', 'cast', 'raycast'} <= checked:
    wrong.append('the tables or regions were not read')

# Every function is called by a test in C or C++: by its name, by macros that paste names, where N is a dimension, or
# by its name in the table of calls.hpp.
sources = {name: read('tests/c/' + name) for name in os.listdir('tests/c')
           if name.endswith(('.c', '.cpp', '.hpp')) and name != 'overhead.cpp'}
table = re.findall(r'DETENT_TEST_CALL\((\w+), N, (\w*)\)', sources.pop('calls.hpp'))
text = '\n'.join([read('src/c/single.hpp'), *sources.values()])
called = set()
for token in re.findall(r'\bdetent_\w+(?:##N(?:##\w+)?)?', text):
    called |= {token.replace('##N##', n).replace('##N', n) for n in '23'}
used = set(re.findall(r'\w::(\w+)', text))
for prefix, suffix in table:
    if prefix + suffix in used:
        called |= {f'detent_{prefix}{n}{suffix}' for n in '23'}
wrong += [f'no test in tests/c calls {name}' for name in functions if name not in called]

print('\n'.join(wrong) or f'C has {len(checked)} queries of README, and {len(regions)} regions of scenes')
sys.exit(bool(wrong))
