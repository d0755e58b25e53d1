# SPDX-License-Identifier: MIT
"""The exported functions, which call those of src/c/: one source per group and dimension."""
import re

GROUPS = (('scene', 'scenes', 'Scenes'), ('world', 'worlds', 'Worlds'), ('body', 'worlds', 'Worlds'),
          ('joint', 'worlds', 'Worlds'), ('hull', 'scenes', 'Hulls'), ('solid', 'worlds', 'Solids'),
          ('part', 'worlds', 'Compounds'), ('compound', 'worlds', 'Compounds'),
          ('mover', 'movers', 'Movers'), ('session', 'sessions', 'Sessions'),
          ('replay', 'sessions', 'Replays'), ('shapes', 'unions', 'Unions'), ('ray', 'unions', 'Rays'),
          ('camera', 'frusta', 'Cameras'), ('frustum', 'frusta', 'Frusta'))
# Functions outside these groups that share a source.
OTHERS = {'contact': ('pairs', 'Pairs'), 'closest_points': ('closest', 'Closest'),
          'time_of_impact': ('pairs', 'Pairs'), 'cast': ('casts', 'Casts')}


def files(description, note):
    sources = {}
    for function in description.functions:
        parts = re.fullmatch(r'detent_([a-z_]*?)([23])(?:_(\w+))?', function.name)
        if not parts:
            continue  # written by hand in context.cpp and assets.cpp
        if parts[1] == 'scene' and (parts[3] or '').startswith('cast'):
            parts = {1: 'mover', 2: parts[2], 3: parts[3]}  # compiled with the casts of characters
        if parts[3] == 'follow':
            parts = {1: 'world', 2: parts[2], 3: parts[3]}  # compiled with worlds
        if (parts[3] or '').startswith('frustum_'):
            parts = {1: 'frustum', 2: parts[2], 3: parts[3].replace('frustum', parts[1])}
        for prefix, header, room in GROUPS:
            if parts[1] == 'shapes' and parts[3] in OTHERS:  # compiled with those of two shapes
                (header, room), called = OTHERS[parts[3]], f'{parts[3]}_of_shapes'
                break
            if parts[3] == 'diff':  # sessions use the same code
                header, room, called = 'sessions', 'Differences', f'of_{parts[1]}s'
                break
            if parts[1] == prefix:
                called = parts[3]
                break
        else:
            header, room = OTHERS.get(parts[1], ('queries', 'Queries'))
            called = '_'.join(filter(None, (parts[1], parts[3])))
        name = f'src/c/exports/{header}_{parts[2]}d.cpp'
        lines = sources.setdefault(name, [
            '// SPDX-License-Identifier: MIT', f'// {note}', f'#include "c/{header}.hpp"', ''])
        declared = ', '.join(f'{"const " if one.const else ""}{one.type}{"*" if one.pointer else ""} '
                             f'{one.name}' for one in function.arguments)
        given = ', '.join(one.name for one in function.arguments)
        lines += ['// clang-format off', f'{function.result} {function.name}({declared}) {{',
                  f'  return detent::c::{room}<{parts[2]}>::{called}({given});', '}',
                  '// clang-format on']
    for lines in sources.values():
        while '// clang-format on' in lines[:-1]:  # one pair around all functions
            at = lines.index('// clang-format on')
            del lines[at:at + 2]
    return {name: '\n'.join(lines) + '\n' for name, lines in sources.items()}
