// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_ExtractionIndex_h
#define interlume_ExtractionIndex_h

#include "Common/CellArrayConversion.h"

#include "vtkObject.h"
#include "vtkSmartPointer.h"

#include <array>
#include <map>
#include <utility>
#include <vector>

class vtkDataArray;
class vtkDataSet;
class vtkUnstructuredGrid;

namespace interlume
{

class ExtractionValues;

/**
 * @class   ExtractionIndex
 * @brief   value ranges of blocks of cells, used to skip blocks that no isovalue intersects
 *
 * Blocks have 8 x 4 x 4 cells in structured grids and 16 successive cells in other grids. The index
 * of a dataset is built at its second extraction, since building it visits all cells. It is cached
 * until the dataset or the scalar array changes. One object serves all leaves of a composite
 * dataset. It also caches the grids that replace grids with polyhedra (see ExtractionLinearizer),
 * two-dimensional cells (see SurfaceCells), coarse grids for previews (see GridSampling), and
 * converted cell arrays.
 */
class ExtractionIndex : public vtkObject
{
public:
  static ExtractionIndex* New();
  vtkTypeMacro(ExtractionIndex, vtkObject);

  /// A range of columns [first, last) in a row of cells.
  using Span = std::array<vtkIdType, 2>;
  static constexpr vtkIdType RunLength = 16;

  /// A grid whose cells all have isotables, and the input cell of each of its cells. See
  /// ExtractionLinearizer and SurfaceCells for the numbers of cells.
  struct LinearGrid
  {
    vtkSmartPointer<vtkUnstructuredGrid> Grid;
    std::vector<vtkIdType> CellIds;
    vtkIdType NumberOfConcave = 0;
    vtkIdType NumberOfFolded = 0;
    vtkIdType NumberOfHigherOrder = 0;
    vtkIdType NumberOfLowerDimensional = 0;
    vtkMTimeType InputTime = 0;
    bool IsUsed = false;
  };

  /// Returns the cache entry of \a input for cells of the given dimension, 2 or 3. Its Grid is null
  /// if no grid is cached or the input has changed.
  LinearGrid& GetLinearGrid(vtkDataSet* input, int dimension)
  {
    return this->GetEntry(dimension == 2 ? this->SurfaceGrids : this->LinearGrids, input);
  }

  /// A coarse copy of a structured grid.
  struct CoarseGrid
  {
    vtkSmartPointer<vtkDataSet> Grid;
    int Stride = 0;
    vtkMTimeType InputTime = 0;
    bool IsUsed = false;
  };

  /// Returns the cache entry of \a input, as GetLinearGrid().
  CoarseGrid& GetCoarseGrid(vtkDataSet* input) { return this->GetEntry(this->CoarseGrids, input); }

  /// Returns the cache of converted cell arrays.
  CellArrayConversion::Cache& GetConvertedArrays() { return this->ConvertedArrays; }

  /// Starts an execution and returns the index to use, or null if \a isUsed is false. Removes
  /// entries that the previous execution did not use. Previews have a separate index, which exists
  /// until the next execution that is not a preview.
  ExtractionIndex* BeginExecution(bool isUsed, bool isPreview);

  /**
   * Selects the ranges of \a input and builds them if needed. Returns false at the first extraction
   * of the scalar array, or if the array or the cells have changed; then Activate() must not be
   * called. \a dimensions is null unless the grid is structured. \a dimension is the dimension of
   * the cells that are extracted, for which there are separate ranges.
   */
  bool Select(vtkDataSet* input, vtkDataArray* scalars, const int* dimensions, int dimension = 3);

  /// Determines the active blocks, whose ranges overlap an interval or contain an isovalue.
  void Activate(const ExtractionValues& values);

  ///@{
  /**
   * Return whether a row of cells may have output, and append the ranges of its cells that may have
   * output to \a spans. Only for structured grids, after Activate(). Rows are numbered as in
   * StructuredExtraction: j + k * (nj - 1).
   */
  bool IsRowActive(vtkIdType cellRow) const;
  /// Returns the fraction of rows of blocks that contain an active block.
  double GetActiveFraction() const;
  void GetActiveSpans(vtkIdType cellRow, std::vector<Span>& spans) const;
  ///@}

  /// Returns whether any cell in a run may have output. A run consists of RunLength cells, starting
  /// at cell RunLength * run. Only for grids that are not structured, after Activate().
  bool IsRunActive(vtkIdType run) const { return this->Active[run] != 0; }

  /// Returns the memory used by all ranges, in bytes.
  std::size_t GetBytes() const;

protected:
  ExtractionIndex();
  ~ExtractionIndex() override;

private:
  ExtractionIndex(const ExtractionIndex&) = delete;
  void operator=(const ExtractionIndex&) = delete;

  struct Ranges
  {
    // Modification times of the scalars and the cells. VTK's modification times are unique.
    vtkMTimeType ScalarTime = 0;
    vtkMTimeType CellTime = 0;
    std::array<vtkIdType, 3> Cells{ { 0, 0, 0 } };
    bool IsUsed = false;
    std::vector<std::array<double, 2>> Blocks;
  };

  /// Returns the entry of a cache for \a input. Clears the entry if the input has changed.
  template <typename Entry>
  Entry& GetEntry(std::map<vtkDataSet*, Entry>& cache, vtkDataSet* input)
  {
    Entry& cached = cache[input];
    if (cached.InputTime != input->GetMTime())
    {
      cached = Entry();
      cached.InputTime = input->GetMTime();
    }
    cached.IsUsed = true;
    return cached;
  }

  template <typename T>
  void BuildStructured(const T* scalars, Ranges& ranges) const;
  template <typename T>
  void BuildRuns(vtkDataSet* input, const T* scalars, Ranges& ranges) const;

  static constexpr vtkIdType BlockSize[3] = { 8, 4, 4 };

  std::map<std::pair<vtkDataArray*, int>, Ranges> Known;
  std::map<vtkDataSet*, LinearGrid> LinearGrids;
  std::map<vtkDataSet*, LinearGrid> SurfaceGrids;
  std::map<vtkDataSet*, CoarseGrid> CoarseGrids;
  /// The index for previews; null if the last execution was not a preview.
  vtkSmartPointer<ExtractionIndex> Previews;
  CellArrayConversion::Cache ConvertedArrays;
  Ranges* Selected = nullptr;
  std::array<vtkIdType, 3> Cells{ { 0, 0, 0 } };
  std::array<vtkIdType, 3> Blocks{ { 0, 0, 0 } };
  std::vector<unsigned char> Active;
  std::vector<unsigned char> ActiveRows;
};

}

#endif
