// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_MaterialTable_h
#define interlume_MaterialTable_h

#include "Common/Error.h"
#include "Volume/TransferColumns.h" // for the number of columns
#include <array>
#include <vector>

class vtkColorTransferFunction;
class vtkVolumeProperty;

namespace interlume
{

class VolumeSamples;

/**
 * @class   MaterialTable
 * @brief   lookup tables of color, extinction and gradient opacity, in the layout of a texture
 *
 * Each row contains the functions of one component, sampled at equidistant positions called
 * columns. The columns cover only the part of the component's range in which the function changes,
 * so that outliers do not reduce the resolution. Outside this part, the function is constant. If a
 * function is not linear between two columns, because of a step or peak for example, its
 * breakpoints there are stored separately (see TransferColumns).
 *
 * If all values of a component are equal, its range starts at this value and has a small width. As
 * in VTK, a function without points is a ramp over the range: colors from 0 to 1, opacities from 0
 * to 0.5. For components that are not independent, the property's functions, unit distance and
 * gradient opacity of index 0 apply. As in VTK, weights apply only to two or more independent
 * components.
 *
 * **Gradient opacity** depends on the same gradient magnitude m as in vtkGPUVolumeRayCastMapper:
 * the length of the central-difference gradient times the mean of the spacings sx, sy and sz,
 *   m = (sx + sy + sz) / 3 |((f(x + 1) - f(x - 1)) / (2 sx), ... y, ... z)|,
 * where x is a voxel index and f is the component that defines the opacity. m is in units of the
 * scalar. For cubic voxels, it is the change from one voxel to the next. m is clamped to a quarter
 * of the component's range.
 */
class MaterialTable
{
public:
  static constexpr int Columns = TransferColumns::Columns;

  /// Meaning of the components of a voxel.
  enum Kinds
  {
    /// Each component has its own functions, in a separate row. Also used for a single component.
    INDEPENDENT,
    /// The first component defines the color, the second the opacity.
    COLOR_OPACITY,
    /// Three components are RGB, and the fourth defines the opacity.
    RGB_OPACITY
  };

  /// If IsOn is true, colors are scattering albedos, clamped to [0, 1]. They are given by Albedo
  /// or, if it is null, by the color functions of the property.
  struct Scattering
  {
    bool IsOn = false;
    vtkColorTransferFunction* Albedo = nullptr;
  };

  /**
   * Samples the functions of \a property. \a transmission may be null. Returns an error for
   * - three components that are not independent,
   * - 2D transfer functions,
   * - a unit distance that is not positive,
   * - a transmission or albedo function with several independent components or with RGB.
   */
  Error Build(vtkVolumeProperty* property, const VolumeSamples& samples,
    vtkColorTransferFunction* transmission, const Scattering& scattering);
  Error Build(vtkVolumeProperty* property, const VolumeSamples& samples,
    vtkColorTransferFunction* transmission)
  {
    return this->Build(property, samples, transmission, Scattering());
  }

  /// Returns the largest extinction per world unit in [lower, upper] of \a row's opacity function.
  /// Returns 0 if lower > upper. A bound is treated as equal to a point of the function if the
  /// difference is within rounding error or a thousandth of a column's width.
  double GetLargestExtinction(int row, double lower, double upper) const;

  /// Returns true if the opacity of all rows changes only in steps and does not depend on the
  /// gradient. Ramps narrower than a thousandth of the scalar range count as steps.
  bool HasSharpOpacity() const;

  /// Returns the smallest positive extinction per world unit, or 0 if everything is transparent.
  double GetSmallestExtinction() const;

  /// Returns the component that defines \a row's opacity.
  int GetOpacityComponent(int row) const
  {
    return this->Kind == INDEPENDENT ? row : this->Kind == COLOR_OPACITY ? 1 : 3;
  }

  Kinds Kind = INDEPENDENT;
  int Rows = 0;
  /// Range of the scalar that defines a row's opacity. The ends are never equal, and their
  /// difference is finite.
  std::array<std::array<double, 2>, 4> ScalarRange{};
  /// Scalars at the first and last column of a row, for the color and transmission functions and
  /// for the opacity function. The ends are never equal, and their difference is finite.
  std::array<std::array<double, 2>, 4> ColorRange{};
  std::array<std::array<double, 2>, 4> OpacityRange{};
  /// Red, green, blue, and extinction per world unit times the component's weight. The extinction
  /// is -ln(1 - opacity) / unit distance, at most LargestOpticalDepth / unit distance. Colors are
  /// white for RGB_OPACITY.
  std::vector<float> Colors;
  static constexpr double LargestOpticalDepth = 69.0;
  /// Gradient opacity for a magnitude m of 0 to GradientRange[row]. The range ends at a quarter of
  /// the scalar range, or at the function's last point if that is smaller. The values are 1 for
  /// rows without a function or with DisableGradientOpacity. Empty if all values are 1.
  std::vector<float> GradientOpacity;
  std::array<double, 4> GradientRange{ { 1.0, 1.0, 1.0, 1.0 } };
  /// RGB of the transmitted light, sampled over ColorRange[0]. Empty if there is no transmission
  /// function.
  std::vector<float> Transmission;
  /// For each column of the tables above, the index in Bends of the first texel of its breakpoint
  /// list, or 0 if it has no list.
  std::vector<int> ColorBends;
  std::vector<int> ExtinctionBends;
  std::vector<int> GradientOpacityBends;
  std::vector<int> TransmissionBends;
  /// Texels of the breakpoint lists, with four floats each. Empty if there are no lists.
  std::vector<float> Bends;
  /// For each column of the tables above, start and end of its edge; see TransferColumns::Edges.
  std::vector<std::array<float, 2>> ColorEdges;
  std::vector<std::array<float, 2>> ExtinctionEdges;
  std::vector<std::array<float, 2>> GradientOpacityEdges;
  std::vector<std::array<float, 2>> TransmissionEdges;
  /// Returns true if any column has an edge.
  bool HasEdges() const;

private:
  void BuildRow(vtkVolumeProperty* property, const VolumeSamples& samples, int row,
    vtkColorTransferFunction* transmission, const Scattering& scattering);
  void BuildGradientOpacity(vtkVolumeProperty* property);

  double GetExtinction(int row, double opacity) const;

  std::array<TransferNodes, 4> Opacities;
  std::array<double, 4> UnitDistance{ { 1.0, 1.0, 1.0, 1.0 } };
  std::array<double, 4> Weight{ { 1.0, 1.0, 1.0, 1.0 } };
  /// Offset of the component that defines the opacity. The rounding errors of texels are
  /// proportional to the difference from the offset.
  std::array<double, 4> Offset{};
};

}

#endif
