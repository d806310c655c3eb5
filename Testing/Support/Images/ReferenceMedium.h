// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReferenceMedium_h
#define ReferenceMedium_h

#include "Support/Images/ReferenceFunction.h" // for the transfer functions
#include "Support/Images/ReferenceImage.h"    // for the values

#include "vtkSmartPointer.h" // for the planes

#include <array>
#include <vector>

class vtkPlane;

namespace reference
{

struct SceneVolume;

/**
 * @class   ReferenceMedium
 * @brief   extinction, color and normals of a volume as documented for vtkShadowedSliceMapper, in
 * double precision
 *
 * The functions of the property are evaluated at each point, not sampled from a table. Cropping and
 * clipping planes are part of the medium: the extinction is 0 in removed regions.
 */
class ReferenceMedium
{
public:
  /// Properties of a component at a point. Dependent components form a single part.
  struct Part
  {
    /// Index of the reflection coefficients.
    int Row = 0;
    double Extinction = 0.0;
    Double3 Color{};
    /// Direction of decreasing values, of length 1, or 0 if the gradient is 0.
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

  /// Throws std::invalid_argument like ReferenceImage and StraightFunction, and for three dependent
  /// components.
  explicit ReferenceMedium(const SceneVolume& volume);

  const ReferenceImage& GetImage() const { return this->Image; }
  const Reflection& GetReflection(int row) const { return this->Rows[row].Reflect; }

  /// Writes the parts with a positive extinction and returns their number. If \a withColors is
  /// false, colors and normals are not computed.
  int GetParts(const Double3& index, bool withColors, std::array<Part, 4>& parts) const;
  /// Returns the extinction for the three color channels of light: tau (1 - transmission).
  Double3 GetLightExtinction(const Double3& index) const;

  /// Returns the distances along the line of its intersections with cropping planes.
  std::vector<double> GetCuts(const IndexLine& line) const;
  /// Clips [begin, end] of a line in world coordinates with the clipping planes. Returns false if
  /// the result is empty.
  bool Clip(const Double3& world, const Double3& direction, double& begin, double& end) const;

private:
  struct Row
  {
    StraightFunction Color;
    StraightFunction Opacity;
    StraightFunction GradientOpacity;
    bool HasGradientOpacity = false;
    double UnitDistance = 1.0;
    double Weight = 1.0;
    Reflection Reflect;
  };

  bool IsCropped(const Double3& index) const;
  double GetExtinction(const Row& row, const Double3& index, const ReferenceImage::Sample& sample,
    int component) const;

  ReferenceImage Image;
  std::vector<Row> Rows;
  bool IsIndependent = true;
  bool IsDirect = false;
  StraightFunction Transmission;
  bool HasTransmission = false;
  int CroppingFlags = 0;
  std::array<double, 6> CroppingPlanes{};
  std::vector<vtkSmartPointer<vtkPlane>> Planes;
};

}

#endif
