# SPDX-License-Identifier: BSD-3-Clause
"""From the smallest to the largest of a number among rows, for a sentence."""

from measured_cells import NOTHING


def spread(cell, text, **fields):
    """A function that makes text of a run: "1.2 to 1.5", or one number where both are the same."""
    def value(run):
        numbers = sorted(cell.number(row) for row in run.select(**{**cell.fields, **fields}))
        if not numbers:
            return NOTHING
        ends = list(dict.fromkeys([text(numbers[0]), text(numbers[-1])]))
        return " to ".join(ends)
    return value


def single(cell, **fields):
    """Likewise of the only row."""
    return lambda run: cell(run, fields)
