"""Makes the pictures of Documentation/guide/paraview.md: the client's window after some of the uses.

Argument: the folder of the pictures, Documentation/pictures/guide. Needs ImageMagick besides what
TestNewcomer.py needs, and the same environment; the target guide-pictures of the build runs it. The
pictures are named after the filters, whose help pages show them.
"""

import os
import sys
import tempfile

from newcomer_client import play, python
from newcomer_uses import applied, drawn_as, opened

SECONDS = 280
WIDTH = 900
SHOT = f"import -window root -resize {WIDTH}x -colors 96 -strip -define png:compression-level=9"


def shot(path):
    """The gesture of photographing the whole window, drawn to the end."""
    code = "import os; from paraview.simple import *; Render(); from newcomer_record import settle; "
    return python(code + f"settle(); os.system({SHOT + ' ' + path!r})")


def seen_from_aside():
    """A camera from which depth is seen."""
    code = ("from paraview.simple import *; view = GetActiveView(); ResetActiveCameraToPositiveY(); "
            "camera = view.GetActiveCamera(); camera.Elevation(25); camera.Azimuth(30); ResetCamera(view)")
    return [python(code)]


def pictures():
    """For each picture the gestures before it."""
    disk = opened("disk_out_ref.vtu")
    return {
        "opened": disk,
        "IntervalVolume": disk + applied("IntervalVolume"),
        "IsotableContour": opened("tooth.vti") + applied("IsotableContour"),
        "ShadowedSlices": opened("tooth.vti") + drawn_as("Shadowed Slices"),
        "TimeVaryingIntervalVolume": opened("mug.ex2") + applied("TimeVaryingIntervalVolume"),
        "FlowVolume": disk + applied("ImplicitFlowField", "InflowMapping", "FlowVolume"),
        "TetrahedralMesher": disk + applied("TetrahedralMesher"),
    }


def gestures(folder):
    for name, steps in pictures().items():
        yield from steps
        yield from seen_from_aside()
        yield shot(os.path.join(folder, name + ".png"))
        yield python("import newcomer_record; newcomer_record.reset()")


def main():
    folder = os.path.realpath(sys.argv[1])
    os.makedirs(folder, exist_ok=True)
    with tempfile.TemporaryDirectory() as scratch:
        status, log = play(gestures(folder), scratch, "guide", SECONDS)
    print("\n".join(log))
    sys.exit(0 if status == 0 else 1)


if __name__ == "__main__":
    main()
