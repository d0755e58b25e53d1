# SPDX-License-Identifier: MIT
"""The declarations of the LuaJIT binding: the description without comments and preprocessor lines."""
import re


def files(description, note):
    text = re.sub(r'/\*.*?\*/', '', description.text, flags=re.S)
    text = re.sub(r'^[ \t]*#(?:[^\n]*\\\n)*[^\n]*\n', '', text, flags=re.M)
    text = re.sub(r'^(extern "C" \{|\}|@\w+)$', '', text, flags=re.M)
    text = re.sub(r'\bDETENT_API ', '', text)
    text = re.sub(r'[ \t]+$', '', text, flags=re.M)
    text = re.sub(r'\n{2,}', '\n', text).strip()
    sizes = [f'  {struct.name} = {struct.size},' for struct in description.structs.values()
             if not struct.has_pointers]
    lines = ['-- SPDX-License-Identifier: MIT', f'-- {note}', '-- The C interface as it is.',
             "local ffi = require('ffi')", 'ffi.cdef[[', text, ']]', 'local sizes = {', *sizes, '}',
             'for name, size in pairs(sizes) do assert(ffi.sizeof(name) == size, name) end',
             'return sizes', '']
    return {'bindings/lua/detent/interface.lua': '\n'.join(lines)}
