# SPDX-License-Identifier: BSD-3-Clause
"""Tests the flow filters in ParaView: their inputs, panels, defaults and termination surfaces."""

import numpy
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy

from plugin_testing import check_documentation, check_inputs, check_menu, fetch, run

KINDS = ["Rectangle", "Sphere", "Cylinder", "Box", "Tube", "Parallelogram"]


def fresh(kind):
    """Returns a surface with the values that it has before it is used with data."""
    group = servermanager.ProxyNamespace(
        ["termination_surfaces"], servermanager.ActiveConnection.Session)
    return getattr(group, kind)()


def check_shapes(checks):
    """Tests bounds and texture coordinates of each surface with default values."""
    half = 0.5
    flat = [-half, half, -half, half, 0.0, 0.0]
    cube = [-half, half] * 3
    bounds = {"Rectangle": flat, "Parallelogram": flat, "Tube": cube, "Sphere": cube, "Cylinder": cube,
              "Box": cube}
    for kind in KINDS:
        surface = fresh(kind)
        mesh = fetch(simple.TerminationSurface(Surface=surface))
        found = mesh.GetBounds()
        checks.that(numpy.abs(numpy.subtract(found, bounds[kind])).max() < 1e-6, f"{kind}, {found}")
        checks.that(mesh.GetPointData().GetTCoords() is not None, f"{kind}, texture coordinates")
        check_documentation(checks, surface)


def check_placing(checks):
    """Tests that the values of the widgets place the surfaces."""
    rectangle = fresh("Rectangle")
    rectangle.Center, rectangle.Normal, rectangle.Lengths = [1, 2, 3], [0, 2, 0], [4, 2]
    cylinder = fresh("Cylinder")
    cylinder.Center, cylinder.Axis, cylinder.Length = [1, 0, 0], [3, 0, 0], 4
    box = fresh("Box")
    box.Position, box.Lengths = [1, 2, 3], [1, 2, 4]
    for surface, bounds in (
            (rectangle, [0, 2, 2, 2, 1, 5]), (cylinder, [-1, 3, -0.5, 0.5, -0.5, 0.5]),
            (box, [1, 2, 2, 4, 3, 7])):
        found = fetch(simple.TerminationSurface(Surface=surface)).GetBounds()
        checks.that(numpy.abs(numpy.subtract(found, bounds)).max() < 1e-6, f"placed at {found}")
    rectangle.Normal, rectangle.Lengths, rectangle.Angle = [0, 0, 1], [2, 2], 45
    found = fetch(simple.TerminationSurface(Surface=rectangle)).GetBounds()
    expected = [1 - 2**0.5, 1 + 2**0.5, 2 - 2**0.5, 2 + 2**0.5, 3, 3]
    checks.that(numpy.abs(numpy.subtract(found, expected)).max() < 1e-6, f"rotated to {found}")


def make_perpendicular(surface):
    """Makes a plane perpendicular to the flow along x, through the center of the data."""
    if hasattr(surface, "Normal"):
        surface.Normal = [1, 0, 0]
    else:
        surface.Origin, surface.Point1, surface.Point2 = [1, -1, -1], [1, 1, -1], [1, -1, 1]


def surface_of(field):
    return field.TerminationSurface


def check_field(checks, flow):
    """Tests that surfaces can be selected by name and start at the center of the data."""
    simple.SetActiveSource(flow)
    field = simple.ImplicitFlowField(Input=flow)
    checks.equal(list(field.Vectors), ["POINTS", "Velocity"], "vectors")
    # ParaView 6.1 removes the spaces.
    kinds = [kind.replace(" ", "") for kind in field.GetProperty("TerminationSurface").Available]
    checks.equal(kinds, ["Wheretheflowenters", *KINDS, "None"], "kinds of surfaces")
    checks.equal(surface_of(field).SMProxy.GetXMLLabel(), "Where the flow enters", "the first surface")
    checks.equal(surface_of(field).Size, 1.0, "default size")
    reached = {}
    for kind in KINDS:
        field.TerminationSurface = kind
        surface = surface_of(field)
        if kind in ("Rectangle", "Parallelogram"):  # parallel to the flow by default
            make_perpendicular(surface)
        if kind not in ("Tube", "Parallelogram", "Box"):
            checks.equal(list(surface.Center), [1.0, 0.0, 0.0], f"{kind}, center")
        statuses = vtk_to_numpy(fetch(field).GetPointData().GetArray("FlowStatus"))
        reached[kind] = int((statuses == 0).sum())
        checks.that(reached[kind] > 0, f"{kind} is reached")
    field.TerminationSurface = "Box"
    checks.equal(list(surface_of(field).Position), [0.0, -1.0, -1.0], "corner of the box")
    checks.equal(list(surface_of(field).Lengths), [2.0, 2.0, 2.0], "lengths of the box")
    field.TerminationSurface = "None"
    field.DomainFaces = True
    ids = vtk_to_numpy(fetch(field).GetPointData().GetArray("TerminationId"))
    checks.equal(numpy.unique(ids).tolist(), [1000], "ids of the faces")
    return field


def check_samples(checks, flow, field):
    """Tests samples from an input, which determine the points and the type of the output."""
    field.SampleMode = "Points of the samples"
    field.Samples = simple.Sphere(Center=[1.0, 0.0, 0.0])
    samples = fetch(field)
    checks.equal(samples.GetClassName(), "vtkPolyData", "type of the samples")
    times = vtk_to_numpy(samples.GetPointData().GetArray("AdvectionTime"))
    positions = vtk_to_numpy(samples.GetPoints().GetData())[:, 0]
    checks.that(numpy.abs(times - positions).max() < 1e-6, "times of the samples")
    field.SampleMode = "Image"
    field.SampleDimensions = [5, 4, 3]
    checks.equal(fetch(field).GetDimensions(), (5, 4, 3), "image of samples")
    field.SampleMode = "Points of the field"
    checks.equal(fetch(field).GetNumberOfPoints(), fetch(flow).GetNumberOfPoints(), "number of points of the field")


def mean_arrays(field):
    domain = field.GetProperty("MeanArrays").SMProperty.FindDomain("vtkSMArrayListDomain")
    return {domain.GetString(i) for i in range(domain.GetNumberOfStrings())}


def check_means(checks, flow, field):
    """Tests that one-component arrays can be selected and that none is selected by default."""
    checks.equal(mean_arrays(field), set(), "one-component arrays of the flow")
    speed = simple.Calculator(Input=flow, ResultArrayName="Speed", Function="mag(Velocity)")
    speed.UpdatePipeline()
    means = simple.ImplicitFlowField(Input=speed, TerminationSurface="None", DomainFaces=True)
    checks.equal(mean_arrays(means), {"Speed"}, "one-component arrays")
    checks.equal(list(means.MeanArrays), [], "default means")
    means.MeanArrays = ["Speed"]
    low, high = fetch(means).GetPointData().GetArray("MeanSpeed").GetRange()
    checks.that(abs(low - 1.0) < 1e-6 and abs(high - 1.0) < 1e-6, f"means {low} to {high}")


def check_boundary(checks, flow):
    """Tests the regions of a uniform flow, and that one of them can be a termination surface."""
    boundary = simple.FlowBoundary(Input=flow)
    rates = vtk_to_numpy(fetch(boundary).GetFieldData().GetArray("RegionFlowRate"))
    checks.that(numpy.abs(rates - [-4.0, 4.0]).max() < 1e-6, f"flow rates {rates}")
    boundary.Region = 0
    checks.equal(fetch(boundary).GetBounds()[:2], (0.0, 0.0), "position of the inflow")
    field = simple.ImplicitFlowField(
        Input=flow, TerminationSurface="None", Surfaces=boundary, ComputeLocalAttributes=True)
    points = fetch(field).GetPointData()
    checks.equal(points.GetArray("FlowStatus").GetRange(), (0.0, 0.0), "all samples reach the region")
    speeds = points.GetArray("LocalSpeed").GetRange()
    checks.that(max(abs(speed - 1.0) for speed in speeds) < 1e-6, f"local speeds {speeds}")
    mapping = simple.InflowMapping(Input=field, Formula="t + LocalSpeed")
    low, high = fetch(mapping).GetPointData().GetArray("Inflow").GetRange()
    checks.that(abs(low - 1.0) < 1e-6 and abs(high - 3.0) < 1e-6, f"formula with time: {low} to {high}")
    return boundary


def check_mapping(checks, field):
    mapping = simple.InflowMapping(Input=field)
    checks.equal(mapping.Formula, "u", "default formula")
    values = lambda: vtk_to_numpy(fetch(mapping).GetPointData().GetArray("Inflow"))
    parameters = vtk_to_numpy(fetch(mapping).GetPointData().GetArray("TerminationUV"))
    checks.that(numpy.array_equal(values(), parameters[:, 0]), "Inflow is u")
    mapping.Formula = "2*v"
    checks.that(numpy.array_equal(values(), 2 * parameters[:, 1]), "Inflow is 2 v")
    mapping.FormulasById = ["1000", "u + f"]
    checks.that(numpy.array_equal(values(), parameters[:, 0] + 1000), "Inflow uses the formula of the id")
    mapping.Rings = ["1000", "0.5", "0.5", "0.25", "0.1", "3"]
    distances = numpy.hypot(*(parameters - 0.5).T)
    ring = 3 * numpy.exp(-(((distances - 0.25) / 0.1) ** 2))
    checks.that(numpy.abs(values() - ring).max() < 1e-12, "Inflow is a ring")
    image = simple.Wavelet(WholeExtent=[0, 4, 0, 4, 0, 0])
    mapping.Image = image
    checks.that(numpy.abs(values() - ring).max() < 1e-12, "the image applies only to ids without a mapping")
    mapping.ImageId = 1000
    low, high = fetch(image).GetPointData().GetArray("RTData").GetRange()
    found = values()
    checks.that(abs(found.min() - low) < 1e-4 and abs(found.max() - high) < 1e-4, "Inflow is read from the image")
    mapping.Image = None
    mapping.Rings = []
    mapping.FormulasById = []
    checks.that(numpy.array_equal(values(), 2 * parameters[:, 1]), "Inflow is 2 v again")
    return mapping


def check_volume(checks, mapping):
    volume = simple.FlowVolume(Input=mapping)
    for port, name in enumerate(("Volume", "Stream Surfaces", "Time Surfaces")):
        checks.equal(volume.SMProxy.GetOutputPortName(port), name, f"output port {port}")
    checks.that(0 < fetch(volume).GetNumberOfCells(), "the default volume is not empty")
    volume.Intervals = []
    checks.that(fetch(volume).GetNumberOfCells() > 0, "without an interval the volume is not empty")
    checks.equal(fetch(volume, 1).GetNumberOfCells(), 0, "stream surfaces are off by default")
    checks.equal(fetch(volume, 2).GetNumberOfCells(), 0, "time surfaces are off by default")
    volume.TimeRange = [0.25, 0.75]
    low, high = fetch(volume).GetPointData().GetArray("AdvectionTime").GetRange()
    checks.that(abs(low - 0.25) < 1e-6 and abs(high - 0.75) < 1e-6, f"times {low} to {high}")
    volume.ParametersAsTextureCoordinates = True
    checks.equal(fetch(volume).GetPointData().GetTCoords().GetName(), "TerminationUV", "texture")
    return volume


def upright_rectangle(height):
    rectangle = fresh("Rectangle")
    rectangle.Center, rectangle.Normal, rectangle.Lengths = [0, 0, 0], [1, 0, 0], [2, height]
    return rectangle


def check_lengths(checks, texture, height):
    """Checks that on the surface u = 0.5, which is y = 0, the length is measured from one end of the
    rectangle."""
    surface = fetch(texture)
    used = numpy.unique(vtk_to_numpy(surface.GetPolys().GetConnectivityArray()))
    points = vtk_to_numpy(surface.GetPoints().GetData())[used]
    found = vtk_to_numpy(surface.GetPointData().GetTCoords())[used]
    checks.that(len(points) > 0 and numpy.abs(points[:, 1]).max() < 1e-6, f"{height}: the surface is at y = 0")
    error = min(numpy.abs(found[:, 0] - height / 2 - side * points[:, 2]).max() for side in (1, -1))
    checks.that(error < 1e-5, f"{height}: error {error} of the length along the contour")
    checks.that(numpy.abs(found[:, 1] - points[:, 0]).max() < 1e-5, f"{height}: time")


def check_texture(checks, flow):
    """Tests that texture coordinates are updated after changes upstream."""
    field = simple.ImplicitFlowField(Input=flow, TerminationSurface=upright_rectangle(2))
    mapping = simple.InflowMapping(Input=field, Formula="u")
    volume = simple.FlowVolume(
        Input=mapping, Intervals=[], StreamSurfaces=[0.5], GenerateStreamSurfaces=True)
    texture = simple.StreamSurfaceParameters(Input=simple.OutputPort(volume, 1))
    checks.equal(texture.Resolution, 256, "default resolution")
    check_lengths(checks, texture, 2)
    field.TerminationSurface = upright_rectangle(4)
    check_lengths(checks, texture, 4)
    lic = simple.FlowLIC(Input=texture, Field=flow)
    checks.equal(list(lic.Vectors), ["POINTS", "Velocity"], "vectors of the field")
    low, high = fetch(lic).GetPointData().GetArray("LIC").GetRange()
    checks.that(0.0 <= low < high <= 1.0, f"LIC from {low} to {high}")
    return texture, lic


def main(checks):
    flow = simple.AnalyticFlow(
        Field="Uniform", WholeExtent=[0, 8, 0, 8, 0, 8], Bounds=[0, 2, -1, 1, -1, 1])
    flow.UpdatePipeline()
    check_shapes(checks)
    check_placing(checks)
    field = check_field(checks, flow)
    check_samples(checks, flow, field)
    check_means(checks, flow, field)
    mapping = check_mapping(checks, field)
    volume = check_volume(checks, mapping)
    others = [check_boundary(checks, flow), simple.FlowCriticalPoints(Input=flow), simple.VortexAxis(Input=flow)]
    for proxy in (field, mapping, volume, *check_texture(checks, flow), *others):
        check_documentation(checks, proxy)
        check_menu(checks, "filters", proxy.SMProxy.GetXMLName())
    source = simple.TerminationSurface()
    check_documentation(checks, source)
    check_menu(checks, "sources", source.SMProxy.GetXMLName())
    for name in ("ImplicitFlowField", "FlowBoundary", "FlowCriticalPoints", "VortexAxis"):  # fields have point vectors
        check_inputs(checks, name, ((flow, True), (simple.Wavelet(), False), (simple.Sphere(), False)))


run(main)
