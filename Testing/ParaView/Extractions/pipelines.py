# SPDX-License-Identifier: BSD-3-Clause
"""Creates data, sources and filters from the descriptions that the tests inside ParaView read.

A description has the property names of ParaView. Descriptions in time have a `source` (a key of SOURCES),
its `source_properties`, and the `properties` of the filter. Descriptions of flows have `source_properties`
of the analytic flow, `surfaces` and `meshes` (each with `kind`, the label of its proxy, and `properties`),
`axis` (properties of a vortex axis, whose lines become tubes of `TubeRadius`), `field`, `mapping`, `image`
(the extent of a wavelet), `volume`, and `texture` and `lic` for its stream surfaces.
"""

import os

from interlume import (
    vtkAnalyticFieldSource, vtkAnalyticFlowSource, vtkFlowLIC, vtkFlowVolume, vtkImplicitFlowField,
    vtkInflowMapping, vtkIntervalVolume, vtkStreamSurfaceParameters, vtkTaperedCylinderSource,
    vtkTerminationBox, vtkTerminationCylinder, vtkTerminationMesh, vtkTerminationPlane,
    vtkTerminationSphere, vtkTerminationSurfaceSource, vtkTerminationTube, vtkTimeVaryingIntervalVolume,
    vtkVortexAxis)
from vtkmodules.vtkCommonCore import vtkIdList
from vtkmodules.vtkCommonDataModel import vtkDataObject
from vtkmodules.vtkImagingCore import vtkRTAnalyticSource
from vtkmodules.vtkIOLegacy import vtkDataSetReader
from vtkmodules.vtkIOXML import vtkXMLGenericDataObjectReader

SOURCES = {"AnalyticField": vtkAnalyticFieldSource, "TaperedCylinderWake": vtkTaperedCylinderSource}
# Properties with rows: the method that accepts a row, the size of a row, and whether its index comes first.
ROWS = {
    "Intervals": ("SetInterval", 2, True), "StreamSurfaces": ("SetStreamSurface", 1, True),
    "TimeSurfaces": ("SetTimeSurface", 1, True), "StartPoints": ("AddStartPoint", 3, False),
    "Boundaries": ("GenerateBoundaryOn", 1, False), "Points": ("AddPoint", 3, False),
    "FormulasById": ("SetFormula", 2, False), "Rings": ("AddRing", 6, False)}


def set_properties(result, properties):
    """Calls the setters of an object and returns the object."""
    for name, value in properties.items():
        values = value if isinstance(value, list) else [value]
        if name not in ROWS:
            getattr(result, "Set" + name)(*values)
            continue
        method, size, has_index = ROWS[name]
        for row in range(len(values) // size):
            getattr(result, method)(*([row] if has_index else []), *values[size * row:size * (row + 1)])
    return result


def updated(result):
    """Updates an algorithm and returns it."""
    result.Update()
    return result


def connected(result, source, port=0):
    """Connects an algorithm and returns it. The source must exist until then."""
    result.SetInputConnection(source.GetOutputPort(port))
    return result


def read_data(name):
    """Returns the dataset of a file in Data/."""
    reader = vtkDataSetReader() if name.endswith(".vtk") else vtkXMLGenericDataObjectReader()
    reader.SetFileName(os.path.join(os.environ["INTERLUME_DATA"], name))
    return updated(reader).GetOutput()


def wavelet(extent=None):
    result = vtkRTAnalyticSource()
    if extent:
        result.SetWholeExtent(*extent)
    return updated(result).GetOutput()


def interval_volume(data, array, intervals):
    """Returns the filter for a point array; intervals are pairs."""
    result = vtkIntervalVolume()
    result.SetInputData(data)
    result.SetInputArrayToProcess(0, 0, 0, vtkDataObject.FIELD_ASSOCIATION_POINTS, array)
    return set_properties(result, {"Intervals": [bound for pair in intervals for bound in pair]})


def temporal_source(description):
    return set_properties(SOURCES[description["source"]](), description["source_properties"])


def time_varying_volume(description):
    result = connected(vtkTimeVaryingIntervalVolume(), temporal_source(description))
    return set_properties(result, description["properties"])


def make_rectangle(Center, Normal, Lengths):
    """Returns the rectangle that the proxy makes for a normal along x: u along y, v along z."""
    assert Normal == [1.0, 0.0, 0.0], "only rectangles with the normal x are supported"
    x, y, z = Center[0], Center[1] - 0.5 * Lengths[0], Center[2] - 0.5 * Lengths[1]
    return set_properties(vtkTerminationPlane(), {
        "Origin": [x, y, z], "Point1": [x, y + Lengths[0], z], "Point2": [x, y, z + Lengths[1]]})


def make_cylinder(Center, Axis, Length, **others):
    """Returns the cylinder that the proxy makes for an axis along z."""
    assert Axis == [0.0, 0.0, 2.0], "only cylinders with the axis 2 z are supported"
    ends = [[Center[0], Center[1], Center[2] + side * 0.5 * Length] for side in (-1, 1)]
    return set_properties(vtkTerminationCylinder(), {"Point1": ends[0], "Point2": ends[1], **others})


def make_box(Position, Lengths):
    bounds = [bound for low, length in zip(Position, Lengths) for bound in (low, low + length)]
    return set_properties(vtkTerminationBox(), {"Bounds": bounds})


SURFACES = {
    "Rectangle": make_rectangle, "Cylinder": make_cylinder, "Box": make_box,
    "Sphere": lambda **properties: set_properties(vtkTerminationSphere(), properties),
    "Tube": lambda **properties: set_properties(vtkTerminationTube(), properties),
    "Parallelogram": lambda **properties: set_properties(vtkTerminationPlane(), properties)}


def termination_surface(description):
    properties = dict(description["properties"])
    number = properties.pop("Id", -1)
    return set_properties(SURFACES[description["kind"]](**properties), {"Id": number})


def surface_mesh(description):
    """Returns a triangle mesh of a surface."""
    source = set_properties(vtkTerminationSurfaceSource(), {"Surface": termination_surface(description)})
    return set_properties(vtkTerminationMesh(), {"Mesh": updated(source).GetOutput()})


def tubes(lines, radius):
    """Yields a tube for each line."""
    ids = vtkIdList()
    for line in range(lines.GetNumberOfLines()):
        lines.GetLines().GetCellAtId(line, ids)
        points = [x for i in range(ids.GetNumberOfIds()) for x in lines.GetPoint(ids.GetId(i))]
        yield set_properties(vtkTerminationTube(), {"Radius": radius, "Points": points})


def analytic_flow(description):
    return set_properties(vtkAnalyticFlowSource(), description["source_properties"])


def vortex_axis(description):
    result = connected(vtkVortexAxis(), analytic_flow(description))
    return updated(set_properties(result, description["axis"])).GetOutput()


def flow_field(description):
    result = connected(vtkImplicitFlowField(), analytic_flow(description))
    surfaces = [*map(termination_surface, description["surfaces"]), *map(surface_mesh, description["meshes"])]
    if "axis" in description:
        surfaces += tubes(vortex_axis(description), description["TubeRadius"])
    for surface in surfaces:
        result.AddTerminationSurface(surface)
    return set_properties(result, description["field"])


def inflow_mapping(field, description):
    result = connected(vtkInflowMapping(), field)
    properties = dict(description["mapping"])
    result.SetFormula(vtkInflowMapping.ALL, properties.pop("Formula"))
    for name, rows in properties.items():
        set_properties(result, {name: [value for row in rows for value in row]})
    if "image" in description:
        result.SetImage(description["ImageId"], wavelet(description["image"]))
    return result


def flow_volume(mapping, description):
    return set_properties(connected(vtkFlowVolume(), mapping), description["volume"])


def stream_texture(volume, mapping, field, description):
    """Returns texture coordinates for the stream surfaces of an updated volume."""
    result = set_properties(connected(vtkStreamSurfaceParameters(), volume, 1), description["texture"])
    result.SetMapping(mapping)
    for i in range(field.GetNumberOfUsedSurfaces()):
        result.AddTerminationSurface(field.GetUsedSurface(i), field.GetUsedSurfaceId(i))
    return result


def stream_lic(volume, description):
    """Returns line integral convolution at the points of the stream surfaces."""
    result = set_properties(connected(vtkFlowLIC(), volume, 1), description["lic"])
    flow = analytic_flow(description)
    result.SetFieldConnection(flow.GetOutputPort())
    return result
