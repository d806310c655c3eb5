// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_ReachedBoundary_h
#define interlume_ReachedBoundary_h

#include "Advection/AdvectionOptions.h"
#include "Samples/BeyondCorners.h"
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
 * @brief   locates the boundary between samples that reach a surface and samples that do not
 *
 * For each pair of such corners of a cell, bisection by streamlines finds the last position on the
 * line between them that reaches the surface as well. Each sample gets a distance. The ratios of
 * the distances of pairs are those of the positions, as far as one distance for each sample allows.
 * Samples that do not reach the surface get values that are extrapolated linearly.
 */
class ReachedBoundary
{
public:
  struct Answer
  {
    vtkIdType Sample = -1;
    bool IsReached = false;
    double Distance = 0.0;
    /// The extrapolated values; for samples that reach the surface, no result.
    AdvectionResult Beyond;
  };

  /// The arguments must not change while this is used. The progress stays the same.
  ReachedBoundary(
    const StageContext& context, vtkDataSet* samples, const ImplicitFlowArrays& arrays)
    : Context(context)
    , Samples(samples)
    , Arrays(arrays)
  {
  }

  /// Computes the answers of all samples of the pairs, ascending by sample, whose \a results are
  /// known. If processes have parts of the field, all of them call this. Returns false if the
  /// execution was aborted.
  bool Find(const std::vector<BeyondCorners::Pair>& pairs, const SampleArrays& results,
    std::vector<Answer>& answers);

private:
  /// A pair, as numbers of answers, and the fractions of its line between which the boundary is.
  struct Line
  {
    std::size_t Reached;
    std::size_t Other;
    int Id;
    double First = 0.0;
    double Last = 1.0;
    /// The result at First; that of the sample itself if First is 0.
    AdvectionResult Result;

    /// Returns the fraction of the boundary, which is neither 0 nor 1.
    double GetFraction() const { return 0.5 * (this->First + this->Last); }
  };
  using Answers = std::vector<Answer>;

  /// Computes the position at a fraction of a line. Returns the length of the line.
  double GetPosition(const Answers& answers, const Line& line, double fraction, double x[3]) const;
  bool Bisect(const Answers& answers);
  void SetDistances(Answers& answers) const;
  void Extrapolate(const SampleArrays& results, Answers& answers) const;

  const StageContext& Context;
  vtkDataSet* Samples;
  const ImplicitFlowArrays& Arrays;
  std::vector<Line> Lines;
};

}

#endif
