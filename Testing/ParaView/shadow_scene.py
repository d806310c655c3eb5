# SPDX-License-Identifier: BSD-3-Clause
"""A scene of surfaces and a volume whose shadows are known in closed form, for tests of Shadowed Slices:
homogeneous smoke above a floor, a plate above one of its corners, and a light from above.
"""

from paraview import simple

from plugin_images import color_by, plain_view

OPACITY = 0.5  # opacity of one unit of smoke
WHITE = [1.0, 1.0, 1.0]
SLAB_EXTENT = [-2, 2, -2, 2, 2, 4]
SLAB_TRANSMITTANCE = (1.0 - OPACITY) ** (SLAB_EXTENT[5] - SLAB_EXTENT[4])
# Points of the floor without an occluder, below the smoke only, and below plate and smoke.
FLOOR = (4.0, -3.0, 0.0)
BENEATH_SMOKE = (1.0, -1.0, 0.0)
BENEATH_PLATE = (-2.5, -1.0, 0.0)
# Points at the front of the smoke, below the plate and without an occluder.
SMOKE_UNDER_PLATE = (-1.5, -2.0, 3.0)
SMOKE = (1.0, -2.0, 3.0)


def make_slab(extent=None):
    slab = simple.Wavelet()
    slab.WholeExtent = extent or SLAB_EXTENT
    slab.UpdatePipeline()
    return slab


def make_plate(corner, size, height):
    """Returns a horizontal square with the given corner."""
    x, y = corner
    plate = simple.Plane()
    plate.Origin = [x, y, height]
    plate.Point1 = [x + size, y, height]
    plate.Point2 = [x, y + size, height]
    return plate


def show_surface(source, view):
    display = simple.Show(source, view)
    display.SetRepresentationType("Surface")
    color_by(display, None)
    display.AmbientColor = display.DiffuseColor = WHITE
    return display


def show_slab(source, view, opacity=OPACITY):
    """Shows the data as white smoke, regardless of its values."""
    display = simple.Show(source, view)
    display.SetRepresentationType("Shadowed Slices")
    simple.ColorBy(display, ["POINTS", "RTData"])
    lowest, highest = -1e3, 1e3
    display.LookupTable.RGBPoints = [lowest, *WHITE, highest, *WHITE]
    display.ScalarOpacityFunction.Points = [lowest, opacity, 0.5, 0.0, highest, opacity, 0.5, 0.0]
    display.ShadowedOpacityUnitDistance = 1.0
    display.ShadowedShade = False
    display.AutoAdjustSampleDistances = False
    return display


def dark_view():
    """Returns a view from the front and above, without a light."""
    view = plain_view()
    view.UseLight = False
    view.CameraPosition = [0.0, -16.0, 7.0]
    view.CameraFocalPoint = [0.0, 0.0, 1.0]
    view.CameraViewUp = [0.0, 0.0, 1.0]
    return view


def add_sun(view):
    light = simple.AddLight(view=view)
    light.Coords = "Scene"
    light.Type = "Directional"
    light.Position = [0.0, 0.0, 10.0]
    light.FocalPoint = [0.0, 0.0, 0.0]
    return light


def make_sources():
    return {"floor": make_plate((-6.0, -6.0), 12.0, 0.0), "plate": make_plate((-3.0, -3.0), 3.0, 4.5),
            "slab": make_slab()}


def show_scene(sources, view):
    displays = {name: show_surface(sources[name], view) for name in ("floor", "plate")}
    displays["slab"] = show_slab(sources["slab"], view)
    return displays


def brightness(view, shot, point):
    """Returns the brightness of the pixel that shows a point, from 0 to 255."""
    renderer = view.GetClientSideObject().GetRenderer()
    renderer.SetWorldPoint(*point, 1.0)
    renderer.WorldToDisplay()
    x, y, _ = renderer.GetDisplayPoint()
    return float(shot[int(y) * view.ViewSize[0] + int(x)].mean())


def drawing_pass(view):
    """Returns the pass that renders the props, among the passes of ParaView."""
    render_pass = view.GetClientSideObject().GetRenderer().GetPass()
    while not render_pass.IsA("vtkCameraPass"):
        render_pass = render_pass.GetDelegatePass()
    return render_pass.GetDelegatePass()
