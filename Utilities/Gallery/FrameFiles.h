// SPDX-License-Identifier: BSD-3-Clause
#ifndef FrameFiles_h
#define FrameFiles_h

#include "vtkSmartPointer.h"

#include <string>

class vtkGenericMovieWriter;
class vtkImageData;

namespace gallery
{
/**
 * Writes a picture as PNG. Throws std::runtime_error where that fails.
 */
void WritePng(vtkImageData* picture, const std::string& path);

/**
 * The frames of a scene's animation as files: `<id>/000.png` and so on, and, where VTK has an
 * encoder, a movie `<id>.ogv` of them.
 */
class FrameFiles
{
public:
  static constexpr int FramesPerSecond = 12;

  FrameFiles(const std::string& folder, const std::string& id);
  ~FrameFiles();

  void Add(vtkImageData* frame);
  /// Ends the movie. Returns whether there is one.
  bool Finish();

  /// Returns the name of a frame within the folder.
  static std::string GetName(const std::string& id, int number);
  static std::string GetMovieName(const std::string& id) { return id + ".ogv"; }

private:
  FrameFiles(const FrameFiles&) = delete;
  void operator=(const FrameFiles&) = delete;

  std::string Folder;
  std::string Id;
  int Number = 0;
  vtkSmartPointer<vtkGenericMovieWriter> Movie;
};
}

#endif
