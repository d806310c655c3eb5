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
 * @brief   an image as a medium, by the transfer functions of its volume
 *
 * Active scalars of points, of one component, interpolated in each cell between them; the
 * extinction is -ln(1 - opacity) per ScalarOpacityUnitDistance, the albedo the volume's colour or
 * that of a function of its own. Functions are taken from tables of 4,096 columns over the range of
 * the data, straight between them.
 */
class VolumeMedium : public TransportMedium
{
public:
  /// \a albedo may be null. std::invalid_argument without such scalars.
  VolumeMedium(
    vtkImageData* image, vtkVolumeProperty* property, vtkColorTransferFunction* albedo = nullptr);

  double GetExtinction(const glm::dvec3& place) const override;
  glm::dvec3 GetAlbedo(const glm::dvec3& place) const override;

private:
  /// Returns the interpolated scalar in columns of the tables.
  double GetColumn(const glm::dvec3& place) const;
  std::vector<ExtinctionRange> GetBlockRanges(const std::array<int, 3>& blocks) const;

  glm::dvec3 Spacing{};
  std::array<int, 3> Points{};
  std::vector<float> Columns;
  std::vector<double> Extinction;
  std::vector<glm::dvec3> Albedo;
};

}

#endif
