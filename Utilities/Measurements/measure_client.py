#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""measure_client.py [--json FILE] [--off] [USE...]: measures how the ParaView client answers a user.

Each use of client_uses.py runs in a new client on a separate display, with mouse events. The client and the plugin are
those of the environment variables INTERLUME_CLIENT and INTERLUME_PLUGIN, which Utilities/bench-with-paraview --client
sets. Prints the rows and writes them to FILE.
"""

import argparse
import datetime
import json
import os
import platform
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "Testing" / "ParaView"))

from newcomer_client import display, started  # noqa: E402

SCREEN = "1451x981"  # The view then has 1143 x 746 pixels in ParaView 5.11.
SECONDS = 1800  # Time limit of a use on a busy machine.
USES = ("time-24x64", "intervals-6M", "intervals-8M", "select-1M", "slices-256x256x128", "slices-256", "slices-64",
        "slices-21")


def measure(use, detail, folder, seconds):
    """Returns the rows of a use. A client that exceeds the time limit is ended; its rows so far are returned."""
    home = folder / "home"
    shutil.rmtree(home, ignore_errors=True)
    home.mkdir(mode=0o700)
    rows = folder / "rows.jsonl"
    rows.write_text("")
    client, plugin = os.environ["INTERLUME_CLIENT"], os.environ["INTERLUME_PLUGIN"]
    command = [client, "--dr", "--plugins", "Interlume", f"--plugin-search-paths={os.path.dirname(plugin)}",
               f"--script={Path(__file__).with_name('client_uses.py')}"]
    with display(SCREEN, str(home), subprocess.DEVNULL) as screen:
        environment = {
            **os.environ, "DISPLAY": screen, "HOME": str(home), "XDG_RUNTIME_DIR": str(home),
            "LIBGL_ALWAYS_SOFTWARE": "1", "INTERLUME_USE": use, "INTERLUME_DETAIL": detail, "INTERLUME_ROWS": str(rows),
            "INTERLUME_DATA": str(ROOT / "Data"), "INTERLUME_DRAG": str(Path(__file__).with_name("drag.py"))}
        with started(command, env=environment, cwd=home) as process:
            try:
                status = process.wait(seconds)
            except subprocess.TimeoutExpired:
                status = f"none after {seconds} s"
    if status != 0:
        print(f"{use}, {detail}: the client's exit status is {status}", file=sys.stderr)
    return [json.loads(line) for line in rows.read_text().splitlines()]


def print_row(row):
    fields = [f"{row.get(name, 0):8.2f}" for name in (
        "first_seconds", "still_seconds", "frames", "processor_seconds", "longest_seconds")]
    print(f"{row['case']:20}{row['method']:18}{row['parameter']:5}", *fields, flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("--json", type=Path, help="file for the rows")
    parser.add_argument("--off", action="store_true", help="also measure without levels of detail")
    parser.add_argument("--seconds", type=int, default=SECONDS, help="time limit of a use")
    parser.add_argument("uses", nargs="*", metavar="USE", help=", ".join(USES))
    arguments = parser.parse_args()
    rows = []
    print(f"{'use':20}{'method':18}{'LOD':5}    first    still   frames    drag, s longest", flush=True)
    with tempfile.TemporaryDirectory() as folder:
        for use in arguments.uses or USES:
            for detail in ("on", "off") if arguments.off else ("on",):
                found = measure(use, detail, Path(folder), arguments.seconds)
                rows += found
                for row in found:
                    print_row(row)
    if arguments.json:
        results = {
            "machine": {"cpu": platform.machine(), "cores": os.cpu_count()},
            "vtk": "9.2.0",
            "conditions": {"date": str(datetime.date.today()), "size": "full", "threads": os.cpu_count(),
                           "command": "Utilities/bench-with-paraview --client"},
            "rows": rows}
        arguments.json.write_text(json.dumps(results, indent=1) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
