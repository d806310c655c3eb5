# SPDX-License-Identifier: BSD-3-Clause
"""Ranges of two attributes and their intersection (figure 3.10).

python3 interval_intersection.py IMAGE.png
"""

from interlume import vtkIntervalVolume
from props import COLORS, make_intervals, read, run
from stage import Stage
from vtkmodules.vtkCommonDataModel import vtkDataObject
from vtkmodules.vtkFiltersCore import vtkAppendFilter

amber, blue, green = COLORS[2], COLORS[0], COLORS[1]
temperature, arsine = ("Temp", 380.0, 560.0), ("AsH3", 0.1, 0.14)
disk = read("disk_out_ref.vtu")
overlapping = vtkAppendFilter()
parts = []
for number, ranges in enumerate([[temperature], [arsine], [temperature, arsine]]):
    interval = vtkIntervalVolume()
    interval.SetInputArrayToProcess(
        0, 0, 0, vtkDataObject.FIELD_ASSOCIATION_POINTS, ranges[0][0])
    interval.SetInterval(0, *ranges[0][1:])
    for criterion in ranges[1:]:
        interval.AddCriterion(*criterion)
    parts.append(run(interval, disk))
    parts[-1].GetCellData().GetArray("IntervalId").Fill(number)
    overlapping.AddInputData(parts[-1])

stage = Stage()
first, second, both = map(
    stage.add_panel, ["temperature 380 to 560 K", "arsine 10 to 14 %", "both"])
first.look_from((-1.0, -1.0, 0.5))
second.look_as(first)
both.look_as(first)
first.add(make_intervals(parts[0], (amber, 0.25)))
second.add(make_intervals(parts[1], (amber, 0.0), (blue, 0.25)))
volume = make_intervals(run(overlapping), (amber, 0.05), (blue, 0.05), (green, 0.4))
volume.GetMapper().SetBlendModeToOpticalDepth()
both.add(volume)
stage.save()
