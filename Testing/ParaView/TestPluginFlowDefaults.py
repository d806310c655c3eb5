# SPDX-License-Identifier: BSD-3-Clause
"""Tests flow filters with default settings on every dataset with vectors. They must have colored output or a
warning, and surfaces must have the size of the data and of their widgets.
"""

import time

import numpy
from paraview import servermanager, simple
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkInteractionWidgets import vtkImplicitPlaneRepresentation
from vtkmodules.util.numpy_support import vtk_to_numpy

from plugin_images import VIEW_SIZE, plain_view, snapshot
from plugin_testing import data_path, fetch, run, warnings_of

DATA = ("disk_out_ref.vtu", "post.vts", "bluntfin.vts", "AnalyticFlow")
# Limit per filter in processor seconds. It is far above the goal of two seconds, so that the test
# passes on a busy machine.
MAXIMUM_SECONDS = 60.0


def open_field(name):
    field = simple.AnalyticFlow() if name == "AnalyticFlow" else simple.OpenDataFile(data_path(name))
    field.UpdatePipeline()
    return field


def update(proxy):
    """Updates a filter and returns its messages."""
    with warnings_of(proxy, ("WarningEvent", "ErrorEvent")) as messages:
        proxy.UpdatePipeline()
    return " ".join(messages)


def scalars_of(proxy, port=0):
    data = fetch(proxy, port=port)
    scalars = data.GetPointData().GetScalars() or data.GetCellData().GetScalars()
    return scalars.GetName() if scalars else None


def check_chain(checks, name):
    """Tests the pipeline Implicit Flow Field, Inflow Mapping, Flow Volume."""
    proxies = [open_field(name)]
    for kind, scalars in (
            ("ImplicitFlowField", "AdvectionTime"), ("InflowMapping", "Inflow"), ("FlowVolume", "Inflow")):
        proxies.append(getattr(simple, kind)(Input=proxies[-1]))
        start, wall = time.process_time(), time.time()
        messages = update(proxies[-1])
        seconds, wall = time.process_time() - start, time.time() - wall
        print(f"{name}, {kind}: {wall:.2f} s, processor {seconds:.2f} s", flush=True)
        checks.equal(messages, "", f"{name}, {kind}, messages")
        checks.that(seconds < MAXIMUM_SECONDS, f"{name}, {kind} takes {seconds} s")
        checks.that(fetch(proxies[-1]).GetNumberOfCells() > 0, f"{name}, {kind} has cells")
        checks.equal(scalars_of(proxies[-1]), scalars, f"{name}, {kind}, scalars")
    field, mapping, volume = proxies[1:]
    status = vtk_to_numpy(fetch(field).GetPointData().GetArray("FlowStatus"))
    checks.that((status == 0).mean() > 0.3, f"{name}: {(status == 0).mean()} of the samples reach the surface")
    bands = numpy.reshape(list(volume.Intervals), (-1, 2))
    checks.equal(len(bands), 5, f"{name}, default bands")
    inflow = vtk_to_numpy(fetch(volume).GetPointData().GetArray("Inflow"))
    distance = numpy.maximum(bands[:, :1] - inflow, inflow - bands[:, 1:]).min(axis=0)
    checks.that(distance.max() < 1e-6, f"{name}, Inflow is up to {distance.max()} outside of the bands")
    check_reports(checks, name, field, volume)
    check_unreached(checks, name, field)
    times = mapping.PointData["AdvectionTime"].GetRange()
    checks.that(numpy.allclose(list(volume.TimeRange), times), f"{name}, {list(volume.TimeRange)}, {times}")
    checks.equal((len(volume.StreamSurfaces), len(volume.TimeSurfaces)), (0, 0), f"{name}, default surfaces")
    return proxies


def summary_of(proxy):
    proxy.UpdatePropertyInformation()
    return proxy.GetProperty("Summary").GetData()


def check_reports(checks, name, field, volume):
    """Tests the text of the panels against numbers of the output."""
    status = vtk_to_numpy(fetch(field).GetPointData().GetArray("FlowStatus"))
    text = summary_of(field)
    checks.that(text.startswith(f"Of {len(status)} samples, {100 * (status == 0).mean():.3g} % reached a surface, "
                                f"{100 * (status == 1).mean():.3g} % left the field, "), f"{name}, {text}")
    text = summary_of(volume)
    checks.that(text.startswith(f"Of {fetch(field).GetNumberOfCells()} cells, "), f"{name}, {text}")


def check_unreached(checks, name, field):
    """Tests that exactly the cells without a corner that reached a surface are hidden."""
    data = fetch(field)
    status = data.GetPointData().GetArray("FlowStatus")
    ghosts = data.GetCellData().GetArray("vtkGhostType")
    wrong = 0
    for cell in range(0, data.GetNumberOfCells(), 101):
        ids = data.GetCell(cell).GetPointIds()
        reached = any(status.GetValue(ids.GetId(i)) == 0 for i in range(ids.GetNumberOfIds()))
        wrong += (ghosts is not None and ghosts.GetValue(cell) & 32 != 0) == reached
    checks.equal(wrong, 0, f"{name}, wrongly hidden or shown cells")


def check_single_filter(checks, name, source, volume):
    """Tests that the single filter gives the same result as the three filters."""
    single = simple.FlowVolumefromVectors(Input=source)
    checks.equal(update(single), "", f"{name}, single filter")
    checks.equal(scalars_of(single), "Inflow", f"{name}, scalars of the single filter")
    checks.equal(fetch(single).GetNumberOfCells(), fetch(volume).GetNumberOfCells(), f"{name}, single filter, cells")
    checks.that("reached a surface" in summary_of(single) and "skipped" in summary_of(single), summary_of(single))
    simple.Delete(single)


def check_default_surface(checks, name, source, field):
    """Tests that the second output shows the surface, which must be inside the data."""
    checks.equal(field.TerminationSurface.SMProxy.GetXMLLabel(), "Where the flow enters", "first surface")
    checks.equal(field.SMProxy.GetOutputPortName(1), "Termination Surfaces", "second output")
    drawn = numpy.reshape(fetch(field, port=1).GetBounds(), (3, 2))
    bounds = numpy.reshape(source.GetDataInformation().GetBounds(), (3, 2))
    size = bounds[:, 1] - bounds[:, 0]
    checks.that((drawn[:, 0] >= bounds[:, 0] - 1e-6 * size).all(), f"{name}, {drawn} in {bounds}")
    checks.that((drawn[:, 1] <= bounds[:, 1] + 1e-6 * size).all(), f"{name}, {drawn} in {bounds}")
    extent = (drawn[:, 1] - drawn[:, 0]) / size
    checks.equal(int((extent == 0).sum()), 1, f"{name}, a rectangle, {extent}")
    checks.that(sorted(extent)[1] > 0.3, f"{name}, as large as the flow, {extent}")


def widget_bounds(bounds, surface):
    """Returns the bounds of ParaView's plane widget."""
    widget = vtkImplicitPlaneRepresentation()
    widget.SetPlaceFactor(1.0)
    widget.PlaceWidget(bounds)
    widget.SetOrigin(list(surface.Center))
    widget.SetNormal(list(surface.Normal))
    drawn = vtkPolyData()
    widget.UpdatePlacement()
    widget.GetPolyData(drawn)
    return drawn.GetBounds()


def check_widgets(checks, name, source, field):
    """Tests that surfaces equal their widgets."""
    bounds = source.GetDataInformation().GetBounds()
    center = [(bounds[2 * i] + bounds[2 * i + 1]) / 2 for i in range(3)]
    diagonal = numpy.linalg.norm(numpy.subtract(bounds[1::2], bounds[0::2]))

    def drawn():
        update(field)
        return fetch(field, port=1).GetBounds()

    def compare(expected, what):
        error = numpy.abs(numpy.subtract(drawn(), expected)).max()
        checks.that(error < 2e-3 * diagonal, f"{name}, {what}: {drawn()}, expected {expected}")

    field.TerminationSurface = "Rectangle"
    rectangle = field.TerminationSurface
    checks.that(numpy.allclose(list(rectangle.Center), center), f"{name}, center of the rectangle")
    for normal in ([0, 0, 1], [1, 0, 0], [0, 2, 0]):
        rectangle.Normal = normal
        rectangle.Center = [center[0] + 0.1 * diagonal * (normal[0] > 0), center[1], center[2]]
        compare(widget_bounds(bounds, rectangle), f"rectangle across {normal}")
    rectangle.Normal, rectangle.Center = [1, 1, 0], center
    outer, inner = numpy.reshape(drawn(), (3, 2)), numpy.reshape(widget_bounds(bounds, rectangle), (3, 2))
    tolerance = 1e-6 * diagonal
    checks.that((outer[:, 0] <= inner[:, 0] + tolerance).all() and (outer[:, 1] >= inner[:, 1] - tolerance).all(),
                f"{name}, an oblique rectangle contains the plane's part inside the data")
    field.TerminationSurface = "Cylinder"
    radius = field.TerminationSurface.Radius
    compare([center[0] - radius, center[0] + radius, center[1] - radius, center[1] + radius, *bounds[4:]],
            "cylinder")
    field.TerminationSurface = "Tube"
    radius = field.TerminationSurface.Radius
    compare([center[0] - radius, center[0] + radius, center[1] - radius, center[1] + radius, *bounds[4:]], "tube")
    field.TerminationSurface = "Sphere"
    radius = field.TerminationSurface.Radius
    compare([center[i // 2] + (radius if i % 2 else -radius) for i in range(6)], "sphere")
    field.TerminationSurface = "Box"
    compare(bounds, "box")
    field.TerminationSurface = "Parallelogram"
    compare([*bounds[:4], center[2], center[2]], "parallelogram")


def check_others(checks, name, source, volume):
    """Tests that the other flow filters have output or report why not."""
    for kind in ("FlowBoundary", "FlowCriticalPoints", "VortexAxis"):
        proxy = getattr(simple, kind)(Input=source)
        messages = update(proxy)
        points = fetch(proxy).GetNumberOfPoints()
        print(f"{name}, {kind}: {points} points", flush=True)
        checks.that((points > 0) == (messages == ""), f"{name}, {kind}: {points} points, {messages!r}")
        checks.that(points == 0 or scalars_of(proxy) in ("FlowDirection", "CriticalPointType", "SwirlStrength"), f"{kind}, scalars")
    surface = simple.Slice(Input=source)
    lic = simple.FlowLIC(Input=surface, Field=source)
    checks.equal(update(lic), "", f"{name}, LIC")
    checks.equal(scalars_of(lic), "LIC", f"{name}, scalars of LIC")
    check_streaks(checks, name, lic)
    texture = simple.StreamSurfaceParameters(Input=simple.OutputPort(volume, 1))
    checks.that("GenerateStreamSurfaces" in update(texture), f"{name}, a missing stream surface causes a warning")
    volume.GenerateStreamSurfaces = True
    checks.equal(update(texture), "", f"{name}, texture")
    checks.that(fetch(texture).GetNumberOfCells() > 0, f"{name}, textured triangles")
    checks.equal(scalars_of(texture), "AdvectionTime", f"{name}, scalars of the texture")


def check_streaks(checks, name, lic):
    """Tests that the first image of a LIC is gray, has contrast, and has streaks: its structure tensor, averaged
    over a neighborhood, has one large eigenvalue."""
    view = plain_view()
    display = simple.Show(lic, view)
    display.Ambient, display.Diffuse = 1, 0  # ParaView's lights are tinted
    bounds = numpy.reshape(lic.GetDataInformation().GetBounds(), (3, 2))
    axis = int(numpy.argmin(bounds[:, 1] - bounds[:, 0]))
    camera = view.GetActiveCamera()
    camera.SetFocalPoint(0, 0, 0)
    camera.SetPosition(*(numpy.arange(3) == axis).astype(float))
    camera.SetViewUp(*(numpy.arange(3) == (axis + 1) % 3).astype(float))
    simple.ResetCamera(view)
    shot = snapshot(view)
    checks.that(numpy.ptp(shot, axis=1).max() <= 1, f"{name}, LIC is gray")
    values = shot[:, 0].reshape(VIEW_SIZE[1], VIEW_SIZE[0]).astype(float)
    inside = values > 0
    checks.that(values[inside].std() > 30, f"{name}, contrast of LIC: {values[inside].std()}")
    rows, columns = numpy.gradient(values)

    def blur(products):
        products = numpy.where(inside, products, 0.0)
        sums = products.cumsum(axis=0).cumsum(axis=1)
        size = 9
        return sums[size:, size:] - sums[:-size, size:] - sums[size:, :-size] + sums[:-size, :-size]

    xx, yy, xy = blur(columns**2), blur(rows**2), blur(rows * columns)
    full = blur(numpy.ones_like(values)) > 80
    coherence = (numpy.hypot(xx - yy, 2 * xy) / (xx + yy + 1e-9))[full].mean()
    print(f"{name}, coherence of LIC {coherence:.2f}", flush=True)
    checks.that(coherence > 0.5, f"{name}, streaks of LIC: {coherence}")
    simple.Delete(view)


def check_empty(checks, mapping, volume):
    """Tests that the warning about an empty volume contains the range of the data."""
    volume.Intervals = [5, 6]
    message = update(volume)
    checks.that("Interval 0, [5, 6], is outside of the range of Inflow, [0" in message, message)
    volume.Intervals = []
    mapping.Input.MaximumTime = 1e-6
    checks.that("None of" in update(mapping.Input) and fetch(mapping.Input).GetNumberOfCells() > 0,
                "a warning if no sample reaches a surface")
    mapping.Input.MaximumTime = 1e299
    checks.equal(update(mapping.Input), "", "a huge maximum time is not a limit")
    mapping.Input.MaximumTime = 0
    checks.equal(update(mapping.Input), "", "a maximum time of 0 is not a limit")


def check_panels(checks, field, mapping, volume):
    """Tests which properties can be animated, and which outputs are shown."""
    for proxy, names in (
            (field, ("MaximumTime",)), (mapping, ("Formula", "Rings")),
            (volume, ("Intervals", "TimeRange", "StreamSurfaces", "TimeSurfaces", "MaximumTimeJump"))):
        for name in names:
            checks.that(proxy.GetProperty(name).SMProperty.GetAnimateable(), f"{name} can be animated")
    controller = servermanager.vtkSMParaViewPipelineControllerWithRendering()
    for proxy, ports in ((field, 2), (volume, 3)):
        for port in range(ports):
            view = controller.GetPreferredViewType(proxy.SMProxy, port)
            checks.equal(view == "None", port > 0, f"{proxy.SMProxy.GetXMLName()}, output {port} in {view}")


def main(checks):
    for name in DATA:
        source, field, mapping, volume = check_chain(checks, name)
        check_default_surface(checks, name, source, field)
        check_others(checks, name, source, volume)
        if name == DATA[0]:
            check_single_filter(checks, name, source, volume)
            check_panels(checks, field, mapping, volume)
            check_empty(checks, mapping, volume)
        if name in ("disk_out_ref.vtu", "AnalyticFlow"):
            field.SampleMode = "Image"
            field.SampleDimensions = [3, 3, 3]
            check_widgets(checks, name, source, field)


run(main)
