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
 * @brief   colour, extinction and gradient opacity by scalar, as textures have them
 *
 * A row is the functions of one component, sampled at Columns places, ends included, over that part
 * of the component's range in which the function changes, so that a value far beyond all others
 * does not make it coarse. What is beyond has the values of the ends. Where a function bends
 * between two columns, as at its points, steps and peaks, there is a list of bends (see
 * TransferColumns).
 *
 * Where all values of a component are equal, its range is from there on. A function without points
 * is a ramp over the range, colours from 0 to 1 and opacities from 0 to 0.5, as in VTK. Of
 * components that are not independent the functions, the unit distance and the gradient opacity are
 * those of index 0. Weights count for two and more independent components only, as in VTK.
 *
 * **Gradient opacity** is by the magnitude that vtkGPUVolumeRayCastMapper looks up: the length of
 * the gradient by central differences per unit of length of the image, times the mean of its three
 * spacings s,
 *   m = (sx + sy + sz) / 3 |((f(x + 1) - f(x - 1)) / (2 sx), ... y, ... z)|,
 * x counting voxels; so it is in units of the scalar, for cubic voxels its change from one to the
 * next. m beyond a quarter of the component's range counts as that quarter. f is the opacity's
 * component.
 */
class MaterialTable
{
public:
  static constexpr int Columns = TransferColumns::Columns;

  /// The meanings of a voxel's components.
  enum Kinds
  {
    /// Each component has its own functions, and a row; a single component is such.
    INDEPENDENT,
    /// The first component has a colour, the second an opacity.
    COLOR_OPACITY,
    /// There are RGB and a fourth component that has an opacity.
    RGB_OPACITY
  };

  /// Whether colours are shares of light that matter scatters, 0 to 1, and the function of these;
  /// null for the property's colours.
  struct Scattering
  {
    bool IsOn = false;
    vtkColorTransferFunction* Albedo = nullptr;
  };

  /**
   * Samples the functions of \a property. \a transmission may be null. Returns an error for three
   * components that are not independent, for transfer functions of two dimensions, for a unit
   * distance that is not above 0, and for a transmission or an albedo of several independent
   * components or of RGB.
   */
  Error Build(vtkVolumeProperty* property, const VolumeSamples& samples,
    vtkColorTransferFunction* transmission, const Scattering& scattering);
  Error Build(vtkVolumeProperty* property, const VolumeSamples& samples,
    vtkColorTransferFunction* transmission)
  {
    return this->Build(property, samples, transmission, Scattering());
  }

  /// Returns the largest extinction per world unit in [lower, upper] of \a row's opacity function.
  /// A bound within rounding of a point of the function, or within a thousandth of a column's
  /// width, counts as on it. 0 where lower > upper.
  double GetLargestExtinction(int row, double lower, double upper) const;

  /// Returns whether opacity changes by steps alone, within a thousandth of the scalar's range, in
  /// all rows and whatever the gradient.
  bool HasSharpOpacity() const;

  /// The smallest extinction above 0 per world unit that opacities of that kind have, 0 where all
  /// is transparent.
  double GetSmallestExtinction() const;

  /// The component that \a row's opacity is of.
  int GetOpacityComponent(int row) const
  {
    return this->Kind == INDEPENDENT ? row : this->Kind == COLOR_OPACITY ? 1 : 3;
  }

  Kinds Kind = INDEPENDENT;
  int Rows = 0;
  /// The range of the scalar that a row's opacity belongs to. The ends are never equal, and their
  /// difference is finite.
  std::array<std::array<double, 2>, 4> ScalarRange{};
  /// The scalars of the first and last column of a row for the colour (and the transmission), and
  /// for the opacity. They are never equal, and their difference is finite.
  std::array<std::array<double, 2>, 4> ColorRange{};
  std::array<std::array<double, 2>, 4> OpacityRange{};
  /// Red, green, blue, and extinction per world unit (-ln(1 - opacity) / unit distance, at most
  /// LargestOpticalDepth / unit distance), times the component's weight. White for RGB_OPACITY.
  std::vector<float> Colors;
  static constexpr double LargestOpticalDepth = 69.0;
  /// Gradient opacity over the magnitude m, 0 to GradientRange[row], a quarter of the range or the
  /// function's last point where that is before; 1 for rows without such a function or with
  /// DisableGradientOpacity, empty where all are 1.
  std::vector<float> GradientOpacity;
  std::array<double, 4> GradientRange{ { 1.0, 1.0, 1.0, 1.0 } };
  /// The RGB of light let through, by row 0's colour range; empty without it.
  std::vector<float> Transmission;
  /// The lists: for each column of the tables above the first texel of its list in Bends, or 0.
  std::vector<int> ColorBends;
  std::vector<int> ExtinctionBends;
  std::vector<int> GradientOpacityBends;
  std::vector<int> TransmissionBends;
  /// Texels of four floats; empty where no function has a list.
  std::vector<float> Bends;
  /// The edges: for each column of the tables where its edge begins and ends.
  std::vector<std::array<float, 2>> ColorEdges;
  std::vector<std::array<float, 2>> ExtinctionEdges;
  std::vector<std::array<float, 2>> GradientOpacityEdges;
  std::vector<std::array<float, 2>> TransmissionEdges;
  /// Returns whether any column has an edge.
  bool HasEdges() const;

private:
  void BuildRow(vtkVolumeProperty* property, const VolumeSamples& samples, int row,
    vtkColorTransferFunction* transmission, const Scattering& scattering);
  void BuildGradientOpacity(vtkVolumeProperty* property);

  double GetExtinction(int row, double opacity) const;

  std::array<TransferNodes, 4> Opacities;
  std::array<double, 4> UnitDistance{ { 1.0, 1.0, 1.0, 1.0 } };
  std::array<double, 4> Weight{ { 1.0, 1.0, 1.0, 1.0 } };
  /// The offset of the opacity's component, which texels are rounded relative to.
  std::array<double, 4> Offset{};
};

}

#endif
