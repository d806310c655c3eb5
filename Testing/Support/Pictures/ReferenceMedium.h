// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReferenceMedium_h
#define ReferenceMedium_h

#include "Support/Pictures/ReferenceFunction.h" // for the transfer functions
#include "Support/Pictures/ReferenceImage.h"    // for the values

#include "vtkSmartPointer.h" // for the planes

#include <array>
#include <vector>

class vtkPlane;

namespace reference
{

struct SceneVolume;

/**
 * @class   ReferenceMedium
 * @brief   extinction, colour and normals in a volume, as vtkShadowedSliceMapper.h has them, in
 * double
 *
 * The functions of the property are evaluated at each place, not from a table. Cropping and
 * clipping planes are part of the medium: nothing is where they cut.
 */
class ReferenceMedium
{
public:
  /// What one component (or dependent ones together) is at a place.
  struct Part
  {
    /// Which component's coefficients of reflection count.
    int Row = 0;
    double Extinction = 0.0;
    Double3 Color{};
    /// Towards lower values, of length 1; 0 where the gradient is.
    Double3 Normal{};
  };

  /// Coefficients of reflection of a component.
  struct Reflection
  {
    bool Shade = false;
    double Ambient = 0.0;
    double Diffuse = 0.0;
    double Specular = 0.0;
    double SpecularPower = 1.0;
  };

  /// std::invalid_argument as ReferenceImage, StraightFunction, and for three dependent components.
  explicit ReferenceMedium(const SceneVolume& volume);

  const ReferenceImage& GetImage() const { return this->Image; }
  const Reflection& GetReflection(int row) const { return this->Rows[row].Reflect; }

  /// The parts with an extinction above 0, and how many. \a withColors false leaves colour and
  /// normal out.
  int GetParts(const Double3& index, bool withColors, std::array<Part, 4>& parts) const;
  /// The extinction of the three channels of light: tau (1 - transmission).
  Double3 GetLightExtinction(const Double3& index) const;

  /// The distances along the line at which cropping planes cut it.
  std::vector<double> GetCuts(const IndexLine& line) const;
  /// Reduces [begin, end] of a line in the world to what clipping planes leave of it; false where
  /// that is nothing.
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
