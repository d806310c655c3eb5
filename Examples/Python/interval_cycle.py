# SPDX-License-Identifier: BSD-3-Clause
"""Adjacent intervals of a scanned bonsai's crown, shown in turn (figure 3.5).

python3 interval_cycle.py IMAGE.png
"""

from interlume import vtkIntervalVolume
from props import COLORS, make_intervals, read, reduce, run
from stage import Stage
from vtkmodules.vtkImagingCore import vtkExtractVOI

crown = vtkExtractVOI()
crown.SetVOI(20, 235, 96, 255, 0, 255)
half = reduce(run(crown, read("bonsai.vti")), 2)

bounds = [26.0, 42.0, 60.0, 85.0, 255.0]
names = ["leaves", "twigs", "branches", "core of the wood"]
extinctions = [0.12, 0.18, 0.18, 0.18]
interval = vtkIntervalVolume()
stage = Stage(columns=2)
for i in range(4):
    interval.SetInterval(0, bounds[i], bounds[i + 1])
    panel = stage.add_panel(f"{names[i]}, {bounds[i]:.0f} to {bounds[i + 1]:.0f}")
    panel.add(make_intervals(run(interval, half), (COLORS[i], extinctions[i])))
    if i > 0:
        panel.look_as(stage.panels[0])
    else:
        panel.look_from((0.4, 0.35, -1.0), up=(0.0, 1.0, 0.0))
stage.save()
