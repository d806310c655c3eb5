#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""time_commands.py: measures the README's command for a first look.

Each command runs in a new clone of HEAD, without ccache. Writes the processor time, in minutes, to
Documentation/measurements/vtk-VERSION/commands.json. Divide it by the number of cores for the time on an idle machine.
Downloads take no processor time and are not included.
"""

import datetime
import json
import os
import resource
import subprocess
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
COMMANDS = ("Utilities/demo --scene bonsai",)


def children_seconds():
    usage = resource.getrusage(resource.RUSAGE_CHILDREN)
    return usage.ru_utime + usage.ru_stime


def measure(command):
    """Returns the row of a command."""
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run(["git", "clone", "-q", ROOT, folder], check=True)
        before = children_seconds()
        subprocess.run(command.split(), cwd=folder, env={**os.environ, "CCACHE_DISABLE": "1"}, check=True)
        minutes = (children_seconds() - before) / 60
    return {"suite": "commands", "case": command, "minutes": round(minutes, 1), "runs": 1}


def output_of(*command):
    return subprocess.run(command, capture_output=True, text=True, check=True).stdout.strip()


def main():
    rows = [measure(command) for command in COMMANDS]
    version = output_of("dpkg-query", "-W", "-f", "${source:Upstream-Version}", "libvtk9-dev").split("+")[0]
    results = {
        "machine": {"cpu": output_of("uname", "-m"), "cores": os.cpu_count(),
                    "compiler": "gcc " + output_of("g++", "-dumpfullversion"), "build": "Release"},
        "vtk": version,
        "conditions": {"date": str(datetime.date.today()), "size": "full", "threads": os.cpu_count(),
                       "command": "Utilities/Measurements/time_commands.py"},
        "rows": rows,
    }
    path = ROOT / "Documentation" / "measurements" / f"vtk-{'.'.join(version.split('.')[:2])}" / "commands.json"
    path.write_text(json.dumps(results, indent=1) + "\n", encoding="utf-8")
    print(path)


if __name__ == "__main__":
    main()
