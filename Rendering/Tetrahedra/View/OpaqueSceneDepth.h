// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_OpaqueSceneDepth_h
#define interlume_OpaqueSceneDepth_h

#include "View/TetrahedraView.h"

#include <array>
#include <limits>
#include <vector>

class vtkRenderer;

namespace interlume
{

/**
 * @class   OpaqueSceneDepth
 * @brief   reads the scene's depth buffer and converts it to depths as defined by TetrahedraView
 */
class OpaqueSceneDepth
{
public:
  /// Depth of a pixel at which tetrahedra are not cut.
  static constexpr float NONE = std::numeric_limits<float>::lowest();

  /**
   * Reads the scene's depth buffer. Returns true if it contains a surface; otherwise GetBuffer() is
   * empty.
   */
  bool Read(vtkRenderer* renderer);

  ///@{
  /**
   * Set/Get the viewport's depth buffer. Values are in [0, 1], and 1 is the far plane.
   */
  const std::vector<float>& GetBuffer() const { return this->Buffer; }
  void SetBuffer(const std::vector<float>& depths, const std::array<int, 2>& size);
  ///@}

  /**
   * Converts the depth buffer value of every \a stride-th pixel in x and y to a depth as defined by
   * TetrahedraView. A pixel without a surface gets the depth of the far plane if \a
   * isCutByFarPlane, otherwise NONE.
   */
  void Resample(const TetrahedraView& view, int stride, bool isCutByFarPlane);

  /// Returns, for each pixel, the depth as defined by TetrahedraView beyond which tetrahedra are
  /// cut off; empty if nothing is cut off.
  const std::vector<float>& GetDepths() const { return this->Depths; }

private:
  std::array<int, 2> Size{ { 0, 0 } };
  std::vector<float> Buffer;
  std::vector<float> Depths;
};

}

#endif
