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
 * Counts how often each surface of a renderer is drawn. GetPasses() returns the largest count.
 */
class DrawCounter
{
public:
  /**
   * Starts counting how often each actor in \a renderer is drawn.
   */
  explicit DrawCounter(vtkRenderer* renderer);
  ~DrawCounter();

  int GetPasses() const;

private:
  struct Counted;
  std::vector<std::unique_ptr<Counted>> Counts;
};

/**
 * Number and size of the off-screen textures of a panel and its window, and number of screen-space
 * passes that process these textures.
 */
struct BufferCount
{
  int Buffers = 0;
  vtkIdType Bytes = 0;
  int ScreenPasses = 0;
};

/**
 * Counts the textures that the window, ambient occlusion and scene shadows used to draw \a panel.
 * Assumes the texture formats of VTK 9. Adds the names of active features to \a features.
 */
BufferCount CountBuffers(const Panel& panel, std::set<std::string>& features);

/**
 * Adds the mapper reports of the volumes of \a panel to \a report.
 */
void AddVolumeReports(const Panel& panel, SceneReport& report);
}

#endif
