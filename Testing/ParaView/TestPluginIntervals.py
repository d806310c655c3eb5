# SPDX-License-Identifier: BSD-3-Clause
"""Tests that default intervals follow the data and the array until a user sets them, that outputs are colored and
shown in the right representation, and that invalid settings are reported.
"""

import os
import tempfile

from paraview import servermanager, simple

from plugin_testing import fetch, interval_volume, open_data, run, warnings_of


def proposal(source, array):
    lowest, highest = source.PointData.GetArray(array).GetRange()
    return [(lowest + highest) / 2, highest]


def check_reset(checks, source):
    """Tests that the reset button sets one complete row, regardless of the previous values."""
    volume = interval_volume(source, "Temp", [(400, 500)])
    intervals = volume.SMProxy.GetProperty("Intervals")
    expected = proposal(source, "Temp")
    for before in ([400, 500], [1, 2, 3, 4], []):
        volume.Intervals = before
        intervals.ResetToDomainDefaults()
        checks.equal(list(volume.Intervals), expected, f"reset from {before}")
        volume.SMProxy.UpdateVTKObjects()
        checks.that(fetch(volume).GetNumberOfCells() > 0, f"reset from {before} produces tetrahedra")
    contour = simple.IsotableContour(Input=source)
    contour.Isosurfaces = [1, 2]
    contour.SMProxy.GetProperty("ContourValues").ResetToDomainDefaults()
    center = proposal(source, contour.ContourBy[1])[0]
    checks.equal(list(contour.Isosurfaces), [center], "reset of the contour")


def check_new_array(checks, source):
    """Tests that another array gets other defaults, in a script and in a panel before Apply."""
    volume = simple.IntervalVolume(Input=source)
    contour = simple.IsotableContour(Input=source)
    for array in ("Temp", "Pres"):
        volume.Scalars = ["POINTS", array]
        checks.equal(list(volume.Intervals), proposal(source, array), f"proposed for {array}")
        values = fetch(volume).GetPointData().GetArray(array).GetRange()
        checks.that(values[0] >= proposal(source, array)[0] * (1 - 1e-6), f"used for {array}")
        contour.ContourBy = ["POINTS", array]
        checks.equal(list(contour.Isosurfaces), proposal(source, array)[:1], f"value for {array}")
    volume.Intervals = [1, 2]
    volume.Scalars = ["POINTS", "Temp"]
    checks.equal(list(volume.Intervals), [1, 2], "intervals set by a user are kept")

    volume = simple.IntervalVolume(Input=source)
    before = list(volume.Intervals)
    scalars = volume.SMProxy.GetProperty("SelectInputScalars")
    intervals = volume.SMProxy.GetProperty("Intervals")
    scalars.SetUncheckedElement(4, "Temp")
    shown = [intervals.GetUncheckedElement(i) for i in range(intervals.GetNumberOfUncheckedElements())]
    checks.equal(shown, proposal(source, "Temp"), "defaults in the panel")
    checks.equal(list(volume.Intervals), before, "intervals before Apply")
    scalars.ClearUncheckedElements()
    intervals.ClearUncheckedElements()


def check_display(checks, source):
    """Tests that outputs are colored by the selected scalars as Interval Volume, and only the first is
    shown."""
    view = simple.CreateRenderView()
    controller = servermanager.vtkSMParaViewPipelineControllerWithRendering()
    volume = interval_volume(source, "Temp", [(400, 500)])
    display = simple.Show(volume, view)
    checks.equal(display.Representation, "Interval Volume", "representation")
    checks.equal(list(display.ColorArrayName), ["POINTS", "Temp"], "colors")
    for port, shown in ((0, True), (1, False)):
        preferred = controller.ShowInPreferredView(volume.SMProxy, port, view.SMProxy)
        checks.equal(preferred is not None, shown, f"output {port} is shown after Apply")
    contour = simple.IsotableContour(Input=source)
    contour.ContourBy = ["POINTS", "Pres"]
    checks.equal(list(simple.Show(contour, view).ColorArrayName), ["POINTS", "Pres"], "colors of the contour")
    simple.Delete(view)


def check_messages(checks, source):
    """Tests that each problem is reported once."""
    volume = interval_volume(source, "Temp", [(4000, 5000)])
    with warnings_of(volume) as messages:
        fetch(volume)
    checks.one_message(messages, "from 293.15 to 913.15", "an interval outside the range")
    group = simple.GroupDatasets(Input=[source, source])
    grouped = interval_volume(group, "Temp", [(4000, 5000)])
    with warnings_of(grouped) as messages:
        grouped.UpdatePipeline()
    checks.one_message(messages, "from 293.15 to 913.15", "an interval of a group outside the range")
    for name, values, part in (("Intervals", [400, 500, 600], "1 of its 2 values"),
                               ("Criteria", ["AsH3", "0.1"], "2 of its 3 values")):
        volume = interval_volume(source, "Temp", [(400, 500)])
        fetch(volume)
        domain = volume.SMProxy.GetProperty(name).FindDomain("vtkSMCompleteRowsDomain")
        with warnings_of(domain) as messages:
            setattr(volume, name, values)
            fetch(volume)
        checks.one_message(messages, part, f"an incomplete row of {name}")
        simple.Delete(volume)
    volume = interval_volume(source, "Temp", [(400, 500)], [("AsH3", "low", 1)])
    errors = []
    volume.GetClientSideObject().AddObserver("ErrorEvent", lambda *_: errors.append(1))
    checks.equal(fetch(volume).GetNumberOfCells(), 0, "tetrahedra if a bound is not a number")
    checks.equal(len(errors), 1, "errors if a bound is not a number")


def check_criteria(checks, source):
    """Tests how criteria change the result."""
    volume = interval_volume(source, "Temp", [(400, 500)], [("AsH3", 0.1, 0.14)])
    ids = {}
    for operation in ("Intersection", "Union", "Difference"):
        volume.CombineCriteria = operation
        ids[operation] = fetch(volume).GetCellData().GetArray("IntervalId").GetRange()
    checks.equal(ids, {"Intersection": (0, 0), "Union": (-1, 0), "Difference": (0, 0)}, "interval ids")
    simple.Delete(volume)


def check_animation(checks, source):
    """Tests that bounds and values can be animated."""
    volume = interval_volume(source, "Temp", [(400, 500)])
    contour = simple.IsotableContour(Input=source)
    contour.ContourBy = ["POINTS", "Temp"]
    scene = simple.GetAnimationScene()
    scene.PlayMode = "Sequence"
    scene.NumberOfFrames = 3
    scene.StartTime, scene.EndTime = 0, 1
    for proxy, name, index, first, last in (
            (volume, "Intervals", 1, [450], [800]), (contour, "ContourValues", 0, [400], [600])):
        track = simple.GetAnimationTrack(name, index, proxy)
        frames = []
        for time, values in ((0.0, first), (1.0, last)):
            frame = simple.CompositeKeyFrame()
            frame.KeyTime = time
            frame.KeyValues = values
            frames.append(frame)
        track.KeyFrames = frames
    for time, intervals, value in ((0.0, [400, 450], 400), (0.5, [400, 625], 500), (1.0, [400, 800], 600)):
        scene.AnimationTime = time
        checks.equal(list(volume.Intervals), intervals, f"intervals at {time}")
        checks.equal(list(contour.Isosurfaces), [value], f"value at {time}")
        highest = fetch(volume).GetPointData().GetArray("Temp").GetRange()[1]
        checks.close(highest, intervals[1], 1e-6, f"upper end of the values at {time}")


def check_state(checks, source):
    """Tests that a state file restores intervals and arrays."""
    volume = interval_volume(source, "Temp", [(400, 500), (600, 700)], [("AsH3", 0.1, 0.2)])
    simple.RenameSource("saved", volume)
    expected = fetch(volume).GetNumberOfCells()
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "state.pvsm")
        simple.SaveState(path)
        for proxy in list(simple.GetSources().values()):
            simple.Delete(proxy)
        simple.LoadState(path)
    loaded = simple.FindSource("saved")
    checks.equal(list(loaded.Intervals), [400, 500, 600, 700], "intervals of a state")
    checks.equal(list(loaded.Scalars), ["POINTS", "Temp"], "scalars of a state")
    checks.equal(list(loaded.Criteria), ["AsH3", "0.1", "0.2"], "criteria of a state")
    checks.equal(fetch(loaded).GetNumberOfCells(), expected, "tetrahedra of a state")


def main(checks):
    source = open_data("disk_out_ref")
    check_reset(checks, source)
    check_new_array(checks, source)
    check_display(checks, source)
    check_messages(checks, source)
    check_criteria(checks, source)
    check_animation(checks, source)
    check_state(checks, source)


run(main)
