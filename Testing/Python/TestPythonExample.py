# SPDX-License-Identifier: BSD-3-Clause
"""An example of so many lines at most draws the bytes that C++ has drawn with this build: the gallery's scene
of the same name, whose own test has compared it with its baseline, or the program of a page of the guide.

TestPythonExample.py LINES EXAMPLE.py PICTURE.png EXPECTED.png [ARGUMENT of the example before its picture]
"""

import runpy
import sys
from pathlib import Path

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader


def read_pixels(path):
    reader = vtkPNGReader()
    reader.SetFileName(str(path))
    reader.Update()
    return vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars()).astype(int)


example, picture, expected = map(Path, sys.argv[2:5])
lines = len(example.read_text(encoding="utf-8").splitlines())
assert lines <= int(sys.argv[1]), f"{example.name} has {lines} lines"
picture.unlink(missing_ok=True)
sys.argv = [str(example), *sys.argv[5:], str(picture)]
sys.path.insert(0, str(example.parent))
runpy.run_path(str(example), run_name="__main__")
difference = np.abs(read_pixels(picture) - read_pixels(expected))
assert not difference.any(), (
    f"{np.count_nonzero(difference.max(1))} pixels differ, by up to {difference.max()}")
