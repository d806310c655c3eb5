// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_RowPass_h
#define interlume_RowPass_h

#include "Output/ExtractionReport.h"
#include "Arrays/PointArrays.h"
#include "Cuts/TieCaseCache.h"
#include "Grid/RowIndex.h"
#include "Pass/ExtractionStages.h"
#include "Structured/RowCount.h"
#include "Structured/SlotLocation.h"

#include "vtkIsotable.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace interlume
{

/**
 * Results that a thread collects during a structured extraction.
 */
struct RowResults
{
  interlume::TieCaseCache TieCaseCache;
  std::vector<vtkIdType> TiedTriangles;
  std::vector<vtkIdType> TiedSimplices;
  ExtractionReport Report;
};

/**
 * @class   RowPass
 * @brief   base class of the row-by-row extractions from structured grids
 *
 * \a Local must derive from RowResults.
 */
template <typename Pass, typename Local>
class RowPass : public ExtractionStages<Pass, Local>
{
public:
  static constexpr std::array<double, 4> Progress = { { 0.05, 0.4, 0.4, 0.8 } };

  bool Execute()
  {
    return this->ExtractionStages<Pass, Local>::Execute(this->Rows.GetNumberOfRows());
  }

protected:
  RowPass(const ExtractionContext& context, const int dimensions[3], const GridCellRange& window,
    ExtractionMesh& mesh)
    : ExtractionStages<Pass, Local>(context)
    , Mesh(mesh)
    , Table(vtkIsotable::Get(context.Values->GetKind(), vtkIsotable::HEXAHEDRON))
    , Ranks(SlotLocation::FindRanks(Table))
    , Rows(dimensions, window)
    , Nx(window.Last[0] - window.First[0] + 1)
    , Offsets(Rows.GetNumberOfRows() + 1)
  {
  }

  /// Converts the counts of rows to start positions, and allocates the output.
  void AllocateRows()
  {
    RowCount total;
    for (RowCount& count : this->Offsets)
    {
      total.Add(count);
      count = total;
    }
    const ExtractionContext& context = this->Context;
    if (context.Arrays)
    {
      context.Arrays->Allocate(total.Points);
    }
    else
    {
      this->Mesh.Points.Allocate(total.Points);
    }
    this->Mesh.Allocate(total.Points, total.Simplices, context.GetSimplexSize(), total.Triangles,
      context.KeepCellIds, total.Interior, 8 * total.Interior);
  }

  /// Gathers the results of all threads: the reports, and the tied triangles and simplices in
  /// ascending order. Records the working memory, including \a bytes of the derived class.
  void Gather(std::size_t bytes)
  {
    for (const Local& local : this->Locals)
    {
      this->Context.Report->Add(local.Report);
      Append(local.TiedTriangles, this->Mesh.TiedTriangles);
      Append(local.TiedSimplices, this->Mesh.TiedSimplices);
    }
    vtkSMPTools::Sort(this->Mesh.TiedTriangles.begin(), this->Mesh.TiedTriangles.end());
    vtkSMPTools::Sort(this->Mesh.TiedSimplices.begin(), this->Mesh.TiedSimplices.end());
    this->Context.UpdatePeakWorkingBytes(bytes + this->Offsets.capacity() * sizeof(RowCount) +
      this->Mesh.Points.GetBytes() + this->Mesh.Used.GetBytes());
  }

  ExtractionMesh& Mesh;
  const vtkIsotable& Table;
  // Ranks of the slots, which are the same in all cells.
  vtkIsotable::RankArray Ranks;
  RowIndex Rows;
  vtkIdType Nx;
  // The count of row r is at index r + 1. After summation, the start position of row r is at index
  // r.
  std::vector<RowCount> Offsets;

private:
  static void Append(const std::vector<vtkIdType>& some, std::vector<vtkIdType>& all)
  {
    all.insert(all.end(), some.begin(), some.end());
  }
};

}

#endif
