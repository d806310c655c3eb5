#ifndef vtkExtractionContext_h
#define vtkExtractionContext_h

#include "vtkAlgorithm.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkExtractionReport.h"
#include "vtkExtractionValues.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkSMPTools.h"
#include "vtkSmartPointer.h"
#include "vtkTypeInt64Array.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <array>
#include <vector>

class vtkExtractionIndex;

/**
 * What an output point is made of: a grid point when Near equals Far, else the point at Weight of
 * the way from Near to Far, Weight <= 1/2 since Near is the end nearer the isovalue.
 */
struct vtkExtractionPoint
{
  vtkIdType Near;
  vtkIdType Far;
  double Weight;
};

/**
 * The result of an extraction before arrays are interpolated.
 */
struct vtkExtractionMesh
{
  std::vector<vtkExtractionPoint> Points;
  /// Four (interval) or three (contour) point ids a simplex, in the order of the input's cells.
  vtkSmartPointer<vtkTypeInt64Array> Connectivity;
  vtkNew<vtkIntArray> ItemIds;
  /// The input cell of each simplex; only when the input has cell arrays.
  std::vector<vtkIdType> CellIds;

  /// Boundary triangles of intervals, when asked for.
  std::vector<std::array<vtkIdType, 3>> Triangles;
  vtkNew<vtkIntArray> TriangleItemIds;
  vtkNew<vtkIntArray> TriangleSides;
  std::vector<vtkIdType> TriangleCellIds;

  /// Whether points may have been made that no simplex uses.
  bool MayHaveUnusedPoints = false;
};

/**
 * @class   vtkExtractionContext
 * @brief   what every part of one extraction needs to know
 */
struct vtkExtractionContext
{
  vtkAlgorithm* Owner = nullptr;
  const vtkExtractionValues* Values = nullptr;
  vtkDataSet* Input = nullptr;
  vtkDataArray* Scalars = nullptr;
  vtkExtractionIndex* Index = nullptr;
  vtkUnsignedCharArray* CellGhosts = nullptr;
  vtkUnsignedCharArray* PointGhosts = nullptr;
  bool GenerateBoundaries = false;
  bool KeepCellIds = false;
  vtkExtractionReport* Report = nullptr;

  int GetSimplexSize() const { return this->Values->GetKind() == vtkIsotable::INTERVAL ? 4 : 3; }

  /// Whether the ghost arrays say that a cell does not count.
  bool IsCellBlanked(vtkIdType cell) const
  {
    constexpr unsigned char blanked = vtkDataSetAttributes::DUPLICATECELL |
      vtkDataSetAttributes::REFINEDCELL | vtkDataSetAttributes::HIDDENCELL;
    return this->CellGhosts && (this->CellGhosts->GetValue(cell) & blanked);
  }
  bool IsPointBlanked(vtkIdType point) const
  {
    return this->PointGhosts &&
      (this->PointGhosts->GetValue(point) & vtkDataSetAttributes::HIDDENPOINT);
  }
  bool HasBlanking() const { return this->CellGhosts || this->PointGhosts; }

  /**
   * Runs \a work(first, last) over [0, number) on all threads, in a few batches between which
   * progress goes from \a from to \a to. Returns false when the user aborted.
   */
  template <typename Work>
  bool Run(vtkIdType number, double from, double to, Work&& work) const
  {
    constexpr vtkIdType batches = 8;
    const vtkIdType step = std::max<vtkIdType>((number + batches - 1) / batches, 1);
    for (vtkIdType first = 0; first < number; first += step)
    {
      const vtkIdType last = std::min(first + step, number);
      vtkSMPTools::For(first, last, work);
      this->Owner->UpdateProgress(from + (to - from) * last / number);
      if (this->Owner->GetAbortExecute())
      {
        return false;
      }
    }
    return true;
  }

  /// Notes that \a bytes of working memory are held at this moment.
  void NoteWorkingBytes(std::size_t bytes) const
  {
    this->Report->WorkingBytes =
      std::max(this->Report->WorkingBytes, static_cast<vtkIdType>(bytes));
  }
};

#endif
