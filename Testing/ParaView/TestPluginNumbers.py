"""Both filters give inside ParaView what the C++ classes gave in the build of the VTK modules."""

import json

from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy
import numpy

from plugin_testing import (
    Checks, extractions_path, fetch, interval_volume, load_plugin, open_data, simplices, sizes)

TOLERANCE = 1e-12  # of a sum, whose order differs


def array_names(attributes):
    return sorted(attributes.GetArrayName(i) for i in range(attributes.GetNumberOfArrays()))


def compare(checks, name, grid, expected, id_array):
    checks.equal(grid.GetNumberOfCells(), expected["cells"], f"{name}, cells")
    checks.equal(grid.GetNumberOfPoints(), expected["points"], f"{name}, points")
    checks.equal(list(grid.GetBounds()), expected["bounds"], f"{name}, bounds")
    checks.equal(array_names(grid.GetPointData()), expected["arrays"]["point"], f"{name}, point arrays")
    checks.equal(array_names(grid.GetCellData()), expected["arrays"]["cell"], f"{name}, cell arrays")
    checks.close(sizes(simplices(grid)).sum(), expected["size"], TOLERANCE, f"{name}, size")
    ids = vtk_to_numpy(grid.GetCellData().GetArray(id_array))
    counts = numpy.unique(ids, return_counts=True)[1].tolist()
    checks.equal(counts, expected["cells_by_id"], f"{name}, cells by {id_array}")


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


def main():
    load_plugin()
    checks = Checks()
    with open(extractions_path("numbers.json"), encoding="utf-8") as file:
        extractions = json.load(file)
    checks.that(len(extractions) > 0, "there are extractions to repeat")
    for number, extraction in enumerate(extractions):
        name = f"{number}: {extraction['filter']} of {extraction['data']}"
        print(name, flush=True)
        if extraction["filter"] == "IntervalVolume":
            repeat_intervals(checks, name, extraction)
        else:
            repeat_contours(checks, name, extraction)
    checks.finish()


main()
