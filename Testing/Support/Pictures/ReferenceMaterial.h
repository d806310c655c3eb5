// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReferenceMaterial_h
#define ReferenceMaterial_h

#include "Support/Pictures/ReferenceFunction.h"    // for the transfer functions
#include "Support/Pictures/ReferenceIntegral.h"    // for the parts
#include "Support/Pictures/ReferenceTetrahedron.h" // for barycentric coordinates
#include "vtkType.h"                               // for vtkIdType

#include <array>
#include <string>
#include <vector>

class vtkDataArray;
class vtkUnstructuredGrid;
class vtkVolumeProperty;

namespace reference
{

/**
 * The arrays that a picture of a grid is made of.
 */
struct MaterialArrays
{
  /// Name of the scalars; the active ones where it is empty.
  std::string Scalars;
  /// Whether they are of cells: one value for each tetrahedron.
  bool OfCells = false;
  /// Name of the point array with the extent in time; none where it is empty: 1 everywhere.
  std::string DeltaT;
};

/**
 * @class   ReferenceMaterial
 * @brief   colour and extinction in the tetrahedra of a grid, in double
 *
 * Scalars and components as vtkTimeWeightedTetrahedraMapper has them. The extinction is the opacity
 * function divided by ScalarOpacityUnitDistance. std::invalid_argument for arrays that are missing
 * or have a wrong number of components.
 */
class ReferenceMaterial
{
public:
  /// What the picture takes from one place of a tetrahedron.
  struct Sample
  {
    /// The arguments of the colour and the opacity function.
    double ColorArgument;
    double OpacityArgument;
    /// The colour itself, where it is not the function's.
    std::array<double, 3> Direct;
    double Weight;
  };

  ReferenceMaterial(
    vtkUnstructuredGrid* grid, vtkVolumeProperty* property, const MaterialArrays& arrays);

  /// Whether no value at a corner of the tetrahedron is NaN or infinite.
  bool IsFinite(vtkIdType cell, const std::array<vtkIdType, 4>& points) const;

  Sample At(
    vtkIdType cell, const std::array<vtkIdType, 4>& points, const Barycentric& position) const;

  /// Returns whether the array holds colors instead of arguments of the color function.
  bool HasDirectColors() const { return this->IsDirect; }

  /// The colour, and the opacity as the function has it, not divided by the unit distance.
  std::array<double, 3> GetColor(const Sample& sample) const;
  double GetOpacity(const Sample& sample) const;

  /// Appends the straight parts between two samples so far apart, front to back.
  void AppendParts(
    const Sample& begin, const Sample& end, double length, std::vector<StraightPart>& parts) const;
  /// The one part that has the mean of both ends as its colour and extinction.
  StraightPart GetMeanPart(const Sample& begin, const Sample& end, double length) const;

private:
  Sample OfTuple(vtkIdType tuple) const;
  std::array<double, 3> EvaluateColor(const Sample& sample, const Sample& inside) const;

  vtkDataArray* Scalars = nullptr;
  vtkDataArray* DeltaT = nullptr;
  bool OfCells = false;
  bool IsDirect = false;
  /// The component that is taken of independent ones; -1 for their magnitude.
  int Component = 0;
  bool Independent = true;
  double ColorScale = 1.0;
  double UnitDistance = 1.0;
  StraightFunction Color;
  StraightFunction Opacity;
};

}

#endif
