# SPDX-License-Identifier: BSD-3-Clause
"""An example's picture has the bytes of the gallery's scene of the same name, which the scene's own
test has drawn with this build and compared with its baseline.

TestPythonExample.py EXAMPLE.py PICTURE.png SCENE.png
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


example, picture, scene = map(Path, sys.argv[1:])
lines = len(example.read_text(encoding="utf-8").splitlines())
assert lines <= 40, f"{example.name} has {lines} lines"
picture.unlink(missing_ok=True)
sys.argv = [str(example), str(picture)]
sys.path.insert(0, str(example.parent))
runpy.run_path(str(example), run_name="__main__")
difference = np.abs(read_pixels(picture) - read_pixels(scene))
assert not difference.any(), (
    f"{np.count_nonzero(difference.max(1))} pixels differ, by up to {difference.max()}")
