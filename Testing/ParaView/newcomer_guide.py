# SPDX-License-Identifier: BSD-3-Clause
"""Makes the pictures of Documentation/guide/paraview.md: the client's window after some of the uses.

Arguments: the folder of the pictures, Documentation/pictures/guide, and names to make these only. Needs ImageMagick besides what
TestNewcomer.py needs, and the same environment: ninja guide-pictures in the build of the plugin. The
pictures are named after the filters, whose help pages show them.
"""

import os
import sys
import tempfile

from newcomer_client import play, python
from newcomer_uses import applied, drawn_as, opened

SECONDS = 400
SHOT = "import -window root -resize 800x +dither -colors 64 -strip"


def seen_from(position, up):
    """A camera that shows depth, from a direction, over the whole."""
    return python(f"from paraview.simple import *; view = GetActiveView(); "
                  f"view.CameraPosition, view.CameraFocalPoint = {position}, [0, 0, 0]; "
                  f"view.CameraViewUp = {up}; ResetCamera(view); Render(view)")


def shot(path):
    """The whole window in a file. The test player has drawn it by then."""
    return python(f"import os; os.system({SHOT + ' PNG8:' + path!r})")


def pictures():
    """For each picture what is done before it."""
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
    yield python("import newcomer_record")
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
