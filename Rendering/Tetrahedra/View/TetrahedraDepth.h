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
 * @brief   reads the scene's depth buffer and converts it to depths as defined by TetrahedraView
 */
class TetrahedraDepth
{
public:
  /**
   * Reads the scene's depth buffer. Returns true if it contains a surface; otherwise GetBuffer() is
   * empty.
   */
  bool Read(vtkRenderer* renderer);

  ///@{
  /**
   * Set/Get the depth buffer of the viewport, 0 to 1 (far plane).
   */
  const std::vector<float>& GetBuffer() const { return this->Buffer; }
  void SetBuffer(const std::vector<float>& depths, const std::array<int, 2>& size);
  ///@}

  /**
   * Converts the depth of every \a stride-th pixel to a depth as defined by TetrahedraView. Pixels
   * without a surface get the depth of the far plane if \a isCutByFarPlane, otherwise a depth that
   * cuts nothing.
   */
  void Resample(const TetrahedraView& view, int stride, bool isCutByFarPlane);

  /// Returns the depth at which tetrahedra are cut, as defined by TetrahedraView, for each pixel;
  /// empty if nothing is cut.
  const std::vector<float>& GetDepths() const { return this->Depths; }

private:
  std::array<int, 2> Size{ { 0, 0 } };
  std::vector<float> Buffer;
  std::vector<float> Depths;
};

}

#endif
