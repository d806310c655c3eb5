# SPDX-License-Identifier: BSD-3-Clause
"""Support for the guide's scripts: finds data files, sets up a renderer, and writes the image."""

import sys

import vtkmodules.vtkRenderingOpenGL2  # draws
import vtkmodules.vtkRenderingVolumeOpenGL2  # draws volumes
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingCore import vtkRenderer, vtkRenderWindow, vtkWindowToImageFilter


class GuideImage:
    """Reads the script's arguments: the data directory and the PNG file to write."""

    def __init__(self):
        if len(sys.argv) != 3:
            sys.exit(f"usage: python3 {sys.argv[0]} DATA IMAGE.png")
        self.folder, self.file = sys.argv[1:]
        self.renderer = vtkRenderer()
        self.renderer.SetBackground(0.925, 0.929, 0.933)

    def path(self, name):
        """Returns the path of a data file."""
        return f"{self.folder}/{name}"

    def write(self, x, y, z):
        """Renders the scene from a camera in the given direction and writes the image."""
        window = vtkRenderWindow()
        window.OffScreenRenderingOn()
        window.SetMultiSamples(0)
        window.SetSize(600, 450)
        window.AddRenderer(self.renderer)
        camera = self.renderer.GetActiveCamera()
        camera.SetPosition(x, y, z)
        camera.SetFocalPoint(0.0, 0.0, 0.0)
        camera.SetViewUp(0.0, 0.0, 1.0)
        self.renderer.ResetCamera()
        camera.Zoom(1.25)
        window.Render()
        picture = vtkWindowToImageFilter()
        picture.SetInput(window)
        picture.ReadFrontBufferOff()
        picture.ShouldRerenderOff()
        writer = vtkPNGWriter()
        writer.SetInputConnection(picture.GetOutputPort())
        writer.SetFileName(self.file)
        writer.Write()
