#ifndef vtkSpaceTimeStep_h
#define vtkSpaceTimeStep_h

#include "vtkBlanking.h"
#include "vtkDataArray.h"
#include "vtkExtractionBuffer.h"
#include "vtkExtractionContext.h"
#include "vtkSmartPointer.h"

#include <atomic>
#include <string>

class vtkUnstructuredGrid;

/**
 * @class   vtkSpaceTimeStep
 * @brief   one time step of one dataset, as an extraction between two of them needs it
 */
class vtkSpaceTimeStep : public vtkBlanking
{
public:
  /// Keeps the arrays of \a input, not the object; polyhedra are made cells that have tables.
  vtkSpaceTimeStep(vtkDataSet* input, vtkDataArray* scalars, double time);

  vtkDataSet* GetGrid() const { return this->Grid; }
  vtkDataArray* GetScalars() const { return this->Scalars; }
  double GetTime() const { return this->Time; }
  vtkIdType GetNumberOfPoints() const { return this->Grid->GetNumberOfPoints(); }
  vtkIdType GetNumberOfCells() const { return this->Grid->GetNumberOfCells(); }
  /// The points along each axis, or null for an unstructured grid.
  const int* GetDimensions() const { return this->HasRows ? this->Dimensions : nullptr; }
  vtkUnstructuredGrid* GetUnstructuredGrid() const;

  /// The cells before polyhedra were cut.
  vtkIdType GetNumberOfInputCells() const { return this->NumberOfInputCells; }

  /// The codes of all points; made at the first call, while progress goes from \a from to \a to.
  /// Returns false when the user aborted.
  bool MakeCodes(const vtkExtractionContext& context, double from, double to);
  const vtkExtractionValues::Code* GetCodes() const { return this->Codes.GetData(); }
  /// Whether a value equals a bound, once there are codes.
  bool HasTies() const { return this->Ties; }

  std::size_t GetBytes() const { return this->Codes.GetBytes(); }

  /// How the cells of two steps differ, in words, or nothing.
  std::string FindDifference(const vtkSpaceTimeStep& before) const;
  /// Whether the points of two steps are in the same places.
  bool HasSamePoints(const vtkSpaceTimeStep& other) const;

private:
  vtkSmartPointer<vtkDataSet> Grid;
  vtkSmartPointer<vtkDataArray> Scalars;
  double Time;
  vtkIdType NumberOfInputCells;
  bool HasRows;
  int Dimensions[3] = { 0, 0, 0 };
  vtkExtractionBuffer<vtkExtractionValues::Code> Codes;
  std::atomic<bool> Ties{ false };
};

#endif
