# SPDX-License-Identifier: BSD-3-Clause
"""Tests pyproject.toml: it has the entries required by the standard and scikit-build-core, the same version of
VTK everywhere, and correct statements about the sources.
"""

import re
import sys
from pathlib import Path

try:
    import tomllib
except ImportError:
    print("Skipped: the test needs the TOML parser of Python 3.11")
    sys.exit(77)

root = Path(sys.argv[1])
version = sys.argv[2]
project = tomllib.loads((root / "pyproject.toml").read_text())
lists = (root / "CMakeLists.txt").read_text()
failures = []


def check(condition, text):
    if not condition:
        failures.append(text)


build, about, settings = project["build-system"], project["project"], project["tool"]["scikit-build"]
check(build["build-backend"] == "scikit_build_core.build", "the build backend is scikit_build_core")
names = [re.match("[a-z-]+", requirement)[0] for requirement in build["requires"]]
check(names == ["scikit-build-core", "vtk", "vtk-sdk"], f"the build requires scikit-build-core, vtk and vtk-sdk, not {names}")
pins = re.findall(r"\bvtk(?:-sdk)?==([0-9.]+)", " ".join(build["requires"] + about["dependencies"]))
check(len(pins) == 3 and len(set(pins)) == 1, f"VTK is pinned three times to one version: {pins}")
check([int(part) for part in pins[0].split(".")] >= [9, 6, 0], f"VTK is pinned to 9.6 or later, which has wheels for building: {pins[0]}")

check(about["name"] == "interlume", "the package is named interlume")
check(about["dynamic"] == ["version"], "the version is dynamic")
source = settings["metadata"]["version"]
found = re.search(source["regex"], (root / source["input"]).read_text())
check(found and found["value"] == version, f"the version {version} is found in {source['input']}")
for name in [about["readme"], *about["license-files"]]:
    check((root / name).is_file(), f"the file {name} exists")

check(settings["install"]["components"] == ["runtime", "python"], "a wheel has the components runtime and python")
check(settings["wheel"]["packages"] == [], "a wheel has only installed files")
for name in settings["cmake"]["define"]:
    check(name == "BUILD_TESTING" or f"option({name} " in lists, f"CMakeLists.txt has the option {name}")

for failure in failures:
    print("FAILED:", failure)
sys.exit(bool(failures))
