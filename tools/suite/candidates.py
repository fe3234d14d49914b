"""Finds the places of one source file that can be mutated, by libclang.

A candidate is a dictionary: kind, line, column, before, after, edits. An edit is (begin, end, text): the bytes of the
file from begin to end become the text, in which @ stands for the number of the mutant.
"""
import re
import shlex
import sys

from clang.cindex import CursorKind as K
from clang.cindex import Index, TypeKind

from common import SWITCH_HEADER, with_edits

sys.setrecursionlimit(10000)

# Bits of libclang's parse options: record macro expansions; keep the headers parsed for the next parse.
PARSE_OPTIONS = 0x01 | 0x04 | 0x100
ERROR = 3

BOUNDARY = {"<": "<=", "<=": "<", ">": ">=", ">=": ">"}
NEGATION = {"<": ">=", "<=": ">", ">": "<=", ">=": "<", "==": "!=", "!=": "=="}
# Calls of these functions are not mutated: without them only the time that the program takes would change.
ONLY_SPEED = {"reserve", "shrink_to_fit"}

INTEGER = re.compile(r"(0[xX][0-9a-fA-F']+|0[bB][01']+|[0-9][0-9']*)([uUlLzZ]*)\Z")
FLOATING = re.compile(r"(0[xX][0-9a-fA-F'.]+[pP][+-]?[0-9]+|[0-9'.]+([eE][+-]?[0-9]+)?)[fFlL]?\Z")
CONSTANT = re.compile(r"\b(constexpr|consteval|constinit|static|thread_local)\b")
COMMENT = re.compile(r"//[^\n]*|/\*.*?\*/", re.S)
SPACE = re.compile(rb"(?:\s|//[^\n]*|/\*.*?\*/)*", re.S)

SIGNED = {TypeKind.CHAR_S, TypeKind.SCHAR, TypeKind.SHORT, TypeKind.INT, TypeKind.LONG, TypeKind.LONGLONG}
UNSIGNED = {TypeKind.CHAR_U, TypeKind.UCHAR, TypeKind.CHAR16, TypeKind.CHAR32, TypeKind.USHORT, TypeKind.UINT,
            TypeKind.ULONG, TypeKind.ULONGLONG}
REAL = {TypeKind.FLOAT, TypeKind.DOUBLE, TypeKind.LONGDOUBLE}
ARITHMETIC = SIGNED | UNSIGNED | REAL

SCOPES = {K.NAMESPACE, K.LINKAGE_SPEC, K.UNEXPOSED_DECL, K.CLASS_DECL, K.STRUCT_DECL, K.CLASS_TEMPLATE,
          K.CLASS_TEMPLATE_PARTIAL_SPECIALIZATION}
FUNCTIONS = {K.FUNCTION_DECL, K.CXX_METHOD, K.CONSTRUCTOR, K.DESTRUCTOR, K.CONVERSION_FUNCTION, K.FUNCTION_TEMPLATE}
NOT_ENTERED = {K.STATIC_ASSERT, K.PARM_DECL, K.FIELD_DECL, K.ENUM_DECL, K.TYPE_ALIAS_DECL, K.TYPEDEF_DECL,
               K.TYPE_REF, K.TEMPLATE_REF}
LOOPS = {K.FOR_STMT, K.CXX_FOR_RANGE_STMT, K.WHILE_STMT}


def compiler_arguments(command, source):
    """The arguments of a compile command that libclang needs, without warnings."""
    arguments, words = [], iter(shlex.split(command)[1:])
    for word in words:
        if word == "-o":
            next(words)
        elif word != "-c" and word != source and not word.startswith(("-W", "--param")):
            arguments.append(word)
    # The last two options make an error of a mutated array size that is no constant, which the compiler would
    # accept as an extension.
    return arguments + ["-include", str(SWITCH_HEADER), "-Wno-everything", "-Werror=vla", "-Werror=vla-extension"]


class Source:
    """One parsed source file."""

    def __init__(self, path, command):
        self.path = str(path)
        self.bytes = path.read_bytes()
        self.unit = Index.create().parse(self.path, args=compiler_arguments(command, self.path), options=PARSE_OPTIONS)
        self.faults = self._faults()
        self.found = []
        self.macros = []

    def _faults(self):
        return [str(d) for d in self.unit.diagnostics if d.severity >= ERROR]

    def candidates(self):
        for cursor in self.unit.cursor.get_children():
            if cursor.location.file is None or cursor.location.file.name != self.path:
                continue
            if cursor.kind == K.MACRO_INSTANTIATION:
                self.macros.append((cursor.extent.start.offset, cursor.extent.end.offset))
            else:
                self._enter_scope(cursor)
        # libclang may show an expression of a template twice, so each place and kind is kept once.
        unique = {(c["edits"][0][:2], c["kind"]): c for c in self.found if self._free_of_macros(c)}
        return [unique[key] for key in sorted(unique)]

    def compiles_with(self, edits):
        """Returns true if the file with these edits is still valid C++."""
        changed = with_edits(self.bytes, [{"id": 1, "edits": edits}])
        self.unit.reparse(unsaved_files=[(self.path, changed.decode())], options=PARSE_OPTIONS)
        return not self._faults()

    # ---- walking --------------------------------------------------------------------------------------------

    def _enter_scope(self, cursor):
        if cursor.kind in FUNCTIONS:
            self._enter_function(cursor)
        elif cursor.kind in SCOPES:
            for child in cursor.get_children():
                self._enter_scope(child)

    def _enter_function(self, cursor):
        for child in cursor.get_children():
            if child.kind == K.COMPOUND_STMT and not self._says_constant(cursor, child.extent.start.offset):
                self._walk(child, [])

    def _says_constant(self, cursor, end):
        """Returns true if the cursor's text up to `end` declares a constant, or a static variable, which is
        made once. A static function does not count."""
        words = CONSTANT.findall(COMMENT.sub("", self._text(cursor.extent.start.offset, end)))
        return any(word != "static" or cursor.kind == K.VAR_DECL for word in words)

    def _walk(self, cursor, parents):
        if cursor.kind in NOT_ENTERED:
            return
        if cursor.kind in FUNCTIONS or cursor.kind in SCOPES:  # a class inside a function
            self._enter_scope(cursor)
            return
        if cursor.kind == K.VAR_DECL and self._says_constant(cursor, cursor.location.offset):
            return
        children = list(cursor.get_children())
        if cursor.kind == K.LAMBDA_EXPR:
            bodies = [c for c in children if c.kind == K.COMPOUND_STMT]
            if bodies and self._says_constant(cursor, bodies[-1].extent.start.offset):
                return
        self._look_at(cursor, children, parents)
        if cursor.kind == K.CASE_STMT:
            children = children[1:]
        if cursor.kind == K.IF_STMT and re.match(r"if\s+constexpr\b", self._text_of(cursor)):
            children = children[1:]
        for child in children:
            self._walk(child, parents + [cursor])

    def _look_at(self, cursor, children, parents):
        if cursor.kind == K.BINARY_OPERATOR and len(children) == 2:
            self._comparison(cursor, children)
        elif cursor.kind == K.CALL_EXPR:
            if cursor.spelling.startswith("operator") and len(children) == 3:
                self._comparison(cursor, children)
            self._call(cursor, parents)
        elif cursor.kind in (K.INTEGER_LITERAL, K.FLOATING_LITERAL):
            self._constant(cursor, parents)

    # ---- the three kinds ------------------------------------------------------------------------------------

    def _comparison(self, cursor, children):
        begin, end = _range(cursor)
        left, right = _range(children[0]), _range(children[-1])
        if left[0] != begin or right[1] != end or left[1] > right[0]:
            return
        sign = COMMENT.sub("", self._text(left[1], right[0])).strip()
        if sign not in NEGATION or cursor.type.get_canonical().kind not in (TypeKind.BOOL, TypeKind.DEPENDENT,
                                                                            TypeKind.UNEXPOSED):
            return
        a, b = self._text(*left), self._text(*right)
        whole = self._text(begin, end)
        if sign in BOUNDARY and cursor.kind == K.BINARY_OPERATOR:
            between = self._text(left[1], right[0]).replace(sign, BOUNDARY[sign], 1)
            self._add("comparison", cursor, whole, f"{a} {BOUNDARY[sign]} {b}",
                      [(begin, end, f"(thaum_mutants::on(@) ? ({a}{between}{b}) : ({whole}))")], "boundary")
        self._add("comparison", cursor, whole, f"{a} {NEGATION[sign]} {b}",
                  [(begin, end, f"(thaum_mutants::on(@) != ({whole}))")], "negation")

    def _call(self, cursor, parents):
        """Adds a mutant without the call if the call is a whole statement. The braces keep an `else` at its
        `if`."""
        name = cursor.spelling
        if (name.startswith("operator") and name != "operator()") or name in ONLY_SPEED or not parents:
            return
        parent, statement = _statement_of(cursor, parents)
        if parent is None or not _is_body(parent, statement):
            return
        begin, end = _range(statement)
        after = SPACE.match(self.bytes, end).end()
        if self.bytes[after:after + 1] != b";":
            return
        self._add("call", cursor, self._text(begin, end), "",
                  [(begin, begin, "{ if (!thaum_mutants::on(@)) "), (after + 1, after + 1, " }")])

    def _constant(self, cursor, parents):
        begin, end = _range(cursor)
        before = self._text(begin, end)
        target = cursor.type.get_canonical()
        for parent in reversed(parents):
            if parent.kind != K.UNEXPOSED_EXPR or _range(parent) != (begin, end):
                break
            kind = parent.type.get_canonical().kind
            if kind in (TypeKind.BOOL, TypeKind.POINTER, TypeKind.NULLPTR, TypeKind.MEMBERPOINTER):
                return
            if kind in ARITHMETIC:
                target = parent.type.get_canonical()
        after = _other_value(cursor, before, target)
        if after is None:
            return
        chosen = f"(thaum_mutants::on(@) ? {after} : {before})"
        if target.kind != cursor.type.get_canonical().kind:
            chosen = f"static_cast<{target.spelling.replace('const ', '')}>{chosen}"
        self._add("constant", cursor, before, after, [(begin, end, chosen)])

    # ---- helpers --------------------------------------------------------------------------------------------

    def _add(self, kind, cursor, before, after, edits, way=""):
        start = cursor.extent.start
        one_line = (" ".join(COMMENT.sub("", text).split()) for text in (before, after))
        before, after = one_line
        found = {"kind": kind, "line": start.line, "column": start.column, "before": before, "after": after,
                 "edits": edits}
        if way and self.found and self.found[-1]["edits"][0][:2] == edits[0][:2]:
            self.found[-1]["other"] = found  # the draw takes one of the two mutants
        else:
            self.found.append(found)

    def _free_of_macros(self, candidate):
        """Whether a candidate is outside of macros. It may contain a whole macro, but not be in one."""
        begin = candidate["edits"][0][0]
        end = candidate["edits"][-1][1]
        return all(e <= begin or end <= b or (begin <= b and e <= end and (begin, end) != (b, e))
                   for b, e in self.macros)

    def _text(self, begin, end):
        return self.bytes[begin:end].decode(errors="replace")

    def _text_of(self, cursor):
        return self._text(*_range(cursor))


def _range(cursor):
    return cursor.extent.start.offset, cursor.extent.end.offset


def _statement_of(cursor, parents):
    """Returns the statement that consists of this call alone, and its parent."""
    statement = cursor
    for parent in reversed(parents):
        if parent.kind != K.UNEXPOSED_EXPR:
            return parent, statement
        if _range(parent) != _range(cursor):
            return None, None
        statement = parent
    return None, None


def _is_body(parent, statement):
    children = list(parent.get_children())
    if parent.kind == K.COMPOUND_STMT:
        return True
    if parent.kind == K.IF_STMT:
        return statement not in children[:1] and len(children) > 1
    if parent.kind in LOOPS or parent.kind in (K.CASE_STMT, K.DEFAULT_STMT):
        return statement == children[-1]
    return parent.kind == K.DO_STMT and statement == children[0]


def _other_value(cursor, before, target):
    """Mutated text of a literal x: x + 1, or x - 1 if x + 1 is too large for the type; 2 x + 1 for floats."""
    if cursor.kind == K.FLOATING_LITERAL:
        return f"{before} * 2 + 1" if FLOATING.match(before) else None
    match = INTEGER.match(before)
    if not match:
        return None
    digits = match.group(1).replace("'", "")
    octal = len(digits) > 1 and digits[0] == "0" and digits[1].isdigit()
    value = int(digits, 8 if octal else 0)
    limits = [_greatest(t) for t in (cursor.type.get_canonical(), target) if t.kind in SIGNED | UNSIGNED]
    return f"{before} - 1" if limits and value + 1 > min(limits) else f"{before} + 1"


def _greatest(kind):
    bits = 8 * kind.get_size()
    return 2 ** (bits - 1 if kind.kind in SIGNED else bits) - 1
