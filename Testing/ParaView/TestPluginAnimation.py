# SPDX-License-Identifier: BSD-3-Clause
"""Runs a script of Examples/ParaView/Animations and checks its frames.

Arguments: the script, its data file if it reads one, and the start of the frames' names.
"""

import glob
import os
import runpy
import sys

from plugin_images import pixels
from plugin_testing import Checks, data_path

NUMBER = 4
SMALLEST_FRACTION = 0.02  # fraction of pixels that differ from the background
SMALLEST_CHANGE = 0.005  # fraction of pixels that differ between two frames


def main():
    script, *data, frames = sys.argv[1:]
    for path in glob.glob(f"{frames}-*.png"):
        os.remove(path)
    sys.argv = [script, os.environ["INTERLUME_PLUGIN"], *map(data_path, data), frames, str(NUMBER)]
    runpy.run_path(script)
    checks = Checks()
    paths = sorted(glob.glob(f"{frames}-*.png"))
    checks.equal([path[len(frames):] for path in paths],
                 [f"-{frame:03}.png" for frame in range(NUMBER)], "frames")
    images = [pixels(path).reshape(-1, 3) for path in paths]
    for frame, image in enumerate(images):
        shown = (image != image[0]).any(axis=1).mean()
        checks.that(shown >= SMALLEST_FRACTION, f"frame {frame} is not empty: {shown:.3f}")
        changed = (image != images[frame - 1]).any(axis=1).mean()
        checks.that(changed >= SMALLEST_CHANGE, f"frame {frame} differs from the previous: {changed:.3f}")
    checks.finish()


main()
