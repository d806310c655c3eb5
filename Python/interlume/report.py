# SPDX-License-Identifier: BSD-3-Clause
"""What the last execution of a filter or mapper did, as a dictionary."""


def report(algorithm):
    """Returns the numbers and words of the algorithm's GetReport() by their names.

    They are fields of a C++ structure, which wrapping leaves out, and are read from what the
    algorithm prints. Several values are a tuple; none is an empty text.
    """
    values = {}
    depth = None
    for line in str(algorithm).splitlines():
        indent = len(line) - len(line.lstrip())
        name, _, text = line.strip().partition(":")
        if depth is not None and indent <= depth:
            break
        if depth is not None:
            values[name] = _read(text.split())
        elif name == "Report":
            depth = indent
    if depth is None:
        raise TypeError(f"{algorithm.GetClassName()} has no report")
    return values


def _read(words):
    numbers = [_read_number(word) for word in words]
    if not words or None in numbers:
        return " ".join(words)
    return tuple(numbers) if len(numbers) != 1 else numbers[0]


def _read_number(word):
    for kind in (int, float):
        try:
            return kind(word)
        except ValueError:
            pass
    return None
