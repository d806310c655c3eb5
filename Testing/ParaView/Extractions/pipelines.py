# SPDX-License-Identifier: BSD-3-Clause
"""Data, sources and filters by the descriptions that the tests inside ParaView read.

A description has properties by the names that they have in ParaView. Temporal: `source`, one of
SOURCES, its `source_properties`, and `properties` of the filter. Flow: `source_properties` of the
analytic flow, `surfaces` and `meshes` (each a `kind`, the label of its proxy, and its `properties`),
`axis` (properties of a vortex axis, whose lines are tubes of `TubeRadius`), `field`, `mapping`,
`image` (the extent of a wavelet), `volume`, and of its stream surfaces `texture` and `lic`.
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
# Properties of rows: the method that takes a row, the numbers of one, whether its index comes first.
ROWS = {
    "Intervals": ("SetInterval", 2, True), "StreamSurfaces": ("SetStreamSurface", 1, True),
    "TimeSurfaces": ("SetTimeSurface", 1, True), "StartPoints": ("AddStartPoint", 3, False),
    "Boundaries": ("GenerateBoundaryOn", 1, False), "Points": ("AddPoint", 3, False),
    "FormulasById": ("SetFormula", 2, False), "Rings": ("AddRing", 6, False)}


def set_properties(made, properties):
    """Calls the setters of an object, which it returns."""
    for name, value in properties.items():
        values = value if isinstance(value, list) else [value]
        if name not in ROWS:
            getattr(made, "Set" + name)(*values)
            continue
        method, size, has_index = ROWS[name]
        for row in range(len(values) // size):
            getattr(made, method)(*([row] if has_index else []), *values[size * row:size * (row + 1)])
    return made


def updated(made):
    """An algorithm that is up to date."""
    made.Update()
    return made


def connected(made, source, port=0):
    """An algorithm with its input, which must not be gone before it is connected."""
    made.SetInputConnection(source.GetOutputPort(port))
    return made


def read_data(name):
    """The dataset of a file in Data/."""
    reader = vtkDataSetReader() if name.endswith(".vtk") else vtkXMLGenericDataObjectReader()
    reader.SetFileName(os.path.join(os.environ["INTERLUME_DATA"], name))
    return updated(reader).GetOutput()


def wavelet(extent=None):
    made = vtkRTAnalyticSource()
    if extent:
        made.SetWholeExtent(*extent)
    return updated(made).GetOutput()


def interval_volume(data, array, intervals):
    """The filter over a point array; intervals are pairs."""
    made = vtkIntervalVolume()
    made.SetInputData(data)
    made.SetInputArrayToProcess(0, 0, 0, vtkDataObject.FIELD_ASSOCIATION_POINTS, array)
    return set_properties(made, {"Intervals": [bound for pair in intervals for bound in pair]})


def temporal_source(description):
    return set_properties(SOURCES[description["source"]](), description["source_properties"])


def time_varying_volume(description):
    made = connected(vtkTimeVaryingIntervalVolume(), temporal_source(description))
    return set_properties(made, description["properties"])


def make_rectangle(Center, Normal, Lengths):
    """The corners that the proxy has for a normal along x: u along y, v along z."""
    assert Normal == [1.0, 0.0, 0.0], "a rectangle here has the normal x"
    x, y, z = Center[0], Center[1] - 0.5 * Lengths[0], Center[2] - 0.5 * Lengths[1]
    return set_properties(vtkTerminationPlane(), {
        "Origin": [x, y, z], "Point1": [x, y + Lengths[0], z], "Point2": [x, y, z + Lengths[1]]})


def make_cylinder(Center, Axis, Length, **others):
    """The points that the proxy has for an axis along z."""
    assert Axis == [0.0, 0.0, 2.0], "a cylinder here has the axis 2 z"
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
    """The triangles of a surface."""
    source = set_properties(vtkTerminationSurfaceSource(), {"Surface": termination_surface(description)})
    return set_properties(vtkTerminationMesh(), {"Mesh": updated(source).GetOutput()})


def tubes(lines, radius):
    """Each line as a tube."""
    ids = vtkIdList()
    for line in range(lines.GetNumberOfLines()):
        lines.GetLines().GetCellAtId(line, ids)
        points = [x for i in range(ids.GetNumberOfIds()) for x in lines.GetPoint(ids.GetId(i))]
        yield set_properties(vtkTerminationTube(), {"Radius": radius, "Points": points})


def analytic_flow(description):
    return set_properties(vtkAnalyticFlowSource(), description["source_properties"])


def vortex_axis(description):
    made = connected(vtkVortexAxis(), analytic_flow(description))
    return updated(set_properties(made, description["axis"])).GetOutput()


def flow_field(description):
    made = connected(vtkImplicitFlowField(), analytic_flow(description))
    surfaces = [*map(termination_surface, description["surfaces"]), *map(surface_mesh, description["meshes"])]
    if "axis" in description:
        surfaces += tubes(vortex_axis(description), description["TubeRadius"])
    for surface in surfaces:
        made.AddTerminationSurface(surface)
    return set_properties(made, description["field"])


def inflow_mapping(field, description):
    made = connected(vtkInflowMapping(), field)
    properties = dict(description["mapping"])
    made.SetFormula(vtkInflowMapping.ALL, properties.pop("Formula"))
    for name, rows in properties.items():
        set_properties(made, {name: [value for row in rows for value in row]})
    if "image" in description:
        made.SetImage(description["ImageId"], wavelet(description["image"]))
    return made


def flow_volume(mapping, description):
    return set_properties(connected(vtkFlowVolume(), mapping), description["volume"])


def stream_texture(volume, mapping, field, description):
    """Texture coordinates of the stream surfaces of a volume that is up to date."""
    made = set_properties(connected(vtkStreamSurfaceParameters(), volume, 1), description["texture"])
    made.SetMapping(mapping)
    for i in range(field.GetNumberOfUsedSurfaces()):
        made.AddTerminationSurface(field.GetUsedSurface(i), field.GetUsedSurfaceId(i))
    return made


def stream_lic(volume, description):
    """Line integral convolution at the points of the stream surfaces."""
    made = set_properties(connected(vtkFlowLIC(), volume, 1), description["lic"])
    flow = analytic_flow(description)
    made.SetFieldConnection(flow.GetOutputPort())
    return made
