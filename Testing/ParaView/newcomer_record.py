# SPDX-License-Identifier: BSD-3-Clause
"""Records the view in the client's Python shell, and clears the pipeline."""

import contextlib
import json
import os
import sys
import traceback

from paraview import simple, smtrace

SIZE = [480, 360]


@contextlib.contextmanager
def without_annotations(view):
    """Hides axes and legends, whose text differs slightly between machines."""
    bars = [bar for bar in view.Representations if "ScalarBar" in bar.GetXMLName()]
    shown = [(bar, "Visibility", bar.Visibility) for bar in bars]
    for name in ("OrientationAxesVisibility", "CenterAxesVisibility"):
        shown.append((view, name, getattr(view, name)))
    for proxy, name, _ in shown:
        setattr(proxy, name, 0)
    yield
    for proxy, name, visibility in shown:
        setattr(proxy, name, visibility)


def facts(view):
    """Returns the type and the rendering settings of the active source."""
    source = simple.GetActiveSource()
    display = simple.GetRepresentation(source, view)
    return {
        "source": source.GetXMLLabel(),
        "cells": source.GetDataInformation().GetNumberOfCells(),
        "representation": str(display.Representation).strip("'"),
        "colored by": str(display.ColorArrayName[1]),
        "background": [float(value) for value in view.Background],
    }


def record(folder, use):
    """Saves the image of the active view and its settings in files named after the use."""
    try:
        view = simple.GetActiveView()
        with without_annotations(view):
            path = os.path.join(folder, use + ".png")
            simple.SaveScreenshot(path, view, ImageResolution=SIZE)
        with open(os.path.join(folder, use + ".json"), "w", encoding="utf-8") as file:
            json.dump(facts(view), file)
    except Exception:  # the shell shows errors only in its window
        traceback.print_exc(file=sys.__stderr__)


def note(path, name, evaluate):
    """Appends the result of a function to a file, one line of JSON per call."""
    try:
        with open(path, "a", encoding="utf-8") as file:
            json.dump([name, evaluate()], file)
            file.write("\n")
    except Exception:  # the shell shows errors only in its window
        traceback.print_exc(file=sys.__stderr__)


def handles():
    """Returns the number of widgets with handles that are visible in the active view."""
    widgets = simple.GetActiveView().SMProxy.GetProperty("HiddenRepresentations")
    shown = [widgets.GetProxy(i).GetProperty("Visibility") for i in range(widgets.GetNumberOfProxies())]
    return sum(visibility.GetElement(0) for visibility in shown if visibility)


FRAMES = []
OBSERVERS = []


def watch():
    """Starts recording the number of cells of the active source at each image of the active view, and a trace."""
    source = simple.GetActiveSource().GetClientSideObject()
    view = simple.GetActiveView().SMProxy
    for observer in OBSERVERS:
        view.RemoveObserver(observer)
    FRAMES.clear()
    OBSERVERS[:] = [view.AddObserver(
        "EndEvent", lambda *_: FRAMES.append(source.GetOutputDataObject(0).GetNumberOfElements(1)))]
    smtrace.start_trace()


def watched(name):
    """Returns facts about a drag that watch() has recorded: whether there were images during it, whether they had much
    fewer cells than the last image, whether that image is exact, and the number of lines of trace that set the
    property."""
    lines = smtrace.stop_trace().splitlines()
    source = simple.GetActiveSource().GetClientSideObject()
    shown = FRAMES[-1] if FRAMES else 0
    source.Modified()
    source.Update()
    return [len(set(FRAMES)) > 2, 2 * max(FRAMES[:-1], default=0) < shown,
            shown == source.GetOutputDataObject(0).GetNumberOfElements(1),
            sum(f".{name} = " in line for line in lines)]


def reset():
    simple.ResetSession()
