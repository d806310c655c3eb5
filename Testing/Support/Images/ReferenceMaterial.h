// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReferenceMaterial_h
#define ReferenceMaterial_h

#include "Support/Images/ReferenceFunction.h"    // for the transfer functions
#include "Support/Images/ReferenceIntegral.h"    // for the parts
#include "Support/Images/ReferenceTetrahedron.h" // for barycentric coordinates
#include "vtkType.h"                             // for vtkIdType

#include <array>
#include <string>
#include <vector>

class vtkDataArray;
class vtkUnstructuredGrid;
class vtkVolumeProperty;

namespace reference
{

/**
 * The arrays of a grid that determine color and extinction.
 */
struct MaterialArrays
{
  /// Name of the scalars. If empty, the active scalars are used.
  std::string Scalars;
  /// Whether the scalars are cell data, with one value per tetrahedron.
  bool OfCells = false;
  /// Name of the point array with the temporal extent. If empty, the temporal extent is 1
  /// everywhere.
  std::string DeltaT;
};

/**
 * @class   ReferenceMaterial
 * @brief   color and extinction in the tetrahedra of a grid, in double precision
 *
 * Scalars and components are used as in vtkTimeWeightedTetrahedraMapper. The extinction is the
 * opacity function divided by ScalarOpacityUnitDistance. Throws std::invalid_argument if arrays are
 * missing or have an invalid number of components.
 */
class ReferenceMaterial
{
public:
  /// Interpolated values at a point of a tetrahedron.
  struct Sample
  {
    /// Arguments of the color function and the opacity function.
    double ColorArgument;
    double OpacityArgument;
    /// Color, if the scalars are colors.
    std::array<double, 3> Direct;
    double Weight;
  };

  ReferenceMaterial(
    vtkUnstructuredGrid* grid, vtkVolumeProperty* property, const MaterialArrays& arrays);

  /// Returns whether all values at the corners of the tetrahedron are finite.
  bool IsFinite(vtkIdType cell, const std::array<vtkIdType, 4>& points) const;

  Sample At(
    vtkIdType cell, const std::array<vtkIdType, 4>& points, const Barycentric& position) const;

  /// Returns whether the scalars are colors instead of arguments of the color function.
  bool HasDirectColors() const { return this->IsDirect; }

  /// Return the color, and the value of the opacity function, not divided by the unit distance.
  std::array<double, 3> GetColor(const Sample& sample) const;
  double GetOpacity(const Sample& sample) const;

  /// Splits the line between two samples into parts on which color and extinction are linear, and
  /// appends them front to back. \a length is the distance between the samples.
  void AppendParts(
    const Sample& begin, const Sample& end, double length, std::vector<LinearPart>& parts) const;
  /// Returns a single part with the mean color and extinction of both ends.
  LinearPart GetMeanPart(const Sample& begin, const Sample& end, double length) const;

private:
  Sample MakeSampleFromTuple(vtkIdType tuple) const;
  std::array<double, 3> EvaluateColor(const Sample& sample, const Sample& inside) const;

  vtkDataArray* Scalars = nullptr;
  vtkDataArray* DeltaT = nullptr;
  bool OfCells = false;
  bool IsDirect = false;
  /// Selected independent component, or -1 for the magnitude.
  int Component = 0;
  bool Independent = true;
  double ColorScale = 1.0;
  double UnitDistance = 1.0;
  PiecewiseLinearFunction Color;
  PiecewiseLinearFunction Opacity;
};

}

#endif
