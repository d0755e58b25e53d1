# SPDX-License-Identifier: MIT
"""The types and functions of the C interface, read from bindings/detent.h.in.

The file is C99 except for lines that begin with @. Text between @each and @end is repeated for each
dimension: {N} is the dimension, {x} the coordinates, {A} the number of components of an angular
velocity and {C} the number of points of a contact. `generate` replaces @generated and @layouts.
"""
import re
from dataclasses import dataclass, field

SCALARS = {'int32_t': 4, 'uint32_t': 4, 'uint64_t': 8}


@dataclass
class Field:
    name: str
    type: str  # a scalar, the name of a struct, or 'pointer'
    count: int = 0  # of an array, otherwise 0
    offset: int = 0


@dataclass
class Struct:
    name: str
    fields: list
    doc: str
    union: list = field(default_factory=list)  # the members of a union `as` at the end
    size: int = 0
    alignment: int = 1
    has_pointers: bool = False


@dataclass
class Argument:
    name: str
    type: str  # without const and *
    pointer: bool
    const: bool


@dataclass
class Function:
    name: str
    result: str
    arguments: list
    doc: str


@dataclass
class Constant:
    name: str
    value: int
    doc: str


def expand(text):
    """Expands the text between @each and @end for both dimensions."""
    def both(match):
        parts = []
        for n, x, a, c in ((2, 'x, y', 1, 2), (3, 'x, y, z', 3, 4)):
            parts.append(match[1].replace('{N}', str(n)).replace('{x}', x).replace('{A}', str(a))
                         .replace('{C}', str(c)))
        return ''.join(parts)
    return re.sub(r'@each\n(.*?)@end\n', both, text, flags=re.S)


def sentence(comment):
    return ' '.join(line.strip(' *') for line in comment.strip('/* ').splitlines()).strip()


class Description:
    def __init__(self, path):
        self.text = expand(open(path, encoding='utf-8').read())
        self.aliases, self.structs, self.functions, self.constants = {}, {}, [], []
        for match in re.finditer(
                r'(?P<doc>/\*\*(?:[^*]|\*(?!/))*\*/)\n(?:'
                r'enum \{(?P<enum>.*?)\};|'
                r'typedef struct (?P<struct>\w+) \{(?P<body>.*?)\n\} \w+;|'
                r'typedef (?P<alias>\w+) (?P<as>\w+);|'
                r'DETENT_API (?P<result>const char\*|\w+) (?P<function>\w+)\((?P<arguments>.*?)\);)',
                self.text, re.S):
            doc = sentence(match['doc'])
            if match['enum'] is not None:
                self.read_enum(match['enum'])
            elif match['struct']:
                self.read_struct(match['struct'], match['body'], doc)
            elif match['alias']:
                self.aliases[match['as']] = match['alias']
            else:
                self.read_function(match, doc)
        said = len(re.findall(r'^DETENT_API', self.text, re.M))
        if said != len(self.functions):
            raise SystemExit(f'{said} functions are declared, {len(self.functions)} were read')

    def read_enum(self, body):
        for name, value, doc in re.findall(r'(\w+) = (-?\d+),?(?:\s*/\*\*<(.*?)\*/)?', body):
            self.constants.append(Constant(name, int(value), doc.strip()))

    def read_fields(self, body):
        body = re.sub(r'/\*.*?\*/', '', body, flags=re.S)
        fields = []
        for statement in filter(None, (part.strip() for part in body.split(';'))):
            pointer = re.fullmatch(r'void\*\s+(\w+)|\w+\*? ?\(\*(\w+)\)\(.*\)', statement, re.S)
            if pointer:
                fields.append(Field((pointer[1] or pointer[2]), 'pointer'))
                continue
            kind, names = statement.split(None, 1)
            for name in names.split(','):
                array = re.fullmatch(r'\s*(\w+)(?:\[(\d+)\])?', name)
                fields.append(Field(array[1], kind, int(array[2] or 0)))
        return fields

    def read_struct(self, name, body, doc):
        union = re.search(r'union \{(.*?)\} as;', body, re.S)
        struct = Struct(name, self.read_fields(body[:union.start()] if union else body), doc)
        if union:
            struct.union = self.read_fields(union[1])
        at = 0
        for one in struct.fields:
            size, alignment = self.size_of(one, struct)
            at = -(-at // alignment) * alignment
            one.offset = at
            at += size
            struct.alignment = max(struct.alignment, alignment)
        if struct.union:
            for one in struct.union:
                one.offset = at
            at += max(self.size_of(one, struct)[0] for one in struct.union)
        struct.size = -(-at // struct.alignment) * struct.alignment
        self.structs[name] = struct

    def size_of(self, one, owner):
        if one.type == 'pointer':
            owner.has_pointers = True
            return 8, 8
        kind = self.aliases.get(one.type, one.type)
        if kind in SCALARS:
            size = alignment = SCALARS[kind]
        else:
            size, alignment = self.structs[kind].size, self.structs[kind].alignment
        return size * max(one.count, 1), alignment

    def read_function(self, match, doc):
        arguments = []
        for text in re.sub(r'\s+', ' ', match['arguments']).split(','):
            if text.strip() == 'void':
                continue
            parts = re.fullmatch(r' ?(const )?(\w+)(\*)? (\w+)', text)
            if not parts:
                raise SystemExit(f'{match["function"]}: cannot read "{text}"')
            arguments.append(Argument(parts[4], parts[2], bool(parts[3]), bool(parts[1])))
        self.functions.append(Function(match['function'], match['result'], arguments, doc))
