// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_StreamlineInterpolation_h
#define interlume_StreamlineInterpolation_h

#include "vtkType.h"

#include <array>
#include <functional>
#include <vector>

class vtkDataSet;

namespace interlume
{

/**
 * @class   StreamlineInterpolation
 * @brief   decides which samples of a regular grid can be interpolated from their neighbors
 *
 * At first, every fourth sample along each axis is advected. Each of two further levels halves the
 * spacing. Each sample at a midpoint between known samples is either advected, or interpolated from
 * up to 4^3 known samples by cubic polynomials. Eight known samples are the corners of a block. A
 * sample is interpolated if all blocks that contain it are good. A block is good if
 * - all samples used for interpolation in it reached the same surface, neither u nor v crosses a
 *   seam between them, and the interpolated values lie on the surface,
 * - some of its corners are midpoints at the spacing of the previous level, and interpolation there
 *   had an error of at most four times the tolerance (halving the spacing reduces the error at
 *   least by a factor of four, even where second derivatives jump at faces of the field's cells),
 * - interpolation at its center, where the polynomial's error is largest, has an error within the
 *   tolerance. The sample at the center is always advected.
 *
 * Measuring the error needs no additional streamlines, since each streamline is also the result of
 * a sample.
 */
class StreamlineInterpolation
{
public:
  /// Arrays with the results of all samples. The caller also stores interpolated results in them.
  struct SampleResults
  {
    const unsigned char* Status;
    const int* Id;
    const double* Parameters;
    const double* Time;
  };
  /// Interpolated values.
  struct SampleResult
  {
    int Id = -1;
    double Parameters[2] = { 0.0, 0.0 };
    double Time = 0.0;
  };
  /// Computes the error of interpolated values, in units of the tolerance. \a uv and \a time are
  /// the result of advection, on the same surface. The error is infinite if it cannot be computed.
  using Measure = std::function<double(const SampleResult& guess, const double* uv, double time)>;
  /// Returns whether u and v are periodic on the surface with this id.
  using Seams = std::function<std::array<bool, 2>(int id)>;
  using Ids = std::vector<vtkIdType>;

  /// Gets the dimensions of the grid of samples. Returns false if the grid is not structured.
  static bool GetDimensions(vtkDataSet* samples, int dimensions[3]);

  StreamlineInterpolation(
    const int dimensions[3], const SampleResults& results, Measure measure, Seams seams);

  /// Returns the samples to advect first.
  Ids GetFirst() const;

  /// Starts the next level. Returns false after the last level.
  bool Next();
  /// Returns the samples of this level that must be advected in any case.
  Ids GetSamplesToAdvect();
  /// Returns the samples to advect in addition, once the results of GetFollowed are known.
  Ids CheckCenters();
  /// Calls \a visit with the interpolated values of all samples of this level that were not
  /// advected.
  void VisitInterpolated(
    const std::function<void(vtkIdType id, const SampleResult& result)>& visit);

  ///@{
  /// Number of good blocks, and the largest and mean interpolation error at their centers in units
  /// of the tolerance.
  vtkIdType GetNumberOfChecks() const { return this->Checks; }
  double GetLargestError() const { return this->LargestError; }
  double GetMeanError() const { return this->Checks > 0 ? this->SumOfErrors / this->Checks : 0.0; }
  ///@}

private:
  enum BlockMarks : unsigned char
  {
    NOT_GOOD = 0,
    /// Good except for the interpolation error at the center.
    REFUTED = 1,
    GOOD = 2
  };
  using Index = std::array<int, 3>;

  vtkIdType GetId(const Index& at) const;
  Index GetBlock(std::size_t block) const;
  void SetStride(int stride);
  /// Interpolates a sample midway between known samples with spacing \a stride. Returns false if
  /// interpolation is not allowed.
  bool Predict(const Index& at, int stride, SampleResult& result) const;
  /// Returns true if the known samples nearest to a midpoint reached the same surface: \a first
  /// and, along each axis with more than one node, the next sample.
  bool ReachSameSurface(const Index& first, const Index& nodes, int stride) const;
  /// Interpolates from \a nodes samples along each axis, beginning at \a first. Returns false if
  /// they did not reach the same surface, if they are on both sides of a seam, or if the result is
  /// not on the surface.
  bool Interpolate(const Index& first, const Index& nodes, const double* const weights[3],
    int stride, SampleResult& result) const;
  /// Returns the interpolation error at an advected sample, in units of the tolerance; infinite if
  /// the surface differs or interpolation is not allowed.
  double GetError(const Index& at, int stride) const;
  double GetError(const Index& at, const SampleResult& guess) const;
  bool HasGoodBlock() const;
  /// Calls visit(at) for the midpoints of a block. If visit returns false, stops and returns false.
  template <typename Visit>
  bool VisitMidpoints(const Index& block, Visit&& visit) const;
  /// Calls visit(at) for all samples that this level adds.
  template <typename Visit>
  void VisitNewSamples(Visit&& visit) const;
  /// Calls visit(block) for all blocks, in parallel.
  template <typename Visit>
  void VisitBlocks(Visit&& visit) const;
  /// Returns true if all blocks that contain a sample have at least the given mark.
  bool IsInMarkedBlocks(const Index& at, unsigned char minimumMark) const;
  /// Returns the sample at the center of a block. IsCenter returns true for such a sample.
  Index GetCenter(const Index& block) const;
  bool IsCenter(const Index& at) const;
  /// Returns true if interpolation at the previous level's spacing predicts at least one corner of
  /// a block, and all predicted corners are within the allowed error.
  bool IsVerified(const Index& block) const;

  Index Dimensions;
  SampleResults Known;
  Measure Compare;
  Seams FindSeams;
  /// Spacing of known samples at the first and the current level, and number of blocks per axis.
  int First = 1;
  int Stride = 0;
  Index Blocks{};
  std::vector<unsigned char> Marks;
  vtkIdType Checks = 0;
  double LargestError = 0.0;
  double SumOfErrors = 0.0;
};

}

#endif
