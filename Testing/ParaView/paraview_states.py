# SPDX-License-Identifier: BSD-3-Clause
"""Writes state files of Examples/ParaView and screenshots of the client that shows them.

Arguments: the output directories Examples/ParaView/States and Documentation/pictures, and optional names. Needs the
requirements of newcomer_guide.py, and uses optipng if it is there: run ninja paraview-states in the build of the
plugin. File names in the states are relative to the repository.
"""

import os
import shutil
import subprocess
import sys
import tempfile

from newcomer_client import play, python
from plugin_testing import data_path

SECONDS = 3000
SIZE = "1600x1000"
# Data of each example, the variable of the selected source, and the name of the screenshot.
EXAMPLES = {
    "intervals_of_a_tooth": ("tooth.vti", "intervals", "paraview.png"),
    "shadows_of_a_bonsai": ("bonsai.vti", "tree", "paraview-shadows.png"),
    "stream_volume_around_a_disk": ("disk_out_ref.vtu", "bundles", "paraview-flow.png"),
    "mug_over_time": ("mug.ex2", "over_time", "paraview-time.png"),
}


def repository():
    return os.path.realpath(os.path.join(os.path.dirname(data_path("")), ".."))


def compress(path):
    """Compresses an image without loss."""
    if shutil.which("optipng"):
        subprocess.run(["optipng", "-quiet", "-o2", path], check=True)


def gestures(states, pictures, names):
    yield python("import os, newcomer_record, newcomer_state; newcomer_record.set_progressive(0)")
    for name in names:
        data, selected, picture = EXAMPLES[name]
        script = os.path.join(repository(), "Examples", "ParaView", name + ".py")
        state = os.path.join(states, name + ".pvsm")
        shot = f"import -window root -strip PNG24:{os.path.join(pictures, picture)!r}"
        yield python(f"newcomer_state.build({script!r}, {data_path(data)!r}, {state!r}, {selected!r})")
        yield python(f"os.system({shot!r})")
        yield python("newcomer_state.reset()")


def main():
    states, pictures = map(os.path.realpath, sys.argv[1:3])
    names = sys.argv[3:] or list(EXAMPLES)
    os.makedirs(states, exist_ok=True)
    with tempfile.TemporaryDirectory() as scratch:
        status, log = play(gestures(states, pictures, names), scratch, "states", SECONDS, size=SIZE)
    print("\n".join(log))
    for name in names:
        compress(os.path.join(pictures, EXAMPLES[name][2]))
    sys.exit(0 if status == 0 else 1)


if __name__ == "__main__":
    main()
