// SPDX-License-Identifier: BSD-3-Clause
#ifndef VolumeMedium_h
#define VolumeMedium_h

#include "Support/Transport/TransportMedium.h"

class vtkColorTransferFunction;
class vtkImageData;
class vtkVolumeProperty;

namespace reference
{

/**
 * @class   VolumeMedium
 * @brief   medium defined by an image and the transfer functions of a volume
 *
 * Uses the active one-component point scalars with trilinear interpolation. The extinction is -ln(1
 * - opacity) per ScalarOpacityUnitDistance. The albedo is the volume's color or a separate
 * function of the scalars. All functions are sampled in tables of 4,096 columns over the scalar
 * range and interpolated linearly.
 */
class VolumeMedium : public TransportMedium
{
public:
  /// If \a albedo is null, the albedo is the volume's color. Throws std::invalid_argument if the
  /// image has no active one-component point scalars.
  VolumeMedium(
    vtkImageData* image, vtkVolumeProperty* property, vtkColorTransferFunction* albedo = nullptr);

  double GetExtinction(const glm::dvec3& position) const override;
  glm::dvec3 GetAlbedo(const glm::dvec3& position) const override;

private:
  /// Returns the interpolated scalar as a fractional column of the tables, or -1 outside the image.
  double GetColumn(const glm::dvec3& position) const;
  std::vector<ExtinctionRange> GetBlockRanges(const std::array<int, 3>& blocks) const;

  glm::dvec3 Spacing{};
  std::array<int, 3> Points{};
  std::vector<float> Columns;
  std::vector<double> Extinction;
  std::vector<glm::dvec3> Albedo;
};

}

#endif
