// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_StreamlineSharing_h
#define interlume_StreamlineSharing_h

#include "vtkType.h"

#include <array>
#include <functional>
#include <vector>

class vtkDataSet;

namespace interlume
{

/**
 * @class   StreamlineSharing
 * @brief   decides which samples of a regular grid can be interpolated from their neighbors
 *
 * Every fourth sample along each axis is advected first. Each of two further levels halves the
 * spacing. Each sample at a midpoint between known samples is either advected, or interpolated from
 * up to 4^3 known samples by cubic polynomials. A sample is interpolated if all its blocks of eight
 * known samples are good. A block is good if
 * - all samples used for interpolation in it reached one surface, neither u nor v crosses a seam
 *   between them, and the interpolated values lie on the surface,
 * - some of its corners are midpoints at the spacing of the previous level, and interpolation there
 *   had an error of at most four times the tolerance (halving the spacing reduces the error at
 *   least by a factor of four, even where second derivatives jump at faces of the field's cells),
 * - the sample at its center, where the polynomial's error is largest, is advected, and
 *   interpolation at the center has an error within the tolerance.
 *
 * Therefore the interpolation error is measured, and measuring it needs no additional streamlines:
 * each streamline is also the result of a sample.
 */
class StreamlineSharing
{
public:
  /// Results of all samples. The caller also stores the interpolated results here.
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
  /// Computes the error of interpolated values against the result of a sample with the same id, in
  /// units of the tolerance; infinite if it cannot be computed.
  using Measure = std::function<double(const SampleResult& guess, const double* uv, double time)>;
  /// Returns whether u and v are periodic on the surface with this id.
  using Seams = std::function<std::array<bool, 2>(int id)>;
  using Ids = std::vector<vtkIdType>;

  /// Gets the dimensions of samples on a regular grid. Returns false for other samples.
  static bool GetDimensions(vtkDataSet* samples, int dimensions[3]);

  StreamlineSharing(
    const int dimensions[3], const SampleResults& results, Measure measure, Seams seams);

  /// Returns the samples to advect first.
  Ids GetFirst() const;

  /// Starts the next level. Returns false after the last level.
  bool Next();
  /// Returns the samples of this level that must be advected in any case.
  Ids GetFollowed();
  /// Returns the samples to advect in addition, once the results of GetFollowed are known.
  Ids CheckCenters();
  /// Calls \a visit with the interpolated values of all samples of this level that were not
  /// advected.
  void VisitInterpolated(
    const std::function<void(vtkIdType id, const SampleResult& result)>& visit);

  ///@{
  /// Number of compared centers of good blocks, and their largest and mean interpolation error in
  /// units of the tolerance.
  vtkIdType GetNumberOfChecks() const { return this->Checks; }
  double GetLargestError() const { return this->LargestError; }
  double GetMeanError() const { return this->Checks > 0 ? this->SumOfErrors / this->Checks : 0.0; }
  ///@}

private:
  enum BlockMarks : unsigned char
  {
    NOT_GOOD = 0,
    /// The block was good until its center was compared.
    REFUTED = 1,
    GOOD = 2
  };
  using Index = std::array<int, 3>;

  vtkIdType GetId(const Index& at) const;
  Index GetBlock(std::size_t block) const;
  void SetStride(int stride);
  /// Interpolates a sample midway between samples with spacing \a stride. Returns false if
  /// interpolation is not allowed.
  bool Predict(const Index& at, int stride, SampleResult& result) const;
  /// Returns true if the known samples nearest to a midpoint reached one surface. Along an axis
  /// with several \a nodes, these are sample \a first and the next sample; otherwise only \a first.
  bool ReachOneSurface(const Index& first, const Index& nodes, int stride) const;
  /// Interpolates from \a nodes samples along each axis, beginning at \a first. Returns false if
  /// they did not reach one surface.
  bool Interpolate(const Index& first, const Index& nodes, const double* const weights[3],
    int stride, SampleResult& result) const;
  /// Returns the interpolation error of a sample with a known result, in units of the tolerance;
  /// infinite if the surface differs or interpolation is not allowed.
  double GetError(const Index& at, int stride) const;
  double GetError(const Index& at, const SampleResult& guess) const;
  bool IsAnyGood() const;
  /// Calls visit(at) for the midpoints of a block until visit returns false. Returns true if visit
  /// never returned false.
  template <typename Visit>
  bool VisitMidpoints(const Index& block, Visit&& visit) const;
  /// Calls visit(at) for all samples of this level.
  template <typename Visit>
  void VisitNew(Visit&& visit) const;
  /// Calls visit(block) for all blocks, in parallel.
  template <typename Visit>
  void VisitBlocks(Visit&& visit) const;
  /// Returns true if all blocks of a sample have at least this mark.
  bool IsInMarkedBlocks(const Index& at, unsigned char minimumMark) const;
  /// Returns the sample at the center of a block; IsCenter tests for such a sample.
  Index GetCenter(const Index& block) const;
  bool IsCenter(const Index& at) const;
  /// Returns true if interpolation at the previous level's spacing predicts some corners of a
  /// block, all of them within the allowed error.
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
