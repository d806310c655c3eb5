#ifndef vtkTetrahedraDepth_h
#define vtkTetrahedraDepth_h

#include "vtkTetrahedraView.h"

#include <vector>

class vtkRenderer;

/**
 * @class   vtkTetrahedraDepth
 * @brief   the scene's depth in the numbers of vtkTetrahedraView
 */
class vtkTetrahedraDepth
{
public:
  /**
   * Reads the scene's depth, for every \a stride-th pixel. Returns false where it could not be
   * read.
   */
  bool Read(vtkRenderer* renderer, const vtkTetrahedraView& view, int stride);

  /// Depths as vtkTetrahedraView has them, for each of its pixels; empty where nothing is drawn.
  const std::vector<float>& GetDepths() const { return this->Depths; }

private:
  std::vector<float> Buffer;
  std::vector<float> Depths;
};

#endif
