#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""check_messages.py SOURCE: checks each error and warning message in the source directory.

A message must be a sentence that starts with a capital, ends with a period, and names the value, array,
setting or class concerned. Messages that are only forwarded are checked where they are composed: a
function that returns a text that starts with a capital must return a sentence. Texts that start in
lower case are clauses of a message.
"""
import re
import sys
from pathlib import Path

MACRO = re.compile(r"\bvtk(?:Generic)?(?:Error|Warning)(?:WithObject)?Macro\(")
COMPOSED = re.compile(r"\breturn (?:interlume::)?(?:Error[({]\s*)?(?=(?:std::string\()?\"[A-Z][a-z]* )")
LITERAL = re.compile(r'"((?:\\.|[^"\\])*)"')
# A streamed value, the name of a class, function, setting or constant, or quoted text.
NAMED = re.compile(r"<>|\b[A-Z][a-z]+[A-Z]\w*|\bvtk\w+|\b[A-Z_]{4,}\b|\b[a-z]+[A-Z]\w+|'[^']+'|\\\"")


def arguments_of(text, start):
    """Returns the text from start, behind an opening parenthesis, to the closing parenthesis."""
    depth, position = 1, start
    while depth:
        if text[position] == '"':
            position = LITERAL.match(text, position).end()
            continue
        depth += {"(": 1, ")": -1}.get(text[position], 0)
        position += 1
    return text[start : position - 1]


def message_of(streamed):
    """Returns the text of a message, with <> for each value."""
    parts, last = [], 0
    for literal in LITERAL.finditer(streamed):
        if re.search(r"\w", streamed[last : literal.start()]):
            parts.append("<>")
        parts.append(literal.group(1))
        last = literal.end()
    if re.search(r"\w", streamed[last:]):
        parts.append("<>")
    return "".join(parts)


def errors_of_sentence(message):
    if not re.match(r"[A-Z<\\]|[a-z]+[A-Z]\w*[ :]", message):
        yield "does not start with a capital"
    if not re.search(r"(\.|<>)$", message.rstrip()):
        yield "does not end with a period"
    if len(message.split()) < 4:
        yield "is not a sentence"


def errors_of(message):
    if message == "<>":
        return
    yield from errors_of_sentence(message)
    if not NAMED.search(message):
        yield "names no value, array, setting or class"


def composed_messages(text):
    """Yields the position and text of each returned message."""
    for match in COMPOSED.finditer(text):  # except the start of a longer message
        end = LITERAL.sub(lambda literal: "x" * len(literal.group(0)), text[match.end() :]).index(";")
        message = message_of(text[match.end() : match.end() + end])
        if not message.endswith(" "):
            yield match.start(), message


def main(source):
    number = failures = 0
    for folder in ("Filters", "Rendering", "Plugin"):
        for path in sorted(Path(source, folder).rglob("*")):
            if path.suffix not in (".h", ".cxx"):
                continue
            text = path.read_text()
            found = [(macro.start(), message_of(arguments_of(text, macro.end())), errors_of)
                     for macro in MACRO.finditer(text)]
            found += [(start, message, errors_of_sentence) for start, message in composed_messages(text)]
            for start, message, check in found:
                number += 1
                for error in check(message):
                    failures += 1
                    line = text.count("\n", 0, start) + 1
                    print(f"{path.relative_to(source)}:{line}: \"{message}\" {error}")
    print(f"{number} messages, {failures} failures")
    return 1 if failures or number < 150 else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
