#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""check_class_comments.py SOURCE: checks that class comments have at most 60 lines, and prints the longest ten."""
import re
import sys
from pathlib import Path

MAXIMUM = 60
COMMENT = re.compile(r"/\*\*(?:(?!\*/).)*?@class\s+(\w+).*?\*/", re.DOTALL)


def main(source):
    lengths = sorted(
        ((match.group(0).count("\n") + 1, match.group(1))
         for directory in ("Filters", "Rendering", "Plugin", "Testing", "Utilities")
         for path in (Path(source) / directory).rglob("*.h")
         for match in COMMENT.finditer(path.read_text(encoding="utf-8"))), reverse=True)
    for length, name in lengths[:10]:
        print(f"{name}: {length} lines")
    print(f"{len(lengths)} class comments")
    return 0 if len(lengths) > 100 and lengths[0][0] <= MAXIMUM else 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
