# SPDX-License-Identifier: BSD-3-Clause
"""Tables in Markdown of the rows of a run."""

from measured_cells import NOTHING, short


def markdown(columns, lines):
    return "\n".join(["| " + " | ".join(columns) + " |", "| " + " | ".join("---" for _ in columns) + " |",
                      *("| " + " | ".join(line) + " |" for line in lines)])


class Table:
    """A line for each value of a field, or of several, among the rows of `suite` that have `fields`, in their order.

    `names` gives a line's words by that value; what it lacks is named as it is. `columns` are pairs of a heading
    and a cell; one without fields of its own takes those of the table.
    """

    def __init__(self, suite, columns, head="", by="case", names=None, **fields):
        self.suite = suite
        self.columns = columns
        self.head = head
        self.by = (by,) if isinstance(by, str) else by
        self.names = names or {}
        self.fields = fields

    def named(self, part):
        """A field's value in words."""
        part = self.names.get(part, part)
        return part if isinstance(part, str) else short(part)

    def lines(self, run):
        """The fields that tell the rows of each line, and its words."""
        found = {}
        for row in run.select(**self.fields):
            key = tuple(row.get(name) for name in self.by)
            words = ", ".join(self.named(part) for part in key if part is not None)
            found.setdefault(key, ({**self.fields, **dict(zip(self.by, key))}, words))
        return list(found.values())

    def of(self, run):
        lines = [[words, *(cell(run, line, self.by) for heading, cell in self.columns)]
                 for line, words in self.lines(run)]
        if not lines:
            return ""
        return markdown([self.head, *(heading for heading, cell in self.columns)], lines)


class Lines(Table):
    """A table whose lines are listed: pairs of words and of the fields that tell their rows."""

    def __init__(self, suite, columns, lines, head=""):
        super().__init__(suite, columns, head, by=None)
        self.listed = lines

    def lines(self, run):
        made = [(fields, words) for words, fields in self.listed]
        return [one for one in made if any(cell(run, one[0], None) != NOTHING for heading, cell in self.columns)]


def claims_table(run):
    """What is wanted of a suite, what is missed first."""
    lines = []
    for claim in sorted(run.claims, key=lambda one: one["met"]):
        missed = [case for case in claim["cases"] if not case["met"]]
        met = [case for case in claim["cases"] if case["met"]]
        if not claim["cases"]:
            continue

        def words(cases):
            return "; ".join(f"{case['case']}: {short(case['number'])}" for case in cases)
        lines.append([claim["text"], f"**missed**: {words(missed)}" if missed else "met", words(met)])
    return markdown(["wanted", "missed", "met"], lines) if lines else ""
