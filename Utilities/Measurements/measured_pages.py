# SPDX-License-Identifier: BSD-3-Clause
"""Pages from templates: words as they stand, and what stands in {{ }} from the measurements.

{{table NAME}} is a table of suites/, once for each VTK that its suite was run with, and its conditions;
{{claims SUITE}} what is wanted of a suite; {{value NAME}} a number in a sentence; {{record NAME}} a table or
paragraph of transcribed/; {{runs}} what was run when and where; {{counts}} how much of the page is measured;
{{readme}} the README's table; {{"text"}} is text: a setting or a name with digits, no measurement.
"""

import json
import re
from pathlib import Path

from measured_cells import seconds
from measured_rows import Results
from measured_tables import claims_table, markdown
from readme_table import readme_table
from suites import TABLES, VALUES

FIELD = re.compile(r"\{\{(.+?)\}\}")
README_BLOCK = re.compile(r"(<!-- measured: .*? -->\n).*?(<!-- /measured -->)", re.DOTALL)
# What is no prose: code, pictures, the targets of links, versions of programs.
NO_PROSE = re.compile(r"\{\{.*?\}\}|`[^`]*`|!\[[^\]]*\]\([^)]*\)|\]\([^)]*\)|\b(?:VTK|ParaView|Debian) [\d.]+")
MEASURED = re.compile(r"\d\.\d|\d ?%|\d\s?e-?\d|\d ?(?:s|ms|µs|MB|MiB|GB|GiB|times|million)\b")


def check_words(name, text):
    """A template has no measured number of its own."""
    for number, line in enumerate(text.splitlines(), 1):
        found = MEASURED.search(NO_PROSE.sub(" ", line))
        if found:
            raise ValueError(f"{name}:{number}: \"{found.group()}\" is typed by hand: {line.strip()}")


class Records:
    """What no program writes yet: tables and paragraphs, each with where it comes from."""

    def __init__(self, folder):
        self.records = {}
        for path in sorted(Path(folder).glob("*.json")):
            with open(path, encoding="utf-8") as file:
                section = json.load(file)
            if not section.get("transcribed"):
                raise ValueError(f"{path} does not say where it is transcribed from")
            for name, record in section["records"].items():
                self.records[f"{path.stem}.{name}"] = record

    def of(self, name):
        record = self.records[name]
        if "text" in record:
            return "\n".join(record["text"]) + " †"
        foot = "; ".join(filter(None, ["† transcribed", record["conditions"]]))
        return f"{markdown(record['columns'], record['rows'])}\n\n{foot}"


class Pages:
    """The texts of the pages, of the templates and measurements in `folder`."""

    def __init__(self, folder):
        self.folder = Path(folder)
        self.results = Results(folder)
        self.records = Records(self.folder / "transcribed")
        self.used = []

    def written(self, root):
        """By path: measurements.md, and the README with its block anew."""
        page = root / "Documentation" / "measurements.md"
        readme = root / "README.md"
        block = self.expanded("readme.in.md")
        old = readme.read_text(encoding="utf-8")
        if not README_BLOCK.search(old):
            raise ValueError(f"{readme} has no block <!-- measured: --> ... <!-- /measured -->")
        of_readme = self.used
        self.used = []
        text = self.expanded("page.in.md")
        unused = {f"record {name}" for name in self.records.records}
        unused -= {" ".join(field) for field in of_readme + self.used}
        if unused:
            raise ValueError(f"on no page: {', '.join(sorted(unused))}")
        return {page: text.replace("{{counts}}", self.counts()),
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
        if words == "counts":
            # Known when the page is whole.
            return "{{counts}}"
        kind, _, name = words.partition(" ")
        self.used.append((kind, name))
        makers = {"table": self.table, "claims": self.claims, "value": self.value, "record": self.records.of,
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
        return number(runs[0]) + (" †" if runs[0].transcribed else "") if runs else "(not measured)"

    def runs(self):
        lines = []
        for suite in self.results.suites():
            for run in self.results.of(suite):
                conditions = run.conditions
                missed = f"{sum(not claim['met'] for claim in run.claims)} of {len(run.claims)}" if run.claims else ""
                if run.transcribed:
                    lines.append([suite, run.version, "†", conditions["text"], "", missed])
                else:
                    lines.append([suite, run.version, f"`{run.command()}`",
                                  f"{conditions['date']}, {run.machine_text()}", seconds(run.took), missed])
        return markdown(["suite", "VTK", "command", "when and where", "took", "claims missed"], lines)

    def counts(self):
        """How much of the page is measured."""
        tables = [name for kind, name in self.used if kind == "table"]
        transcribed = sum(all(run.transcribed for run in self.results.of(TABLES[name].suite)) for name in tables)
        records = [self.records.records[name] for kind, name in self.used if kind == "record"]
        paragraphs = sum("text" in record for record in records)
        return (f"Tables made of rows that the program wrote: {len(tables) - transcribed}; of rows that were "
                f"transcribed: {transcribed}; tables transcribed as they were: {len(records) - paragraphs}; "
                f"paragraphs: {paragraphs}")
