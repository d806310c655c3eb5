# SPDX-License-Identifier: BSD-3-Clause
"""Tests widgets of the plugin in the ParaView client. Argument: the output directory.

Each step of a use has gestures and, optionally, a Python expression with its expected value.
"""

import json
import os
import sys

from newcomer_client import check, play, python
from newcomer_uses import APPLY, MENU_BAR, applied, drawn_as, opened
from plugin_testing import Checks

SECONDS = 1500  # Time limit on a busy machine.
PANEL = ("pqClientMainWindow/propertiesDock/propertiesPanel/scrollArea/qt_scrollarea_viewport/scrollAreaWidgetContents/"
         "PropertiesFrame/ProxyPanel/")
SEARCH = "pqClientMainWindow/QuickLaunchDialog"
OPACITY = PANEL.replace("Properties", "Display") + "Opacity/DoubleRangeWidget/Slider"
RETURN = 0x01000004
KEY_PRESS = 6
INTERVALS = PANEL + "Intervals/"


def chosen(name):
    return [(MENU_BAR + "/menuFilters/Alphabetical", "activate", name)]


def clicked(widget):
    return [(widget, "activate", "")]


def searched(text):
    """Types into the search box, and creates the selected filter."""
    keys = [(ord(letter.upper()), letter) for letter in text] + [(RETURN, "")]
    return [(MENU_BAR + "/menuFilters", "activate", "Search...\tCtrl+Space")] + [
        (SEARCH, "keyEvent", f"{KEY_PRESS}:{key}:0:{letter}:0:1") for key, letter in keys]


def shell(code):
    return [python("from paraview.simple import *; " + code)]


def of_table(is_table):
    """Returns the checks that the table is visible or not, and that the sliders and buttons are."""
    return [check(INTERVALS + "Several", "visible", "true"), check(INTERVALS + "Sliders", "visible", "true"),
            check(INTERVALS + "Table", "visible", "true" if is_table else "false"),
            check(INTERVALS + "Reset", "visible", "true")]


def slider_of(property_name):
    return f"{PANEL}{property_name}/Sliders/ThresholdBetween_0/Slider"


def dragging(slider, positions):
    """Drags a slider by its handle, which is at the left end, to pixel positions, without releasing it."""
    left = 1
    return ([(slider, "mousePress", f"{left},{left},0,4,8")]
            + [(slider, "mouseMove", f"{left},{left},0,{x},8") for x in positions])


def slid(slider, positions):
    """Drags and releases a slider."""
    return [*dragging(slider, positions), (slider, "mouseRelease", f"1,0,0,{positions[-1]},8")]


def dragged(property_name, positions):
    """Drags and releases the first slider of a property."""
    return slid(slider_of(property_name), positions)


def wavelet(size):
    """Creates an image with the given number of cells from its center to each side."""
    return shell(f"w = Wavelet(WholeExtent=[{-size}, {size}] * 3); w.UpdatePipeline(); SetActiveSource(w)")


def values(name, numbers):
    return shell(f"GetActiveSource().{name} = {numbers}")


# The lower value is the minimum of the image from wavelet(), so that its slider is at the left end.
RANGE = [37.0, 60.0]
WATCH = shell("newcomer_record.watch()")
APPLIED = check(APPLY[0], "enabled", "false")
UNDO = [(MENU_BAR + "/menu_Edit", "activate", "actionEditUndo")]
REDO = [(MENU_BAR + "/menu_Edit", "activate", "actionEditRedo")]
FILTER = "FindSource('IntervalVolume1')"
SELECT_SOURCE_CELLS = [(MENU_BAR + "/menu_Edit", "activate", "actionSelectSourceCells")]
MESSAGE = "pqClientMainWindow/SourceCellsMessage/"
SELECT_CELLS = shell("Render(); x, y = GetActiveView().ViewSize; SelectSurfaceCells(Rectangle=[0, 0, x - 1, y - 1])")
# Compares the cells that are selected in the input of the filter with the origins of the cells that were selected in
# its output.
ARE_SOURCES = f"newcomer_record.selected({FILTER}.Input, 'vtkOriginalCellIds') == newcomer_record.SELECTED"
REMEMBERED = f"len(newcomer_record.remember({FILTER})) > 50"
LEGEND = "GetScalarBar(GetColorTransferFunction('AsH3'), GetActiveView()).RangeLabelFormat"
ROWS = "[round(value, 6) for value in FindSource('IntervalVolume1').Intervals]"
HANDLES = "newcomer_record.handles()"
DISPLAY = "GetRepresentation(GetActiveSource(), GetActiveView())"
ONE = [0.1, 0.12]
# Refinements run between gestures.
PAUSE = 8 * shell("import time; time.sleep(0.2)")
USES = {
    "search": [
        (opened("mug.ex2") + searched("time-varying"), "GetActiveSource().GetXMLName()", "TimeVaryingIntervalVolume")],
    "time slice": [
        (opened("mug.ex2") + chosen("TimeVaryingIntervalVolume")
         + shell("GetActiveSource().GenerateSimplices = 1; GetActiveSource().TimeStepRange = [5, 6]")
         + [APPLY] + chosen("SimplexTimeSlice")
         + [(PANEL + "UseAnimationTime/CheckBox", "set_boolean", "false"), APPLY],
         "[GetActiveSource().UseAnimationTime, str(GetActiveSource().Input.Port)]", [0, "2"])],
    "intervals": [
        (opened("disk_out_ref.vtu") + applied("IntervalVolume") + of_table(False)
         + [check(INTERVALS + "Skipped", "visible", "false")], LEGEND + "[-2:]", "2e"),
        (shell(f"FindSource('IntervalVolume1').Intervals = {ONE}") + clicked(INTERVALS + "Several") + of_table(True)
         + clicked(INTERVALS + "Table/Add") + of_table(True) + [APPLY] + of_table(True), ROWS, [0.1, 0.12, 0.12, 0.14]),
        (clicked(INTERVALS + "Table/Add") + of_table(True) + [APPLY], ROWS, [0.1, 0.12, 0.12, 0.14, 0.14, 0.16]),
        (clicked(INTERVALS + "Reset") + of_table(False) + [APPLY], f"len({ROWS})", 2)],
    "drag": [
        # More than a million cells: coarse during the drag.
        (wavelet(51) + chosen("IntervalVolume") + values("Intervals", RANGE) + [APPLY] + WATCH
         + dragged("Intervals", [6, 7, 8, 9]), "newcomer_record.watched('Intervals')", [True, True, True, 1]),
        ([APPLIED], "GetActiveSource().Intervals[1]", RANGE[1])],
    # Each command of the Python shell clears the steps to undo.
    "undo a drag": [
        (wavelet(10) + chosen("IntervalVolume") + values("Intervals", RANGE) + [APPLY]
         + dragged("Intervals", [6, 7, 8, 9]) + [APPLIED, *UNDO, APPLIED], "list(GetActiveSource().Intervals)", RANGE),
        (dragged("Intervals", [6, 7, 8, 9]) + UNDO + REDO + [APPLIED],
         "GetActiveSource().Intervals[0] > " + str(RANGE[0]), True)],
    "drag small data": [
        (wavelet(10) + chosen("IntervalVolume") + values("Intervals", RANGE) + [APPLY] + WATCH
         + dragged("Intervals", [6, 7, 8, 9, 10]), "newcomer_record.watched('Intervals')", [True, False, True, 1]),
        (clicked(INTERVALS + "Several") + values("Intervals", [*RANGE, 60.0, 70.0]) + WATCH
         + dragged("Intervals", [6, 7, 8, 9]), "newcomer_record.watched('Intervals')", [True, False, True, 1]),
        ([APPLIED], "GetActiveSource().Intervals[2:]", [60.0, 70.0]),
        (wavelet(10) + chosen("IsotableContour") + values("Isosurfaces", [38.0]) + [APPLY] + WATCH
         + dragged("ContourValues", [8, 12, 16]), "newcomer_record.watched('Isosurfaces')", [True, False, True, 1])],
    "progressive tetrahedra": [
        (wavelet(50) + chosen("IntervalVolume") + values("Intervals", [100, 200])
         + shell("newcomer_record.watch_images()") + [APPLY] + PAUSE,
         "newcomer_record.refined()", [True, True, False, True])],
    "progressive slices": [
        (wavelet(100) + shell("Show()") + drawn_as("Shadowed Slices") + PAUSE
         + shell("newcomer_record.watch_images(moves_mouse=True)") + values("XFreq", 40) + shell("Render()")
         + 2 * PAUSE,
         "newcomer_record.refined()", [True, True, True, True]),
        (shell(DISPLAY + ".Opacity = 0; Render(); newcomer_record.watch_images()")
         # The first and the last image have the same opacity. Events that arrive during an image are combined.
         + slid(OPACITY, [30, 40, 50, 60, 50, 40, 30]), "len(set(newcomer_record.IMAGES)) > 3", True),
        (PAUSE, "newcomer_record.refined()", [True, True, False, True]),
        (shell("newcomer_record.watch_images(); " + DISPLAY + ".Opacity = 0.5; Render(); "
               "newcomer_record.take_screenshot()") + PAUSE, "newcomer_record.refined()", [True, True, False, True]),
        ([], "newcomer_record.is_screenshot_complete()", True),
        # Nothing has changed, so the final image is shown again.
        (shell("Render()") + PAUSE + shell("newcomer_record.watch_images(); Render()"), "newcomer_record.refined()",
         [False, True, False, True])],
    "drag before Apply": [
        (wavelet(10) + chosen("IntervalVolume") + values("Intervals", RANGE) + WATCH + dragged("Intervals", [8, 14])
         + [check(APPLY[0], "enabled", "true")], "any(newcomer_record.FRAMES)", False)],
    "drag outside of the range": [
        (wavelet(10) + chosen("IntervalVolume") + values("Intervals", [-500.0, 900.0]) + [APPLY] + WATCH
         + dragged("Intervals", [6, 7, 8, 9]), "newcomer_record.watched('Intervals')", [True, False, True, 1]),
        ([APPLIED], "GetActiveSource().Intervals[0] > 37 and GetActiveSource().Intervals[1] == 900", True)],
    "drag one of two": [
        (wavelet(10) + chosen("IntervalVolume") + values("Intervals", [100.0, 200.0]) + [APPLY]
         + shell("SetActiveSource(FindSource('Wavelet1'))") + chosen("IntervalVolume") + values("Intervals", RANGE)
         + [APPLY] + dragged("Intervals", [6, 7, 8, 9]) + [APPLIED, *UNDO, APPLIED],
         "[list(source.Intervals) for source in (FindSource('IntervalVolume1'), FindSource('IntervalVolume2'))]",
         [[100.0, 200.0], RANGE])],
    "drag a hidden slider": [
        (wavelet(51) + chosen("IntervalVolume") + values("Intervals", RANGE) + [APPLY] + WATCH
         + dragging(slider_of("Intervals"), [6, 7, 8, 9]) + shell("SetActiveSource(FindSource('Wavelet1'))"),
         f"{FILTER}.SMProxy.GetProperty('PreviewCellLimit').GetElement(0)", 0)],
    "drag a deleted filter": [
        (wavelet(51) + chosen("IntervalVolume") + values("Intervals", RANGE) + [APPLY]
         + dragging(slider_of("Intervals"), [6, 7, 8, 9]) + shell(f"Delete({FILTER})"), FILTER, None)],
    "drag and disconnect": [
        (wavelet(51) + chosen("IntervalVolume") + values("Intervals", RANGE) + [APPLY]
         + dragging(slider_of("Intervals"), [6, 7, 8, 9]) + shell("Disconnect(); Connect()"), "len(GetSources())", 0)],
    "source cells": [
        (opened("disk_out_ref.vtu") + applied("IntervalVolume") + SELECT_SOURCE_CELLS
         + [check(MESSAGE + "qt_msgbox_label", "text", "Select cells in the output of an Interval Volume first.")]
         + clicked(MESSAGE + "qt_msgbox_buttonbox/1QPushButton0") + SELECT_CELLS + SELECT_SOURCE_CELLS
         + clicked(MESSAGE + "qt_msgbox_buttonbox/1QPushButton0"), ARE_SOURCES, True),
        (shell(f"{FILTER}.GenerateOriginArrays = 1") + [APPLY] + SELECT_CELLS, REMEMBERED, True),
        (SELECT_SOURCE_CELLS, ARE_SOURCES, True),
        ([], f"newcomer_record.selected({FILTER}, 'OriginCell')", []),
        ([], f"str(GetRepresentation({FILTER}.Input, GetActiveView()).Representation)", "'Outline'"),
        ([], "GetActiveSource().GetXMLName()", "XMLUnstructuredGridReader")],
    "source cells of blocks": [
        (opened("mug.ex2") + applied("IntervalVolume") + shell(f"{FILTER}.GenerateOriginArrays = 1") + [APPLY]
         + SELECT_CELLS, REMEMBERED, True),
        (SELECT_SOURCE_CELLS, ARE_SOURCES, True)],
    "skipped cells": [
        (shell("w = Wavelet(); w.UpdatePipeline(); f = ProgrammableFilter(Input=w); f.Script = 'import numpy; "
               "v = inputs[0].PointData[\"RTData\"]; "
               "output.PointData.append(numpy.where(v > 200, numpy.nan, v), \"value\")'; "
               "f.UpdatePipeline(); SetActiveSource(f)")
         + applied("IntervalVolume") + [check(INTERVALS + "Skipped", "visible", "true")], None, None)],
    "handles": [
        (shell("Show(Wavelet(WholeExtent=[-4, 4, -4, 4, -4, 4])); Render()") + drawn_as("Shadowed Slices"), HANDLES, 0),
        (shell(DISPLAY + ".ProjectiveLight = 1"), HANDLES, 1),
        (shell(DISPLAY + ".AreaLight = 1"), HANDLES, 2),
        (shell(DISPLAY + ".ProjectiveLight = 0"), HANDLES, 1),
        (shell(DISPLAY + ".AreaLight = 0"), HANDLES, 0),
        # A panel that is first opened while the volume is shown.
        (shell("w = Wavelet(WholeExtent=[-3, 3, -3, 3, -3, 3]); SetActiveSource(None); d = Show(w); "
               "d.SetRepresentationType('Shadowed Slices'); Render()") + shell("SetActiveSource(w)"), HANDLES, 0)],
}


def gestures(notes, uses):
    yield python("import newcomer_record; from paraview.simple import *")
    for use in uses:
        for index, (steps, expression, _) in enumerate(USES[use]):
            yield from steps
            if expression:
                yield python(f"newcomer_record.note({notes!r}, '{use} {index}', lambda: {expression})")
        yield python("newcomer_record.reset()")


def main():
    folder = os.path.realpath(sys.argv[1])
    uses = sys.argv[2:] or list(USES)
    os.makedirs(folder, exist_ok=True)
    notes = os.path.join(folder, "notes.json")
    if os.path.exists(notes):
        os.remove(notes)
    checks = Checks()
    status, log = play(gestures(notes, uses), folder, "client", SECONDS)
    checks.equal(status, 0, "exit status of the client")
    print("\n".join(log))
    results = {}
    if os.path.exists(notes):
        with open(notes, encoding="utf-8") as file:
            results = dict(json.loads(line) for line in file)
    for use in uses:
        for index, (_, expression, expected) in enumerate(USES[use]):
            if expression:
                name = f"{use} {index}"
                checks.equal(results.get(name), expected, name)
    checks.finish()


main()
