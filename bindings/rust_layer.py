# SPDX-License-Identifier: MIT
"""The foreign functions and structures of the Rust binding."""
import re

SCALARS = {'int32_t': 'i32', 'uint32_t': 'u32', 'uint64_t': 'u64', 'size_t': 'usize', 'void': 'c_void'}


def pascal(name):
    """detent_world3_settings -> World3Settings"""
    return ''.join(part.capitalize() for part in name.replace('detent_', '').split('_'))


def has_union(description, struct):
    """Whether it or a field has a union, which Rust cannot compare or print."""
    inner = [description.structs.get(one.type) for one in struct.fields]
    return bool(struct.union) or any(one and has_union(description, one) for one in inner)


def files(description, note):
    lines = ['// SPDX-License-Identifier: MIT', f'// {note}', '//! The C interface as it is.', '',
             '#![allow(missing_docs)]', '', 'use std::os::raw::{c_char, c_void};', '']

    def type_of(name):
        name = description.aliases.get(name, name)
        return SCALARS.get(name) or pascal(name)

    def field(one):
        name = {'as': 'r#as', 'self': 'self_', 'match': 'match_'}.get(one.name, one.name)
        kind = type_of(one.type) if one.type != 'pointer' else 'Option<Hook>'
        return f'    pub {name}: {f"[{kind}; {one.count}]" if one.count else kind},'

    for constant in description.constants:
        name = constant.name.replace('DETENT_', '')
        kind = 'i32' if constant.value < 0 or name in ('OK', 'NO') else 'u32'
        lines.append(f'pub const {name}: {kind} = {constant.value};')
    for struct in description.structs.values():
        if struct.has_pointers:
            continue
        name = pascal(struct.name)
        lines += ['', '#[repr(C)]']
        if struct.union:
            lines += ['#[derive(Clone, Copy)]', f'pub union {name}As {{']
            lines += [field(one) for one in struct.union]
            lines += ['}', '', '#[repr(C)]']
        default = '' if struct.name == 'detent_traits' else 'Default, '  # lib.rs has a better one
        lines.append('#[derive(Clone, Copy)]' if has_union(description, struct) else
                     f'#[derive(Clone, Copy, Debug, {default}PartialEq, Eq)]')
        lines += [f'/// {struct.doc}', f'pub struct {name} {{']
        lines += [field(one) for one in struct.fields]
        if struct.union:
            lines.append(f'    pub of: {name}As,')
        lines += ['}', f'const _: () = assert!(std::mem::size_of::<{name}>() == {struct.size});']
    lines += ['', '#[link(name = "detent")]', 'extern "C" {']
    for function in description.functions:
        arguments = []
        for one in function.arguments:
            kind = type_of(one.type)
            if one.type == 'detent_allocator':
                kind = 'c_void'
            if one.pointer:
                kind = f'*{"const" if one.const else "mut"} {kind}'
            arguments.append(f'{one.name}: {kind}')
        result = '*const c_char' if function.result == 'const char*' else type_of(function.result)
        lines.append(f'    pub fn {function.name}({", ".join(arguments)}) -> {result};')
    lines += ['}', '']
    return {'bindings/rust/src/ffi.rs': re.sub(r' +\n', '\n', '\n'.join(lines))}
