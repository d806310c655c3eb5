# SPDX-License-Identifier: BSD-3-Clause
"""write_numbers.py FOLDER: writes reference results for the tests of the ParaView plugin.

Writes numbers.json, a list of extractions with filter, data, settings and results, and the data in the
legacy format. Also writes time_varying.json and flow.json for temporal sources and flows. The plugin must
reproduce the results.

The legacy format is used because ParaView 5.11 of Debian cannot read appended XML data with an expat that
defers parsing (2.6, and 2.5 with that fix).
"""

import json
import os
import sys

import numpy
from interlume import (
    vtkAnalyticFieldSource, vtkAnalyticFlowSource, vtkFlowCriticalPoints, vtkIsotableContour,
    vtkSimplexTimeSlice)
from vtkmodules.util.numpy_support import numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkDataObject
from vtkmodules.vtkIOLegacy import vtkDataSetWriter

import pipelines
from pieces import named, write_pieces
from pipelines import connected, updated
from simplex_measures import counts, measure

FILES = {"disk_out_ref": "disk_out_ref.vtu", "bluntfin": "bluntfin.vts", "post_tets": "post_tets.vtk"}
INTERVALS = (
    ("wavelet", "RTData", [[140.0, 180.0]], []),
    ("wavelet", "RTData", [[60.0, 100.0], [100.0, 130.0], [200.0, 250.0]], []),
    ("bluntfin", "Density", [[1.2, 2.5]], []),
    ("disk_out_ref", "Temp", [[400.0, 500.0], [500.0, 700.0]], []),
    ("disk_out_ref", "Temp", [[350.0, 600.0]], [["Pres", 0.01, 0.02]]),
    ("post_tets", "Pressure", [[0.8, 1.1]], []))
CONTOURS = (("wavelet", "RTData", [100.0, 157.0]), ("disk_out_ref", "Temp", [400.0]))
DISTRIBUTED = {"disk_out_ref": "Temp", "post_tets": "Pressure"}
NUMBER_OF_PIECES = 4

ALL_KINDS = list(range(8))
TIME_VARYING = (
    # Two adjacent intervals, and a slice at the time step between two slabs.
    {"source": "AnalyticField",
     "source_properties": {
         "Field": vtkAnalyticFieldSource.VORTEX, "WholeExtent": [0, 19, 0, 23, 0, 15],
         "Bounds": [-0.5, 0.5, -0.6, 0.6, -0.4, 0.4], "NumberOfTimeSteps": 3, "TimeRange": [0.0, 2.0]},
     "properties": {"Intervals": [0.4, 0.5, 0.5, 0.8], "Boundaries": ALL_KINDS, "GenerateSimplices": 1},
     "slice_times": [0.3, 1.0]},
    # A range of time steps, and a projection direction other than time.
    {"source": "AnalyticField",
     "source_properties": {
         "Field": vtkAnalyticFieldSource.WAVE, "WholeExtent": [0, 19, 0, 9, 0, 9],
         "Bounds": [-2.0, 2.0, -1.0, 1.0, -1.0, 1.0], "NumberOfTimeSteps": 5, "TimeRange": [0.0, 2.0]},
     "properties": {
         "Intervals": [-0.15, 0.15], "TimeStepRange": [1, 3], "ProjectionDirection": [0.5, 0.0, 0.25, 1.0],
         "OutputPointsPrecision": 1, "Boundaries": [1, 2, 4], "GenerateSimplices": 1},
     "slice_times": [0.75]},
    {"source": "TaperedCylinderWake",
     "source_properties": {"Dimensions": [16, 24, 8], "NumberOfTimeSteps": 2, "TimeRange": [0.0, 0.5]},
     "properties": {"Intervals": [0.9934, 0.9944], "Boundaries": ALL_KINDS, "GenerateSimplices": 1},
     "slice_times": [0.25]})


def flow(field, points):
    return {"Field": field, "WholeExtent": [0, points] * 3, "Bounds": [-1.0, 1.0] * 3}


def surface(kind, **properties):
    return {"kind": kind, "properties": properties}


def volume(**properties):
    return {"GenerateStreamSurfaces": 1, "GenerateTimeSurfaces": 1, **properties}


FLOWS = (
    # Flow around a sphere from an upstream rectangle: two intervals, with surfaces inside them.
    {"source_properties": flow(vtkAnalyticFlowSource.SPHERE, 19),
     "surfaces": [surface("Rectangle", Center=[-0.875, 0.0, 0.125], Normal=[1.0, 0.0, 0.0], Lengths=[1.5, 1.25])],
     "meshes": [], "field": {}, "mapping": {"Formula": "u + v/4"},
     "volume": volume(Intervals=[0.25, 0.5, 0.5, 0.75], TimeRange=[0.2, 1.2], StreamSurfaces=[0.4],
                      TimeSurfaces=[0.6, 0.9], GenerateNormals=1),
     "texture": {"LengthScale": 4.0, "TimeScale": 0.5, "Resolution": 64},
     "lic": {"NoiseScale": 0.125, "Contrast": 0.25}},
    # A source and a sink: two surfaces with ids, rings on one and formulas for the faces of the other, on
    # image samples, forward with the classical method.
    {"source_properties": flow(vtkAnalyticFlowSource.SOURCE_SINK, 23),
     "surfaces": [surface("Sphere", Center=[0.5, 0.0, 0.0], Radius=0.25, Axis=[1.0, 0.0, 0.0], Id=7),
                  surface("Box", Position=[-0.9375, -0.875, -0.75], Lengths=[1.875, 1.75, 1.5], Id=20)],
     "meshes": [],
     "field": {"Direction": 1, "Integrator": 2, "SampleMode": 1, "SampleDimensions": [17, 15, 13],
               "SampleBounds": [-0.75, 0.75, -0.625, 0.625, -0.5, 0.5], "ComputeArcLength": 1},
     "mapping": {"Formula": "v", "FormulasById": [[22, "u*v"], [23, "2 - v"]],
                 "Rings": [[7, 0.5, 0.5, 0.25, 0.125, 1.0], [7, 0.0, 0.75, 0.0, 0.25, 0.5]]},
     "volume": volume(Intervals=[0.25, 0.75], TimeSurfaces=[1.0], OutputPointsPrecision=1),
     "texture": {"StartPoints": [0.75, 0.0, 0.0]},
     "lic": {"NoiseScale": 0.25, "Length": 1.0, "StepLength": 0.125, "Kernel": 0, "Seed": 3}},
    # A hurricane: a closed cylinder, the mesh of a sphere, and an image over u and v.
    {"source_properties": flow(vtkAnalyticFlowSource.HURRICANE, 15),
     "surfaces": [surface("Cylinder", Center=[0.0, 0.0, -0.25], Axis=[0.0, 0.0, 2.0], Radius=0.625, Length=1.0,
                          Capped=1)],
     "meshes": [surface("Sphere", Center=[0.5, 0.5, 0.5], Radius=0.25, Axis=[0.0, 0.0, 1.0])],
     "field": {"MaximumTime": 4.0, "KeepSteps": 1}, "mapping": {"Formula": "u"},
     "image": [-10, 10, -8, 8, 0, 0], "ImageId": 0,
     "volume": volume(Intervals=[130.0, 200.0], StreamSurfaces=[160.0], TimeSurfaces=[0.5, 1.0]),
     "texture": {}, "lic": {}},
    # A tornado: a tube around its axis, and the domain faces.
    {"source_properties": flow(vtkAnalyticFlowSource.TORNADO, 15), "surfaces": [], "meshes": [],
     "axis": {"NumberOfPlanes": 11, "SearchRadius": 0.5}, "TubeRadius": 0.125,
     "field": {"DomainFaces": 1, "DomainFaceId": 50, "MaximumTime": 3.0}, "mapping": {"Formula": "v + f/100"},
     "volume": volume(StreamSurfaces=[1.0], TimeSurfaces=[0.5])},
    # An unbounded plane, a tube, and spheres around critical points.
    {"source_properties": flow(vtkAnalyticFlowSource.COUPLED_CHARGE, 15),
     "surfaces": [surface("Parallelogram", Origin=[0.75, -0.5, -0.5], Point1=[0.75, 0.5, -0.25],
                          Point2=[0.875, -0.5, 0.5], Unbounded=1),
                  surface("Tube", Points=[0.0, -0.5, -0.5, 0.0, 0.0, -0.375, 0.0, 0.5, -0.5], Radius=0.125,
                          Capped=1)],
     "meshes": [], "field": {"CriticalPointSpheres": 1, "CriticalPointRadius": 1.5}, "mapping": {"Formula": "u"},
     "volume": volume(Intervals=[0.25, 0.75], TimeSurfaces=[0.125])})


def write_data(folder):
    """Returns the datasets by name, after writing a copy of each file for ParaView."""
    datasets = {"wavelet": pipelines.wavelet()}
    for name, file in FILES.items():
        data = datasets[name] = pipelines.read_data(file)
        # Global point ids survive redistribution to other processes. Their order determines how
        # cells are split.
        ids = numpy_to_vtkIdTypeArray(numpy.arange(data.GetNumberOfPoints()), deep=True)
        data.GetPointData().SetGlobalIds(named(ids, "GlobalPointIds"))
        writer = vtkDataSetWriter()
        writer.SetInputData(data)
        writer.SetFileTypeToBinary()
        writer.SetFileName(os.path.join(folder, name + ".vtk"))
        assert writer.Write() == 1, f"cannot write to {folder}"
    return datasets


def extract_intervals(datasets, data, array, intervals, criteria):
    algorithm = pipelines.interval_volume(datasets[data], array, intervals)
    algorithm.GenerateBoundariesOn()
    for criterion in criteria:
        algorithm.AddCriterion(*criterion)
    algorithm.Update()
    return {"filter": "IntervalVolume", "data": data, "array": array, "intervals": intervals, "criteria": criteria,
            "output": measure(algorithm.GetOutput(0), "IntervalId"),
            "boundary": measure(algorithm.GetOutput(1), "IntervalId")}


def extract_contours(datasets, data, array, values):
    algorithm = vtkIsotableContour()
    algorithm.SetInputData(datasets[data])
    algorithm.SetInputArrayToProcess(0, 0, 0, vtkDataObject.FIELD_ASSOCIATION_POINTS, array)
    for i, value in enumerate(values):
        algorithm.SetValue(i, value)
    algorithm.Update()
    return {"filter": "IsotableContour", "data": data, "array": array, "values": values,
            "output": measure(algorithm.GetOutput(0), "ContourId")}


def measure_in_time(description):
    algorithm = updated(pipelines.time_varying_volume(description))
    slices = []
    for time in description["slice_times"]:
        cut = connected(vtkSimplexTimeSlice(), algorithm, 2)
        cut.SetTime(time)
        slices.append(measure(updated(cut).GetOutput(), "IntervalId"))
    return {**description, "tetrahedra": measure(algorithm.GetOutput(0), "SimplexClass"),
            "boundaries": measure(algorithm.GetOutput(1), "BoundaryKind"),
            "simplices": measure(algorithm.GetOutput(2), "TimeSlab"), "slices": slices}


def finite_sum(array, component=None):
    """Returns the sum of the finite values of an array or one of its components."""
    values = vtk_to_numpy(array)
    values = values if component is None else values[:, component]
    return values[numpy.isfinite(values)].sum(dtype=float)


def measure_samples(data):
    arrays = data.GetPointData()
    parameters = arrays.GetArray("TerminationUV")
    return {"number": data.GetNumberOfPoints(), "statuses": counts(arrays.GetArray("FlowStatus")),
            "ids": counts(arrays.GetArray("TerminationId")), "u": finite_sum(parameters, 0),
            "v": finite_sum(parameters, 1), "time": finite_sum(arrays.GetArray("AdvectionTime")),
            "inflow": finite_sum(arrays.GetArray("Inflow"))}


def measure_texture(texture):
    arrays = texture.GetOutput().GetPointData()
    coordinates = arrays.GetArray("StreamTexture")
    return {"contours": counts(arrays.GetArray("ContourId")), "length": finite_sum(coordinates, 0),
            "time": finite_sum(coordinates, 1)}


def measure_flow(description):
    field = pipelines.flow_field(description)
    mapping = updated(pipelines.inflow_mapping(field, description))
    algorithm = updated(pipelines.flow_volume(mapping, description))
    ids = ("IntervalId", "StreamSurfaceId", "TimeSurfaceId")
    result = {**description, "points": measure_samples(mapping.GetOutputDataObject(0)),
              "outputs": [measure(algorithm.GetOutput(port), name) for port, name in enumerate(ids)]}
    if "texture" in description:
        texture = updated(pipelines.stream_texture(algorithm, mapping, field, description))
        lic = updated(pipelines.stream_lic(algorithm, description)).GetOutputDataObject(0)
        result["textured"] = measure_texture(texture)
        result["lic_sum"] = finite_sum(lic.GetPointData().GetArray("LIC"))
    search = connected(vtkFlowCriticalPoints(), pipelines.analytic_flow(description))
    result["critical_points"] = counts(updated(search).GetOutput().GetPointData().GetArray("CriticalPointType"))
    if "axis" in description:
        result["axis_points"] = pipelines.vortex_axis(description).GetNumberOfPoints()
    return result


def main():
    folder = sys.argv[1]
    datasets = write_data(folder)
    for name, array in DISTRIBUTED.items():
        write_pieces(datasets[name], array, NUMBER_OF_PIECES, os.path.join(folder, name + "_pieces"))
    numbers = [extract_intervals(datasets, *arguments) for arguments in INTERVALS]
    numbers += [extract_contours(datasets, *arguments) for arguments in CONTOURS]
    for file, content in (("numbers", numbers), ("time_varying", [*map(measure_in_time, TIME_VARYING)]),
                          ("flow", [*map(measure_flow, FLOWS)])):
        with open(os.path.join(folder, file + ".json"), "w", encoding="utf-8") as output:
            json.dump(content, output, indent=1)


main()
