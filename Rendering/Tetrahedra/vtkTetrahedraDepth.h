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
   * Reads the scene's depth, for every \a stride-th pixel; where nothing is drawn, that of the far
   * plane if \a isCutByFarPlane.
   */
  void Read(vtkRenderer* renderer, const vtkTetrahedraView& view, int stride, bool isCutByFarPlane);

  /// Depths as vtkTetrahedraView has them, for each of its pixels; empty where nothing cuts.
  const std::vector<float>& GetDepths() const { return this->Depths; }

private:
  std::vector<float> Buffer;
  std::vector<float> Depths;
};

#endif
