# SPDX-License-Identifier: BSD-3-Clause
"""Runs a script of Examples/ParaView and looks at the picture that it writes.

Arguments: the script, the data file and the picture.
"""

import os
import runpy
import sys

import numpy

from plugin_pictures import pixels
from plugin_testing import Checks, data_path

SMALLEST_SHARE = 0.12  # of the picture that shows something
SMALLEST_MARGIN = 5  # rows and columns of background around it
FEWEST_COLOURS = 200


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
    colours = len(numpy.unique(drawn.reshape(-1, 3), axis=0))
    print(f"shown {shown.mean():.3f}, margin {margin}, colours {colours}", flush=True)
    checks = Checks()
    checks.that(shown.mean() >= SMALLEST_SHARE, "the picture shows something")
    checks.that(margin >= SMALLEST_MARGIN, "nothing is cut off")
    checks.that(colours >= FEWEST_COLOURS, "it has form")
    checks.finish()


main()
