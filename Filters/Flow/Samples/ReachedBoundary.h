// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_ReachedBoundary_h
#define interlume_ReachedBoundary_h

#include "Advection/AdvectionOptions.h"
#include "Samples/FarSideCorners.h"
#include "Streams/StageContext.h"

#include "vtkType.h"

#include <vector>

class vtkDataSet;

namespace interlume
{

class ImplicitFlowArrays;
class SampleArrays;

/**
 * @class   ReachedBoundary
 * @brief   locates the boundary of the reached region, between samples that reach a surface and
 * samples that do not
 *
 * For each pair of such samples in a cell, bisection finds the last position between them whose
 * streamline reaches the same surface. Then each sample gets a distance from the boundary. The
 * ratios of the distances are fitted to the positions found. Samples that do not reach the surface
 * get linearly extrapolated values.
 */
class ReachedBoundary
{
public:
  struct SampleResult
  {
    vtkIdType Sample = -1;
    bool IsReached = false;
    double Distance = 0.0;
    /// Extrapolated values; not set for samples that reach the surface.
    AdvectionResult FarSide;
  };

  /// The arguments must outlive this object and not change. No progress is reported.
  ReachedBoundary(
    const StageContext& context, vtkDataSet* samples, const ImplicitFlowArrays& arrays)
    : Context(context)
    , Samples(samples)
    , Arrays(arrays)
  {
  }

  /// Computes \a sampleResults for all samples in \a pairs, sorted by sample, from the advection
  /// results in \a results. Collective if the field is distributed. Returns false if the execution
  /// was aborted.
  bool Find(const std::vector<FarSideCorners::Pair>& pairs, const SampleArrays& results,
    std::vector<SampleResult>& sampleResults);

private:
  /// Line between the two samples of a pair. Reached and Other are indices into SampleResults.
  /// First and Last are the fractions of the line that bracket the boundary.
  struct Line
  {
    std::size_t Reached;
    std::size_t Other;
    int Id;
    double First = 0.0;
    double Last = 1.0;
    /// Advection result at First; the result of the sample itself if First is 0.
    AdvectionResult Result;

    /// Returns the fraction at which the boundary lies, strictly between 0 and 1.
    double GetFraction() const { return 0.5 * (this->First + this->Last); }
  };
  using SampleResults = std::vector<SampleResult>;

  /// Computes the position at a fraction of a line. Returns the length of the line.
  double GetPosition(
    const SampleResults& sampleResults, const Line& line, double fraction, double x[3]) const;
  bool Bisect(const SampleResults& sampleResults);
  void SetDistances(SampleResults& sampleResults) const;
  void Extrapolate(const SampleArrays& results, SampleResults& sampleResults) const;

  const StageContext& Context;
  vtkDataSet* Samples;
  const ImplicitFlowArrays& Arrays;
  std::vector<Line> Lines;
};

}

#endif
