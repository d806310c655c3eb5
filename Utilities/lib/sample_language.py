#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""sample_language.py SEED [COMMENTS NAMES MESSAGES TOOLTIPS]

Prints randomly selected comments, names of private classes and functions, messages and tooltips
(by default 200, 60, 40 and 40) for a reader who has not written them. The line of code that follows
a comment is printed with it. The same seed selects the same samples of the same tree.
"""
import random
import re
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "Testing" / "Install"))
from check_messages import MACRO, arguments_of, message_of  # noqa: E402

COMMENT = re.compile(r"(?:^[ \t]*///?<?[^\n]*\n)+|^[ \t]*/\*\*?.*?\*/", re.MULTILINE | re.DOTALL)
NAME = re.compile(r"^\s*(?:class|struct|enum(?: class)?)\s+(?:\w+_EXPORT\s+)?(\w+)\s*(?:final\s*)?[:{]?\s*$"
                  r"|^\s*[\w:<>&*, ]+[ &*](\w+)\([^;]*\)\s*(?:const)?\s*(?:override)?;", re.MULTILINE)
TOOLTIP = re.compile(r"<Documentation[^>]*>(.*?)</Documentation>", re.DOTALL)


def line_of(text, position):
    return text.count("\n", 0, position) + 1


def with_next_line(text, match):
    """Returns a comment and the next line of code, as its reader sees it."""
    following = text[match.end():].lstrip("\n").split("\n", 1)[0]
    return match.group(0).strip("\n") + ("\n" + following if following.strip() else "")


def collect():
    """Returns lists of (file:line, text) for each kind of sample."""
    comments, names, messages, tooltips = [], [], [], []
    listed = subprocess.run(["git", "ls-files"], cwd=ROOT, capture_output=True, text=True, check=True)
    for name in listed.stdout.split("\n"):
        path = ROOT / name
        if path.suffix == ".xml" and name.startswith("Plugin/"):
            text = path.read_text()
            tooltips += [(f"{name}:{line_of(text, match.start())}", " ".join(match.group(1).split()))
                         for match in TOOLTIP.finditer(text)]
        if path.suffix not in (".h", ".cxx", ".glsl"):
            continue
        text = path.read_text()
        for match in COMMENT.finditer(text):
            if "SPDX" not in match.group(0) and len(match.group(0).split()) > 4:
                comments.append((f"{name}:{line_of(text, match.start())}", with_next_line(text, match)))
        if path.suffix == ".h" and not path.name.startswith("vtk"):
            names += [(f"{name}:{line_of(text, match.start())}", match.group(1) or match.group(2))
                      for match in NAME.finditer(text)]
        if name.startswith(("Filters/", "Rendering/", "Plugin/")):
            messages += [(f"{name}:{line_of(text, match.start())}",
                          message_of(arguments_of(text, match.end()))) for match in MACRO.finditer(text)]
            messages += [(f"{name}:{line_of(text, match.start())}", match.group(1))
                         for match in re.finditer(r'(?:return|Error\()\s*"((?:[^"\\]|\\.){20,})"', text)]
    return comments, names, [entry for entry in messages if entry[1] != "<>"], tooltips


def main(arguments):
    generator = random.Random(int(arguments[0]))
    numbers = [int(number) for number in arguments[1:5]] or [200, 60, 40, 40]
    for kind, number, entries in zip(("comments", "names", "messages", "tooltips"), numbers, collect()):
        print(f"== {number} of {len(entries)} {kind}")
        for place, text in generator.sample(entries, min(number, len(entries))):
            print(f"{place}\n{text}\n")


if __name__ == "__main__":
    main(sys.argv[1:])
