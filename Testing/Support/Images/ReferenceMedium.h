// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReferenceMedium_h
#define ReferenceMedium_h

#include "Support/Images/ReferenceFunction.h" // for the transfer functions
#include "Support/Images/ImageInterpolator.h" // for the values

#include "vtkSmartPointer.h" // for the planes

#include <array>
#include <vector>

class vtkPlane;

namespace reference
{

struct SceneVolume;

/**
 * @class   ReferenceMedium
 * @brief   extinction, color and normals of a volume in double precision, as documented for
 * vtkShadowedSliceMapper
 *
 * The transfer functions are evaluated at each point instead of being looked up in a table.
 * Cropping and clipping planes are part of the medium: the extinction is 0 in removed regions.
 */
class ReferenceMedium
{
public:
  /// Optical properties of one component at a point. Dependent components are combined into one
  /// part.
  struct Part
  {
    /// Argument for GetReflection().
    int Row = 0;
    double Extinction = 0.0;
    Double3 Color{};
    /// Unit vector opposite to the gradient, or the zero vector if the gradient is 0.
    Double3 Normal{};
  };

  /// Reflection coefficients of a component.
  struct Reflection
  {
    bool Shade = false;
    double Ambient = 0.0;
    double Diffuse = 0.0;
    double Specular = 0.0;
    double SpecularPower = 1.0;
  };

  /// Throws std::invalid_argument if ImageInterpolator or PiecewiseLinearFunction does, or if the
  /// volume has three dependent components.
  explicit ReferenceMedium(const SceneVolume& volume);

  const ImageInterpolator& GetImage() const { return this->Image; }
  const Reflection& GetReflection(int row) const { return this->Rows[row].Reflect; }

  /// Stores the parts with positive extinction in \a parts and returns their number. If \a
  /// withColors is false, colors and normals are not computed.
  int GetParts(const Double3& index, bool withColors, std::array<Part, 4>& parts) const;
  /// Returns the extinction of light in each color channel: tau (1 - transmission color).
  Double3 GetLightExtinction(const Double3& index) const;

  /// Returns the distances along the line at which it crosses the cropping planes.
  std::vector<double> GetCuts(const IndexLine& line) const;
  /// Clips the interval [begin, end] of a line in world coordinates against the clipping planes.
  /// Returns false if the result is empty.
  bool Clip(const Double3& world, const Double3& direction, double& begin, double& end) const;

private:
  struct Row
  {
    PiecewiseLinearFunction Color;
    PiecewiseLinearFunction Opacity;
    PiecewiseLinearFunction GradientOpacity;
    bool HasGradientOpacity = false;
    double UnitDistance = 1.0;
    double Weight = 1.0;
    Reflection Reflect;
  };

  bool IsCropped(const Double3& index) const;
  double GetExtinction(const Row& row, const Double3& index,
    const ImageInterpolator::Sample& sample, int component) const;

  ImageInterpolator Image;
  std::vector<Row> Rows;
  bool IsIndependent = true;
  bool IsDirect = false;
  PiecewiseLinearFunction Transmission;
  bool HasTransmission = false;
  int CroppingFlags = 0;
  std::array<double, 6> CroppingPlanes{};
  std::vector<vtkSmartPointer<vtkPlane>> Planes;
};

}

#endif
