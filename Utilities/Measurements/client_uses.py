# SPDX-License-Identifier: BSD-3-Clause
"""Uses of the ParaView client that measure_client.py measures. The client runs this file as its --script.

INTERLUME_USE names the use, and INTERLUME_ROWS the file that receives one line of JSON per measurement. Mouse events
come from xdotool through the X server. Times are processor times of the client, in seconds, so they hardly depend on
other programs.
"""

import builtins
import json
import os
import subprocess
import sys
import time
import traceback

from paraview import servermanager, simple
from PyQt5.QtCore import QObject, QPoint, QTimer
from PyQt5.QtWidgets import (
    QAction, QApplication, QComboBox, QMessageBox, QSlider, QStyle, QStyleOptionSlider, QToolTip)
from vtkmodules.vtkRenderingCore import vtkCoordinate

DRAG = os.environ["INTERLUME_DRAG"]  # Path of drag.py.
TICK = 0.05  # Time between checks of a condition.
REST = 0.6  # Time without frames after which the client is at rest.
# Defaults that restore the behavior without levels of detail.
OFF = {"representations": {"UnstructuredGridRepresentation": {"IntervalAutoAdjustLevelOfDetail": 0}}}


class Steps:
    """Runs a generator in the client's event loop. It yields the condition of its next step."""

    def __init__(self, steps):
        self.steps = steps
        self.condition = None
        # A timer does not fire during its own function, so dialogs need another one.
        self.timers = [QTimer(), QTimer()]
        for timer, function in zip(self.timers, (self.advance, confirm)):
            timer.timeout.connect(function)
            timer.start(int(1000 * TICK))

    def advance(self):
        status = 0
        try:
            if not self.condition or self.condition():
                self.condition = next(self.steps)
            return
        except StopIteration:
            pass
        except Exception:  # Qt would print it and continue.
            traceback.print_exc(file=sys.__stderr__)
            status = 1
        os._exit(status)  # The client's destructors may wait for a dialog.


def confirm():
    """Answers a question, such as whether to draw a large volume, with yes."""
    box = QApplication.activeModalWidget()
    if isinstance(box, QMessageBox):
        box.button(QMessageBox.Yes if box.button(QMessageBox.Yes) else QMessageBox.Ok).click()


class Frames:
    """Records the processor times at which the active view has shown a complete frame."""

    def __init__(self):
        self.times = []
        self.window = simple.GetActiveView().GetRenderWindow()
        self.window.AddObserver("EndEvent", self.record)

    def record(self, _caller, _event):
        if not self.window.GetAbortRender():
            self.times.append(time.process_time())

    def take(self):
        taken, self.times = self.times, []
        return taken

    def at_rest(self):
        """Returns a condition: no frame and hardly any processor time for a while."""
        last = {}

        def condition():
            if last.get("frames") != len(self.times) or time.process_time() - last["processor"] > 0.3 * REST:
                last.update(frames=len(self.times), processor=time.process_time(), wall=time.monotonic(), checks=0)
            last["checks"] += 1
            return time.monotonic() - last["wall"] > REST and last["checks"] > 0.5 * REST / TICK
        return condition


def after(seconds):
    end = time.monotonic() + seconds
    return lambda: time.monotonic() > end


def widget_of(name, kind=QObject):
    """Returns the visible widget with an object or class name."""
    for widget in QApplication.instance().allWidgets():
        if name in (widget.objectName(), widget.metaObject().className()) and widget.isVisible() and isinstance(
                widget, kind):
            return widget
    raise LookupError(f"the client shows no widget {name}")


def action_of(name):
    """Returns a menu entry or button of the main window."""
    main = [top for top in QApplication.instance().topLevelWidgets() if top.objectName() == "pqClientMainWindow"][0]
    return main.findChildren(QAction, name)[0]


def position(widget, x, y):
    """Returns the screen position of a fraction of a widget's size."""
    point = widget.mapToGlobal(QPoint(int(x * widget.width()), int(y * widget.height())))
    return point.x(), point.y()


def slider_positions(widget):
    """Returns the screen positions of a slider's handle, and a third of its length away from it."""
    slider = [one for one in widget.findChildren(QSlider) if one.isVisible()][-1]
    option = QStyleOptionSlider()
    slider.initStyleOption(option)
    handle = slider.style().subControlRect(QStyle.CC_Slider, option, QStyle.SC_SliderHandle, slider).center()
    end = handle + QPoint(-slider.width() // 3, 0)
    return [(point.x(), point.y()) for point in (slider.mapToGlobal(handle), slider.mapToGlobal(end))]


def handle_positions(point):
    """Returns the screen positions of a point of the scene, and 60 pixels away from it."""
    place = vtkCoordinate()
    place.SetCoordinateSystemToWorld()
    place.SetValue(*point)
    x, y = place.GetComputedDisplayValue(simple.GetActiveView().GetRenderer())
    view = widget_of("pqQVTKWidget")
    start = view.mapToGlobal(QPoint(x, view.height() - 1 - y))
    return [(start.x(), start.y()), (start.x() - 60, start.y() + 60)]


def gap(times):
    return max((b - a for a, b in zip(times, times[1:])), default=0.0)


def tetrahedra():
    """Returns the number of cells of the active source's output."""
    return simple.GetActiveSource().GetDataInformation().GetNumberOfCells()


def write(method, **numbers):
    row = {"suite": "client", "case": os.environ["INTERLUME_USE"], "method": method,
           "parameter": os.environ["INTERLUME_DETAIL"], **{name: round(value, 3) for name, value in numbers.items()}}
    with open(os.environ["INTERLUME_ROWS"], "a", encoding="utf-8") as file:
        file.write(json.dumps(row) + "\n")


def changed(frames, method, change, algorithm=None):
    """Measures the time until the first and the last frame after a change, or after an algorithm's execution."""
    yield frames.at_rest()
    frames.take()
    ends = []
    if algorithm:
        algorithm.AddObserver("EndEvent", lambda _caller, _event: ends.append(time.process_time()))
    start = time.process_time()
    change()
    yield lambda: frames.times or method == "collapse"
    yield frames.at_rest()
    end = ends[-1] if ends else start
    times = [end] + [one for one in frames.take() if one > end]
    write(method, cells=tetrahedra(), execution_seconds=end - start, first_seconds=times[min(1, len(times) - 1)] - end,
          still_seconds=times[-1] - end, frames=len(times) - 1, longest_seconds=gap(times))


def dragged(frames, method, start, end):
    """Measures the frames of a drag, and the time from the release to the last frame."""
    yield frames.at_rest()
    frames.take()
    begin = time.process_time(), time.monotonic()
    process = subprocess.Popen(["python3", DRAG, *map(str, (os.getpid(), *start, *end))])
    yield lambda: process.poll() is not None
    last = time.process_time(), time.monotonic()
    times = frames.take()
    subprocess.run(["xdotool", "mouseup", "1"], check=True)
    yield frames.at_rest()
    write(method, frames=len(times), processor_seconds=last[0] - begin[0], wall_seconds=last[1] - begin[1],
          longest_seconds=gap([begin[0], *times, last[0]]), still_seconds=max(frames.take(), default=last[0]) - last[0])


def answered(frames, method, words):
    """Measures the processor time from a gesture, given as arguments of xdotool, until the client is at rest."""
    yield frames.at_rest()
    frames.take()
    start = time.process_time()
    gesture = subprocess.Popen(["xdotool", *map(str, words)])
    yield lambda: gesture.poll() is not None
    yield frames.at_rest()
    write(method, cells=tetrahedra(), frames=len(frames.take()), processor_seconds=time.process_time() - start)


def toggled(name):
    """Presses a button of the view."""
    action_of(name).trigger()
    yield after(1)


def hovered(frames, name):
    """Moves the mouse over the view while a tooltip shows values, and stops there."""
    yield from toggled(name)
    view = widget_of("pqQVTKWidget")
    for step in range(4):
        x, y = position(view, 0.45 + 0.02 * step, 0.5)
        yield from answered(frames, name + ("" if step else ", first"), ("mousemove", x, y))
        if not QToolTip.isVisible():
            print(f"{name}: no tooltip is visible.", file=sys.__stderr__)
    yield from toggled(name)


def selected(frames):
    """Drags a rubber band over most of the view."""
    yield from toggled("actionSelectSurfaceCells")
    view = widget_of("pqQVTKWidget")
    begin, end = position(view, 0.2, 0.2), position(view, 0.8, 0.8)
    yield from answered(frames, "rubber band", (
        "mousemove", *begin, "sleep", 0.3, "mousedown", 1, "sleep", 0.3, "mousemove", *end, "sleep", 0.3, "mouseup", 1))


def rotated(frames):
    view = widget_of("pqQVTKWidget")
    yield from dragged(frames, "rotate", position(view, 0.4, 0.5), position(view, 0.6, 0.6))


def collapsed(frames):
    """Collapses the panel's group of properties, and expands it again."""
    words = ["xdotool", "mousemove", *map(str, position(widget_of("PropertiesButton"), 0.3, 0.5)), "click", "1"]
    yield from changed(frames, "collapse", lambda: subprocess.run(words, check=True))
    subprocess.run(words, check=True)


def shown(source, **properties):
    """Shows a source that the script creates, as after opening it."""
    simple.SetActiveSource(source)
    source.UpdatePipeline()
    simple.Show(source, **properties)
    simple.ResetCamera()


def applied(frames, name, **properties):
    """Creates a filter from its menu entry, sets its properties and presses Apply."""
    yield frames.at_rest()  # The client enables menu entries with a delay.
    action_of(name).trigger()
    yield after(1)
    proxy = simple.GetActiveSource()
    for key, value in properties.items():
        setattr(proxy, key, value)
    yield from changed(frames, "shown", widget_of("Accept").click, proxy.GetClientSideObject())


def intervals(points):
    def use(frames):
        shown(simple.AnalyticField(Field="Gyroid", NumberOfTimeSteps=1, WholeExtent=[0, points - 1] * 3))
        yield from applied(frames, "IntervalVolume", Intervals=[-0.6, 0.6])
        yield from rotated(frames)
        yield from dragged(frames, "slider", *slider_positions(widget_of("Intervals")))
        yield from collapsed(frames)
    return use


def selections(frames):
    shown(simple.AnalyticField(Field="Gyroid", NumberOfTimeSteps=1, WholeExtent=[0, 71] * 3))
    yield from applied(frames, "IntervalVolume", Intervals=[-0.6, 0.6])
    yield from hovered(frames, "actionHoveringSurfaceCells")
    yield from hovered(frames, "actionHoveringSurfacePoints")
    yield from selected(frames)


def time_steps(frames):
    shown(simple.AnalyticField(Field="Vortex", NumberOfTimeSteps=24, WholeExtent=[0, 63] * 3))
    yield from applied(frames, "TimeVaryingIntervalVolume", Intervals=[0.07, 0.65], TimeStepRange=[0, 23],
                       TimeStepStride=1)
    yield from rotated(frames)


def slices(make_source):
    def use(frames):
        source = make_source()
        shown(source)
        yield after(1)
        display = simple.GetRepresentation(source)
        chooser = widget_of("displayRepresentation").findChild(QComboBox)
        yield from changed(frames, "Volume", lambda: chooser.setCurrentText("Volume"))
        display.Shade = 1
        yield from changed(frames, "Volume, shaded", simple.Render)
        yield from changed(frames, "shown", lambda: chooser.setCurrentText("Shadowed Slices"))
        yield from rotated(frames)
        display.AreaLight = 1
        yield after(1)
        before = list(display.AreaLightPosition)
        yield from dragged(frames, "handle", *handle_positions(before))
        if list(display.AreaLightPosition) == before:
            print("The mouse missed the handle of the area light.", file=sys.__stderr__)
        yield from collapsed(frames)
    return use


def opened(name):
    return simple.OpenDataFile(os.path.join(os.environ["INTERLUME_DATA"], name))


USES = {
    "time-24x64": time_steps,
    "intervals-6M": intervals(132),
    "intervals-8M": intervals(144),
    "select-1M": selections,
    "slices-256x256x128": slices(
        lambda: simple.ExtractSubset(Input=opened("bonsai.vti"), VOI=[0, 255, 0, 255, 64, 191])),
    "slices-256": slices(lambda: opened("bonsai.vti")),
    "slices-64": slices(lambda: opened("hydrogen_orbital.vti")),
    "slices-21": slices(lambda: simple.Wavelet(WholeExtent=[-10, 10] * 3)),
}


def started(use):
    yield after(1)
    for widget in QApplication.instance().topLevelWidgets():
        if isinstance(widget, QMessageBox):
            widget.close()
    simple.LoadPlugin(os.environ["INTERLUME_PLUGIN"], remote=False, ns=vars(simple))  # Adds its sources to simple.
    simple.GetActiveViewOrCreate("RenderView")
    if os.environ["INTERLUME_DETAIL"] == "off":
        servermanager.vtkSMSettings.GetInstance().AddCollectionFromString(json.dumps(OFF), 1e6)
        simple.GetSettingsProxy("InterlumeSettings").ProgressiveImages = 0
    yield from use(Frames())


builtins.interlume_steps = Steps(started(USES[os.environ["INTERLUME_USE"]]))
