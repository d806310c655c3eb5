# SPDX-License-Identifier: BSD-3-Clause
"""Tests a client and a server with the plugin on both: filters must produce the same output as in one process, and
views the same images, regardless of whether server or client renders. Volumes are always rendered by the server, as
ParaView's own volumes are. A server with several processes must show the same. If one side does not have the
plugin, ParaView's plugin manager must report which.

Arguments: `write` and the file for the results of one process; `compare` or `ranks`, that file and the server's
program, preceded for `ranks` by the arguments of mpiexec; or `alone`, the side that has the plugin (`client` or
`server`), and the server's program.
"""

import sys

import numpy
from paraview import servermanager, simple

from plugin_images import color_by, fraction_shown, look_at, plain_view, snapshot
from plugin_testing import Checks, interval_volume, load_plugin, open_data
from server_testing import connect, load_plugin_on

# Size of the geometry, in megabytes, above which the server renders.
RENDERERS = {"server": 0.0, "client": 1e5}
# Properties that make an image depend on the duration of the previous frame. They are switched off.
AUTOMATIC = ("AutoAdjustSampleDistances", "IntervalAutoAdjustLevelOfDetail")
VOLUMES = ("Interval Volume", "Shadowed Slices", "Inflow Textures")
SMALLEST_FRACTION = 0.05  # fraction of pixels that differ from the background
LARGEST_DIFFERENCE = 1  # in steps of 1/255
# Largest and mean difference if four processes render pieces, and the number of pixels that may differ by more. Images
# rounded to 1/255 are composited (3 and 0.1 were measured), rays restart in each piece, and shadows between pieces use
# a coarser grid. Each piece locates the boundary of the flow from its own samples, which moves silhouettes by a pixel.
DIFFERENCE_OF_PIECES = {"intervals": (4, 0.4, 0), "shadowed_slices": (60, 0.8, 0), "inflow_textures": (10, 0.4, 30),
                        "flow_volume": (2, 0.1, 60)}


def intervals():
    return interval_volume(open_data("wavelet"), "RTData", [(140.0, 180.0)]), "Interval Volume"


def shadowed_slices():
    return open_data("wavelet"), "Shadowed Slices"


def field():
    flow = simple.AnalyticFlow()
    flow.UpdatePipeline()
    return simple.ImplicitFlowField(Input=flow)


def inflow_textures():
    return field(), "Inflow Textures"


def flow_volume():
    samples = field()
    samples.UpdatePipeline()
    mapping = simple.InflowMapping(Input=samples)
    mapping.UpdatePipeline()
    return simple.FlowVolume(Input=mapping), "Surface"


SCENES = (intervals, shadowed_slices, inflow_textures, flow_volume)


def numbers(source):
    """Returns points, cells and bounds of the output, as reported by the server."""
    source.UpdatePipeline()
    data = source.GetDataInformation()
    return numpy.array([data.GetNumberOfPoints(), data.GetNumberOfCells(), *data.GetBounds()])


def shots(source, representation, renderers):
    view = plain_view()
    view.UseFXAA = False
    view.CompressorConfig = "vtkLZ4Compressor 0 0"  # lossless
    display = simple.Show(source, view)
    display.SetRepresentationType(representation)
    if representation == "Interval Volume":
        color_by(display, None)
    if representation == "Shadowed Slices":
        # A transparent medium. With the estimated opacity, coarse shadows between pieces would dominate.
        simple.GetOpacityTransferFunction("RTData").Points = [37.0, 0.0, 0.5, 0.0, 277.0, 0.99, 0.5, 0.0]
    for name in AUTOMATIC:
        if name in display.ListProperties():
            setattr(display, name, False)
    look_at(view)
    for name, threshold in renderers.items():
        view.RemoteRenderThreshold = threshold
        drawn = snapshot(view)
        remote = view.GetClientSideObject().GetUseDistributedRenderingForRender()
        yield name, drawn, remote
    simple.Delete(view)  # before its window loses its display


def write(path):
    load_plugin()
    results = {}
    for scene in SCENES:
        source, representation = scene()
        results[f"{scene.__name__} numbers"] = numbers(source)
        for _, drawn, _ in shots(source, representation, {"here": 0.0}):
            results[f"{scene.__name__} picture"] = drawn
    numpy.savez(path, **results)


def compare(checks, mode, path, program):
    """Compares with the results of one process. The number of points differs with several processes."""
    expected = numpy.load(path)
    server = connect(*program)
    load_plugin_on(client=True, server=True)
    for scene in SCENES:
        name = scene.__name__
        source, representation = scene()
        found = numbers(source)
        if mode == "compare":
            checks.that((found == expected[f"{name} numbers"]).all(), f"{name}, points, cells and bounds")
        picture = expected[f"{name} picture"]
        checks.that(fraction_shown(picture) > SMALLEST_FRACTION, f"{name} is visible")
        for renderer, drawn, remote in shots(source, representation, RENDERERS):
            difference = numpy.abs(drawn - picture)
            largest, mean = difference.max(), difference.mean()
            print(f"{name}, drawn by the {renderer}: difference {largest}, mean {mean:.4f}", flush=True)
            bounds = DIFFERENCE_OF_PIECES[name] if mode == "ranks" else (LARGEST_DIFFERENCE, LARGEST_DIFFERENCE, 0)
            outside = (difference.max(axis=1) > bounds[0]).sum()
            checks.that(outside <= bounds[2] and mean <= bounds[1],
                        f"{name}, drawn by the {renderer}: {largest}, {mean}, {outside} pixels differ by more")
            by_server = renderer == "server" or representation in VOLUMES
            checks.equal(bool(remote), by_server, f"{name}, rendered by the server instead of the {renderer}")
    checks.that(not any("ERR|" in line for line in server.lines), f"no errors: {server.lines}")


def check_missing(checks, side, program):
    """Tests that ParaView reports on each side if the plugin is missing on the other."""
    connect(program)
    load_plugin_on(client=side == "client", server=side == "server")
    other = "server" if side == "client" else "client"
    manager = servermanager.vtkSMProxyManager.GetProxyManager().GetPluginManager()
    session = servermanager.ActiveConnection.Session
    checks.that(not manager.FulfillPluginRequirements(session, True), f"a plugin only on the {side} is reported")
    plugins = manager.GetLocalInformation() if side == "client" else manager.GetRemoteInformation(session)
    messages = {plugins.GetPluginName(i): plugins.GetPluginStatusMessage(i)
            for i in range(plugins.GetNumberOfPlugins())}
    checks.that(f"loaded on {other}" in str(messages.get("Interlume")), f"the message names the {other}: {messages}")


def main():
    mode, argument = sys.argv[1:3]
    checks = Checks()
    if mode == "write":
        write(argument)
    elif mode in ("compare", "ranks"):
        compare(checks, mode, argument, sys.argv[3:])
    else:
        check_missing(checks, argument, sys.argv[3])
    checks.finish()


main()
