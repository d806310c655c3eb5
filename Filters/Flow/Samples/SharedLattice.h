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
 * The samples come in levels, those at every 2^k-th place of each axis first. At each level the
 * samples in the middles between those known are either followed, or interpolated from at most 4^3
 * of them by polynomials of degree three. A block of eight known samples is good where all samples
 * in the middles of the block twice as wide were followed, or it was good itself, and the
 * interpolation told them to within eight times the tolerance: in half the width the error falls by
 * as much. It is refused where one of the samples that are interpolated from reached no surface, or
 * another one, or where u or v jumps at a seam. The sample in the middle of each good block, where
 * the polynomial is off by most, is followed all the same: where that is more than the tolerance
 * the block is good no longer. So the error that the answers have is known by measurement.
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
  /// Returns the samples to be followed at this level.
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
  /// Computes the answer for a sample in the middle of known ones.
  bool Predict(const Index& at, Answer& answer) const;
  /// Returns the error in tolerances of the prediction for a sample that has an answer.
  double GetError(const Index& at) const;
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
  /// Finds the blocks of the next level that are good.
  void Prove();

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
