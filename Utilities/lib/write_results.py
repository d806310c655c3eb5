# SPDX-License-Identifier: BSD-3-Clause
"""write_results.py FILE LOGS COMPILER RUN...: writes the results of ctest runs as JSON: date, system, compiler,
and for each RUN (name:directory:version) the tests that passed, failed and were skipped, in total and with the
label image. LOGS is the directory with the output of each run, test-<name>.log.
"""

import datetime
import json
import platform
import re
import subprocess
import sys
from pathlib import Path

RESULT = re.compile(r"^ *\d+/\d+ Test +#\d+: (\S+) \.* *(.*?) +[\d.]+ sec", re.MULTILINE)


def find_image_tests(folder):
    """Returns the names of the tests with the label image."""
    listing = subprocess.run(["ctest", "--test-dir", folder, "-L", "image", "--show-only=json-v1"],
                             capture_output=True, check=True).stdout
    return {test["name"] for test in json.loads(listing)["tests"]}


def read_run(logs, name, folder, version):
    results = dict(RESULT.findall(Path(logs, f"test-{name}.log").read_text(errors="replace")))
    skipped = sorted(test for test, result in results.items() if "Skipped" in result)
    failed = sorted(test for test, result in results.items() if result != "Passed" and test not in skipped)
    images = find_image_tests(folder) & results.keys()
    return {"name": name, "version": version, "passed": len(results) - len(failed) - len(skipped), "failed": failed,
            "skipped": skipped, "pictures": len(images), "pictures passed": len(images - {*failed, *skipped})}


def main(target, logs, compiler, *runs):
    results = {"date": datetime.date.today().isoformat(),
               "system": platform.freedesktop_os_release()["PRETTY_NAME"], "compiler": compiler,
               "runs": [read_run(logs, *run.split(":")) for run in runs]}
    Path(target).write_text(json.dumps(results, indent=1) + "\n")


main(*sys.argv[1:])
