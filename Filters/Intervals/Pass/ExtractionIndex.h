// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_ExtractionIndex_h
#define interlume_ExtractionIndex_h

#include "vtkObject.h"
#include "vtkSmartPointer.h"

#include <array>
#include <map>
#include <vector>

class vtkDataArray;
class vtkDataSet;
class vtkUnstructuredGrid;

namespace interlume
{

class ExtractionValues;

/**
 * @class   ExtractionIndex
 * @brief   value ranges of blocks of cells, so that changed isovalues visit only cells near them
 *
 * Structured grids have blocks of 8 x 4 x 4 cells, other grids have runs of 16 cells. The index of
 * a dataset is made at its second extraction, since it costs one visit of all cells, and kept until
 * the dataset or the scalar changes. One object serves the leaves of a composite dataset. It also
 * keeps the linear counterpart of a grid of polyhedra.
 */
class ExtractionIndex : public vtkObject
{
public:
  static ExtractionIndex* New();
  vtkTypeMacro(ExtractionIndex, vtkObject);

  /// The columns [first, last) of a row of cells.
  using Span = std::array<vtkIdType, 2>;
  static constexpr vtkIdType RunLength = 16;

  /// A grid made of cells that have tables, and the input cell of each of its cells.
  struct LinearGrid
  {
    vtkSmartPointer<vtkUnstructuredGrid> Grid;
    std::vector<vtkIdType> CellIds;
    vtkIdType NumberOfConcave = 0;
    vtkMTimeType InputTime = 0;
    int LastUse = 0;
  };

  /// Returns the grid kept for \a input; without a grid when there is none or the input has
  /// changed.
  LinearGrid& GetLinearGrid(vtkDataSet* input);

  /// Forgets what the execution before the last did not use.
  void BeginExecution();

  /**
   * Makes ready the ranges of \a input. Returns false when this is the first extraction of that
   * scalar, or the scalar or the cells have changed since; then nothing may be asked. \a dimensions
   * is null for other than structured grids.
   */
  bool Select(vtkDataSet* input, vtkDataArray* scalars, const int* dimensions);

  /// Finds the blocks that touch an interval or value.
  void Activate(const ExtractionValues& values);

  ///@{
  /**
   * Tell which cells of a row may give output, after Activate, for structured grids; rows are as
   * in StructuredExtraction: j + k (nj - 1).
   */
  bool IsRowActive(vtkIdType cellRow) const;
  /// The share of rows of blocks.
  double GetActiveShare() const;
  void GetActiveSpans(vtkIdType cellRow, std::vector<Span>& spans) const;
  ///@}

  /// Returns whether cells RunLength * run ... may give output, after Activate, for other grids.
  bool IsRunActive(vtkIdType run) const { return this->Active[run] != 0; }

  /// Returns the bytes of all ranges held.
  std::size_t GetBytes() const;

protected:
  ExtractionIndex();
  ~ExtractionIndex() override;

private:
  ExtractionIndex(const ExtractionIndex&) = delete;
  void operator=(const ExtractionIndex&) = delete;

  struct Ranges
  {
    // The times of the data that the ranges were made from, which are unique in the process.
    vtkMTimeType ScalarTime = 0;
    vtkMTimeType CellTime = 0;
    std::array<vtkIdType, 3> Cells{ { 0, 0, 0 } };
    int LastUse = 0;
    std::vector<std::array<double, 2>> Blocks;
  };

  template <typename T>
  void BuildStructured(const T* scalars, Ranges& ranges) const;
  template <typename T>
  void BuildRuns(vtkDataSet* input, const T* scalars, Ranges& ranges) const;

  static constexpr vtkIdType BlockSize[3] = { 8, 4, 4 };

  std::map<vtkDataArray*, Ranges> Known;
  std::map<vtkDataSet*, LinearGrid> LinearGrids;
  int Execution = 0;
  Ranges* Selected = nullptr;
  std::array<vtkIdType, 3> Cells{ { 0, 0, 0 } };
  std::array<vtkIdType, 3> Blocks{ { 0, 0, 0 } };
  std::vector<unsigned char> Active;
  std::vector<unsigned char> ActiveRows;
};

}

#endif
