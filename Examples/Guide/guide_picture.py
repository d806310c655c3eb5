# SPDX-License-Identifier: BSD-3-Clause
"""What the scripts of the guide share: the folder of the data, a renderer, and a picture of what is in it."""

import sys

import vtkmodules.vtkRenderingOpenGL2  # draws
import vtkmodules.vtkRenderingVolumeOpenGL2  # draws volumes
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingCore import vtkRenderer, vtkRenderWindow, vtkWindowToImageFilter


class GuidePicture:
    """Takes the script's arguments: the folder of the data and the PNG file to write."""

    def __init__(self):
        if len(sys.argv) != 3:
            sys.exit(f"usage: python3 {sys.argv[0]} DATA PICTURE.png")
        self.folder, self.file = sys.argv[1:]
        self.renderer = vtkRenderer()
        self.renderer.SetBackground(0.925, 0.929, 0.933)

    def path(self, name):
        """Of a file of the data."""
        return f"{self.folder}/{name}"

    def write(self, x, y, z):
        """Draws all that is in the renderer, seen from this direction."""
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
