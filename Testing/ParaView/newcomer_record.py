# SPDX-License-Identifier: BSD-3-Clause
"""Records the view in the client's Python shell, and clears the pipeline."""

import contextlib
import ctypes
import hashlib
import json
import os
import sys
import tempfile
import time
import traceback

from paraview import servermanager, simple, smtrace
from vtkmodules.vtkCommonCore import vtkUnsignedCharArray

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
IMAGES = []
OBSERVERS = []


def observe(*observers):
    """Replaces all observers by the given ones, each with its object, event and function. They are called first."""
    while OBSERVERS:
        observed, observer = OBSERVERS.pop()
        observed.RemoveObserver(observer)
    OBSERVERS.extend((observed, observed.AddObserver(event, function, 1.0)) for observed, event, function in observers)


def watch():
    """Starts recording the number of cells of the active source at each image of the active view, and a trace. No
    image is refined until watched() is called, because a refinement would look like an image of the drag."""
    source = simple.GetActiveSource().GetClientSideObject()
    FRAMES.clear()
    set_progressive(0)
    simple.Render()  # a refinement of the previous image may be due
    observe((simple.GetActiveView().SMProxy, "EndEvent",
             lambda *_: FRAMES.append(source.GetOutputDataObject(0).GetNumberOfElements(1))))
    if servermanager.vtkSMTrace.GetActiveTracer():  # of a previous drag that was not read
        smtrace.stop_trace()
    smtrace.start_trace()


def watched(name):
    """Returns facts about a drag that watch() has recorded: whether there were images during it, whether they had much
    fewer cells than the last image, whether that image is exact, and the number of lines of trace that set the
    property."""
    lines = smtrace.stop_trace().splitlines()
    set_progressive(1)
    source = simple.GetActiveSource().GetClientSideObject()
    shown = FRAMES[-1] if FRAMES else 0
    source.Modified()
    source.Update()
    return [len(set(FRAMES)) > 2, 2 * max(FRAMES[:-1], default=0) < shown,
            shown == source.GetOutputDataObject(0).GetNumberOfElements(1),
            sum(f".{name} = " in line for line in lines)]


def set_progressive(is_progressive):
    """Turns progressive images of the client on or off."""
    simple.GetSettingsProxy("InterlumeSettings").ProgressiveImages = is_progressive


def image():
    """Returns a digest of the image that the active view shows."""
    window = simple.GetActiveView().GetRenderWindow()
    pixels = vtkUnsignedCharArray()
    window.GetPixelData(0, 0, window.GetSize()[0] - 1, window.GetSize()[1] - 1, 1, pixels, 0)
    return hashlib.md5(memoryview(pixels)).hexdigest()


SCREENSHOTS = []


def take_screenshot():
    """Saves the active view as an image, and stores its pixels."""
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "image.png")
        simple.SaveScreenshot(path, simple.GetActiveView())
        with open(path, "rb") as file:
            SCREENSHOTS.append(file.read())


def is_screenshot_complete():
    """Returns true if the last screenshot has the pixels of a screenshot without progressive images."""
    complete(take_screenshot)
    return SCREENSHOTS[-1] == SCREENSHOTS[-2]


def complete(draw):
    """Returns the result of a function that draws, without progressive images."""
    set_progressive(0)
    result = draw()
    set_progressive(1)
    return result


def drawn():
    simple.Render()
    return image()


def move_mouse():
    """Moves the mouse through the X server to the center of the screen and away from it."""
    server = ctypes.CDLL("libX11.so.6")
    server.XOpenDisplay.restype = ctypes.c_void_p
    connection = ctypes.c_void_p(server.XOpenDisplay(None))
    size = [function(connection, 0) for function in (server.XDisplayWidth, server.XDisplayHeight)]
    for offset in (0, 3):
        server.XWarpPointer(connection, 0, server.XDefaultRootWindow(connection), 0, 0, 0, 0,
                            size[0] // 2 + offset, size[1] // 2)
    server.XCloseDisplay(connection)
    time.sleep(0.1)


def watch_images(moves_mouse=False):
    """Starts recording the images that the active view shows, and which were aborted. With `moves_mouse`, the mouse
    moves during all images after the first one, until one is aborted."""
    view, window = simple.GetActiveView().SMProxy, simple.GetActiveView().GetRenderWindow()

    def check(*_):
        if moves_mouse and IMAGES and not any(is_aborted for _, is_aborted in IMAGES):
            move_mouse()

    IMAGES.clear()
    observe((view, "EndEvent", lambda *_: IMAGES.append((image(), bool(window.GetAbortRender())))),
            (window, "AbortCheckEvent", check))


def refined():
    """Returns facts about the images since watch_images(): whether the first one was coarse and the last one complete,
    whether some were aborted, and whether these did not change what the view shows."""
    images = list(IMAGES)
    observe()
    aborted = [i for i, (_, is_aborted) in enumerate(images) if is_aborted]
    last = complete(drawn)
    return [images[0][0] != last, images[-1][0] == last, bool(aborted),
            all(images[i][0] == images[i - 1][0] for i in aborted)]


SELECTED = []


def selected(source, array):
    """Returns the values of a cell array in the selected cells of a source, with the composite indices of blocks."""
    proxy = source.SMProxy
    if not proxy.GetSelectionInput(0):
        return []
    extract = proxy.GetSelectionOutput(0)
    extract.UpdatePipeline(simple.GetAnimationScene().TimeKeeper.Time)
    data = extract.GetClientSideObject().GetOutputDataObject(0)
    blocks = [(0, data)]
    if data.IsA("vtkCompositeDataSet"):
        at = data.NewIterator()
        blocks = []
        at.InitTraversal()
        while not at.IsDoneWithTraversal():
            blocks.append((at.GetCurrentFlatIndex(), at.GetCurrentDataObject()))
            at.GoToNextItem()
    arrays = [(index, block.GetCellData().GetArray(array)) for index, block in blocks]
    return sorted({(index, values.GetValue(i)) for index, values in arrays if values
                   for i in range(values.GetNumberOfValues())})


def remember(source):
    """Stores the source cells of the cells that are selected in the output of a filter, and returns them."""
    SELECTED[:] = selected(source, "OriginCell")
    return SELECTED


def reset():
    set_progressive(1)
    simple.ResetSession()
