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
 * @brief   one time step of a dataset, prepared for the extraction between two steps
 */
class TimeStep : public Blanking
{
public:
  /// References the arrays of \a input, or copies them if \a isCopied is true. Polyhedra are
  /// replaced by cells that have case tables.
  TimeStep(vtkDataSet* input, vtkDataArray* scalars, double time, bool isCopied);

  vtkDataSet* GetGrid() const { return this->Grid; }
  vtkDataArray* GetScalars() const { return this->Scalars; }
  double GetTime() const { return this->Time; }
  vtkIdType GetNumberOfPoints() const { return this->Grid->GetNumberOfPoints(); }
  vtkIdType GetNumberOfCells() const { return this->Grid->GetNumberOfCells(); }
  /// Returns the number of points along each axis, or null for an unstructured grid.
  const int* GetDimensions() const { return this->HasRows ? this->Dimensions : nullptr; }
  vtkUnstructuredGrid* GetUnstructuredGrid() const;

  /// Returns the number of cells before polyhedra were split.
  vtkIdType GetNumberOfInputCells() const { return this->NumberOfInputCells; }
  /// Returns the number of polyhedra that were split into overlapping parts.
  vtkIdType GetNumberOfConcave() const { return this->NumberOfConcave; }

  /// Returns a warning about skipped cells with non-finite coordinates, or an empty string. \a
  /// input must be the original dataset of the step.
  std::string DescribeNonFinite(vtkDataSet* input) const { return this->NonFinite.Describe(input); }

  /// Computes the codes of all points on the first call, and reports progress between \a from and
  /// \a to. Returns false if the user aborted.
  bool MakeCodes(const ExtractionContext& context, double from, double to);
  const ExtractionValues::Code* GetCodes() const { return this->Codes.GetData(); }
  /// Returns true if any value equals a bound of an interval. Call MakeCodes() first.
  bool HasTies() const { return this->Ties; }

  std::size_t GetBytes() const { return this->Codes.GetBytes(); }

  /**
   * Returns true if \a next was written over this step: its scalars use memory of this step, or its
   * points or another array use memory of this step and were modified since.
   */
  bool IsOverwritten(vtkDataSet* next, vtkDataArray* scalars) const;

  /// Returns an error if the cells differ from those of the previous step.
  Error FindDifference(const TimeStep& before) const;
  /// Returns true if both steps have the same points.
  bool HasSamePoints(const TimeStep& other) const;

private:
  // An array of the input and its modification time. Holding a reference ensures that its memory is
  // not reused.
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
  // The arrays of the input, or empty if the step is a copy.
  std::vector<Source> Sources;
};

}

#endif
