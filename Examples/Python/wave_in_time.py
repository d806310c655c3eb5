# SPDX-License-Identifier: BSD-3-Clause
"""A wave over five time steps, colored by time (figure 3.20).

python3 wave_in_time.py IMAGE.png
"""

from interlume import (
    vtkAnalyticFieldSource, vtkTemporalColorTransferFunction, vtkTimeVaryingIntervalVolume)
from props import make_opacities, make_volume, run
from stage import DARK, Stage

wave = vtkAnalyticFieldSource()
wave.SetFieldToWave()
wave.SetDimensions(100, 20, 8)
wave.SetBounds(-1.4, 1.4, -1.0, 1.0, -1.0, 1.0)
wave.SetTimeRange(0.0, 1.0)
wave.SetNumberOfTimeSteps(5)
sheet = vtkTimeVaryingIntervalVolume()
sheet.SetInputConnection(wave.GetOutputPort())
sheet.SetInterval(0, -0.15, 0.15)
colors = vtkTemporalColorTransferFunction()
colors.SetTimes(5, [0.0, 0.25, 0.5, 0.75, 1.0])
# Half of the green, so that the colors of all times add up to white.
for i in range(colors.GetSize()):
    node = [0.0] * 6
    colors.GetNodeValue(i, node)
    node[2] *= 0.5
    colors.SetNodeValue(i, node)
volume = make_volume(run(sheet), "Time", colors, make_opacities((0.0, 1.1)))
volume.GetMapper().SetBlendModeToAdditive()

stage = Stage()
panel = stage.add_panel()
panel.set_background(DARK)
panel.add(volume)
panel.camera.ParallelProjectionOn()
panel.frame(-1.05, 1.05, -0.1, 0.1, -0.5, 0.5)
panel.look_from((0.25, -1.0, 0.05))
stage.set_color_bar("time", colors, 0.0, 1.0)
stage.save()
