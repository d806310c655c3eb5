# SPDX-License-Identifier: BSD-3-Clause
"""The rows that interlume-bench wrote, by suite and VTK version."""

import json
from pathlib import Path


def short_version(version):
    """9.1.0 as 9.1."""
    return ".".join(version.split(".")[:2])


class Run:
    """What one JSON says of one suite: its rows, its claims, and the conditions they were measured under."""

    def __init__(self, path, suite, results):
        self.path = path
        self.suite = suite
        self.version = short_version(results["vtk"])
        self.machine = results.get("machine", {})
        self.conditions = results.get("conditions", {})
        about = results.get("suites", {}).get(suite, {})
        self.claims = about.get("claims", [])
        self.took = about.get("took")
        self.rows = [row for row in results["rows"] if row["suite"] == suite]

    def select(self, **fields):
        """The rows whose fields are these; a field may be a function that tells."""
        def is_so(row):
            return all(wanted(row.get(name)) if callable(wanted) else row.get(name) == wanted
                       for name, wanted in fields.items())
        return [row for row in self.rows if is_so(row)]

    def machine_text(self):
        machine = self.machine
        return (f"{machine['cpu']}, {machine['cores']} cores, {machine['memory_gib']:.3g} GiB, {machine['smp']}, "
                f"{machine['compiler']} {machine['build']}")

    def conditions_text(self):
        """Where, when and how in one line, for a table's foot."""
        conditions = self.conditions
        load = f", load {conditions['load']} before" if "load" in conditions else ""
        devices = sorted({row["counts"]["device"] for row in self.rows if "device" in row.get("counts", {})})
        # Of what was put together of several runs each has its own.
        when = "; ".join(f"`{part['command']}`, {part['date']}"
                         + (f", load {part['load']} before" if "load" in part else "")
                         for part in conditions.get("parts", []))
        when = when or f"`{self.whole_command()}`, {conditions['date']}"
        return (f"VTK {self.version}, {when}, " + ", ".join([self.machine_text(), *devices])
                + f"{load}; {self.runs_text()}")

    def whole_command(self):
        return self.command() if "command" in self.conditions else f"interlume-bench {self.command()}"

    def command(self):
        """What interlume-bench was asked for; of another program the whole of its command."""
        if "command" in self.conditions:
            return self.conditions["command"]
        size = self.conditions["size"]
        return f"{self.suite}{'' if size == 'full' else ' --' + size} --threads {self.conditions['threads']}"

    def runs_text(self):
        """Of how many runs the times are medians."""
        numbers = sorted({row["runs"] for row in self.rows if "runs" in row})
        if not numbers:
            return "no times"
        if numbers == [1]:
            return "times of one run"
        words = " or ".join(str(number) for number in numbers if number > 1)
        return f"times are medians of {words} runs" + (", or of one where the table says" if 1 in numbers else "")


class Results:
    """Every run in the folders vtk-*/ of a folder."""

    def __init__(self, folder):
        self.runs = {}
        for path in sorted(Path(folder).glob("vtk-*/*.json")):
            with open(path, encoding="utf-8") as file:
                results = json.load(file)
            version = short_version(results["vtk"])
            if path.parent.name != f"vtk-{version}":
                raise ValueError(f"{path} is of VTK {version}")
            for suite in dict.fromkeys(row["suite"] for row in results["rows"]):
                if (suite, version) in self.runs:
                    raise ValueError(f"{path}: {suite} of VTK {version} has another file, "
                                     f"{self.runs[suite, version].path.name}")
                self.runs[suite, version] = Run(path, suite, results)

    def versions(self, suite=None):
        """Those of VTK that there are runs with, the oldest first."""
        found = {version for name, version in self.runs if suite in (None, name)}
        return sorted(found, key=lambda version: [int(part) for part in version.split(".")])

    def suites(self):
        return list(dict.fromkeys(suite for suite, version in self.runs))

    def of(self, suite):
        """The runs of a suite, the oldest VTK first."""
        return [self.runs[suite, version] for version in self.versions(suite)]


def split_report(path, folder):
    """Writes a JSON for each suite of that of a report, into the folder of its VTK."""
    with open(path, encoding="utf-8") as file:
        results = json.load(file)
    target = Path(folder) / f"vtk-{short_version(results['vtk'])}"
    target.mkdir(parents=True, exist_ok=True)
    for suite, about in results["suites"].items():
        one = dict(results, suites={suite: about}, rows=[row for row in results["rows"] if row["suite"] == suite])
        with open(target / f"{suite}.json", "w", encoding="utf-8") as file:
            file.write(json.dumps(one, indent=1, ensure_ascii=False) + "\n")
