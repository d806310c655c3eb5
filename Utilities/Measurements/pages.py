# SPDX-License-Identifier: BSD-3-Clause
"""Fills page templates from the measurements. Fields are in {{ }}:

{{runs}}: the commands, with dates; {{machines}}: the machines; {{table NAME}}: a table of tables.py; {{value NAME}}: a
number in a sentence; {{targets SUITE}}: the number of targets met; {{missed SUITE: TEXT}}: a missed target with its
cases; {{readme}}: the README's table; {{"text"}}: text that is not a measurement, such as a setting.
Each missed target requires a {{missed}} field, so that the page explains the reason.

Pages of the guide have no template. Comments mark their numbers: <!-- value NAME -->1.7<!-- / -->.
"""

import re
from pathlib import Path

from cells import NOTHING, markdown, number_of, short, span_of, text_of
from results import Results
from tables import RATIO_LINES, README_LINES, TABLES, VALUES

FIELD = re.compile(r"\{\{(.+?)\}\}")
GUIDE_VALUE = re.compile(r"<!-- value (\S+) -->.*?<!-- / -->")
GUIDE_RATIOS = re.compile(r"(<!-- ratios -->\n).*?(<!-- /ratios -->)", re.DOTALL)
README_BLOCK = re.compile(r"(<!-- measured: .*? -->\n).*?(<!-- /measured -->)", re.DOTALL)
# Parts of a page that are not prose: fields, code, images, link targets, program versions.
NOT_PROSE = re.compile(r"\{\{.*?\}\}|`[^`]*`|!\[[^\]]*\]\([^)]*\)|\]\([^)]*\)|\b(?:VTK|ParaView|Debian) [\d.]+")
# Generated parts of the README, and code blocks.
NOT_TYPED = re.compile(r"<!-- (versions|measured|ratios).*?<!-- (?:end of |/)\1 -->|```.*?```", re.DOTALL)
MEASURED = re.compile(r"\d\.\d|\d ?%|\d\s?e-?\d|\d ?(?:s|ms|µs|MB|MiB|GB|GiB|times|million)\b")
MAXIMUM_WORDS = 3000
# The README has a column for each VTK version that has results of at least this number of suites.
MINIMUM_SUITES = 3


def check_words(name, text):
    """Raises ValueError if prose contains a measured number, which no command would update."""
    for number, line in enumerate(text.splitlines(), 1):
        found = MEASURED.search(NOT_PROSE.sub(" ", line))
        if found:
            raise ValueError(f"{name}:{number}: \"{found.group()}\" is typed by hand; use a {{{{value}}}} field: "
                             f"{line.strip()}")


def prose_of(text):
    """Returns a page with empty lines in place of generated parts and code, and without generated values."""
    return NOT_TYPED.sub(lambda found: "\n" * found.group().count("\n"), GUIDE_VALUE.sub(" ", text))


def only_row(run, fields):
    """Returns the row with these fields, or None. Raises ValueError if several rows match."""
    found = run.select(**fields)
    if len(found) > 1:
        raise ValueError(f"{run.path}: {len(found)} rows of {run.suite} match {fields}; add a field")
    return found[0] if found else None


def table_text(run, table):
    """Returns a table: a line for each value of the fields `by` in the rows `where`, a column for each template."""
    lines = {}
    for row in run.select(**table["where"]):
        key = {name: row.get(name) for name in table["by"]}
        words = ", ".join(short(table.get("names", {}).get(part, part)) for part in key.values() if part is not None)
        cells = []
        for _, template, *fields in table["columns"]:
            found = only_row(run, {**(fields[0] if fields else table["where"]), **key})
            cells.append(text_of(found, template) if found else NOTHING)
        lines[words] = [words, *cells]
    heads = [column[0] for column in table["columns"]]
    return markdown([table["head"], *heads], lines.values()) if lines else ""


def line_ratios(run, line):
    """Returns the smallest ratio of a line of the README table, and all ratios as text, or None if a row is missing."""
    rows = [only_row(run, fields) for fields in line["rows"]] if run else [None]
    if None in rows:
        return None
    numbers = [number_of(row, "ratio") for row in rows]
    texts = [text_of(row, "{ratio}").rstrip("*") for row in rows]
    return min(numbers), " / ".join(f"**{text}**" if number < 1 else text for number, text in zip(numbers, texts))


class Pages:
    """Creates the pages from the templates and measurements in a directory.

    If `explains` is false, missed targets require no {{missed}} field. Tests use this for runs of small cases.
    """

    def __init__(self, folder, explains=True):
        self.explains = explains
        self.folder = Path(folder)
        self.results = Results(folder)
        self.stated = set()

    def written(self, root):
        """Returns the texts of measurements.md, README.md and the pages of the guide, by path."""
        readme = root / "README.md"
        old = self.filled(readme)
        if not README_BLOCK.search(old):
            raise ValueError(f"{readme} has no block <!-- measured: --> ... <!-- /measured -->; add one")
        check_words(readme, prose_of(old))
        block = self.expanded("readme.in.md")
        page = self.expanded("page.in.md")
        guide = {path: self.filled(path) for path in sorted((root / "Documentation" / "guide").glob("*.md"))}
        words = sum(any(character.isalnum() for character in word) for word in page.split())
        if words > MAXIMUM_WORDS:
            raise ValueError(f"page.in.md expands to {words} words; the limit is {MAXIMUM_WORDS}")
        return {**guide, root / "Documentation" / "measurements.md": page,
                readme: README_BLOCK.sub(lambda found: found.group(1) + block + found.group(2), old)}

    def expanded(self, name):
        text = (self.folder / name).read_text(encoding="utf-8")
        check_words(self.folder / name, text)
        self.stated = set(re.findall(r"\{\{missed (.+?)\}\}", text))
        # Fields that expand to nothing leave empty lines.
        return re.sub(r"\n{3,}", "\n\n", FIELD.sub(lambda found: self.field(found.group(1)), text))

    def filled(self, path):
        """Returns the text of a page with its values. Pages with a program must not contain typed measurements."""
        text = path.read_text(encoding="utf-8")
        if (self.folder.parents[1] / "Examples" / "Guide" / f"{path.stem}.py").exists():
            check_words(path, prose_of(text))
        text = GUIDE_RATIOS.sub(
            lambda found: f"{found.group(1)}{self.ratios(RATIO_LINES)}\n{found.group(2)}", text)
        return GUIDE_VALUE.sub(
            lambda found: f"<!-- value {found.group(1)} -->{self.field('value ' + found.group(1))}<!-- / -->", text)

    def field(self, words):
        if words.startswith('"'):
            return words.strip('"')
        kind, _, name = words.partition(" ")
        makers = {"table": self.table, "targets": self.targets, "missed": self.missed, "value": self.value,
                  "runs": self.runs, "machines": self.machines, "readme": self.readme}
        if kind not in makers:
            raise ValueError(f"The field {{{{{words}}}}} is unknown; see pages.py for the fields")
        try:
            return makers[kind](name)
        except KeyError as missing:
            raise ValueError(f"The field {{{{{words}}}}} names {missing}, which does not exist") from missing

    def table(self, name):
        """Returns a table with the rows of the oldest VTK that has such rows."""
        table = TABLES[name]
        texts = filter(None, (table_text(run, table) for run in self.results.of(table["suite"])))
        return next(texts, f"The suite `{table['suite']}` has not been measured yet.")

    def targets_of(self, suite):
        """Returns the targets of a suite by their text, each from the oldest VTK with cases of it."""
        found = {}
        for run in self.results.of(suite):
            for target in run.targets:
                found.setdefault(target["text"], target)
        return found

    def targets(self, suite):
        found = self.targets_of(suite)
        for text, target in found.items():
            if self.explains and not target["met"] and f"{suite}: {text}" not in self.stated:
                raise ValueError(f"The page lacks {{{{missed {suite}: {text}}}}} and the reason")
        met = sum(target["met"] for target in found.values())
        return f"Targets met: {met}/{len(found)}." if found else ""

    def missed(self, words):
        suite, _, text = words.partition(": ")
        target = self.targets_of(suite).get(text)
        if target is None or target["met"]:
            # Runs of small cases may meet a target that the full run misses.
            return f"*{text}*: not missed."
        cases = [f"{case['case']} {short(case['number'])}" for case in target["cases"] if not case["met"]]
        more = f" and {len(cases) - 2} more" if len(cases) > 2 else ""
        return f"*{text}*: {'; '.join(cases[:2])}{more}."

    def value(self, name):
        suite, template, fields = VALUES[name]
        runs = self.results.of(suite)
        return span_of(runs[0].select(**fields), template) if runs else "(not measured)"

    def runs(self, _):
        lines = {}
        for (_, version), run in sorted(self.results.runs.items()):
            lines.setdefault(run.command(), {})[version] = run.when()
        versions = self.results.versions()
        return markdown(["command", *(f"VTK {version}: date, load" for version in versions)],
                        [[f"`{command}`", *(line.get(version, NOTHING) for version in versions)]
                         for command, line in lines.items()])

    def machines(self, _):
        found = {}
        for (_, version), run in self.results.runs.items():
            found.setdefault(run.machine_text(), set()).add(version)
        return "; ".join(f"{machine} (VTK {', '.join(sorted(versions))})" for machine, versions in found.items())

    def readme(self, _):
        return self.ratios(README_LINES)

    def ratios(self, ratio_lines):
        """Returns a table of ratios to baselines: a column for each VTK, smallest ratio first."""
        measured = [version for _, version in self.results.runs]
        columns = [version for version in self.results.versions() if measured.count(version) >= MINIMUM_SUITES]
        columns = columns or self.results.versions()
        lines = []
        for line in ratio_lines:
            found = {version: line_ratios(self.results.runs.get((line["suite"], version)), line)
                     for version in self.results.versions()}
            found = {version: made for version, made in found.items() if made}
            others = [f"{text} (VTK {version})" for version, (_, text) in found.items() if version not in columns]
            texts = [found[version][1] if version in found else NOTHING for version in columns]
            if others:
                texts[0] = ", ".join([text for text in texts[:1] if text != NOTHING] + others)
            if found:
                smallest = min(number for number, _ in found.values())
                lines.append((smallest, [line["work"], line["data"], line["peer"], *texts]))
        heads = ["task", "data", "baseline", *(f"ratio, VTK {version}" for version in columns)]
        return markdown(heads, [line for _, line in sorted(lines, key=lambda one: one[0])])
