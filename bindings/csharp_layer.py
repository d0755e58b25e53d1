# SPDX-License-Identifier: MIT
"""The C# binding: the foreign functions and structures, and bindings/csharp/spaces.cs.in for both
dimensions. Arrays become fields, such as `axis0` and `axis1`, so that every structure is blittable.
In the template Axial{N} is an angular velocity or a torque: a number in 2D and a vector in 3D."""
import os
import re
from description import expand

SCALARS = {'int32_t': 'int', 'uint32_t': 'uint', 'uint64_t': 'ulong', 'size_t': 'UIntPtr',
           'void': 'void'}
KEYWORDS = {'as', 'base', 'checked', 'event', 'fixed', 'in', 'is', 'object', 'out', 'params', 'ref'}


def pascal(name):
    """detent_world3_settings -> World3Settings; the class Context holds a ContextMemory"""
    if name == 'detent_context':
        return 'ContextMemory'
    return ''.join(part.capitalize() for part in name.replace('detent_', '').split('_'))


def files(description, note):
    head = ['// SPDX-License-Identifier: MIT', f'// {note}']
    lines = head + ['// The C interface as it is.', 'using System;',
                    'using System.Runtime.InteropServices;', '', 'namespace Detent {', '']

    def type_of(name):
        name = description.aliases.get(name, name)
        return SCALARS.get(name) or pascal(name)

    def safe(name):
        return f'@{name}' if name in KEYWORDS else name

    def declared(one, offset=''):
        names = [f'{one.name}{i}' for i in range(one.count)] if one.count else [safe(one.name)]
        return [f'  {offset}public {type_of(one.type)} {name};' for name in names]

    for struct in description.structs.values():
        if struct.has_pointers:
            continue
        name = pascal(struct.name)
        if struct.union:
            lines += ['[StructLayout(LayoutKind.Explicit)]', f'public struct {name}As {{']
            for one in struct.union:
                lines += declared(one, '[FieldOffset(0)] ')
            lines += ['}', '']
        lines += [f'/// <summary>{struct.doc.replace("&", "&amp;").replace("<", "&lt;")}</summary>',
                  '[StructLayout(LayoutKind.Sequential)]', f'public struct {name} {{']
        for one in struct.fields:
            lines += declared(one)
        if struct.union:
            lines.append(f'  public {name}As of;')
        lines += ['}', '']
    lines += ['public static unsafe class C {']
    for constant in description.constants:
        kind = 'int' if constant.value < 0 or constant.name in ('DETENT_OK', 'DETENT_NO') else 'uint'
        lines.append(f'  public const {kind} {constant.name.replace("DETENT_", "")} = {constant.value};')
    for function in description.functions:
        arguments = []
        for one in function.arguments:
            kind = 'void' if one.type == 'detent_allocator' else type_of(one.type)
            arguments.append(f'{kind}{"*" if one.pointer else ""} {safe(one.name)}')
        result = 'IntPtr' if function.result == 'const char*' else type_of(function.result)
        lines += ['', '  [DllImport("detent", CallingConvention = CallingConvention.Cdecl)]',
                  f'  public static extern {result} {function.name}({", ".join(arguments)});']
    lines += ['', '  /// <summary>Throws if a structure does not have the same size as in C.</summary>',
              '  public static void CheckSizes() {']
    for struct in description.structs.values():
        if not struct.has_pointers:
            lines.append(f'    if (sizeof({pascal(struct.name)}) != {struct.size}) '
                         f'throw new TypeLoadException("{struct.name}");')
    lines += ['  }', '}', '', '}', '']
    template = os.path.join(os.path.dirname(os.path.abspath(__file__)), 'csharp', 'spaces.cs.in')
    spaces = expand(open(template, encoding='utf-8').read())
    spaces = spaces.replace('Axial2', 'int').replace('Axial3', 'Vec3')
    spaces = spaces.replace('@generated', note.replace('detent.h.in', 'csharp/spaces.cs.in'))
    return {'bindings/csharp/Interface.cs': re.sub(r' +\n', '\n', '\n'.join(lines)),
            'bindings/csharp/Spaces.cs': spaces}
