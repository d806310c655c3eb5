# SPDX-License-Identifier: BSD-3-Clause
"""Intervals drawn by priority, and in reverse order (figure 3.6).

python3 interval_priority.py IMAGE.png
"""

from interlume import vtkIntervalVolume
from props import COLORS, make_intervals, read, run
from stage import Stage

bounds = [40.0, 50.0, 100.0, 160.0, 255.0]
extinctions = [0.3, 0.05, 0.12, 0.2]
intervals = vtkIntervalVolume()
for i in range(4):
    intervals.SetInterval(i, bounds[i], bounds[i + 1])
tetrahedra = run(intervals, read("neghip.vti"))

stage = Stage()
outside = stage.add_panel("low values painted last")
inside = stage.add_panel("high values painted last")
outside.look_from((-1.0, -0.7, 0.5))
inside.look_as(outside)
for panel in (outside, inside):
    volume = make_intervals(tetrahedra, *zip(COLORS, extinctions))
    volume.GetMapper().SetBlendModeToPriority()
    for i in range(4):
        volume.GetMapper().SetLayerPriority(i, i if panel is inside else 3 - i)
    panel.add(volume)
stage.set_color_key(COLORS, bounds)
stage.save()
