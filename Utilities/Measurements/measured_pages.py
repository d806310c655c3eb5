# SPDX-License-Identifier: BSD-3-Clause
"""Pages from templates: words as they stand, and what stands in {{ }} from the measurements.

{{table NAME}} is a table of suites/, once for each VTK that its suite was run with, and its conditions;
{{claims SUITE}} what is wanted of a suite; {{value NAME}} a number in a sentence; {{runs}} what was run when and where;
{{readme}} the README's table; {{"text"}} is text: a setting or a name with digits, no measurement.
"""

import re
from pathlib import Path

from measured_cells import NOTHING, seconds
from measured_rows import Results
from measured_tables import claims_table, markdown
from readme_table import readme_table
from suites import TABLES, VALUES

FIELD = re.compile(r"\{\{(.+?)\}\}")
README_BLOCK = re.compile(r"(<!-- measured: .*? -->\n).*?(<!-- /measured -->)", re.DOTALL)
# What is no prose: code, pictures, the targets of links, versions of programs.
NO_PROSE = re.compile(r"\{\{.*?\}\}|`[^`]*`|!\[[^\]]*\]\([^)]*\)|\]\([^)]*\)|\b(?:VTK|ParaView|Debian) [\d.]+")
# The parts of the README that commands write, and code.
NOT_TYPED = re.compile(r"<!-- (versions|measured).*?<!-- (?:end of |/)\1 -->|```.*?```", re.DOTALL)
MEASURED = re.compile(r"\d\.\d|\d ?%|\d\s?e-?\d|\d ?(?:s|ms|µs|MB|MiB|GB|GiB|times|million)\b")


def check_words(name, text):
    """Raises ValueError if prose has a measured number, which no command would update."""
    for number, line in enumerate(text.splitlines(), 1):
        found = MEASURED.search(NO_PROSE.sub(" ", line))
        if found:
            raise ValueError(f"{name}:{number}: \"{found.group()}\" is typed by hand: {line.strip()}")


class Pages:
    """The texts of the pages, of the templates and measurements in `folder`."""

    def __init__(self, folder):
        self.folder = Path(folder)
        self.results = Results(folder)

    def written(self, root):
        """By path: measurements.md, and the README with its block anew."""
        page = root / "Documentation" / "measurements.md"
        readme = root / "README.md"
        block = self.expanded("readme.in.md")
        old = readme.read_text(encoding="utf-8")
        if not README_BLOCK.search(old):
            raise ValueError(f"{readme} has no block <!-- measured: --> ... <!-- /measured -->")
        check_words(readme, NOT_TYPED.sub(lambda found: "\n" * found.group().count("\n"), old))
        return {page: self.expanded("page.in.md"),
                readme: README_BLOCK.sub(lambda found: found.group(1) + block + found.group(2), old)}

    def expanded(self, name):
        text = (self.folder / name).read_text(encoding="utf-8")
        check_words(self.folder / name, text)
        text = FIELD.sub(lambda found: self.field(found.group(1)), text)
        # A field may have nothing to say.
        return re.sub(r"\n{3,}", "\n\n", text)

    def field(self, words):
        if words.startswith('"'):
            return words.strip('"')
        kind, _, name = words.partition(" ")
        makers = {"table": self.table, "claims": self.claims, "value": self.value,
                  "runs": lambda nothing: self.runs(), "readme": lambda nothing: readme_table(self.results)}
        if kind not in makers:
            raise ValueError(f"{{{{{words}}}}} is unknown")
        try:
            return makers[kind](name)
        except KeyError as missing:
            raise ValueError(f"{{{{{words}}}}}: there is no {missing}") from missing

    def table(self, name):
        table = TABLES[name]
        made = [(run, table.of(run)) for run in self.results.of(table.suite)]
        texts = [f"{text}\n\n{run.conditions_text()}" for run, text in made if text]
        return "\n\n".join(texts) if texts else f"`interlume-bench {table.suite}` has not been run for this yet."

    def claims(self, suite):
        made = [(run, claims_table(run)) for run in self.results.of(suite)]
        return "\n\n".join(f"Wanted, VTK {run.version}:\n\n{text}" for run, text in made if text)

    def value(self, name):
        suite, number = VALUES[name]
        runs = self.results.of(suite)
        return number(runs[0]) if runs else "(not measured)"

    def runs(self):
        lines = []
        for suite in self.results.suites():
            for run in self.results.of(suite):
                conditions = run.conditions
                missed = f"{sum(not claim['met'] for claim in run.claims)} of {len(run.claims)}" if run.claims else ""
                took = seconds(run.took) if run.took else NOTHING
                lines.append([suite, run.version, f"`{run.command()}`",
                              f"{conditions['date']}, {run.machine_text()}", took, missed])
        return markdown(["suite", "VTK", "command", "when and where", "took", "claims missed"], lines)
