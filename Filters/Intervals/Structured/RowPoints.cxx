// SPDX-License-Identifier: BSD-3-Clause
#include "Structured/RowPoints.h"

#include "Pass/ExtractionIndex.h"
#include "Scalars/ExtractionKernels.h"
#include "Scalars/ExtractionScalars.h"
#include "Scalars/RowKernels.h"
#include "Structured/PointOutput.h"

#include <algorithm>

namespace interlume
{

namespace
{
using Code = ExtractionValues::Code;

// The codes of all rows are cached if they do not exceed this size. Otherwise each thread computes
// the codes that it needs, so most rows are computed several times.
constexpr std::size_t MaximumBytesOfCodes = std::size_t(1) << 26;
// If the index selects less than this fraction of the rows, codes are not cached but computed for
// the selected rows only, about four times each.
constexpr double MinimumFractionOfRows = 0.25;

// Bytes of owner data per grid point, and the maximum size of the data that a thread caches. The
// data should fit in the CPU cache because the rows are requested again in the next layer.
constexpr std::size_t BytesOfOwner = sizeof(std::uint32_t) + 4 * sizeof(Code);
constexpr std::size_t MaximumBytesOfOwners = std::size_t(1) << 22;

// Writes the crossings of an edge. Writing the first crossing unconditionally avoids a branch that
// is hard to predict. If the edge has no crossing, the next point overwrites it.
void WriteCrossings(
  vtkIdType a, vtkIdType b, Code codeA, Code codeB, int number, ExtractionPoint*& out)
{
  const int first = ExtractionValues::GetFirstCrossing(codeA, codeB);
  *out = { a, b, static_cast<double>(first) };
  for (int k = 1; k < number; ++k)
  {
    out[k] = { a, b, static_cast<double>(first + k) };
  }
  out += number;
}
}

RowPoints::RowPoints(ExtractionContext& context, const RowIndex& rows, const GridCellRange& window)
  : Context(context)
  , Values(*context.Values)
  , Scalars(context.MakeScalars())
  , Rows(rows)
  , Nx(window.Last[0] - window.First[0] + 1)
  , Ny(window.Last[1] - window.First[1] + 1)
  , Nz(window.Last[2] - window.First[2] + 1)
  , CachedRows(
      static_cast<std::size_t>(2 * this->Nx * this->Ny) * BytesOfOwner > MaximumBytesOfOwners
        ? 2
        : this->Ny)
  , PointsBelow(1, 0)
{
  for (int code = 0; code <= this->Values.GetNonFiniteCode(); ++code)
  {
    this->PointsBelow.push_back(
      this->PointsBelow.back() + this->Values.IsOutputPoint(static_cast<Code>(code)));
  }
}

bool RowPoints::MakeCodes()
{
  const vtkIdType rows = this->Rows.GetNumberOfRows();
  const std::size_t points = static_cast<std::size_t>(rows * this->Nx);
  const bool areFewUsed =
    this->Context.Index && this->Context.Index->GetActiveFraction() < MinimumFractionOfRows;
  if (areFewUsed || points * sizeof(Code) > MaximumBytesOfCodes)
  {
    return true;
  }
  this->AllCodes.Allocate(points);
  this->CodeRows.resize(rows);
  return this->Context.Run(rows, 0.0, 0.05,
    [this](vtkIdType first, vtkIdType last)
    {
      for (vtkIdType row = first; row < last; ++row)
      {
        this->CodeRows[row].Fill(*this->Scalars, row, this->Rows.GetFirstPoint(row), this->Nx,
          this->AllCodes.GetData() + row * this->Nx);
      }
    });
}

const CodeRow& RowPoints::GetCodes(Local& local, vtkIdType j, vtkIdType k) const
{
  const vtkIdType number = this->Rows.GetRow(j, k);
  if (!this->CodeRows.empty())
  {
    return this->CodeRows[number];
  }
  Local::OwnCodeRow& row = local.Codes[k % 3][j % 3];
  if (row.Row != number)
  {
    row.Memory.resize(this->Nx);
    row.Fill(*this->Scalars, number, this->Rows.GetFirstPoint(number), this->Nx, row.Memory.data());
  }
  return row;
}

const RowPoints::Owners& RowPoints::GetOwners(Local& local, vtkIdType j, vtkIdType k) const
{
  std::vector<Owners>& layer = local.Layers[k & 1];
  layer.resize(this->CachedRows);
  Owners& owners = layer[j % this->CachedRows];
  if (owners.Row == this->Rows.GetRow(j, k))
  {
    return owners;
  }
  owners.Row = this->Rows.GetRow(j, k);
  const auto rows = this->GetOwnerCodes(local, j, k);
  owners.Range = this->GetRange(rows);
  if (owners.Range.First == owners.Range.Last)
  {
    return owners;
  }
  owners.Starts.resize(this->Nx + 1);
  owners.Counts.resize(this->Nx + 1);
  for (auto& offsets : owners.Offsets)
  {
    offsets.resize(this->Nx);
  }
  this->CountOwnedPoints(rows, owners);
  ExtractionKernels::FillStarts(owners.Counts.data() + owners.Range.First,
    owners.Range.Last - owners.Range.First, owners.Starts.data() + owners.Range.First);
  return owners;
}

// Returns the codes that determine which points a row of grid points owns: those of the row itself
// and of the next rows along j and k.
std::array<const CodeRow*, 3> RowPoints::GetOwnerCodes(Local& local, vtkIdType j, vtkIdType k) const
{
  const CodeRow* here = &this->GetCodes(local, j, k);
  return { { here, j + 1 < this->Ny ? &this->GetCodes(local, j + 1, k) : here,
    k + 1 < this->Nz ? &this->GetCodes(local, j, k + 1) : here } };
}

vtkIdType RowPoints::Count(Local& local, vtkIdType j, vtkIdType k) const
{
  const auto rows = this->GetOwnerCodes(local, j, k);
  const ColumnRange range = this->GetRange(rows);
  if (range.First == range.Last)
  {
    return 0;
  }
  const vtkIdType number = range.Last - range.First;
  const Code* const codes[] = { rows[0]->Codes + range.First, rows[1]->Codes + range.First,
    rows[2]->Codes + range.First };
  const vtkIdType points = this->CountGridPoints(*rows[0], codes[0], number);
  if (rows[0]->IsFinite && rows[1]->IsFinite && rows[2]->IsFinite)
  {
    return points + RowKernels::CountCrossings(codes[0], codes[1], codes[2], number);
  }
  vtkIdType crossings = 0;
  for (vtkIdType i = 0; i < number; ++i)
  {
    const Code* const here = codes[0] + i;
    crossings += this->Values.CountCrossings(*here, here[i + 1 < number ? 1 : 0]) +
      this->Values.CountCrossings(*here, codes[1][i]) +
      this->Values.CountCrossings(*here, codes[2][i]);
  }
  return points + crossings;
}

// Returns the number of grid points of a row that are output points.
vtkIdType RowPoints::CountGridPoints(const CodeRow& row, const Code* codes, vtkIdType number) const
{
  const int points = this->CountPointCodes(row);
  if (points == 0 || points == row.Maximum + 1 - row.Minimum)
  {
    return points == 0 ? 0 : number;
  }
  return std::count_if(
    codes, codes + number, [this](Code code) { return this->Values.IsOutputPoint(code); });
}

// Returns how many of the codes from the minimum to the maximum of a row make a grid point an
// output point.
int RowPoints::CountPointCodes(const CodeRow& row) const
{
  return this->PointsBelow[row.Maximum + 1] - this->PointsBelow[row.Minimum];
}

void RowPoints::CountOwnedPoints(const std::array<const CodeRow*, 3>& rows, Owners& owners) const
{
  const vtkIdType begin = owners.Range.First;
  const vtkIdType number = owners.Range.Last - begin;
  const Code* here = rows[0]->Codes + begin;
  const Code* alongJ = rows[1]->Codes + begin;
  const Code* alongK = rows[2]->Codes + begin;
  Code* first = owners.Offsets[0].data() + begin;
  Code* second = owners.Offsets[1].data() + begin;
  Code* third = owners.Offsets[2].data() + begin;
  Code* all = owners.Counts.data() + begin;
  this->FindPoints(*rows[0], here, number, first);
  if (rows[0]->IsFinite && rows[1]->IsFinite && rows[2]->IsFinite)
  {
    RowKernels::CountOwnedPoints(here, alongJ, alongK, number, first, second, third, all);
    return;
  }
  for (vtkIdType i = 0; i < number; ++i)
  {
    const Code next = i + 1 < number ? here[i + 1] : here[i];
    second[i] = static_cast<Code>(first[i] + this->Values.CountCrossings(here[i], next));
    third[i] = static_cast<Code>(second[i] + this->Values.CountCrossings(here[i], alongJ[i]));
    all[i] = static_cast<Code>(third[i] + this->Values.CountCrossings(here[i], alongK[i]));
  }
}

// Marks the grid points that are output points. In most rows, either none or all of them are.
void RowPoints::FindPoints(
  const CodeRow& row, const Code* codes, vtkIdType number, Code* arePoints) const
{
  const int points = this->CountPointCodes(row);
  if (points == 0 || points == row.Maximum + 1 - row.Minimum)
  {
    std::fill_n(arePoints, number, static_cast<Code>(points != 0));
    return;
  }
  for (vtkIdType i = 0; i < number; ++i)
  {
    arePoints[i] = this->Values.IsOutputPoint(codes[i]);
  }
}

void RowPoints::Write(
  Local& local, vtkIdType row, vtkIdType position, vtkIdType number, ExtractionMesh& mesh) const
{
  const vtkIdType j = this->Rows.GetJ(row);
  const vtkIdType k = this->Rows.GetK(row);
  const Owners& owners = this->GetOwners(local, j, k);
  // One more point is needed because WriteCrossings() writes unconditionally.
  if (local.Points.size() <= static_cast<std::size_t>(number))
  {
    local.Points.resize(number + 1);
  }
  ExtractionPoint* out = local.Points.data();
  const auto rows = this->GetOwnerCodes(local, j, k);
  const Code* here = rows[0]->Codes;
  const Code* along = rows[1]->Codes;
  const Code* above = rows[2]->Codes;
  const vtkIdType first = this->Rows.GetFirstPoint(row);
  for (vtkIdType i = owners.Range.First; i < owners.Range.Last; ++i)
  {
    if (owners.Counts[i] == 0)
    {
      i = ExtractionKernels::FindChange(owners.Counts.data(), i, owners.Range.Last) - 1;
      continue;
    }
    const vtkIdType id = first + i;
    const Code own = owners.Offsets[0][i];
    const Code all = owners.Counts[i];
    *out = { id, id, 0.0 };
    out += own;
    // Most grid points here are themselves output points and own no edge crossing.
    if (all != own)
    {
      const Code second = owners.Offsets[1][i];
      const Code third = owners.Offsets[2][i];
      WriteCrossings(id, id + 1, here[i], here[i + 1 < this->Nx ? i + 1 : i], second - own, out);
      WriteCrossings(id, id + this->Rows.GetStep(1), here[i], along[i], third - second, out);
      WriteCrossings(id, id + this->Rows.GetStep(2), here[i], above[i], all - third, out);
    }
  }
  PointOutput::Write(this->Context, *this->Scalars, local.Points.data(), number, position, mesh);
}

std::size_t RowPoints::GetBytes() const
{
  return this->AllCodes.GetBytes() + this->CodeRows.capacity() * sizeof(CodeRow);
}

std::size_t RowPoints::GetBytes(const Local& local) const
{
  // Bytes per grid column: nine rows of codes and two layers of owners.
  const std::size_t bytesOfColumn =
    9 * sizeof(Code) + 2 * static_cast<std::size_t>(this->CachedRows) * BytesOfOwner;
  return static_cast<std::size_t>(this->Nx) * bytesOfColumn +
    local.Points.capacity() * sizeof(ExtractionPoint);
}

}
