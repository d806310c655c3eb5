# SPDX-License-Identifier: BSD-3-Clause
"""Rows written by interlume-bench, by suite and VTK version."""

import json
from pathlib import Path


def short_version(version):
    """Shortens a version: 9.1 for 9.1.0."""
    return ".".join(version.split(".")[:2])


def matches(value, expected):
    """Compares a value with the expected one; a tuple lists several accepted values."""
    return value in expected if isinstance(expected, tuple) else value == expected


class Run:
    """Rows and targets of one suite in one JSON file, and the conditions of the measurement."""

    def __init__(self, path, suite, results):
        about = results.get("suites", {}).get(suite, {})
        self.path = path
        self.suite = suite
        self.version = short_version(results["vtk"])
        self.machine = results["machine"]
        self.conditions = results["conditions"]
        self.targets = [one for one in about.get("claims", []) if one["cases"]]
        self.rows = [row for row in results["rows"] if row["suite"] == suite]

    def select(self, **fields):
        return [row for row in self.rows
                if all(matches(row.get(name), expected) for name, expected in fields.items())]

    def machine_text(self):
        machine = self.machine
        memory = f"{machine['memory_gib']:.3g} GiB" if "memory_gib" in machine else None
        built = f"{machine['compiler']} {machine['build']}" if "compiler" in machine else None
        return ", ".join(filter(None, [machine["cpu"], f"{machine['cores']} cores", memory, machine.get("smp"), built]))

    def command(self):
        conditions = self.conditions
        if "command" in conditions:
            first, *more = conditions["command"].split("; ")
            return first + (" …" if more else "")
        size = "" if conditions["size"] == "full" else f" --{conditions['size']}"
        threads = "" if conditions["threads"] == self.machine["cores"] else f" --threads {conditions['threads']}"
        return self.suite + size + threads

    def when(self):
        """Returns the date, and the load before the run or its parts."""
        loads = [part["load"] for part in self.conditions.get("parts", [self.conditions]) if "load" in part]
        load = " to ".join(dict.fromkeys(map(str, (min(loads), max(loads))))) if loads else ""
        return f"[{self.conditions['date']}](measurements/vtk-{self.version}/{self.path.name})" + (
            f", {load}" if load else "")


class Results:
    """All runs in the directories vtk-*/ of a directory."""

    def __init__(self, folder):
        self.runs = {}
        for path in sorted(Path(folder).glob("vtk-*/*.json")):
            results = json.loads(path.read_text(encoding="utf-8"))
            version = short_version(results["vtk"])
            if path.parent.name != f"vtk-{version}":
                raise ValueError(f"{path} is of VTK {version}; move it to the directory vtk-{version}")
            for suite in dict.fromkeys(row["suite"] for row in results["rows"]):
                if (suite, version) in self.runs:
                    raise ValueError(f"{path}: {suite} of VTK {version} is also in "
                                     f"{self.runs[suite, version].path.name}; remove one of them")
                self.runs[suite, version] = Run(path, suite, results)

    def versions(self):
        """Returns the VTK versions, oldest first."""
        return sorted({version for suite, version in self.runs},
                      key=lambda version: [int(part) for part in version.split(".")])

    def suites(self):
        return sorted({suite for suite, version in self.runs})

    def of(self, suite):
        """Returns the runs of a suite, oldest VTK first."""
        return [self.runs[suite, version] for version in self.versions() if (suite, version) in self.runs]


def split_report(path, folder):
    """Splits the JSON file of a report into one file per suite, in the directory of its VTK version."""
    results = json.loads(Path(path).read_text(encoding="utf-8"))
    target = Path(folder) / f"vtk-{short_version(results['vtk'])}"
    target.mkdir(parents=True, exist_ok=True)
    for suite, about in results["suites"].items():
        one = dict(results, suites={suite: about}, rows=[row for row in results["rows"] if row["suite"] == suite])
        (target / f"{suite}.json").write_text(json.dumps(one, indent=1, ensure_ascii=False) + "\n", encoding="utf-8")
