# SPDX-License-Identifier: BSD-3-Clause
"""Tests that the package has every public class, wrapped by VTK, with the documentation of its header, and
with type hints if VTK writes them. Classes that are not abstract must be creatable and accept settings.
The argument is the project directory.
"""

import ast
import re
import sys
from importlib.util import find_spec
from pathlib import Path

import interlume
from interlume import InterlumeIntervals
from vtkmodules.vtkCommonCore import vtkObject, vtkVersion

source = Path(sys.argv[1])
# Scene has no public classes, and Meshing needs TetGen.
excluded = {"Scene"}
if not hasattr(interlume, "vtkTetrahedralMesher"):
    excluded.add("Meshing")

hinted = {
    node.name
    for hints in Path(interlume.__file__).parent.glob("*.pyi")
    for node in ast.parse(hints.read_text(encoding="utf-8")).body
    if isinstance(node, ast.ClassDef)
}
with_hints = find_spec("vtkmodules.generate_pyi") is not None

declared = re.compile(r"^(?:class|struct) INTERLUME\w+_EXPORT (vtk\w+)\s*(?::|$)", re.MULTILINE)
classes = 0
for header in sorted([*source.glob("Filters/*/vtk*.h"), *source.glob("Rendering/*/vtk*.h")]):
    if excluded & {header.parent.name, header.stem}:
        continue
    text = header.read_text(encoding="utf-8")
    for name in declared.findall(text):
        wrapped = getattr(interlume, name, None)
        assert isinstance(wrapped, type), f"{name} is not wrapped"
        brief = re.search(rf"@class +{name}\s.*?@brief +(\w+)", text, re.DOTALL)
        assert not brief or brief[1] in wrapped.__doc__, f"{name} does not have the documentation of its header"
        assert name in hinted or not with_hints, f"{name} has no type hints"
        if issubclass(wrapped, vtkObject) and f"static {name}* New();" in text:
            instance = wrapped()
            assert instance.IsA(name) and str(instance), f"{name} cannot be created"
        classes += 1
assert classes > 50, classes
assert InterlumeIntervals.vtkIntervalVolume is interlume.vtkIntervalVolume

intervals = interlume.vtkIntervalVolume()
intervals.SetInterval(1, 2.0, 3.0)
assert intervals.GetNumberOfIntervals() == 2
assert intervals.LOWER_SIDE != intervals.UPPER_SIDE
mapper = interlume.vtkTimeWeightedTetrahedraMapper()
mapper.SetSortMode(mapper.MPVONC_SORT)
assert mapper.GetSortMode() == mapper.MPVONC_SORT != 0
# Python properties, if this version of VTK creates them.
if hasattr(mapper, "blend_mode"):
    intervals.generate_boundaries = True
    assert intervals.GetGenerateBoundaries()
print(f"{classes} classes, {len(hinted)} with type hints, of {vtkVersion.GetVTKVersion()}")
