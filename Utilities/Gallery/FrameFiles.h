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
 * Writes an image to a PNG file.
 * @throw std::runtime_error if the file cannot be written.
 */
void WritePng(vtkImageData* image, const std::string& path);

/**
 * Writes the frames of an animation as `<id>/000.png`, `<id>/001.png` and so on. If VTK has an Ogg
 * Theora encoder, also writes the movie `<id>.ogv`.
 */
class FrameFiles
{
public:
  static constexpr int FramesPerSecond = 12;

  FrameFiles(const std::string& folder, const std::string& id);
  ~FrameFiles();

  void Add(vtkImageData* frame);
  /// Completes the movie. Returns false if there is no movie or it could not be written.
  bool Finish();

  /// Returns the path of frame \a number, relative to the output directory.
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
