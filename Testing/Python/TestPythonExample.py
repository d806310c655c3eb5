# SPDX-License-Identifier: BSD-3-Clause
"""TestPythonExample.py LINES EXAMPLE.py IMAGE.png EXPECTED.png [ARGUMENT...]

Tests that an example of at most LINES lines reproduces the image that C++ rendered with this build: a scene of
the gallery, which another test compares with its baseline, or a program of the guide. The arguments are passed
to the example.
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


example, image, expected = map(Path, sys.argv[2:5])
lines = len(example.read_text(encoding="utf-8").splitlines())
assert lines <= int(sys.argv[1]), f"{example.name} has {lines} lines, more than {sys.argv[1]}"
image.unlink(missing_ok=True)
sys.argv = [str(example), *sys.argv[5:]]
sys.path.insert(0, str(example.parent))
runpy.run_path(str(example), run_name="__main__")
difference = np.abs(read_pixels(image) - read_pixels(expected))
assert not difference.any(), (
    f"{np.count_nonzero(difference.max(1))} pixels differ, by up to {difference.max()}")
