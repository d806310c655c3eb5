# SPDX-License-Identifier: BSD-3-Clause
"""Cells of tables: a function each that makes text of a run and of the fields that tell a line's rows."""

NOTHING = "–"


def short(number, digits=3):
    """A number to so many digits; whole numbers whole, with commas. JSON has null for what is no number."""
    if number is None:
        return "no number"
    if number == int(number) and (abs(number) < 1e15):
        return f"{int(number):,}"
    if abs(number) >= 10 ** digits:
        return f"{number:,.0f}"
    if abs(number) < 1e-3:
        mantissa, exponent = f"{number:.{digits - 1}e}".split("e")
        mantissa = mantissa.rstrip("0").rstrip(".") if "." in mantissa else mantissa
        return f"{mantissa}e{int(exponent)}"
    return f"{number:.{digits}g}"


def percent(number):
    return f"{short(100 * number)} %"


def seconds(number):
    """With the unit that suits."""
    for unit, factor in (("s", 1), ("ms", 1e3), ("µs", 1e6)):
        if number * factor >= 0.995 or unit == "µs":
            return f"{short(number * factor)} {unit}"
    return NOTHING


def error(number):
    return short(number, 2)


def mebibytes_of_kib(number):
    return short(round(number / 1024, 1))


def ratio_of(row):
    """The peer's time over ours: above 1 ours is faster."""
    if row.get("ratio") is not None:
        return row["ratio"]
    return row["peer_seconds"] / row["seconds"]


def runs_of_one(row, text):
    """Marks a time that is no median."""
    return text + " (one run)" if row.get("runs") == 1 or row.get("peer_runs") == 1 else text


class Cell:
    """One number of the only row of these fields, and of what tells the line, as text.

    Those are the line's fields `by`, or all of its fields where there is none or the cell has no fields of its own.
    """

    def __init__(self, number, text, **fields):
        self.number = number
        self.text = text
        self.fields = fields

    def row(self, run, line, by):
        told = line if by is None or not self.fields else {name: line[name] for name in by}
        found = run.select(**{**self.fields, **told})
        if len(found) > 1:
            raise ValueError(f"{run.path}: {len(found)} rows of {run.suite} are {self.fields} and {told}")
        return found[0] if found else None

    def __call__(self, run, line, by=None):
        row = self.row(run, line, by)
        if row is None:
            return NOTHING
        try:
            number = self.number(row)
        except KeyError:
            # Counts that this row has not.
            return NOTHING
        return short(None) if number is None else self.text(number)


class TimeCell(Cell):
    """Likewise, of a time: one that is no median says so."""

    def __call__(self, run, line, by=None):
        text = super().__call__(run, line, by)
        return text if text == NOTHING else runs_of_one(self.row(run, line, by), text)


def count(name, text=short, **fields):
    return Cell(lambda row: row["counts"][name], text, **fields)


def ratio(**fields):
    return TimeCell(ratio_of, short, **fields)


def slower(**fields):
    """Our time over the peer's."""
    return TimeCell(lambda row: 1 / ratio_of(row), short, **fields)


def time(**fields):
    return TimeCell(lambda row: row["seconds"], seconds, **fields)


def peer_time(**fields):
    return TimeCell(lambda row: row["peer_seconds"], seconds, **fields)


def error_of(text=error, **fields):
    return Cell(lambda row: row["error"], text, **fields)


def joined(form, *cells):
    """Several cells in one, by a form with a {} for each; nothing where the first has nothing."""
    def cell(run, line, by=None):
        texts = [one(run, line, by) for one in cells]
        return NOTHING if texts[0] == NOTHING else form.format(*texts)
    return cell
