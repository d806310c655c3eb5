# SPDX-License-Identifier: BSD-3-Clause
"""Renders the images of Documentation/guide/paraview.md: the client's window after some uses.

Arguments: the output directory, Documentation/pictures/guide, and optional names of images. Needs ImageMagick in
addition to the requirements of TestNewcomer.py, and the same environment: run ninja guide-pictures in the build of
the plugin. The images have the names of the filters, whose help pages show them.
"""

import os
import sys
import tempfile

from newcomer_client import play, python
from newcomer_uses import applied, drawn_as, opened

SECONDS = 400


def seen_from(position, up):
    """Sets a camera that shows all data from the given direction."""
    return python(f"from paraview.simple import *; view = GetActiveView(); "
                  f"view.CameraPosition, view.CameraFocalPoint = {position}, [0, 0, 0]; "
                  f"view.CameraViewUp = {up}; ResetCamera(view); Render(view)")


def shot(path):
    """Saves an image of the full window, which the test player has already rendered completely."""
    return python(f"import os; os.system({'import -window root -strip PNG24:' + path!r})")


def pictures():
    """Returns the gestures that precede each image."""
    disk = opened("disk_out_ref.vtu")
    return {
        "IntervalVolume": disk + applied("IntervalVolume"),
        "IsotableContour": opened("tooth.vti") + applied("IsotableContour"),
        "ShadowedSlices": opened("bonsai.vti") + drawn_as("Shadowed Slices"),
        "TimeVaryingIntervalVolume": opened("mug.ex2") + applied("TimeVaryingIntervalVolume"),
        "FlowVolume": disk + applied("ImplicitFlowField", "InflowMapping", "FlowVolume"),
        "TetrahedralMesher": disk + applied("TetrahedralMesher") + drawn_as("Surface With Edges"),
    }


def gestures(folder, names):
    yield python("import newcomer_record; newcomer_record.set_progressive(0)")
    for name, steps in pictures().items():
        if names and name not in names:
            continue
        yield from steps
        # The trunk of the bonsai is along y.
        yield seen_from(*([0.5, 0.3, 1], [0, 1, 0]) if name == "ShadowedSlices" else
                        ([0.4, -1, 0.5], [0, 0, 1]))
        yield shot(os.path.join(folder, name + ".png"))
        yield python("newcomer_record.reset()")


def main():
    folder = os.path.realpath(sys.argv[1])
    os.makedirs(folder, exist_ok=True)
    with tempfile.TemporaryDirectory() as scratch:
        status, log = play(gestures(folder, sys.argv[2:]), scratch, "guide", SECONDS, size="1200x800")
    print("\n".join(log))
    sys.exit(0 if status == 0 else 1)


if __name__ == "__main__":
    main()
