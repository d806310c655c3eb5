# SPDX-License-Identifier: BSD-3-Clause
"""Gas flow onto a hot spinning disk: three stream volumes, colored by temperature.

pvbatch stream_volume_around_a_disk.py PLUGIN Data/disk_out_ref.vtu IMAGE.png
"""

import sys

from paraview.simple import *

plugin, data, picture = sys.argv[1:]
LoadPlugin(plugin, remote=False, ns=globals())
view = CreateRenderView(ViewSize=[640, 720], OrientationAxesVisibility=0)
view.UseColorPaletteForBackground = 0
view.Background = [0.93, 0.93, 0.94]

disk = OpenDataFile(data)
field = ImplicitFlowField(Input=disk, Vectors=["POINTS", "V"], TerminationSurface="Rectangle")
lid = field.TerminationSurface  # a square above the disk, through which gas enters
lid.Center, lid.Normal, lid.Lengths = [0, 0, 10.1], [0, 0, 1], [11.5, 11.5]
field.SampleMode = "Image"
field.SampleDimensions, field.SampleBounds = [65, 33, 77], [-5.7, 5.7, 0, 5.7, -3.5, 10.1]
field.MaximumTime = 8

distance = InflowMapping(Input=field, Formula="2*sqrt((u-0.5)^2+(v-0.5)^2)")  # distance from the axis
bundles = FlowVolume(Input=distance, TimeRange=[0, 5.5])
bundles.Intervals = [0.15, 0.25, 0.4, 0.5, 0.65, 0.75]
colored = ResampleWithDataset(SourceDataArrays=disk, DestinationMesh=bundles, PassCellArrays=1)

display = Show(colored, view)
ColorBy(display, ("POINTS", "Temp"))
colors = GetColorTransferFunction("Temp")
colors.ApplyPreset("Cool to Warm (Extended)", True)
colors.RescaleTransferFunction(0, 950)  # cold gas has a temperature of 293 K
view.CameraPosition, view.CameraFocalPoint, view.CameraViewUp = [0.35, -1, 0.3], [0, 0, 0], [0, 0, 1]
ResetCamera(view)
view.GetActiveCamera().Zoom(1.1)
SaveScreenshot(picture, view)
