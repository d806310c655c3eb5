// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_TimeStep_h
#define interlume_TimeStep_h

#include "Common/Blanking.h"
#include "Common/Error.h"
#include "Output/ExtractionBuffer.h"
#include "Pass/ExtractionContext.h"
#include "Pass/NonFinitePoints.h"

#include "vtkDataArray.h"
#include "vtkSmartPointer.h"

#include <atomic>
#include <string>
#include <vector>

class vtkUnstructuredGrid;

namespace interlume
{

/**
 * @class   TimeStep
 * @brief   one time step of one dataset, as an extraction between two of them needs it
 */
class TimeStep : public Blanking
{
public:
  /// Keeps the arrays of \a input, not the object, or copies of them where \a isCopied; polyhedra
  /// are made cells that have tables.
  TimeStep(vtkDataSet* input, vtkDataArray* scalars, double time, bool isCopied);

  vtkDataSet* GetGrid() const { return this->Grid; }
  vtkDataArray* GetScalars() const { return this->Scalars; }
  double GetTime() const { return this->Time; }
  vtkIdType GetNumberOfPoints() const { return this->Grid->GetNumberOfPoints(); }
  vtkIdType GetNumberOfCells() const { return this->Grid->GetNumberOfCells(); }
  /// Returns the points along each axis, or null for an unstructured grid.
  const int* GetDimensions() const { return this->HasRows ? this->Dimensions : nullptr; }
  vtkUnstructuredGrid* GetUnstructuredGrid() const;

  /// Returns the number of cells before polyhedra were cut.
  vtkIdType GetNumberOfInputCells() const { return this->NumberOfInputCells; }
  /// Returns how many of these cells are polyhedra that are cut into parts that overlap.
  vtkIdType GetNumberOfConcave() const { return this->NumberOfConcave; }

  /// Returns a warning about the cells of \a input, the step as it was given, that are skipped
  /// because of their coordinates, or an empty string.
  std::string DescribeNonFinite(vtkDataSet* input) const { return this->NonFinite.Describe(input); }

  /// Makes the codes of all points at the first call, while progress goes from \a from to \a to.
  /// Returns false when the user aborted.
  bool MakeCodes(const ExtractionContext& context, double from, double to);
  const ExtractionValues::Code* GetCodes() const { return this->Codes.GetData(); }
  /// Returns whether a value equals a bound, once there are codes.
  bool HasTies() const { return this->Ties; }

  std::size_t GetBytes() const { return this->Codes.GetBytes(); }

  /**
   * Returns whether the next step has been written over this one: its scalars are in the same
   * memory, or its points or another array are and have changed since.
   */
  bool IsOverwritten(vtkDataSet* next, vtkDataArray* scalars) const;

  /// Returns an error if the cells of two steps differ.
  Error FindDifference(const TimeStep& before) const;
  /// Returns whether the points of two steps are in the same places.
  bool HasSamePoints(const TimeStep& other) const;

private:
  // An array that the step was read from, held so that its memory is not another's, and when it had
  // changed last.
  struct Source
  {
    vtkSmartPointer<vtkDataArray> Array;
    vtkMTimeType Time;
  };

  vtkSmartPointer<vtkDataSet> Grid;
  vtkSmartPointer<vtkDataArray> Scalars;
  double Time;
  vtkIdType NumberOfInputCells;
  vtkIdType NumberOfConcave = 0;
  bool HasRows;
  int Dimensions[3] = { 0, 0, 0 };
  NonFinitePoints NonFinite;
  ExtractionBuffer<ExtractionValues::Code> Codes;
  std::atomic<bool> Ties{ false };
  // The arrays that the step was read from; empty where the step is a copy.
  std::vector<Source> Sources;
};

}

#endif
