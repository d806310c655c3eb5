# SPDX-License-Identifier: BSD-3-Clause
"""Formats numbers of rows by templates such as "{ratio} ({seconds})", with the fields and counts of a row.

{name} is formatted by the unit in the name (seconds, KiB), {name:%} as a percentage, {name:2} with two digits. {a/b} is
a quotient of two numbers, {ratio} the baseline's time divided by Interlume's, and {slower} its inverse.
"""

import re

NOTHING = "–"
FIELD = re.compile(r"\{([\w/]+)(?::(\d|%))?\}")
TIMES = ("ratio", "slower", "seconds", "peer_seconds")


def short(number, digits=3):
    """Formats a number with the given digits; integers in full, with commas. Null stands for NaN and infinity."""
    if number is None:
        return "no number"
    if isinstance(number, str):
        return number
    if number == int(number) and abs(number) < 1e15:
        return f"{int(number):,}"
    if abs(number) >= 10 ** digits:
        return f"{number:,.0f}"
    if abs(number) < 1e-3:
        mantissa, exponent = f"{number:.{digits - 1}e}".split("e")
        return f"{float(mantissa):g}e{int(exponent)}"
    return f"{number:.{digits}g}"


def seconds(number):
    for unit, factor in (("s", 1), ("ms", 1e3)):
        if number * factor >= 0.995:
            return f"{short(number * factor)} {unit}"
    return f"{short(number * 1e6)} µs"


def number_of(row, name):
    """Returns a field or count of a row. Raises KeyError if the row has neither."""
    if "/" in name:
        above, below = name.split("/")
        return number_of(row, above) / number_of(row, below)
    if name == "slower":
        return 1 / number_of(row, "ratio")
    if name == "ratio" and row.get("ratio") is None:
        return row["peer_seconds"] / row["seconds"]
    return row[name] if name in row else row["counts"][name]


def formatted(row, name, form):
    number = number_of(row, name)
    if number is None:
        return short(None)
    if form == "%":
        text = f"{short(100 * number)} %"
    elif form:
        text = short(number, int(form))
    elif name.endswith("seconds"):
        text = seconds(number)
    elif name.endswith("kib"):
        text = short(round(number / 1024, 1))
    else:
        text = short(number)
    return f"above {text}" if name == "ratio" and row.get("counts", {}).get("at_least") else text


def text_of(row, template):
    """Fills a template from a row. Returns NOTHING if the row lacks one of its numbers.

    A star marks times of a single run. "1–1" is shortened to "1".
    """
    try:
        text = FIELD.sub(lambda found: formatted(row, found.group(1), found.group(2)), template)
    except KeyError:
        return NOTHING
    single = 1 in (row.get("runs"), row.get("peer_runs")) and any(name in TIMES for name, _ in FIELD.findall(template))
    return re.sub(r"\(([^–]+)–\1\)", r"(\1)", text) + ("*" if single else "")


def span_of(rows, template):
    """Returns the text of a row, or "a to b" for the smallest and the largest number of several rows."""
    name = FIELD.search(template).group(1)
    texts = [text_of(row, template) for row in sorted(rows, key=lambda row: number_of(row, name))]
    return " to ".join(dict.fromkeys((texts[0], texts[-1]))) if texts else NOTHING


def markdown(columns, lines):
    rows = ["| " + " | ".join(line) + " |" for line in [columns, *lines]]
    return "\n".join([rows[0], "|---" * len(columns) + "|", *rows[1:]])
