# SPDX-License-Identifier: BSD-3-Clause
"""Runs a script of Examples/ParaView and checks its image.

Arguments: the script, the data file and the image.
"""

import os
import runpy
import sys

import numpy

from plugin_images import pixels
from plugin_testing import Checks, data_path

SMALLEST_FRACTION = 0.12  # fraction of pixels that differ from the background
SMALLEST_MARGIN = 5  # background rows and columns at the borders
MINIMUM_COLORS = 200


def main():
    script, data, picture = sys.argv[1:]
    if os.path.exists(picture):
        os.remove(picture)
    sys.argv = [script, os.environ["INTERLUME_PLUGIN"], data_path(data), picture]
    size = list(runpy.run_path(script)["view"].ViewSize)
    drawn = pixels(picture).reshape(size[1], size[0], 3)
    shown = (drawn != drawn[0, 0]).any(axis=2)
    rows, columns = numpy.nonzero(shown)
    margin = min(rows.min(), columns.min(), size[1] - 1 - rows.max(), size[0] - 1 - columns.max())
    colors = len(numpy.unique(drawn.reshape(-1, 3), axis=0))
    print(f"shown {shown.mean():.3f}, margin {margin}, colors {colors}", flush=True)
    checks = Checks()
    checks.that(shown.mean() >= SMALLEST_FRACTION, "the image is not empty")
    checks.that(margin >= SMALLEST_MARGIN, "there is a margin")
    checks.that(colors >= MINIMUM_COLORS, "the image has many colors")
    checks.finish()


main()
