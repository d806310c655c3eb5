// SPDX-License-Identifier: BSD-3-Clause
#ifndef GuideImage_h
#define GuideImage_h

#include <vtkNew.h>
#include <vtkRenderer.h>

#include <string>

/// Support for the guide's programs: finds data files, sets up a renderer, and writes the image.
class GuideImage
{
public:
  /// Reads the program's arguments: the data directory and the PNG file to write.
  GuideImage(int argc, char* argv[]);

  vtkRenderer* GetRenderer() { return this->Renderer; }

  /// Returns the path of a data file.
  std::string GetPath(const std::string& name) const;

  /// Renders the scene from a camera in the direction (x, y, z) and writes the image. Returns the
  /// exit status of the program.
  int Write(double x, double y, double z);

private:
  vtkNew<vtkRenderer> Renderer;
  std::string Folder;
  std::string File;
};

#endif
