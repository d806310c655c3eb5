// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_RowPass_h
#define interlume_RowPass_h

#include "Output/ExtractionReport.h"
#include "Arrays/PointArrays.h"
#include "Cuts/TiedCases.h"
#include "Grid/RowIndex.h"
#include "Pass/ExtractionFrame.h"
#include "Structured/RowCount.h"
#include "Structured/SlotPlace.h"

#include "vtkIsotable.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace interlume
{

/**
 * What a thread keeps while it extracts from rows.
 */
struct RowNotes
{
  interlume::TiedCases TiedCases;
  std::vector<vtkIdType> TiedTriangles;
  std::vector<vtkIdType> TiedSimplices;
  ExtractionReport Report;
};

/**
 * @class   RowPass
 * @brief   shares the stages of extractions by rows: a row owns points, its cells give simplices
 *
 * \a Local derives from RowNotes.
 */
template <typename Pass, typename Local>
class RowPass : public ExtractionFrame<Pass, Local>
{
public:
  static constexpr std::array<double, 4> Progress = { { 0.05, 0.4, 0.4, 0.8 } };

  bool Execute()
  {
    return this->ExtractionFrame<Pass, Local>::Execute(this->Rows.GetNumberOfRows());
  }

protected:
  RowPass(const ExtractionContext& context, const int dimensions[3], const GridWindow& window,
    ExtractionMesh& mesh)
    : ExtractionFrame<Pass, Local>(context)
    , Mesh(mesh)
    , Table(vtkIsotable::Get(context.Values->GetKind(), vtkIsotable::HEXAHEDRON))
    , Ranks(SlotPlace::FindRanks(Table))
    , Rows(dimensions, window)
    , Nx(window.Last[0] - window.First[0] + 1)
    , Offsets(Rows.GetNumberOfRows() + 1)
  {
  }

  /// Turns the counts of rows into the places where they begin, and allocates all.
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

  /// Gathers what threads have noted: reports, and ties in ascending order. Notes the memory, of
  /// which \a bytes are the pass's own.
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
    this->Context.NoteWorkingBytes(bytes + this->Offsets.capacity() * sizeof(RowCount) +
      this->Mesh.Points.GetBytes() + this->Mesh.Used.GetBytes());
  }

  ExtractionMesh& Mesh;
  const vtkIsotable& Table;
  // The order of slots in rows.
  vtkIsotable::RankArray Ranks;
  RowIndex Rows;
  vtkIdType Nx;
  // The count of a row at the place after it; then where the row begins.
  std::vector<RowCount> Offsets;

private:
  static void Append(const std::vector<vtkIdType>& some, std::vector<vtkIdType>& all)
  {
    all.insert(all.end(), some.begin(), some.end());
  }
};

}

#endif
