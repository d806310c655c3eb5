// SPDX-License-Identifier: BSD-3-Clause
#ifndef DrawCounter_h
#define DrawCounter_h

#include "vtkType.h"

#include <memory>
#include <set>
#include <string>
#include <vector>

class vtkRenderer;

namespace gallery
{
class Panel;
struct SceneReport;

/**
 * Counts how often the surfaces of a renderer are drawn: the draws of its busiest mapper.
 */
class DrawCounter
{
public:
  /**
   * From now on counts the draws of every actor in \a renderer.
   */
  explicit DrawCounter(vtkRenderer* renderer);
  ~DrawCounter();

  int GetPasses() const;

private:
  struct Counted;
  std::vector<std::unique_ptr<Counted>> Counts;
};

/**
 * Off-screen textures of one panel, its window's own included, and the screen-space passes over
 * them.
 */
struct BufferCount
{
  int Buffers = 0;
  vtkIdType Bytes = 0;
  int ScreenPasses = 0;
};

/**
 * The textures that the window and ambient occlusion keep for \a panel after it was
 * drawn, in the formats VTK 9 gives them; adds what is on to \a features.
 */
BufferCount CountBuffers(const Panel& panel, std::set<std::string>& features);

/**
 * Adds what each volume of \a panel took when it was drawn to \a report.
 */
void AddVolumeReports(const Panel& panel, SceneReport& report);
}

#endif
