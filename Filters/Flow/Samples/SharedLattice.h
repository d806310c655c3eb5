// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_SharedLattice_h
#define interlume_SharedLattice_h

#include "vtkType.h"

#include <array>
#include <functional>
#include <vector>

class vtkDataSet;

namespace interlume
{

/**
 * @class   SharedLattice
 * @brief   which samples of a lattice take the answers that those around them have
 *
 * The samples at every 4th place of each axis are followed first. Two levels halve that distance:
 * the samples in the middles between those known are either followed, or interpolated from at most
 * 4^3 of them by polynomials of degree three. Three things have to be so in a block of eight known
 * samples that is good:
 * - All samples that its own ones are interpolated from reached one surface, neither u nor v jumps
 *   at a seam between them, and what is interpolated lies on the surface.
 * - Some of its corners lie in the middles between samples twice as far apart, and these tell them
 *   to within four times the tolerance. In half the width the error falls by that at least, where
 *   second derivatives jump, as they do where streamlines pass faces of the field's cells.
 * - The sample in its middle, where the polynomial is off by most, is followed all the same, and
 * the polynomial tells it to within the tolerance. A sample is interpolated where all blocks that
 * it lies in are good. So the error that the answers have is known by measurement, and no
 * streamline is followed that is not some sample's answer.
 */
class SharedLattice
{
public:
  /// The answers of all samples, to which Share adds.
  struct Answers
  {
    const unsigned char* Status;
    const int* Id;
    const double* Parameters;
    const double* Time;
  };
  /// What is interpolated.
  struct Answer
  {
    int Id = -1;
    double Parameters[2] = { 0.0, 0.0 };
    double Time = 0.0;
  };
  /// Computes the error of an answer in tolerances, against the one with the same id that a sample
  /// has; infinite where there is none.
  using Measure = std::function<double(const Answer& guess, const double* uv, double time)>;
  /// Returns whether u and v are periodic on the surface with this id.
  using Seams = std::function<std::array<bool, 2>(int id)>;
  using Ids = std::vector<vtkIdType>;

  /// Gets the numbers of points of samples that are a lattice. Returns false for others.
  static bool GetDimensions(vtkDataSet* samples, int dimensions[3]);

  SharedLattice(const int dimensions[3], const Answers& answers, Measure measure, Seams seams);

  /// Returns the samples that are followed first.
  Ids GetFirst() const;

  /// Goes to the next level. Returns false after the last.
  bool Next();
  /// Returns the samples to be followed at this level whatever the middles of blocks say.
  Ids GetFollowed();
  /// Returns those to be followed too, after the others were.
  Ids CheckMiddles();
  /// Calls visit(id, answer) for all other samples of this level.
  void Share(const std::function<void(vtkIdType id, const Answer& answer)>& visit);

  ///@{
  /// The number of middles of good blocks that were compared, and the largest and the mean error of
  /// interpolation there, in tolerances.
  vtkIdType GetNumberOfChecks() const { return this->Checks; }
  double GetLargestError() const { return this->LargestError; }
  double GetMeanError() const { return this->Checks > 0 ? this->SumOfErrors / this->Checks : 0.0; }
  ///@}

private:
  enum BlockMarks : unsigned char
  {
    NOT_GOOD = 0,
    /// It was good until its middle was compared.
    REFUTED = 1,
    GOOD = 2
  };
  using Index = std::array<int, 3>;

  vtkIdType GetId(const Index& at) const;
  Index GetBlock(std::size_t block) const;
  void SetStride(int stride);
  /// Computes the answer for a sample in the middle of some that are \a stride apart. Returns false
  /// where that is refused.
  bool Predict(const Index& at, int stride, Answer& answer) const;
  /// Returns whether the samples next to one in their middle, from \a first to the next along each
  /// axis with several \a nodes, reached one surface.
  bool IsOneSurface(const Index& first, const Index& nodes, int stride) const;
  /// Interpolates from \a nodes samples of each axis from \a first on. Returns false where these
  /// have no answers of one surface.
  bool Interpolate(const Index& first, const Index& nodes, const double* const weights[3],
    int stride, Answer& answer) const;
  /// Returns the error in tolerances of a prediction for a sample that has an answer; infinite
  /// where it has another surface, or is not told.
  double GetError(const Index& at, int stride) const;
  double GetError(const Index& at, const Answer& guess) const;
  bool IsAnyGood() const;
  /// Calls visit(at) for the middles of a block until it returns false. Returns whether it did not.
  template <typename Visit>
  bool VisitMiddles(const Index& block, Visit&& visit) const;
  /// Calls visit(at) for all samples of this level.
  template <typename Visit>
  void VisitNew(Visit&& visit) const;
  /// Calls visit(block) for all blocks, by threads.
  template <typename Visit>
  void VisitBlocks(Visit&& visit) const;
  /// Returns whether a sample lies in blocks alone that are marked at least so.
  bool IsShared(const Index& at, unsigned char least) const;
  /// Returns the sample in the middle of a block, and whether one is.
  Index GetMiddle(const Index& block) const;
  bool IsMiddle(const Index& at) const;
  /// Returns whether samples twice as far apart tell corners of a block, and none of them falsely.
  bool IsProven(const Index& block) const;

  Index Dimensions;
  Answers Known;
  Measure Compare;
  Seams FindSeams;
  /// The distance of known samples of the first and of this level, and the blocks between these.
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
