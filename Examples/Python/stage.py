# SPDX-License-Identifier: BSD-3-Clause
"""Images in the layout of the gallery: panels with captions, whose cameras are fitted to their props,
and one legend under all. They are rendered off-screen at twice the size and averaged."""

import math
import sys

import numpy as np
import vtkmodules.vtkRenderingFreeType  # draws text
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints, vtkUnsignedCharArray
from vtkmodules.vtkCommonDataModel import vtkBoundingBox, vtkCellArray, vtkImageData, vtkPolyData
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingCore import (
    vtkActor2D, vtkCamera, vtkLight, vtkPolyDataMapper2D, vtkRenderer, vtkRenderWindow, vtkTextActor,
    vtkTextProperty, vtkTextRenderer, vtkWindowToImageFilter)
from vtkmodules.vtkRenderingOpenGL2 import (
    vtkCameraPass, vtkLightsPass, vtkOpaquePass, vtkRenderPassCollection, vtkSequencePass,
    vtkSSAOPass, vtkVolumetricPass)

INK = (0.13, 0.15, 0.18)
DARK = (0.065, 0.072, 0.085)
SIZE = (480, 300)
SUPERSAMPLING = 2


class Panel:
    """A view with its props, camera and caption."""

    def __init__(self, caption):
        self.caption = caption
        self.box = None
        self.ambient_occlusion = True
        self.renderer = make_renderer()
        self.camera = vtkCamera()
        self.camera.SetViewAngle(22.0)
        self.renderer.SetActiveCamera(self.camera)
        self.look_from((0.0, -1.0, 0.0))

    def add(self, *props):
        for prop in props:
            self.renderer.AddViewProp(prop)

    def look_from(self, direction, up=(0.0, 0.0, 1.0)):
        """Sets the direction of the camera. The stage fits its distance."""
        self.camera.SetFocalPoint(0.0, 0.0, 0.0)
        self.camera.SetPosition(direction)
        self.camera.SetViewUp(up)
        self.camera.OrthogonalizeViewUp()

    def look_as(self, other):
        """Shares the camera of another panel. It is fitted to the props of both."""
        self.camera = other.camera
        self.renderer.SetActiveCamera(self.camera)

    def frame(self, *bounds):
        """Fits the camera to these bounds instead of the bounds of the props."""
        self.box = bounds

    def set_lights(self, *lights):
        self.renderer.RemoveAllLights()
        for light in lights:
            self.renderer.AddLight(light)

    def set_background(self, lower, upper=None):
        """Sets the color behind the props, or two colors between which it changes upward."""
        self.renderer.SetBackground(lower)
        if upper:
            self.renderer.SetBackground2(upper)
            self.renderer.GradientBackgroundOn()

    def get_points(self):
        if self.box:
            return corners_of(self.box)
        return np.concatenate([points_of(prop) for prop in self.renderer.GetViewProps()])

    def draw(self, width, height):
        bounds = [0.0] * 6
        self.renderer.ComputeVisiblePropBounds(bounds)
        self.renderer.SetPass(make_passes(self.renderer, vtkBoundingBox(bounds), self.ambient_occlusion))
        self.renderer.ResetCameraClippingRange(bounds)
        return draw_window(self.renderer, width, height)

    def fit(self, points, aspect):
        """Fits the camera iteratively, since the extent on screen depends on the distance."""
        camera = self.camera
        slope = math.tan(0.5 * camera.GetViewAngle() * math.pi / 180.0)
        to_camera = normalized(np.subtract(camera.GetPosition(), camera.GetFocalPoint()))
        right = normalized(np.cross(camera.GetViewUp(), to_camera))
        up = normalized(np.cross(to_camera, right))
        box = vtkBoundingBox(np.stack([points.min(0), points.max(0)], 1).ravel())
        focus = np.zeros(3)
        box.GetCenter(focus)
        distance = 2.0 * box.GetDiagonalLength() / slope
        for _ in range(12):
            offsets = points - focus
            depths = np.maximum(distance - dot(offsets, to_camera), 1e-3 * distance)
            if camera.GetParallelProjection():
                depths = np.full(len(points), distance)
            across = dot(offsets, right) / (depths * slope * aspect)
            along = dot(offsets, up) / (depths * slope)
            half = 0.5 * max(across.max() - across.min(), along.max() - along.min())
            move = right * (0.5 * (across.min() + across.max()) * distance * slope * aspect)
            focus = focus + move + up * (0.5 * (along.min() + along.max()) * distance * slope)
            distance += depths.min() * (half / 0.95 - 1.0)
        camera.SetFocalPoint(focus)
        camera.SetParallelScale(distance * slope)
        camera.SetPosition(focus + to_camera * distance)
        camera.SetViewUp(up)


class Stage:
    """Arranges panels in a grid with the given number of columns, by default in one row."""

    def __init__(self, columns=0):
        self.columns = columns
        self.panels = []
        self.legend = None
        self.width, self.height = (SUPERSAMPLING * length for length in SIZE)
        self.font = max(9 * SUPERSAMPLING, int(0.022 * self.height + 0.5))

    def add_panel(self, caption=""):
        self.panels.append(Panel(caption))
        return self.panels[-1]

    def set_color_bar(self, title, colors, lower, upper):
        """Sets a legend that maps colors to values."""
        self.legend = lambda overlay: self._add_bar(overlay, title, colors, lower, upper)

    def set_color_key(self, colors, bounds):
        """Sets a legend with a color for each interval between adjacent bounds."""
        words = [f"{lower:.0f} to {upper:.0f}" for lower, upper in zip(bounds, bounds[1:])]
        entries = list(zip(colors, words))
        self.legend = lambda overlay: self._add_key(overlay, entries)

    def save(self, path=None):
        """Renders the image into a PNG file, by default the script's first argument."""
        writer = vtkPNGWriter()
        writer.SetInputData(self.draw())
        writer.SetFileName(path or sys.argv[1])
        writer.Write()

    def draw(self):
        layouts = [self._layout(number) for number in range(len(self.panels))]
        points = {}
        for panel in self.panels:
            points.setdefault(panel.camera, []).append(panel.get_points())
        for panel, (_, _, width, height, caption) in zip(self.panels, layouts):
            panel.fit(np.concatenate(points[panel.camera]), width / (height - caption))
        picture = self._draw_captions(layouts)
        for panel, (left, bottom, width, height, caption) in zip(self.panels, layouts):
            pixels = panel.draw(width, height - caption)
            picture[bottom + caption:bottom + height, left:left + width] = pixels
        fine = picture.reshape(SIZE[1], SUPERSAMPLING, SIZE[0], SUPERSAMPLING, 3).astype(int)
        count = SUPERSAMPLING**2
        return make_image(((fine.sum((1, 3)) + count // 2) // count).astype(np.uint8))

    def _layout(self, number):
        """Returns left, bottom, width, height and caption height of a panel in pixels."""
        columns = self.columns or len(self.panels)
        rows = (len(self.panels) + columns - 1) // columns
        row, column = divmod(number, columns)
        legend = int(4.4 * self.font) if self.legend else 0
        # Without a gap, panels with a background of two colors would appear as one.
        gap = self.width // 200 if self.panels[number].renderer.GetGradientBackground() else 0
        left = self.width * column // columns + (gap if column > 0 else 0)
        right = self.width * (column + 1) // columns - (gap if column + 1 < columns else 0)
        free = self.height - legend
        bottom, top = (legend + free * (rows - i) // rows for i in (row + 1, row))
        caption = int(2.4 * self.font) if self.panels[number].caption else 0
        return left, bottom, right - left, top - bottom, caption

    def _draw_captions(self, layouts):
        overlay = make_renderer()
        for panel, (left, bottom, width, _, caption) in zip(self.panels, layouts):
            add_text(overlay, panel.caption, left + 0.5 * width, bottom + 0.5 * caption, self.font)
        if self.legend:
            self.legend(overlay)
        return draw_window(overlay, self.width, self.height)

    def _add_bar(self, overlay, title, colors, lower, upper):
        width, y, height = 0.42 * self.width, 1.9 * self.font, 0.75 * self.font
        left = 0.5 * self.width - 0.5 * width
        rectangles = []
        for i in range(256):
            color = colors.GetColor(lower + (upper - lower) * (i + 0.5) / 256)
            rectangles.append((left + width * i / 256, y, width / 256, height, color))
        for fraction in (0.0, 0.25, 0.5, 0.75, 1.0):
            x = left + fraction * width
            rectangles.append((x - 1.0, y - 0.3 * self.font, 2.0, 0.3 * self.font, INK))
            label = f"{lower + fraction * (upper - lower):.4g}"
            add_text(overlay, label, x, y - 0.9 * self.font, self.font)
        add_rectangles(overlay, rectangles)
        add_text(overlay, title, 0.5 * self.width, y + height + 0.8 * self.font, self.font)

    def _add_key(self, overlay, entries):
        font, y = self.font, 1.5 * self.font
        patch, gap, space = 1.1 * font, 0.5 * font, 1.6 * font
        widths = [text_width(word, font) for _, word in entries]
        total = -space
        for width in widths:
            total += patch + gap + width + space
        left = 0.5 * self.width - 0.5 * total
        rectangles = []
        for (color, word), width in zip(entries, widths):
            rectangles.append((left, y - 0.5 * patch, patch, patch, color))
            add_text(overlay, word, left + patch + gap, y, font, centered=False)
            left += patch + gap + width + space
        add_rectangles(overlay, rectangles)


def dot(vectors, axis):
    # The order of the summands is fixed, because images must be bit-identical.
    return vectors[..., 0] * axis[0] + vectors[..., 1] * axis[1] + vectors[..., 2] * axis[2]


def normalized(vector):
    return vector * (1.0 / math.sqrt(dot(vector, vector)))


def corners_of(bounds):
    return np.array([(x, y, z) for z in bounds[4:] for y in bounds[2:4] for x in bounds[:2]])


def points_of(prop):
    """Returns enough points to approximate the outline of the prop to about a pixel."""
    mapper = prop.GetMapper()
    mapper.Update()
    shape = mapper.GetInputDataObject(0, 0)
    if not prop.GetIsIdentity() or not shape.IsA("vtkPointSet"):
        return corners_of(prop.GetBounds())
    points = vtk_to_numpy(shape.GetPoints().GetData())
    return points[::max(1, len(points) // 20000)].astype(float)


def make_renderer():
    renderer = vtkRenderer()
    renderer.SetBackground(0.925, 0.929, 0.933)
    renderer.AutomaticLightCreationOff()
    lights = [((-0.7, 0.9, 1.0), 0.80), ((1.2, 0.2, 0.9), 0.45), ((0.0, 0.0, 1.0), 0.24)]
    for position, intensity in lights:
        light = vtkLight()
        light.SetLightTypeToCameraLight()
        light.SetPosition(position)
        light.SetFocalPoint(0.0, 0.0, 0.0)
        light.SetIntensity(intensity)
        renderer.AddLight(light)
    return renderer


def make_passes(renderer, box, ambient_occlusion):
    """Returns passes that draw surfaces, with ambient occlusion if it is on, then volumes."""
    surfaces = vtkOpaquePass()
    if ambient_occlusion and any(prop.IsA("vtkActor") for prop in renderer.GetViewProps()):
        inner = vtkCameraPass()
        inner.SetDelegatePass(surfaces)
        surfaces = vtkSSAOPass()
        surfaces.SetDelegatePass(inner)
        surfaces.SetRadius(0.05 * box.GetDiagonalLength())
        surfaces.SetBias(0.04 * surfaces.GetRadius())
        surfaces.SetKernelSize(48)
        surfaces.BlurOn()
    passes = vtkRenderPassCollection()
    for item in (vtkLightsPass(), surfaces, vtkVolumetricPass()):
        passes.AddItem(item)
    sequence = vtkSequencePass()
    sequence.SetPasses(passes)
    camera = vtkCameraPass()
    camera.SetDelegatePass(sequence)
    return camera


def draw_window(renderer, width, height):
    """Returns the pixels of a window: rows from the bottom, columns, RGB channels."""
    window = vtkRenderWindow()
    window.OffScreenRenderingOn()
    window.SetMultiSamples(0)
    window.SetSize(width, height)
    window.AddRenderer(renderer)
    window.Render()
    grabber = vtkWindowToImageFilter()
    grabber.SetInput(window)
    grabber.SetInputBufferTypeToRGB()
    grabber.ReadFrontBufferOff()
    grabber.ShouldRerenderOff()
    grabber.Update()
    pixels = vtk_to_numpy(grabber.GetOutput().GetPointData().GetScalars())
    return pixels.reshape(height, width, 3).copy()


def make_image(pixels):
    image = vtkImageData()
    image.SetDimensions(pixels.shape[1], pixels.shape[0], 1)
    image.AllocateScalars(3, 3)
    vtk_to_numpy(image.GetPointData().GetScalars())[:] = pixels.reshape(-1, 3)
    return image


def set_style(style, font):
    style.SetFontFamilyToArial()
    style.SetFontSize(font)
    style.SetColor(INK)
    style.SetVerticalJustificationToCentered()


def text_width(text, font):
    style = vtkTextProperty()
    set_style(style, font)
    box = [0] * 4
    vtkTextRenderer.GetInstance().GetBoundingBox(style, text, box, 72)
    return box[1] - box[0]


def add_text(overlay, text, x, y, font, centered=True):
    actor = vtkTextActor()
    actor.SetTextScaleModeToNone()
    actor.SetInput(text)
    set_style(actor.GetTextProperty(), font)
    if centered:
        actor.GetTextProperty().SetJustificationToCentered()
    actor.SetPosition(x, y)
    overlay.AddViewProp(actor)


def add_rectangles(overlay, rectangles):
    points, cells, colors = vtkPoints(), vtkCellArray(), vtkUnsignedCharArray()
    colors.SetNumberOfComponents(3)
    for x, y, width, height, color in rectangles:
        corners = [(x, y), (x + width, y), (x + width, y + height), (x, y + height)]
        cells.InsertNextCell(4, [points.InsertNextPoint(*corner, 0.0) for corner in corners])
        colors.InsertNextTuple3(*(255.0 * channel for channel in color))
    data = vtkPolyData()
    data.SetPoints(points)
    data.SetPolys(cells)
    data.GetCellData().SetScalars(colors)
    actor = vtkActor2D()
    actor.SetMapper(vtkPolyDataMapper2D())
    actor.GetMapper().SetInputData(data)
    overlay.AddViewProp(actor)
