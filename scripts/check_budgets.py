#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Checks the size budgets: lines of a file and of a function, arguments, nesting (CONTRIBUTING.md).

    scripts/check_budgets.py [folder or file ...]

Universal Ctags finds the C++ functions, the standard library the Python functions. An exception needs
a reason in the source, inside the function or up to three lines above it:

    // budget: function: the table of all keys reads best in one place
"""
import ast
import collections
import functools
import json
import pathlib
import re
import shutil
import subprocess
import sys

FILE_LINES, FUNCTION_LINES, ARGUMENTS, NESTING = 300, 60, 6, 3
CPP, PYTHON, SHELL = {".cpp", ".hpp", ".cuh", ".cu"}, {".py"}, {".sh", ""}
ROOT = pathlib.Path(__file__).resolve().parent.parent
SKIPPED = 77

TOKEN = re.compile(
    r"""//[^\n]*|/\*.*?\*/            # comments
    |R"(?P<mark>\w*)\(.*?\)(?P=mark)" # raw strings
    |"(?:\\.|[^"\\\n])*"|(?<![0-9a-fA-F])'(?:\\.|[^'\\\n])*'
    |\w+|[^\s]""",
    re.DOTALL | re.VERBOSE,
)


def tokens_of(text):
    return [m.group() for m in TOKEN.finditer(text) if not m.group().startswith(("//", "/*"))]


class Nesting:
    """Computes the depth of control statements in a function body, with or without braces."""

    def __init__(self, tokens):
        self.tokens, self.at, self.deepest = tokens, 0, 0

    def peek(self):
        return self.tokens[self.at] if self.at < len(self.tokens) else ""

    def skip_group(self, open_mark, close_mark, depth):
        """Skips a bracketed group; blocks in it (lambdas) count as statements."""
        self.at += 1
        while self.peek() not in ("", close_mark):
            self.piece(depth)
        self.at += 1

    def piece(self, depth):
        token = self.peek()
        if token == "(":
            self.skip_group("(", ")", depth)
        elif token == "{":
            self.block(depth)
        else:
            self.at += 1

    def block(self, depth):
        self.at += 1
        while self.peek() not in ("", "}"):
            self.statement(depth)
        self.at += 1

    def condition(self, depth):
        while self.peek() not in ("", "("):
            self.at += 1
        self.piece(depth)

    def body(self, depth):
        self.deepest = max(self.deepest, depth)
        self.statement(depth)

    def statement(self, depth):
        token = self.peek()
        if token == "{":
            self.block(depth)
        elif token in ("if", "for", "while", "switch"):
            self.at += 1
            self.condition(depth)
            self.body(depth + 1)
            if token == "if" and self.peek() == "else":
                self.at += 1
                # "else if" has the depth of its "if".
                self.statement(depth) if self.peek() == "if" else self.body(depth + 1)
        elif token in ("do", "try", "catch"):
            self.at += 1
            if token == "catch":
                self.condition(depth)
            self.body(depth + 1)
        else:
            self.simple_statement(depth)

    def simple_statement(self, depth):
        while self.peek() not in ("", ";", "}"):
            colon = self.peek() == ":"
            self.piece(depth)
            # A statement begins after a label of a switch.
            if colon and self.peek() in ("if", "for", "while", "switch", "do", "try"):
                return
        if self.peek() == ";":
            self.at += 1


def nesting_of(body):
    reader = Nesting(tokens_of(body))
    while reader.peek():
        reader.piece(0)
    return reader.deepest


def count_arguments(signature):
    inner = signature[signature.find("(") + 1 : signature.rfind(")")]
    depth = count = 0
    for mark in tokens_of(inner):
        depth += mark in "(<[{"
        depth -= mark in ")>]}"
        count += mark == "," and depth == 0
    return count + 1 if inner.strip() not in ("", "void") else 0


def ctags_entries(paths):
    """Returns what ctags says of the functions of C++ files, by file; one call takes seconds, a thousand a minute."""
    listing = subprocess.run(
        ["ctags", "--options=NONE", "--language-force=C++", "--kinds-C++=f", "--fields=+neS",
         "--output-format=json", "-I", "KERF_FUNCTION", "-f", "-", "-L", "-"],
        input="\n".join(map(str, paths)), check=True, capture_output=True, text=True)
    entries = collections.defaultdict(list)
    for entry in map(json.loads, listing.stdout.splitlines()):
        if "end" in entry and not entry["name"].startswith("__anon"):
            entries[entry["path"]].append(entry)
    return entries


def cpp_functions(path, entries):
    lines = path.read_text().splitlines()
    for entry in entries[str(path)]:
        body = "\n".join(lines[entry["line"] - 1 : entry["end"]])
        # The parameters precede the body, because a signature of ctags never contains a brace.
        after = body[body.find(")") :] if "(" in body else body
        yield (entry["name"], entry["line"], entry["end"],
               count_arguments(entry.get("signature", "")), nesting_of(after))


def python_depth(node):
    control = (ast.If, ast.For, ast.While, ast.Try, ast.With)
    deepest = 0
    for child in ast.iter_child_nodes(node):
        is_elif = isinstance(node, ast.If) and isinstance(child, ast.If) and child in node.orelse
        own = isinstance(child, control) and not (is_elif and len(node.orelse) == 1)
        deepest = max(deepest, own + python_depth(child))
    return deepest


def python_functions(path):
    for node in ast.walk(ast.parse(path.read_text())):
        if isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef)):
            count = len(node.args.args) + len(node.args.kwonlyargs)
            yield node.name, node.lineno, node.end_lineno, count, python_depth(node)


def excused(lines, what, first, last):
    near = lines[max(0, first - 4) : last]
    return any(re.search(rf"(//|#) budget: {what}: \S", line) for line in near)


def problems_of(path, read_functions):
    lines = path.read_text().splitlines()
    if len(lines) > FILE_LINES and not excused(lines, "file", 1, len(lines)):
        yield f"{path}:1: {len(lines)} lines in a file (at most {FILE_LINES})"
    for name, first, last, arguments, nesting in read_functions(path):
        measured = [
            ("function", last - first + 1, FUNCTION_LINES, "lines in a function"),
            ("arguments", arguments, ARGUMENTS, "arguments"),
            ("nesting", nesting, NESTING, "nested control statements"),
        ]
        for what, value, limit, words in measured:
            if value > limit and not excused(lines, what, first, last):
                yield f"{path}:{first}: {name}: {value} {words} (at most {limit})"


def files_of(places):
    for place in map(pathlib.Path, places):
        inside = sorted(place.rglob("*")) if place.is_dir() else [place]
        yield from (path for path in inside if path.is_file())


def main():
    places = sys.argv[1:] or [ROOT / name for name in ("src", "tests", "benchmarks", "scripts")]
    if not shutil.which("ctags"):
        print("Universal Ctags is not installed: skipped")
        return SKIPPED
    found = checked = 0
    paths = list(files_of(places))
    entries = ctags_entries([path for path in paths if path.suffix in CPP])
    for path in paths:
        if path.suffix in CPP:
            read = functools.partial(cpp_functions, entries=entries)
        elif path.suffix in PYTHON:
            read = python_functions
        elif path.suffix in SHELL:
            read = lambda _: ()
        else:
            continue
        checked += 1
        for problem in problems_of(path, read):
            print(problem)
            found += 1
    print(f"{checked} files checked, {found} over budget")
    return 1 if found or not checked else 0


if __name__ == "__main__":
    sys.exit(main())
