// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_TetrahedraDepth_h
#define interlume_TetrahedraDepth_h

#include "View/TetrahedraView.h"

#include <array>
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
   * Reads the scene's depth. Returns whether anything is drawn; else GetBuffer() is empty.
   */
  bool Read(vtkRenderer* renderer);

  ///@{
  /**
   * The depth of all pixels of the viewport, 0 to 1 at the far plane.
   */
  const std::vector<float>& GetBuffer() const { return this->Buffer; }
  void SetBuffer(const std::vector<float>& depths, const std::array<int, 2>& size);
  ///@}

  /**
   * Takes the depth for every \a stride-th pixel; where nothing is drawn, the depth of the far
   * plane if \a isCutByFarPlane.
   */
  void Place(const TetrahedraView& view, int stride, bool isCutByFarPlane);

  /// Returns depths as TetrahedraView has them, for each of its pixels; empty where nothing cuts.
  const std::vector<float>& GetDepths() const { return this->Depths; }

private:
  std::array<int, 2> Size{ { 0, 0 } };
  std::vector<float> Buffer;
  std::vector<float> Depths;
};

}

#endif
