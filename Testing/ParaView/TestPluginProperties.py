"""A filter made in ParaView starts with values from its input's range, and says what all is for."""

from paraview import servermanager, simple

from plugin_testing import (
    Checks, check_documentation, check_menu, fetch, load_plugin, open_data)

FLOAT_ROUNDING = 1e-7


def check_inputs(checks, name, wavelet):
    """The input takes data with a point array of one component, and a group of such; no other."""
    vectors = simple.Sphere()  # has normals only
    group = simple.GroupDatasets(Input=[wavelet])
    input_property = servermanager.ProxyManager().GetPrototypeProxy("filters", name).GetProperty("Input")
    for source, accepted in ((wavelet, True), (group, True), (vectors, False)):
        source.UpdatePipeline()
        input_property.RemoveAllUncheckedProxies()
        input_property.AddUncheckedInputConnection(source.SMProxy, 0)
        taken = bool(input_property.IsInDomains())
        checks.equal(taken, accepted, f"{name} takes {source.SMProxy.GetXMLName()}")
    input_property.RemoveAllUncheckedProxies()


def main():
    load_plugin()
    checks = Checks()
    wavelet = open_data("wavelet")
    lowest, highest = wavelet.PointData.GetArray("RTData").GetRange()
    middle = (lowest + highest) / 2

    volume = simple.IntervalVolume(Input=wavelet)
    checks.equal(list(volume.Scalars), ["POINTS", "RTData"], "scalars")
    checks.equal(list(volume.Intervals), [middle, highest], "first interval")
    checks.equal(list(volume.Criteria), [], "criteria")
    values = fetch(volume).GetPointData().GetArray("RTData").GetRange()
    for value, bound in zip(values, (middle, highest)):
        checks.close(value, bound, FLOAT_ROUNDING, "end of the values in the first interval")
    checks.equal(volume.SMProxy.GetOutputPortName(0), "Tetrahedra", "output port 0")
    checks.equal(volume.SMProxy.GetOutputPortName(1), "Boundary", "output port 1")
    checks.equal(fetch(volume, 1).GetNumberOfCells(), 0, "boundary triangles, not asked for")
    volume.Intervals = []
    checks.equal(fetch(volume).GetNumberOfCells(), 0, "tetrahedra of no interval")

    contour = simple.IsotableContour(Input=wavelet)
    checks.equal(list(contour.ContourBy), ["POINTS", "RTData"], "contour's scalars")
    checks.equal(list(contour.Isosurfaces), [middle], "first contour value")
    checks.that(fetch(contour).GetNumberOfCells() > 0, "the first contour has triangles")

    for proxy in (volume, contour):
        check_documentation(checks, proxy)
        check_menu(checks, "filters", proxy.SMProxy.GetXMLName())
        check_inputs(checks, proxy.SMProxy.GetXMLName(), wavelet)
    checks.finish()


main()
