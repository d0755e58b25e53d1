# SPDX-License-Identifier: MIT
"""The layouts, constants and types of the JavaScript binding."""
import re


def is_vector(struct):
    return [field.name for field in struct.fields] in (['x', 'y'], ['x', 'y', 'z'])


def short(name):
    """detent_world3_settings -> World3Settings"""
    return ''.join(part.capitalize() for part in name.replace('detent_', '').split('_'))


def files(description, note):
    structs = [struct for struct in description.structs.values() if not struct.has_pointers]
    lines = ['// SPDX-License-Identifier: MIT', f'// {note}', '']
    for constant in description.constants:
        lines.append(f'export const {constant.name.replace("DETENT_", "")} = {constant.value};')
    lines += ['', '// The size of each structure, whether it is a vector, its fields (name, type, offset,',
              '// elements) and the members of its union.', 'export const layouts = {']
    for struct in structs:
        def field(one):
            kind = description.aliases.get(one.type, one.type)
            return f"['{one.name}', '{kind}', {one.offset}, {one.count}]"
        lines.append(f"  {struct.name}: {{ size: {struct.size}, isVector: "
                     f"{'true' if is_vector(struct) else 'false'},")
        lines.append('    fields: [' + ', '.join(map(field, struct.fields)) + '],')
        lines.append('    union: [' + ', '.join(map(field, struct.union)) + '] },')
    lines += ['};', '']
    types = ['// SPDX-License-Identifier: MIT', f'// {note}', '']
    for constant in description.constants:
        types.append(f'export declare const {constant.name.replace("DETENT_", "")}: '
                     f'{constant.value};')

    def type_of(one):
        kind = description.aliases.get(one.type, one.type)
        name = {'uint64_t': 'bigint'}.get(kind, 'number' if kind.endswith('int32_t') else short(kind))
        return f'{name}[]' if one.count else name
    for struct in structs:
        types += ['', f'/** {struct.doc} */']
        if is_vector(struct):
            numbers = ', '.join('number' for _ in struct.fields)
            types.append(f'export type {short(struct.name)} = [{numbers}];')
            continue
        types.append(f'export interface {short(struct.name)} {{')
        types += [f'  {one.name}: {type_of(one)};' for one in struct.fields]
        if struct.union:
            types += [f'  {one.name}?: {type_of(one)};' for one in struct.union]
        types.append('}')
    return {'bindings/js/interface.mjs': re.sub(r' +\n', '\n', '\n'.join(lines)),
            'bindings/js/interface.d.mts': '\n'.join(types) + '\n'}
