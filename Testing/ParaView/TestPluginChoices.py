# SPDX-License-Identifier: BSD-3-Clause
"""Tests what the plugin chooses where the user chose nothing (inputs, times, colors, sizes, digits), and images of
lights."""

import os
import re
import tempfile

import numpy
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import VTK_FLOAT, VTK_UNSIGNED_CHAR, VTK_UNSIGNED_SHORT
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkIOImage import vtkPNGWriter, vtkTIFFWriter

from plugin_images import load_texture, look_at, snapshot
from plugin_testing import fetch, open_file, run, warnings_of


def connection(proxy, name="Input"):
    """Returns the name of the source and the index of the output to which an input is connected, or None."""
    prop = proxy.SMProxy.GetProperty(name)
    if prop.GetNumberOfProxies() == 0:
        return None
    return prop.GetProxy(0).GetXMLName(), prop.GetOutputPortForConnection(0)


def small_view():
    view = simple.CreateView("RenderView")
    view.ViewSize = [48, 36]
    return view


def mug_over_time(simplices):
    mug = open_file("mug.ex2")
    volume = simple.TimeVaryingIntervalVolume(Input=mug, GenerateSimplices=simplices, TimeStepRange=[0, 3])
    volume.Intervals = [0.5, 1.0]
    volume.UpdatePipeline()
    return volume


def check_time_slice(checks):
    volume = mug_over_time(1)
    view = small_view()
    time = list(volume.Input.TimestepValues)[2]
    simple.GetAnimationScene().AnimationTime = time
    display = simple.Show(volume, view)
    piece = simple.SimplexTimeSlice(Input=volume)
    checks.equal(connection(piece), ("TimeVaryingIntervalVolume", 2), "the slice uses the output Simplices")
    checks.equal(piece.UseAnimationTime, 1, "the slice follows the animation")
    checks.close(piece.Time, time, 1e-12, "the default time is the current one")
    with warnings_of(piece, ("WarningEvent", "ErrorEvent")) as messages:
        piece.UpdatePipeline()
    checks.equal(messages, [], "messages of the slice")
    checks.that(piece.GetDataInformation().GetNumberOfCells() > 0, "the slice has cells")
    checks.equal(display.Visibility, 0, "the display of the first output is hidden")
    shown = simple.Show(piece, view)
    checks.equal(str(shown.Representation).strip("'"), "Interval Volume", "representation of the slice")
    other = simple.SimplexTimeSlice(Input=servermanager.OutputPort(volume, 2), Time=0.35)
    checks.equal((other.Time, other.UseAnimationTime), (0.35, 0), "a time that was given")
    display.Visibility = 1
    other.UpdatePipeline()
    checks.equal(display.Visibility, 1, "an output that was given hides nothing")
    simple.Delete(view)


def check_outputs_to_select(checks):
    piece = simple.SimplexTimeSlice(Input=mug_over_time(0))
    with warnings_of(piece) as messages:
        piece.UpdatePipeline()
    checks.one_message(messages, "Turn on GenerateSimplices of Time-Varying Interval Volume, and connect its output "
                       "Simplices", "the slice without simplices")
    flow = simple.AnalyticFlow()
    flow.UpdatePipeline()
    field = simple.ImplicitFlowField(Input=flow)
    mapping = simple.InflowMapping(Input=field)
    volume = simple.FlowVolume(Input=mapping)
    parameters = simple.StreamSurfaceParameters(Input=volume)
    checks.equal(connection(parameters), ("FlowVolume", 1), "parameters use the output Stream Surfaces")
    with warnings_of(parameters) as messages:
        parameters.UpdatePipeline()
    checks.one_message(messages, "Turn on GenerateStreamSurfaces of Flow Volume, connect its output Stream Surfaces",
                       "the parameters without stream surfaces")
    volume.GenerateStreamSurfaces = 1
    with warnings_of(parameters, ("WarningEvent", "ErrorEvent")) as messages:
        parameters.UpdatePipeline()
    checks.equal(messages, [], "messages with stream surfaces")
    checks.that(parameters.GetDataInformation().GetNumberOfCells() > 0, "there are stream surfaces")


def check_field(checks):
    disk = open_file("disk_out_ref.vtu")
    lic = simple.FlowLIC(Input=disk)
    checks.equal(connection(lic, "Field"), ("XMLUnstructuredGridReader", 0), "the input is the field")
    checks.equal(list(lic.Vectors), ["POINTS", "V"], "vectors of the field")
    plane = simple.Slice(Input=disk)
    plane.UpdatePipeline()
    lic = simple.FlowLIC(Input=plane)
    checks.equal(connection(lic, "Field"), ("XMLUnstructuredGridReader", 0), "the field of a slice")
    with warnings_of(lic, ("WarningEvent", "ErrorEvent")) as messages:
        lic.UpdatePipeline()
    checks.equal(messages, [], "messages of LIC on a slice")
    checks.that(lic.PointData["LIC"].GetRange()[1] > 0.5, "LIC on a slice has streaks")
    other = simple.AnalyticFlow()
    lic = simple.FlowLIC(Input=plane, Field=other)
    checks.equal(connection(lic, "Field"), (other.SMProxy.GetXMLName(), 0), "a field that was given")
    lic = simple.FlowLIC(Input=simple.Sphere())
    checks.equal(connection(lic, "Field"), None, "no field for a surface without vectors")


def check_colors(checks):
    view = small_view()
    volume = simple.IntervalVolume(Input=open_file("disk_out_ref.vtu"))
    volume.Scalars = ["POINTS", "Temp"]
    display = simple.Show(volume, view)
    simple.Render(view)
    display.SetScalarBarVisibility(view, True)
    for array in ("Pres", "AsH3"):
        volume.Scalars = ["POINTS", array]
        simple.Render(view)
        checks.equal(list(display.ColorArrayName), ["POINTS", array], "colors follow the scalars")
        checks.that(display.IsScalarBarVisible(view), f"legend of {array}")
        colors = display.LookupTable
        checks.equal(colors.SMProxy, simple.GetColorTransferFunction(array).SMProxy, f"color map of {array}")
        low, high = volume.Intervals
        checks.close(colors.RGBPoints[0], low, 1e-3, f"start of the colors of {array}")
        checks.close(colors.RGBPoints[-4], high, 1e-3, f"end of the colors of {array}")
    shown = [bar for bar in view.Representations if "ScalarBar" in bar.GetXMLName() and bar.Visibility]
    checks.equal(len(shown), 1, "visible legends")
    simple.ColorBy(display, ["POINTS", "H2"])
    volume.Scalars = ["POINTS", "Temp"]
    simple.Render(view)
    checks.equal(list(display.ColorArrayName), ["POINTS", "H2"], "a chosen array remains")
    simple.ColorBy(display, None)
    volume.Scalars = ["POINTS", "Pres"]
    simple.Render(view)
    checks.that(not display.UseScalarColoring if hasattr(display, "UseScalarColoring")
                else not display.ColorArrayName[1], "a solid color remains")
    simple.Delete(view)


def check_sizes(checks):
    view = small_view()
    wavelet = simple.Wavelet()
    wavelet.UpdatePipeline()
    volume = simple.IntervalVolume(Input=wavelet, Intervals=[1e9, 2e9])
    with warnings_of(volume):
        volume.UpdatePipeline()
    display = simple.Show(volume, view)
    simple.Render(view)
    for name in ("GaussianRadius", "ScaleFactor"):
        checks.that(0.0 <= getattr(display, name) < 1e3, f"{name} of empty data: {getattr(display, name)}")
    volume.Intervals = [150.0, 200.0]
    simple.Render(view)
    expected = simple.Show(simple.IntervalVolume(Input=wavelet, Intervals=[150.0, 200.0]), view)
    for name in ("GaussianRadius", "ScaleFactor"):
        checks.equal(getattr(display, name), getattr(expected, name), f"{name} as soon as there are data")
    display.GaussianRadius = 3.5
    volume.Intervals = [160.0, 200.0]
    simple.Render(view)
    checks.equal(display.GaussianRadius, 3.5, "a radius that was set")
    simple.Delete(view)


def ends_of_legend(low, high):
    """Returns the texts at the ends of the legend of a volume with values from low to high."""
    view = small_view()
    wavelet = simple.Wavelet()
    scaled = simple.Calculator(Input=wavelet, ResultArrayName="value")
    scaled.Function = f"{low!r}+({high!r}-{low!r})*(coordsX+10)/20"
    display = simple.Show(scaled, view)
    display.SetRepresentationType("Shadowed Slices")
    simple.ColorBy(display, ["POINTS", "value"])
    colors = display.LookupTable
    colors.RescaleTransferFunction(low, high)
    display.SetScalarBarVisibility(view, True)
    simple.Render(view)
    simple.Render(view)
    legend = simple.GetScalarBar(colors, view)
    texts = [legend.RangeLabelFormat % value for value in (low, high)]
    legend.RangeLabelFormat = "%-#6.7e"
    display.Opacity = 0.5
    simple.Render(view)
    kept = legend.RangeLabelFormat
    simple.Delete(view)
    return [text.strip() for text in texts], kept


def check_digits(checks):
    for low, high, expected in ((0.0, 1.0, ["0.0e+00", "1.0e+00"]), (293.2, 293.9, ["2.9320e+02", "2.9390e+02"]),
                                (-1000.25, -1000.0, ["-1.00025e+03", "-1.00000e+03"])):
        texts, kept = ends_of_legend(low, high)
        checks.equal(texts, expected, f"ends of the legend of {low} to {high}")
        checks.that(re.search("7e", kept), f"a format that was set remains: {kept}")


def check_skipped(checks):
    wavelet = simple.Wavelet()
    holes = simple.ProgrammableFilter(Input=wavelet)
    holes.Script = ("import numpy; values = inputs[0].PointData['RTData']; "
                    "output.PointData.append(numpy.where(values > 200, numpy.nan, values), 'value')")
    holes.UpdatePipeline()
    volume = simple.IntervalVolume(Input=holes, Intervals=[150.0, 190.0])
    volume.Scalars = ["POINTS", "value"]
    with warnings_of(volume, ("WarningEvent", "ErrorEvent")) as messages:
        image = fetch(holes)
        volume.UpdatePipeline()
    values = vtk_to_numpy(image.GetPointData().GetArray("value")).reshape(image.GetDimensions()[::-1])
    isnan = numpy.isnan(values)
    corners = [isnan[i:i - 1 or None, j:j - 1 or None, k:k - 1 or None]
               for i in range(2) for j in range(2) for k in range(2)]
    expected = int(numpy.any(corners, axis=0).sum())
    checks.that(expected > 0, "there are cells with NaN")
    volume.SMProxy.UpdatePropertyInformation()
    skipped = volume.SMProxy.GetProperty("SkippedCells").GetElement(0)
    checks.equal(skipped, expected, "skipped cells")
    checks.equal(len(messages), len(set(messages)), f"each message once: {messages}")


def screen(folder, scalar_type, largest, slices=1):
    """Writes a gray image, dark on the left, and returns a texture of it. VTK's reader of TIFF files reads garbage
    for 16 bits and several components."""
    image = vtkImageData()
    image.SetDimensions(8, 8, slices)
    image.AllocateScalars(scalar_type, 1)
    values = numpy.full((slices, 8, 8), largest * 0.2)
    values[:, :, 4:] = largest
    vtk_to_numpy(image.GetPointData().GetScalars())[:] = values.ravel()
    is_png = scalar_type == VTK_UNSIGNED_SHORT
    writer = vtkPNGWriter() if is_png else vtkTIFFWriter()
    writer.SetInputData(image)
    writer.SetFileName(os.path.join(folder, f"{scalar_type}-{slices}." + ("png" if is_png else "tif")))
    writer.Write()
    return load_texture(writer.GetFileName())


def check_light_images(checks):
    view = small_view()
    wavelet = simple.Wavelet(WholeExtent=[-5, 5, -5, 5, -5, 5])
    wavelet.UpdatePipeline()
    display = simple.Show(wavelet, view)
    display.SetRepresentationType("Shadowed Slices")
    simple.ColorBy(display, ["POINTS", "RTData"])
    display.ProjectiveLight = 1
    look_at(view)
    light = [light for light in view.GetClientSideObject().GetRenderer().GetLights()
             if light.IsA("vtkProjectiveLight")][0]
    rendered = {}
    with tempfile.TemporaryDirectory() as folder:
        for name, kind, largest in (("8 bits", VTK_UNSIGNED_CHAR, 255), ("16 bits", VTK_UNSIGNED_SHORT, 65535),
                                    ("float", VTK_FLOAT, 1.0)):
            display.ProjectiveLightImage = screen(folder, kind, largest)
            rendered[name] = snapshot(view)
            checks.equal(light.GetSwitch(), 1, f"light with an image of {name}")
            checks.that(numpy.abs(rendered[name] - rendered["8 bits"]).max() <= 1, f"image of {name}")
        representation = display.GetClientSideObject().GetActiveRepresentation()
        with warnings_of(representation, ("ErrorEvent",)) as errors:
            display.ProjectiveLightImage = screen(folder, VTK_UNSIGNED_CHAR, 255, 2)
            wrong = snapshot(view)
            snapshot(view)
        checks.one_message(errors, "The projective light is off, because the image on its screen has 2 samples along z",
                           "an invalid image")
        checks.equal(light.GetSwitch(), 0, "a light with an invalid image is off")
        checks.that(numpy.abs(wrong - rendered["8 bits"]).max() > 8, "the light had an effect")
    simple.Delete(view)


def main(checks):
    check_time_slice(checks)
    check_outputs_to_select(checks)
    check_field(checks)
    check_colors(checks)
    check_sizes(checks)
    check_digits(checks)
    check_skipped(checks)
    check_light_images(checks)


run(main)
