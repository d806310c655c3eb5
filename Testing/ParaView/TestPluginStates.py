# SPDX-License-Identifier: BSD-3-Clause
"""Loads the state files in Examples/ParaView/States, and compares their images with those of the examples.

Arguments: the directory of the states, and the directory of the images written by TestPluginExample.py.
"""

import glob
import os
import sys

import numpy
from paraview import servermanager, simple
from vtkmodules.vtkIOImage import vtkPNGReader

from plugin_images import pixels
from plugin_testing import data_path, run

LARGEST_MEAN = 0.5  # mean difference from the example's image, in steps of 1/255
SMALLEST_FRACTION = 0.12  # fraction of pixels that differ from the background


def size_of(path):
    reader = vtkPNGReader()
    reader.SetFileName(path)
    reader.Update()
    return reader.GetOutput().GetDimensions()[:2]


def check_state(checks, state, expected):
    name = os.path.basename(state)
    with open(state, encoding="utf-8") as file:
        checks.that('value="Data/' in file.read(), f"{name} has a relative path")
    simple.LoadState(state, data_directory=data_path(""), restrict_to_data_directory=True)
    view = simple.GetRenderViews()[0]
    view.ViewSize = size_of(expected)
    drawn = expected.replace(".png", "-state.png")
    simple.SaveScreenshot(drawn, view)
    image = pixels(drawn)
    shown = (image != image[0]).any(axis=1).mean()
    difference = numpy.abs(image - pixels(expected)).mean()
    print(f"{name}: shown {shown:.3f}, mean difference {difference:.4f}", flush=True)
    checks.that(shown >= SMALLEST_FRACTION, f"{name} is visible")
    # The states are written by ParaView 5, whose defaults for settings that the examples do not set differ later.
    if servermanager.vtkSMProxyManager.GetVersionMajor() < 6:
        checks.that(difference <= LARGEST_MEAN, f"{name} equals the example")


def main(checks):
    states, images = sys.argv[1:]
    files = sorted(glob.glob(os.path.join(states, "*.pvsm")))
    checks.that(len(files) >= 4, "there are states")
    for state in files:
        stem = os.path.splitext(os.path.basename(state))[0]
        check_state(checks, state, os.path.join(images, stem + ".png"))
        for proxy in simple.GetSources().values():
            simple.Delete(proxy)
        simple.Delete(simple.GetRenderViews()[0])


run(main)
