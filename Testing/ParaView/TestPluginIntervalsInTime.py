# SPDX-License-Identifier: BSD-3-Clause
"""Tests that default intervals in time cover all time steps, and that slices follow the animation time unless a
time is set.
"""

import sys

from paraview import servermanager, simple

from plugin_testing import fetch, run, temporal_source


def times_of(simplex_slice):
    return servermanager.Fetch(simplex_slice).GetPointData().GetArray("Time").GetRange()


def check_proposal(checks, path):
    """Tests the default intervals of the mug, whose first time step is 0 everywhere."""
    mug = simple.OpenDataFile(path)
    mug.UpdatePipeline()
    name = simple.TimeVaryingIntervalVolume(Input=mug).Scalars[1]
    lowest, highest = mug.PointData.GetArray(name).GetRange()
    checks.equal((lowest, highest), (0.0, 0.0), f"{name} at the first step")
    reached = [0.0, 0.0]
    for time in mug.TimestepValues:
        mug.UpdatePipeline(time)
        own = mug.PointData.GetArray(name).GetRange()
        reached = [min(reached[0], own[0]), max(reached[1], own[1])]
    mug.UpdatePipeline(mug.TimestepValues[0])
    volume = simple.TimeVaryingIntervalVolume(Input=mug)
    expected = [sum(reached) / 2, reached[1]]
    checks.equal(list(volume.Intervals), expected, "default intervals of all time steps")
    cells = sum(block.GetNumberOfCells() for block in blocks_of(fetch(volume)))
    checks.that(cells > 0, "the mug has tetrahedra with default settings")
    domain = volume.SMProxy.GetProperty("Intervals").FindDomain("vtkSMProposedRangeDomain")
    checks.equal(domain.GetMaximum(0), reached[1], "maximum of the sliders")
    mug.UpdatePipeline(mug.TimestepValues[-1])
    checks.equal(list(volume.Intervals), expected, "intervals after another time is shown")
    checks.equal(domain.GetMaximum(1), reached[1], "maximum of the sliders after another time is shown")


def blocks_of(data):
    if not data.IsA("vtkCompositeDataSet"):
        return [data]
    iterator = data.NewIterator()
    blocks = []
    iterator.InitTraversal()
    while not iterator.IsDoneWithTraversal():
        blocks.append(iterator.GetCurrentDataObject())
        iterator.GoToNextItem()
    return blocks


def check_display(checks, volume):
    view = simple.CreateRenderView()
    controller = servermanager.vtkSMParaViewPipelineControllerWithRendering()
    display = simple.Show(volume, view)
    checks.equal(display.Representation, "Interval Volume", "representation in time")
    checks.equal(list(display.ColorArrayName), ["POINTS", "f"], "colors in time")
    for port in (1, 2):
        preferred = controller.ShowInPreferredView(volume.SMProxy, port, view.SMProxy)
        checks.that(preferred is None, f"output {port} in time is hidden")
        active = fetch(volume, port).GetPointData().GetScalars()
        checks.that(active and active.GetName() == "f", f"the scalar is active on output {port}")
    simple.Delete(view)


def check_slice(checks, volume):
    source = simple.OutputPort(volume, 2)
    simplex_slice = simple.SimplexTimeSlice(Input=source)
    for time, expected in ((0.0, 0.0), (0.375, 0.375), (1.5, 1.5), (7.0, 2.0), (-1.0, 0.0)):
        simplex_slice.UpdatePipeline(time)
        checks.equal(times_of(simplex_slice), (expected, expected), f"slice while {time} is shown")
        active = servermanager.Fetch(simplex_slice).GetPointData().GetScalars()
        checks.that(active and active.GetName() == "f", "the scalar is active on the slice")
    # Scripts and state files set a time.
    simplex_slice.Time = 0.75
    checks.equal(simplex_slice.UseAnimationTime, 0, "setting a time switches the animation time off")
    for time in (0.25, 1.25):
        simplex_slice.UpdatePipeline(time)
        checks.equal(times_of(simplex_slice), (0.75, 0.75), f"slice at a set time, {time} shown")
    simplex_slice.UseAnimationTime = 1
    simplex_slice.UpdatePipeline(1.25)
    checks.equal(times_of(simplex_slice), (1.25, 1.25), "slice that follows the animation again")
    set_at_once = simple.SimplexTimeSlice(Input=source, Time=0.5)
    set_at_once.UpdatePipeline(1.25)
    checks.equal(times_of(set_at_once), (0.5, 0.5), "slice created with a time")

    panel = simple.SimplexTimeSlice(Input=source).SMProxy
    time, follow = panel.GetProperty("Time"), panel.GetProperty("UseAnimationTime")
    time.SetUncheckedElement(0, 0.5)
    checks.equal(follow.GetUncheckedElement(0), 0, "typing a time in the panel switches the animation time off")
    checks.equal(follow.GetElement(0), 1, "UseAnimationTime before Apply")
    follow.SetUncheckedElement(0, 1)
    time.SetElement(0, 0.5)
    checks.equal(follow.GetElement(0), 1, "UseAnimationTime remains on if it is set after the time")


def main(checks):
    check_proposal(checks, sys.argv[1])
    field = temporal_source("AnalyticField", {"Field": "Wave", "WholeExtent": [0, 15, 0, 7, 0, 7]})
    volume = simple.TimeVaryingIntervalVolume(Input=field)
    volume.GenerateSimplices = 1
    volume.Boundaries = ["Volume at end"]
    volume.UpdatePipeline()
    check_display(checks, volume)
    check_slice(checks, volume)


run(main)
