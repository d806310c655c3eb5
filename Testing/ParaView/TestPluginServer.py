# SPDX-License-Identifier: BSD-3-Clause
"""A client and a server apart, with the plugin on both: filters give what they give in one process, and
a view shows the same whether the server draws it or the client; volumes are always drawn by the server, as
ParaView's own are. A server of several processes shows the same. Where one side lacks the plugin, ParaView's
plugin manager is told which.

Arguments: `write` and the file for what one process makes; `compare` or `ranks`, that file and the server's
program, for `ranks` with mpiexec's words before it; or `alone`, the side that has the plugin, `client` or
`server`, and the server's program.
"""

import sys

import numpy
from paraview import servermanager, simple

from plugin_pictures import color_by, look_at, plain_view, share_shown, snapshot
from plugin_testing import Checks, interval_volume, load_plugin, open_data
from server_testing import connect, load_plugin_on

# Megabytes of geometry from which on the server draws.
WAYS = {"server": 0.0, "client": 1e5}
# What would make a picture depend on how long the last one took.
AUTOMATIC = ("AutoAdjustSampleDistances", "IntervalAutoAdjustLevelOfDetail")
VOLUMES = ("Interval Volume", "Shadowed Slices", "Inflow Textures")
SMALLEST_SHARE = 0.05  # of the picture that shows something
LARGEST_DIFFERENCE = 1  # in steps of 1/255
# Largest and mean difference where four processes draw pieces: pictures rounded to 1/255 each are laid over
# each other (3 and 0.1 were found), rays begin anew in each piece, and shadows cross by a coarser grid.
DIFFERENCE_OF_PIECES = {"intervals": (4, 0.4), "shadowed_slices": (60, 0.8), "inflow_textures": (10, 0.4),
                        "flow_volume": (2, 0.1)}


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
    """Points, cells and bounds of the output, as the server tells them."""
    source.UpdatePipeline()
    data = source.GetDataInformation()
    return numpy.array([data.GetNumberOfPoints(), data.GetNumberOfCells(), *data.GetBounds()])


def shots(source, representation, ways):
    view = plain_view()
    view.UseFXAA = False
    view.CompressorConfig = "vtkLZ4Compressor 0 0"  # without loss
    display = simple.Show(source, view)
    display.SetRepresentationType(representation)
    if representation == "Interval Volume":
        color_by(display, None)
    for name in AUTOMATIC:
        if name in display.ListProperties():
            setattr(display, name, False)
    look_at(view)
    for name, threshold in ways.items():
        view.RemoteRenderThreshold = threshold
        drawn = snapshot(view)
        remote = view.GetClientSideObject().GetUseDistributedRenderingForRender()
        yield name, drawn, remote
    simple.Delete(view)  # while its window still has a display


def write(path):
    load_plugin()
    kept = {}
    for scene in SCENES:
        source, representation = scene()
        kept[f"{scene.__name__} numbers"] = numbers(source)
        for _, drawn, _ in shots(source, representation, {"here": 0.0}):
            kept[f"{scene.__name__} picture"] = drawn
    numpy.savez(path, **kept)


def compare(checks, mode, path, program):
    """Of several processes each has its own points, so that their number is not compared."""
    expected = numpy.load(path)
    server = connect(*program)
    load_plugin_on(client=True, server=True)
    for scene in SCENES:
        name = scene.__name__
        source, representation = scene()
        found = numbers(source)
        if mode == "compare":
            checks.that((found == expected[f"{name} numbers"]).all(), f"{name}, numbers")
        picture = expected[f"{name} picture"]
        checks.that(share_shown(picture) > SMALLEST_SHARE, f"{name} shows something")
        for way, drawn, remote in shots(source, representation, WAYS):
            difference = numpy.abs(drawn - picture)
            largest, mean = difference.max(), difference.mean()
            print(f"{name}, drawn by the {way}: difference {largest}, mean {mean:.4f}", flush=True)
            bounds = DIFFERENCE_OF_PIECES[name] if mode == "ranks" else (LARGEST_DIFFERENCE, LARGEST_DIFFERENCE)
            checks.that(largest <= bounds[0] and mean <= bounds[1], f"{name}, drawn by the {way}: {largest}, {mean}")
            by_server = way == "server" or representation in VOLUMES
            checks.equal(bool(remote), by_server, f"{name}, the {way} draws")
    checks.that(not any("ERR|" in line for line in server.lines), f"no errors: {server.lines}")


def check_missing(checks, side, program):
    """ParaView knows of each side that the plugin is needed on the other too."""
    connect(program)
    load_plugin_on(client=side == "client", server=side == "server")
    other = "server" if side == "client" else "client"
    manager = servermanager.vtkSMProxyManager.GetProxyManager().GetPluginManager()
    session = servermanager.ActiveConnection.Session
    checks.that(not manager.FulfillPluginRequirements(session, True), f"a {side} alone is told of")
    plugins = manager.GetLocalInformation() if side == "client" else manager.GetRemoteInformation(session)
    said = {plugins.GetPluginName(i): plugins.GetPluginStatusMessage(i)
            for i in range(plugins.GetNumberOfPlugins())}
    checks.that(f"loaded on {other}" in str(said.get("Interlume")), f"{other} is named: {said}")


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
