# SPDX-License-Identifier: BSD-3-Clause
"""The inner boundary of an interval, highlighted (figure 3.7).

python3 interval_boundary.py IMAGE.png
"""

from interlume import vtkIntervalVolume
from props import COLORS, add_gradient, make_boundary, make_intervals, read, run, set_boundary
from stage import Stage

interval = vtkIntervalVolume()
interval.SetInterval(0, 0.04, 0.25)
interval.GenerateBoundariesOn()
orbital = add_gradient(read("hydrogen_orbital.vti"), "probability_density")
tetrahedra = run(interval, orbital)

stage = Stage()
plain = stage.add_panel("the interval")
highlighted = stage.add_panel("its inner boundary highlighted")
plain.look_from((1.0, -1.0, 0.5))
highlighted.look_as(plain)
plain.add(make_intervals(tetrahedra, (COLORS[0], 0.035)))
volume = make_intervals(tetrahedra, (COLORS[0], 0.018))
set_boundary(volume, make_boundary(interval, interval.UPPER_SIDE), COLORS[2], 1.0)
look = volume.GetMapper().GetBoundaryProperty()
look.SetAmbient(0.35)
look.SetDiffuse(0.6)
look.SetSpecular(0.2)
highlighted.add(volume)
stage.save()
