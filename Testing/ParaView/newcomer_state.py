# SPDX-License-Identifier: BSD-3-Clause
"""Runs an example in the client's Python shell, and saves its state with file names relative to the repository."""

import os
import re
import runpy
import sys
import tempfile
import traceback

from paraview import simple


def build(script, data, state, selected):
    """`selected` is the variable of the source that is selected in the client."""
    try:
        simple.Delete(simple.GetActiveView())
        with tempfile.TemporaryDirectory() as folder:
            sys.argv = [script, os.environ["INTERLUME_PLUGIN"], data, os.path.join(folder, "image.png")]
            scene = runpy.run_path(script)
        view = scene["view"]
        simple.AssignViewToLayout(view)
        simple.SetActiveSource(scene[selected])
        for source in simple.GetSources().values():
            if "FileName" in source.ListProperties():
                simple.RenameSource(os.path.basename(data), source)
        simple.Render(view)
        simple.SaveState(state)
        with open(state, encoding="utf-8") as file:
            text = file.read()
        # Domains are found again from the data, and make up most of the file.
        text = re.sub(r" *<Domain [^>]*/>\n| *<Domain [^>]*[^/]>.*?</Domain>\n", "", text, flags=re.DOTALL)
        with open(state, "w", encoding="utf-8") as file:
            file.write(text.replace(os.path.dirname(data), "Data"))
    except Exception:  # the shell shows errors only in its window
        traceback.print_exc(file=sys.__stderr__)


def reset():
    simple.ResetSession()
