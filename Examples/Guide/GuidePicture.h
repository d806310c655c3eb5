// SPDX-License-Identifier: BSD-3-Clause
#ifndef GuidePicture_h
#define GuidePicture_h

#include <vtkNew.h>
#include <vtkRenderer.h>

#include <string>

/// What the programs of the guide share: the folder of the data, a renderer, and a picture of what
/// is in it.
class GuidePicture
{
public:
  /// Takes the program's arguments: the folder of the data and the PNG file to write.
  GuidePicture(int argc, char* argv[]);

  vtkRenderer* GetRenderer() { return this->Renderer; }

  /// Returns the path of a file of the data.
  std::string GetPath(const std::string& name) const;

  /// Draws all that is in the renderer, seen from this direction, and returns the program's exit
  /// status.
  int Write(double x, double y, double z);

private:
  vtkNew<vtkRenderer> Renderer;
  std::string Folder;
  std::string File;
};

#endif
