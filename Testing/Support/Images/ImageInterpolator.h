// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReferenceImage_h
#define ReferenceImage_h

#include <algorithm> // for min and max
#include <array>     // for points
#include <cmath>
#include <limits>
#include <string> // for array names
#include <vector> // for the values

class vtkImageData;
class vtkMatrix4x4;

namespace reference
{

using Double3 = std::array<double, 3>;

/**
 * Selects the array of an image.
 */
struct ImageArray
{
  /// Name of the scalars. If empty, the active scalars are used.
  std::string Name;
  /// Whether the scalars are cell data, with samples at the cell centers.
  bool OfCells = false;
};

/**
 * A line in index coordinates: Begin + t Step, where t is the distance in world units.
 */
struct IndexLine
{
  Double3 Begin;
  Double3 Step;

  Double3 At(double t) const
  {
    return { { this->Begin[0] + t * this->Step[0], this->Begin[1] + t * this->Step[1],
      this->Begin[2] + t * this->Step[2] } };
  }
};

/**
 * @class   ImageInterpolator
 * @brief   trilinear interpolation of an image in double precision
 *
 * The domain ends at the outermost samples. Index (0, 0, 0) is the first sample, independent of the
 * extent.
 */
class ImageInterpolator
{
public:
  struct Sample
  {
    std::array<double, 4> Values{};
    /// Total interpolation weight of the finite samples. Values are their weighted mean.
    double Finite = 1.0;
  };

  /// \a worldFromVolume may be null for the identity. Throws std::invalid_argument if the array is
  /// missing or has more than four components.
  ImageInterpolator(vtkImageData* image, const ImageArray& array, vtkMatrix4x4* worldFromVolume);

  int GetNumberOfComponents() const { return this->Components; }
  /// Returns the factor that scales color values to [0, 1]: 1/255 for unsigned char, otherwise 1.
  double GetColorScale() const { return this->ColorScale; }

  IndexLine ToIndex(const Double3& world, const Double3& direction) const;
  Double3 ToVolume(const Double3& index) const;

  Sample At(const Double3& index) const;
  /// Returns the gradient of a component in world space, by central differences over one sample to
  /// each side. Outside the domain, values are those of the nearest point of the domain.
  Double3 GetGradient(const Double3& index, int component) const;

  /// Returns the argument of the gradient opacity function, as in vtkGPUVolumeRayCastMapper: the
  /// length of the gradient times the mean spacing, but at most a quarter of the component's range.
  double GetMagnitude(const Double3& index, int component) const;

  /// Clips the interval [begin, end] of a line to the domain. Returns false if the result is empty.
  bool Cut(const IndexLine& line, double& begin, double& end) const;

  /**
   * Splits [begin, end] at sample planes and at the positions \a cuts. Calls piece(a, b) for each
   * part, in order, until it returns false.
   */
  template <typename Piece>
  static void Walk(const IndexLine& line, double begin, double end, const std::vector<double>& cuts,
    const Piece& piece);

private:
  double GetSlope(const Double3& index, int component, int axis) const;
  Sample Interpolate(const std::array<std::size_t, 8>& corners, const Double3& fraction) const;
  Sample InterpolateFinite(
    const std::array<std::size_t, 8>& corners, const Double3& fraction) const;

  std::array<int, 3> Size{ { 0, 0, 0 } };
  int Components = 0;
  double ColorScale = 1.0;
  Double3 Spacing{ { 1.0, 1.0, 1.0 } };
  std::array<double, 4> Range{}; ///< range of the finite values of each component
  std::vector<double> Values;
  std::vector<unsigned char> Finite; ///< empty if all values are finite
  std::array<double, 16> IndexFromWorld{};
  std::array<double, 16> VolumeFromIndex{};
};

template <typename Piece>
void ImageInterpolator::Walk(const IndexLine& line, double begin, double end,
  const std::vector<double>& cuts, const Piece& piece)
{
  constexpr double never = std::numeric_limits<double>::infinity();
  Double3 next;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double step = line.Step[axis];
    const double at = line.Begin[axis] + begin * step;
    const double plane = step > 0.0 ? std::floor(at) + 1.0 : std::ceil(at) - 1.0;
    next[axis] = step == 0.0 ? never : (plane - line.Begin[axis]) / step;
  }
  const double shortest = 1e-12 * (end - begin);
  for (double a = begin; a < end;)
  {
    double b = std::min({ end, next[0], next[1], next[2] });
    for (double cut : cuts)
    {
      b = cut > a && cut < b ? cut : b;
    }
    if (b - a > shortest && !piece(a, b))
    {
      return;
    }
    for (int axis = 0; axis < 3; ++axis)
    {
      next[axis] += next[axis] <= b ? 1.0 / std::abs(line.Step[axis]) : 0.0;
    }
    a = b;
  }
}

}

#endif
