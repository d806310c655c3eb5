# SPDX-License-Identifier: BSD-3-Clause
"""One interval at two time steps and between them: slices of 4-simplices (figure 3.11).

python3 time_slices.py IMAGE.png
"""

from interlume import vtkAnalyticFieldSource, vtkSimplexTimeSlice, vtkTimeVaryingIntervalVolume
from props import COLORS, make_actor, make_surface, run, shade_by_field
from stage import INK, Stage
from vtkmodules.vtkFiltersSources import vtkCubeSource

wave = vtkAnalyticFieldSource()
wave.SetFieldToWave()
wave.SetDimensions(1280, 32, 2)
wave.SetBounds(-3.4, 3.4, -0.4, 0.4, -0.7, 0.7)
wave.SetTimeRange(0.0, 0.5)
wave.SetNumberOfTimeSteps(2)
sheet = vtkTimeVaryingIntervalVolume()
sheet.SetInputConnection(wave.GetOutputPort())
sheet.SetInterval(0, -0.15, 0.15)
sheet.GenerateTetrahedraOff()
sheet.GenerateSimplicesOn()

stage = Stage(columns=1)
marker = vtkCubeSource()  # at a crest of the first step
marker.SetBounds(0.09, 0.11, -0.43, -0.41, -0.65, 0.65)
times = {0.0: "first step", 0.25: "midway", 0.5: "second step"}
for time, caption in times.items():
    cut = vtkSimplexTimeSlice()
    cut.SetInputConnection(sheet.GetOutputPort(2))
    cut.SetTime(time)
    panel = stage.add_panel(caption)
    panel.frame(-3.4, 3.4, -0.4, 0.4, -0.55, 0.55)
    panel.ambient_occlusion = False
    surface = shade_by_field(make_surface(run(cut)), lambda x: wave.Evaluate(x, time))
    actor = make_actor(surface, COLORS[len(stage.panels)])
    actor.GetProperty().SetAmbient(0.35)
    panel.add(make_actor(run(marker), INK), actor)
    panel.look_from((0.08, -1.0, 0.4))
stage.save()
