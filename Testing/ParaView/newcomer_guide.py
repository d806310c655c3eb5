"""Makes the pictures of Documentation/guide/paraview.md: the client's window after some of the uses.

Argument: the folder of the pictures, Documentation/pictures/guide. Needs ImageMagick besides what
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


def seen_from_aside():
    """A camera that shows depth: the z axis upwards, from the front and a little above."""
    return python("from paraview.simple import *; view = GetActiveView(); "
                  "view.CameraPosition, view.CameraFocalPoint = [0.4, -1, 0.5], [0, 0, 0]; "
                  "view.CameraViewUp = [0, 0, 1]; ResetCamera(view); Render(view)")


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


def gestures(folder):
    yield python("import newcomer_record")
    for name, steps in pictures().items():
        yield from steps
        yield seen_from_aside()
        yield shot(os.path.join(folder, name + ".png"))
        yield python("newcomer_record.reset()")


def main():
    folder = os.path.realpath(sys.argv[1])
    os.makedirs(folder, exist_ok=True)
    with tempfile.TemporaryDirectory() as scratch:
        status, log = play(gestures(folder), scratch, "guide", SECONDS, size="1200x800")
    print("\n".join(log))
    sys.exit(0 if status == 0 else 1)


if __name__ == "__main__":
    main()
