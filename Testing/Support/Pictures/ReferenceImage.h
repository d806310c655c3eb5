// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReferenceImage_h
#define ReferenceImage_h

#include <algorithm> // for the walk
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
 * Which values of an image make a volume.
 */
struct ImageArray
{
  /// Name of the scalars; the active ones where it is empty.
  std::string Name;
  /// Whether they are of cells: a sample is at a cell's centre.
  bool OfCells = false;
};

/**
 * A line in the indices of samples: Begin + t Step, t the distance in world units.
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
 * @class   ReferenceImage
 * @brief   the values of an image between its samples, in double
 *
 * Trilinear between the centres of the samples, in a box that ends at the centres of the outer
 * ones. Index 0, 0, 0 is the first sample, whatever the extent.
 */
class ReferenceImage
{
public:
  struct Sample
  {
    std::array<double, 4> Values{};
    /// The interpolation weight of the samples that are finite: Values are the mean of those.
    double Finite = 1.0;
  };

  /// \a worldFromVolume may be null: the identity. std::invalid_argument for an array that is
  /// missing or has more than four components.
  ReferenceImage(vtkImageData* image, const ImageArray& array, vtkMatrix4x4* worldFromVolume);

  int GetNumberOfComponents() const { return this->Components; }
  /// What direct colours are multiplied with: 1/255 for unsigned char, else 1.
  double GetColorScale() const { return this->ColorScale; }

  IndexLine ToIndex(const Double3& world, const Double3& direction) const;
  Double3 ToVolume(const Double3& index) const;

  Sample At(const Double3& index) const;
  /// Of a component per world unit, by central differences one sample to each side; outside of the
  /// box the values at its border go on.
  Double3 GetGradient(const Double3& index, int component) const;

  /// What gradient opacity is a function of, as in vtkGPUVolumeRayCastMapper: the length of the
  /// gradient per unit of the image's spacing, times the mean of its three spacings, at most a
  /// quarter of the component's range.
  double GetMagnitude(const Double3& index, int component) const;

  /// Reduces [begin, end] to where the line is in the box; false where nothing is left.
  bool Cut(const IndexLine& line, double& begin, double& end) const;

  /**
   * Calls piece(a, b) for the parts of [begin, end] in which neither a plane of samples nor one of
   * \a cuts lies, in order, until it returns false.
   */
  template <typename Piece>
  static void Walk(const IndexLine& line, double begin, double end, const std::vector<double>& cuts,
    const Piece& piece);

private:
  double GetSlope(const Double3& index, int component, int axis) const;
  Sample Interpolate(const std::array<std::size_t, 8>& corners, const Double3& share) const;
  Sample InterpolateFinite(const std::array<std::size_t, 8>& corners, const Double3& share) const;

  std::array<int, 3> Size{ { 0, 0, 0 } };
  int Components = 0;
  double ColorScale = 1.0;
  Double3 Spacing{ { 1.0, 1.0, 1.0 } };
  std::array<double, 4> Range{}; ///< largest less smallest finite value of each component
  std::vector<double> Values;
  std::vector<unsigned char> Finite; ///< empty where all are
  std::array<double, 16> IndexFromWorld{};
  std::array<double, 16> VolumeFromIndex{};
};

template <typename Piece>
void ReferenceImage::Walk(const IndexLine& line, double begin, double end,
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
