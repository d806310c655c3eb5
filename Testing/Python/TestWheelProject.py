# SPDX-License-Identifier: BSD-3-Clause
"""pyproject.toml: what the standard and scikit-build-core ask for is there, one version of VTK stands in
all its places, and what it says of the sources is true of them."""

import re
import sys
from pathlib import Path

try:
    import tomllib
except ImportError:
    print("Python has no parser of TOML before 3.11")
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
check(build["build-backend"] == "scikit_build_core.build", "the backend is scikit-build-core's")
names = [re.match("[a-z-]+", requirement)[0] for requirement in build["requires"]]
check(names == ["scikit-build-core", "vtk", "vtk-sdk"], f"the build requires {names}")
pins = re.findall(r"\bvtk(?:-sdk)?==([0-9.]+)", " ".join(build["requires"] + about["dependencies"]))
check(len(pins) == 3 and len(set(pins)) == 1, f"one version of VTK, three times: {pins}")
check([int(part) for part in pins[0].split(".")] >= [9, 6, 0], f"VTK has wheels to build with from 9.6 on: {pins[0]}")

check(about["name"] == "interlume", "the name of the package")
check(about["dynamic"] == ["version"], "the version is that of CMakeLists.txt")
source = settings["metadata"]["version"]
found = re.search(source["regex"], (root / source["input"]).read_text())
check(found and found["value"] == version, f"the version {version} is found in {source['input']}")
for name in [about["readme"], *about["license-files"]]:
    check((root / name).is_file(), f"there is no file {name}")

check(settings["install"]["components"] == ["runtime", "python"], "the components of a wheel")
check(settings["wheel"]["packages"] == [], "nothing but what the build installs")
for name in settings["cmake"]["define"]:
    check(name == "BUILD_TESTING" or f"option({name} " in lists, f"CMakeLists.txt has no option {name}")

for failure in failures:
    print("FAILED:", failure)
sys.exit(bool(failures))
