# SPDX-License-Identifier: MIT
"""The ctypes layer of the Python binding."""

SCALARS = {'int32_t': 'c_int32', 'uint32_t': 'c_uint32', 'uint64_t': 'c_uint64',
           'pointer': 'c_void_p', 'void': 'c_void_p', 'size_t': 'c_size_t'}


def files(description, note):
    lines = ['# SPDX-License-Identifier: MIT', f'# {note}',
             '"""The C interface as it is: structures, constants and the signatures of functions."""',
             'from ctypes import (POINTER, Union, c_char_p, c_int32, c_size_t, c_uint32, c_uint64,',
             '                    c_void_p, sizeof)', '',
             'from ._checked import Structure, argument', '']

    def type_of(name):
        name = description.aliases.get(name, name)
        return SCALARS.get(name, name)

    def field(one):
        kind = type_of(one.type)
        return f"('{one.name}', {kind}{f' * {one.count}' if one.count else ''})"

    for constant in description.constants:
        lines.append(f'{constant.name} = {constant.value}')
    for struct in description.structs.values():
        lines += ['', '']
        if struct.union:
            lines += [f'class {struct.name}_as(Union):', '    _fields_ = [']
            lines += [f'        {field(one)},' for one in struct.union]
            lines += ['    ]', '', '']
        lines += [f'class {struct.name}(Structure):', f'    """{struct.doc}"""', '    _fields_ = [']
        lines += [f'        {field(one)},' for one in struct.fields]
        if struct.union:
            lines.append(f"        ('as_', {struct.name}_as),")
        lines += ['    ]']
    lines += ['', '']
    for struct in description.structs.values():
        if not struct.has_pointers:
            lines.append(f'assert sizeof({struct.name}) == {struct.size}')
    checked = {kind: kind[2:] for kind in ('c_int32', 'c_uint32', 'c_uint64', 'c_size_t')}
    lines += ['', ''] + [f'{short} = argument({kind})' for kind, short in checked.items()]
    lines += ['', 'FUNCTIONS = {']
    for function in description.functions:
        result = 'c_char_p' if function.result == 'const char*' else type_of(function.result)
        arguments = []
        for one in function.arguments:
            kind = type_of(one.type)
            arguments.append('c_void_p' if one.pointer and kind == 'c_void_p'
                             else f'POINTER({kind})' if one.pointer else checked.get(kind, kind))
        lines.append(f"    '{function.name}': ({result}, [")
        lines += [f'        {kind},' for kind in arguments]
        lines[-1:] = [lines[-1]]
        lines.append('    ]),')
    lines += ['}', '']
    return {'bindings/python/detent/_interface.py': '\n'.join(lines)}
