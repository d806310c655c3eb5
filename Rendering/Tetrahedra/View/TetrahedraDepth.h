// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_TetrahedraDepth_h
#define interlume_TetrahedraDepth_h

#include "View/TetrahedraView.h"

#include <vector>

class vtkRenderer;

namespace interlume
{

/**
 * @class   TetrahedraDepth
 * @brief   the scene's depth in the numbers of TetrahedraView
 */
class TetrahedraDepth
{
public:
  /**
   * Reads the scene's depth, for every \a stride-th pixel; where nothing is drawn, the depth of the
   * far plane if \a isCutByFarPlane.
   */
  void Read(vtkRenderer* renderer, const TetrahedraView& view, int stride, bool isCutByFarPlane);

  /// Returns depths as TetrahedraView has them, for each of its pixels; empty where nothing cuts.
  const std::vector<float>& GetDepths() const { return this->Depths; }

private:
  std::vector<float> Buffer;
  std::vector<float> Depths;
};

}

#endif
