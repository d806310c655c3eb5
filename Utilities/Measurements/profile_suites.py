#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""profile_suites.py PROGRAM [SUITE...]: profiles the benchmark rows that miss their targets.

PROGRAM is interlume-bench, which reports when each measured run began and ended. perf samples it meanwhile. The
fractions of the samples in a row's runs are written to Documentation/measurements/vtk-*/profiles.json, which keeps the
profiles of other suites. The script requires a display and perf.
"""

import argparse
import bisect
import json
import re
import subprocess
import sys
import tempfile
from collections import Counter
from pathlib import Path

from results import short_version

# By suite: samples per second, and the rows to be profiled, by case, method and parameter.
PROFILED = {
    "interval": (10000, [("bonsai-low", "drag", "2 threads"), ("bonsai-low", "drag-tied", "2 threads"),
                        ("head-ct-256-low", "drag", "2 threads"), ("disk-out", "interval-volume", "1 thread"),
                        ("disk-out", "interval-volume", "2 threads"), ("head-ct", "interval-volume", "2 threads")]),
    "contour": (20000, [("head-ct", "isotable-hexahedra-unmerged", "1 thread"),
                        ("disk-out", "isotable-hexahedra-unmerged", "1 thread"),
                        ("disk-out", "isotable-hexahedra", "1 thread")]),
    "interval4d": (4000, [("vortex-2", "warm", "2 threads"), ("wave", "slice-again", None),
                          ("ball", "slice-again", None)]),
    "tetrahedra": (1000, [("gyroid-0.3M", "opengl", "composite"),
                          ("gyroid-0.3M", "software", "composite"),
                          ("gyroid-2M", "software", "composite"),
                          ("gyroid-8M", "software", "composite")]),
    "shadows": (500, [("bonsai-256x256x128", "shadows-off", 1), ("bonsai-256x256x128", "shadows", 1),
                      ("bonsai-256x256x256", "shadows-off", 1), ("bonsai-256x256x256", "shadows", 1)]),
}
SAMPLE = re.compile(r"^\s*(?P<time>[\d.]+):\s+[0-9a-f]+ (?P<symbol>.*) \((?P<library>[^()]*)\)$")
OWN = re.compile(r"interlume::((?:\w+::)*\w+)")
# Libraries that are not part of this project: prefix of the file name, and name in the profile.
LIBRARIES = (("libgallium", "OpenGL"), ("libGL", "OpenGL"), ("swrast", "OpenGL"), ("libLLVM", "OpenGL"),
             ("libvtk", "VTK"), ("libtbb", "TBB"), ("libX", "X"), ("libxcb", "X"))


def plain(symbol):
    """Returns the name of a function without its arguments, templates and namespaces."""
    depth = 0
    out = ""
    for letter in symbol.replace("(anonymous namespace)::", "").replace("interlume::", ""):
        if letter == "(" and depth == 0:
            break
        depth += (letter == "<") - (letter == ">")
        if depth == 0 and letter != ">":
            out += letter
    # The return type of a template precedes its name.
    return out.strip().split(" ")[-1]


def name_of(symbol, library):
    """Returns the name a sample is counted under: Interlume's functions by name, others by library."""
    file = library.rsplit("/", 1)[-1]
    if "kernel" in library:
        return "kernel (pages)" if "clear_page" in symbol or "zero_user" in symbol else "kernel"
    for beginning, name in LIBRARIES:
        if file.startswith(beginning):
            return name
    if file.startswith(("libInterlume", "interlume-bench")):
        own = OWN.search(symbol.replace("(anonymous namespace)::", ""))
        # vtkSMPTools functors are counted as the function that contains them.
        return own.group(1) if own and not symbol.startswith("interlume::") else plain(symbol)
    if file.startswith(("libc.", "libm.", "libstdc++", "ld-")):
        return "C library" + (" (memory)" if re.search("mem(cpy|move|set)", symbol) else "")
    return "compiled shaders" if "anon" in library or symbol == "[unknown]" else file


def read_samples(lines):
    """Returns the times and names of samples printed by `perf script`, in time order."""
    samples = []
    for line in lines:
        match = SAMPLE.match(line.rstrip("\n"))
        if match:
            samples.append((float(match["time"]), name_of(match["symbol"], match["library"])))
    return sorted(samples)


def shares(samples, spans):
    """Returns the number of samples in the spans, and each name's fraction of them, in descending order."""
    times = [time for time, name in samples]
    found = Counter()
    for begin, end in spans:
        for time, name in samples[bisect.bisect_left(times, begin):bisect.bisect_right(times, end)]:
            found[name] += 1
    total = sum(found.values())
    return total, {name: round(number / total, 4) for name, number in found.most_common()}


def profile(program, suite, folder):
    """Runs a suite under perf and returns its results and the samples."""
    rows = folder / "rows.json"
    data = folder / "perf.data"
    subprocess.run(["perf", "record", "--quiet", "--clockid", "CLOCK_MONOTONIC", "--freq", str(PROFILED[suite][0]),
                    "--output", data, "--", program, suite, "--threads", "2", "--spans", "--json", rows],
                   check=True)
    results = json.loads(rows.read_text(encoding="utf-8"))
    with subprocess.Popen(["perf", "script", "--input", data, "--fields", "time,ip,sym,dso"],
                          stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True) as script:
        return results, read_samples(script.stdout)


def profiled_rows(suite, results, samples):
    """Returns a profile row for each profiled row of a suite.

    A row has the same spans for each of its baselines, so the first match is used.
    """
    made = []
    for case, method, parameter in PROFILED[suite][1]:
        row = next((row for row in results["rows"] if (row["case"], row["method"]) == (case, method)
                    and row.get("parameter") == parameter), None)
        if row is None:
            raise ValueError(f"{suite} has no row {case}, {method}, {parameter}; correct PROFILED")
        number, found = shares(samples, row["spans"])
        made.append({"suite": "profiles", "case": f"{suite}: {case}", "method": method, "parameter": parameter,
                     "counts": {"samples": number, "shares": found}})
    return made


def joined(suite, before, results, samples):
    """Merges new profiles of one suite into the profiles of all suites, each with its date and load."""
    def of_others(case):
        return not case.startswith(suite + ":")

    def position(case):
        return list(PROFILED).index(case.split(":")[0])

    name = Path(__file__).name
    rows = [row for row in before["rows"] if of_others(row["case"])] + profiled_rows(suite, results, samples)
    parts = [part for part in before["conditions"].get("parts", []) if part["command"].split(" ")[-1] != suite]
    parts.append({"command": f"{name} interlume-bench {suite}", "date": results["conditions"]["date"],
                  "load": results["conditions"]["load"]})
    conditions = {**results["conditions"], "command": f"{name} interlume-bench",
                  "parts": sorted(parts, key=lambda part: position(part["command"].split(" ")[-1]))}
    return {**results, "conditions": conditions, "suites": {"profiles": {}},
            "rows": sorted(rows, key=lambda row: position(row["case"]))}


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("program", type=Path, help="interlume-bench")
    parser.add_argument("suites", nargs="*", help="default: all of " + ", ".join(PROFILED), metavar="SUITE")
    arguments = parser.parse_args()
    measurements = Path(__file__).resolve().parents[2] / "Documentation" / "measurements"
    for suite in arguments.suites or PROFILED:
        if suite not in PROFILED:
            raise ValueError(f"PROFILED has no row of {suite}; choose from {', '.join(PROFILED)}")
        with tempfile.TemporaryDirectory() as folder:
            results, samples = profile(arguments.program.resolve(), suite, Path(folder))
        path = measurements / f"vtk-{short_version(results['vtk'])}" / "profiles.json"
        before = json.loads(path.read_text(encoding="utf-8")) if path.exists() else {"rows": [], "conditions": {}}
        path.write_text(json.dumps(joined(suite, before, results, samples), indent=1, ensure_ascii=False) + "\n",
                        encoding="utf-8")


if __name__ == "__main__":
    try:
        main()
    except (ValueError, FileNotFoundError, subprocess.CalledProcessError) as error:
        sys.exit(f"profile_suites.py: {error}")
