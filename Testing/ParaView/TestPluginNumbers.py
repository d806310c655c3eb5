# SPDX-License-Identifier: BSD-3-Clause
"""Tests that both filters in ParaView reproduce the results of the C++ classes."""

from paraview import simple

from extraction_measures import compare
from plugin_testing import fetch, interval_volume, open_data, read_extractions, run


def repeat_intervals(checks, name, extraction):
    volume = interval_volume(
        open_data(extraction["data"]), extraction["array"], extraction["intervals"], extraction["criteria"])
    volume.GenerateBoundaries = True
    compare(checks, f"{name}, tetrahedra", fetch(volume, 0), extraction["output"], "IntervalId")
    compare(checks, f"{name}, boundary", fetch(volume, 1), extraction["boundary"], "IntervalId")


def repeat_contours(checks, name, extraction):
    contour = simple.IsotableContour(Input=open_data(extraction["data"]))
    contour.ContourBy = ["POINTS", extraction["array"]]
    contour.Isosurfaces = extraction["values"]
    compare(checks, name, fetch(contour), extraction["output"], "ContourId")


def main(checks):
    extractions = read_extractions("numbers.json")
    for number, extraction in enumerate(extractions):
        name = f"{number}: {extraction['filter']} of {extraction['data']}"
        print(name, flush=True)
        if extraction["filter"] == "IntervalVolume":
            repeat_intervals(checks, name, extraction)
        else:
            repeat_contours(checks, name, extraction)


run(main)
