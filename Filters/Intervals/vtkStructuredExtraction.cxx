#include "vtkStructuredExtraction.h"

#include "vtkCellOrientation.h"
#include "vtkExtractionCell.h"
#include "vtkExtractionDispatch.h"
#include "vtkExtractionIndex.h"
#include "vtkExtractionScalars.h"
#include "vtkSMPThreadLocal.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"

#include <numeric>

namespace
{
using Code = vtkExtractionValues::Code;
using Slot = vtkIsotable::Slot;

// Where a slot of the hexahedron's table is in the rows around a cell.
struct SlotPlace
{
  int Row;       // of the owner: 0 (j,k), 1 (j+1,k), 2 (j,k+1), 3 (j+1,k+1)
  int Column;    // of the owner: 0 or 1
  int Direction; // 0: the grid point itself, 1, 2, 3: the edge along i, j, k
  int Kind;      // 0: lower, 1: upper isovalue
  int Ends[2];   // vertices of the cell
};

std::vector<SlotPlace> FindSlotPlaces(const vtkIsotable& table)
{
  std::vector<SlotPlace> places;
  for (int v = 0; v < 8; ++v)
  {
    places.push_back({ v >> 1, v & 1, 0, 0, { v, v } });
  }
  for (int kind = 0; kind < 2; ++kind)
  {
    for (int e = 0; e < table.GetNumberOfEdges(); ++e)
    {
      const int a = table.GetEdge(e)[0];
      const int b = table.GetEdge(e)[1];
      const int direction = b - a == 1 ? 1 : b - a == 2 ? 2 : 3;
      places.push_back({ a >> 1, a & 1, direction, kind, { a, b } });
    }
  }
  return places;
}

// The codes of one row of grid points.
struct CodeRow
{
  vtkIdType Row = -1;
  Code Minimum = 0;
  Code Maximum = 0;
  bool HasTies = false;
  bool IsFinite = true;
  std::vector<Code> Codes;
};

// Where the output points that a row of grid points owns begin, relative to the row's first.
struct OwnerRow
{
  vtkIdType Row = -1;
  vtkIdType Total = 0;
  std::vector<std::uint32_t> Starts[4];
};

// What the counting pass finds of a row of cells.
struct RowCount
{
  vtkIdType Simplices = 0;
  vtkIdType Triangles = 0;
};

template <typename T>
class Extractor
{
public:
  Extractor(const vtkExtractionContext& context, const int dimensions[3], const T* scalars,
    vtkExtractionMesh& mesh)
    : Context(context)
    , Values(*context.Values)
    , Scalars(scalars, *context.Values)
    , Mesh(mesh)
    , Table(vtkIsotable::Get(context.Values->GetKind(), vtkIsotable::HEXAHEDRON))
    , Places(FindSlotPlaces(Table))
    , Orientation(context.Input)
    , Nx(dimensions[0])
    , Ny(dimensions[1])
    , Nz(dimensions[2])
    , SimplexSize(context.GetSimplexSize())
  {
  }

  bool Execute()
  {
    const vtkIdType pointRows = this->Ny * this->Nz;
    const vtkIdType cellRows = (this->Ny - 1) * (this->Nz - 1);
    this->PointOffsets.assign(pointRows + 1, 0);
    this->CellOffsets.assign(cellRows + 1, RowCount());
    const bool counted =
      this->Context.Run(pointRows, 0.0, 0.15,
        [this](vtkIdType first, vtkIdType last) { this->CountPoints(first, last); }) &&
      this->Context.Run(cellRows, 0.15, 0.4,
        [this](vtkIdType first, vtkIdType last) { this->template ProcessCells<false>(first, last); });
    if (!counted)
    {
      return false;
    }
    this->SumOffsets();
    this->Allocate();
    const bool written =
      this->Context.Run(pointRows, 0.4, 0.5,
        [this](vtkIdType first, vtkIdType last) { this->WritePoints(first, last); }) &&
      this->Context.Run(cellRows, 0.5, 0.8,
        [this](vtkIdType first, vtkIdType last) { this->template ProcessCells<true>(first, last); });
    this->GatherReport();
    return written;
  }

private:
  // Buffers and counts of a thread.
  struct Local
  {
    CodeRow Codes[3][3];
    OwnerRow Owners[2][2];
    std::vector<std::uint16_t> Columns;
    std::vector<std::uint8_t> Gave;
    std::vector<vtkExtractionIndex::Span> Spans;
    vtkExtractionReport Report;
    bool HasTies = false;
  };

  // Row numbers are j + k * Ny for points and j + k * (Ny - 1) for cells.
  const CodeRow& GetCodes(Local& local, vtkIdType j, vtkIdType k) const
  {
    CodeRow& row = local.Codes[k % 3][j % 3];
    const vtkIdType number = j + k * this->Ny;
    if (row.Row != number)
    {
      row.Row = number;
      row.Codes.resize(this->Nx);
      row.IsFinite = this->Scalars.Classify(number * this->Nx, this->Nx, row.Codes.data());
      Code minimum = row.Codes[0];
      Code maximum = minimum;
      Code ties = 0;
      for (const Code code : row.Codes)
      {
        minimum = std::min(minimum, code);
        maximum = std::max(maximum, code);
        ties |= code;
      }
      row.Minimum = minimum;
      row.Maximum = maximum;
      row.HasTies = vtkExtractionValues::IsTie(ties);
    }
    return row;
  }

  const OwnerRow& GetOwners(Local& local, vtkIdType j, vtkIdType k) const
  {
    OwnerRow& owners = local.Owners[k & 1][j & 1];
    if (owners.Row == j + k * this->Ny)
    {
      return owners;
    }
    owners.Row = j + k * this->Ny;
    owners.Total = 0;
    const CodeRow& here = this->GetCodes(local, j, k);
    const CodeRow& along = j + 1 < this->Ny ? this->GetCodes(local, j + 1, k) : here;
    const CodeRow& above = k + 1 < this->Nz ? this->GetCodes(local, j, k + 1) : here;
    const Code minimum = std::min({ here.Minimum, along.Minimum, above.Minimum });
    const Code maximum = std::max({ here.Maximum, along.Maximum, above.Maximum });
    if (minimum == maximum && !this->Values.IsPoint(minimum))
    {
      return owners;
    }
    for (auto& starts : owners.Starts)
    {
      starts.resize(this->Nx);
    }
    const Code* c = here.Codes.data();
    std::uint32_t total = 0;
    for (vtkIdType i = 0; i < this->Nx; ++i)
    {
      owners.Starts[0][i] = total;
      total += this->Values.IsPoint(c[i]);
      owners.Starts[1][i] = total;
      total += i + 1 < this->Nx ? this->Values.CountCrossings(c[i], c[i + 1]) : 0;
      owners.Starts[2][i] = total;
      total += this->Values.CountCrossings(c[i], along.Codes[i]);
      owners.Starts[3][i] = total;
      total += this->Values.CountCrossings(c[i], above.Codes[i]);
    }
    owners.Total = total;
    return owners;
  }

  // Whether anything in the cells at a row of grid points can give output.
  bool IsPointRowActive(vtkIdType j, vtkIdType k) const
  {
    return !this->Context.Index ||
      this->Context.Index->IsRowActive(
        std::min(j, this->Ny - 2) + std::min(k, this->Nz - 2) * (this->Ny - 1));
  }

  void CountPoints(vtkIdType first, vtkIdType last)
  {
    Local& local = this->Locals.Local();
    for (vtkIdType row = first; row < last; ++row)
    {
      const vtkIdType j = row % this->Ny;
      const vtkIdType k = row / this->Ny;
      if (this->IsPointRowActive(j, k))
      {
        this->PointOffsets[row + 1] = this->GetOwners(local, j, k).Total;
        const CodeRow& codes = this->GetCodes(local, j, k);
        local.HasTies |= codes.HasTies || !codes.IsFinite;
      }
    }
  }

  void SumOffsets()
  {
    std::partial_sum(
      this->PointOffsets.begin(), this->PointOffsets.end(), this->PointOffsets.begin());
    RowCount sum;
    for (RowCount& count : this->CellOffsets)
    {
      sum.Simplices += count.Simplices;
      sum.Triangles += count.Triangles;
      count = sum;
    }
  }

  void Allocate()
  {
    const RowCount& total = this->CellOffsets.back();
    this->Mesh.Points.resize(this->PointOffsets.back());
    vtkNew<vtkIdTypeArray> connectivity;
    connectivity->SetNumberOfValues(total.Simplices * this->SimplexSize);
    this->Connectivity = connectivity->GetPointer(0);
    this->Mesh.Connectivity = connectivity;
    this->Mesh.ItemIds->SetNumberOfValues(total.Simplices);
    this->Mesh.Triangles.resize(total.Triangles);
    this->Mesh.TriangleItemIds->SetNumberOfValues(total.Triangles);
    this->Mesh.TriangleSides->SetNumberOfValues(total.Triangles);
    if (this->Context.KeepCellIds)
    {
      this->Mesh.CellIds.resize(total.Simplices);
      this->Mesh.TriangleCellIds.resize(total.Triangles);
    }
  }

  void GatherReport()
  {
    bool hasTies = false;
    std::size_t bytes = this->PointOffsets.capacity() * sizeof(vtkIdType) +
      this->CellOffsets.capacity() * sizeof(RowCount) +
      this->Mesh.Points.capacity() * sizeof(vtkExtractionPoint);
    for (const Local& local : this->Locals)
    {
      this->Context.Report->Add(local.Report);
      hasTies |= local.HasTies;
      bytes += static_cast<std::size_t>(this->Nx) * (9 * sizeof(Code) + 16 * sizeof(std::uint32_t));
    }
    this->Mesh.MayHaveUnusedPoints =
      hasTies || this->Context.HasBlanking() || this->Values.HasFlatItem();
    this->Context.NoteWorkingBytes(bytes);
  }

  void WriteCrossings(vtkIdType a, vtkIdType b, Code codeA, Code codeB, vtkExtractionPoint*& out)
  {
    const int first = vtkExtractionValues::GetFirstCrossing(codeA, codeB);
    const int number = this->Values.CountCrossings(codeA, codeB);
    for (int k = first; k < first + number; ++k)
    {
      *out++ = this->Scalars.Cross(a, b, k);
    }
  }

  void WritePoints(vtkIdType firstRow, vtkIdType lastRow)
  {
    Local& local = this->Locals.Local();
    for (vtkIdType row = firstRow; row < lastRow; ++row)
    {
      if (this->PointOffsets[row] == this->PointOffsets[row + 1])
      {
        continue;
      }
      const vtkIdType j = row % this->Ny;
      const vtkIdType k = row / this->Ny;
      vtkExtractionPoint* out = this->Mesh.Points.data() + this->PointOffsets[row];
      const Code* here = this->GetCodes(local, j, k).Codes.data();
      const Code* along =
        j + 1 < this->Ny ? this->GetCodes(local, j + 1, k).Codes.data() : nullptr;
      const Code* above =
        k + 1 < this->Nz ? this->GetCodes(local, j, k + 1).Codes.data() : nullptr;
      for (vtkIdType i = 0; i < this->Nx; ++i)
      {
        const vtkIdType id = row * this->Nx + i;
        if (this->Values.IsPoint(here[i]))
        {
          *out++ = { id, id, 0.0 };
        }
        if (i + 1 < this->Nx)
        {
          this->WriteCrossings(id, id + 1, here[i], here[i + 1], out);
        }
        if (along)
        {
          this->WriteCrossings(id, id + this->Nx, here[i], along[i], out);
        }
        if (above)
        {
          this->WriteCrossings(id, id + this->Nx * this->Ny, here[i], above[i], out);
        }
      }
    }
  }

  // The rows around a row of cells, in the order of SlotPlace::Row.
  struct Around
  {
    vtkIdType J;
    vtkIdType K;
    vtkIdType FirstPoint; // of the cell at column 0
    vtkIdType FirstCell;
    const Code* Codes[4];
    const OwnerRow* Owners[4];
    vtkIdType Offsets[4];
    bool HasTies = false;
    bool IsFinite = true;
  };

  template <bool Write>
  void ProcessCells(vtkIdType firstRow, vtkIdType lastRow)
  {
    Local& local = this->Locals.Local();
    for (vtkIdType row = firstRow; row < lastRow; ++row)
    {
      local.Spans.clear();
      if (this->Context.Index)
      {
        this->Context.Index->GetActiveSpans(row, local.Spans);
      }
      else
      {
        local.Spans.push_back({ 0, this->Nx - 1 });
      }
      RowCount place = Write ? this->CellOffsets[row] : RowCount();
      if (!local.Spans.empty() && (!Write || this->HasOutput(row)))
      {
        this->template ProcessRow<Write>(local, row, place);
      }
      if (!Write)
      {
        this->CellOffsets[row + 1] = place;
      }
    }
  }

  bool HasOutput(vtkIdType row) const
  {
    const RowCount& here = this->CellOffsets[row];
    const RowCount& next = this->CellOffsets[row + 1];
    return here.Simplices != next.Simplices || here.Triangles != next.Triangles;
  }

  template <bool Write>
  void ProcessRow(Local& local, vtkIdType row, RowCount& place)
  {
    Around around;
    around.J = row % (this->Ny - 1);
    around.K = row / (this->Ny - 1);
    around.FirstPoint = (around.J + around.K * this->Ny) * this->Nx;
    around.FirstCell = row * (this->Nx - 1);
    Code minimum = std::numeric_limits<Code>::max();
    Code maximum = 0;
    for (int r = 0; r < 4; ++r)
    {
      const vtkIdType j = around.J + (r & 1);
      const vtkIdType k = around.K + (r >> 1);
      const CodeRow& codes = this->GetCodes(local, j, k);
      around.Codes[r] = codes.Codes.data();
      around.HasTies |= codes.HasTies;
      around.IsFinite &= codes.IsFinite;
      minimum = std::min(minimum, codes.Minimum);
      maximum = std::max(maximum, codes.Maximum);
    }
    // A second loop: the owners' rows reach further, and only then may the codes' places change.
    for (int r = 0; Write && r < 4; ++r)
    {
      const vtkIdType j = around.J + (r & 1);
      const vtkIdType k = around.K + (r >> 1);
      around.Owners[r] = &this->GetOwners(local, j, k);
      around.Offsets[r] = this->PointOffsets[j + k * this->Ny];
    }
    local.Gave.assign(Write ? 0 : this->Nx, 0);
    if (!Write)
    {
      this->CountInput(local, around);
    }
    const auto& items = this->Values.GetItems();
    const std::uint8_t last = this->Values.GetKind() == vtkIsotable::INTERVAL ? 2 : 1;
    for (std::size_t item = 0; item < items.size(); ++item)
    {
      const auto& digits = items[item].Digits;
      const bool isEmpty = digits[maximum] == 0 || digits[minimum] == last;
      if (!isEmpty || !around.IsFinite)
      {
        this->template ProcessItem<Write>(local, around, static_cast<int>(item), place);
      }
    }
    if (!Write)
    {
      local.Report.CellsWithOutput += std::count(local.Gave.begin(), local.Gave.end(), 1);
    }
  }

  bool IsFinite(const Around& around, vtkIdType i) const
  {
    const Code nonFinite = this->Values.GetNonFiniteCode();
    for (const Code* codes : around.Codes)
    {
      if (codes[i] == nonFinite || codes[i + 1] == nonFinite)
      {
        return false;
      }
    }
    return true;
  }

  bool IsBlanked(const Around& around, vtkIdType i) const
  {
    if (this->Context.IsCellBlanked(around.FirstCell + i))
    {
      return true;
    }
    for (int v = 0; this->Context.PointGhosts && v < 8; ++v)
    {
      if (this->Context.IsPointBlanked(this->GetVertex(around, i, v)))
      {
        return true;
      }
    }
    return false;
  }

  vtkIdType GetVertex(const Around& around, vtkIdType i, int vertex) const
  {
    return around.FirstPoint + i + (vertex & 1) + ((vertex >> 1) & 1) * this->Nx +
      (vertex >> 2) * this->Nx * this->Ny;
  }

  void CountInput(Local& local, const Around& around) const
  {
    for (const auto& span : local.Spans)
    {
      local.Report.CellsVisited += span[1] - span[0];
      for (vtkIdType i = span[0]; i < span[1] && this->Context.HasBlanking(); ++i)
      {
        local.Report.BlankedCells += this->IsBlanked(around, i);
      }
      for (vtkIdType i = span[0]; i < span[1] && !around.IsFinite; ++i)
      {
        local.Report.NonFiniteCells += !this->IsFinite(around, i) && !this->IsBlanked(around, i);
      }
    }
  }

  // A digit of the key for each column of four grid points.
  void FillColumns(Local& local, const Around& around, const std::vector<std::uint8_t>& digits) const
  {
    const int base = this->Values.GetKind() == vtkIsotable::INTERVAL ? 3 : 2;
    const int square = base * base;
    local.Columns.resize(this->Nx);
    for (const auto& span : local.Spans)
    {
      for (vtkIdType i = span[0]; i <= span[1]; ++i)
      {
        local.Columns[i] = static_cast<std::uint16_t>(digits[around.Codes[0][i]] +
          square * (digits[around.Codes[1][i]] +
            square * (digits[around.Codes[2][i]] + square * digits[around.Codes[3][i]])));
      }
    }
  }

  template <bool Write>
  void ProcessItem(Local& local, const Around& around, int item, RowCount& place)
  {
    const auto& what = this->Values.GetItems()[item];
    this->FillColumns(local, around, what.Digits);
    const int base = this->Values.GetKind() == vtkIsotable::INTERVAL ? 3 : 2;
    const int last = this->Table.GetNumberOfCases() - 1;
    const bool isSimple = around.IsFinite && !this->Context.HasBlanking();
    for (const auto& span : local.Spans)
    {
      for (vtkIdType i = span[0]; i < span[1]; ++i)
      {
        const int key = local.Columns[i] + base * local.Columns[i + 1];
        if (key == 0 || key == last ||
          (!isSimple && (!this->IsFinite(around, i) || this->IsBlanked(around, i))))
        {
          continue;
        }
        const vtkIsotable::Case& found = this->Table.GetCase(key);
        const RowCount before = place;
        if (around.HasTies || what.Lower == what.Upper)
        {
          this->template ProcessCell<Write, true>(local, around, i, item, found, place);
        }
        else if (Write)
        {
          this->template ProcessCell<true, false>(local, around, i, item, found, place);
        }
        else
        {
          place.Simplices += found.Simplices.size();
          place.Triangles += this->Context.GenerateBoundaries ? found.Boundary.size() : 0;
        }
        if (!Write && place.Simplices != before.Simplices)
        {
          local.Gave[i] = 1;
        }
      }
    }
  }

  // The output id of a slot, or while counting any number that tells points apart.
  template <bool Write>
  vtkIdType GetId(const Around& around, vtkIdType i, const vtkExtractionValues::Item& item,
    const Code* codes, Slot slot) const
  {
    if (!Write)
    {
      return slot;
    }
    const SlotPlace& at = this->Places[slot];
    vtkIdType id = around.Offsets[at.Row] +
      around.Owners[at.Row]->Starts[at.Direction][i + at.Column];
    if (at.Direction != 0)
    {
      id += (at.Kind == 0 ? item.Lower : item.Upper) -
        vtkExtractionValues::GetFirstCrossing(codes[at.Ends[0]], codes[at.Ends[1]]);
    }
    return id;
  }

  template <bool Write, bool Ties>
  void ProcessCell(Local& local, const Around& around, vtkIdType i, int item,
    const vtkIsotable::Case& found, RowCount& place)
  {
    const auto& what = this->Values.GetItems()[item];
    Code codes[8];
    for (int v = 0; v < 8; ++v)
    {
      codes[v] = around.Codes[v >> 1][i + (v & 1)];
    }
    vtkIdType ids[vtkIsotable::MaximumNumberOfSlots];
    for (const Slot slot : found.Slots)
    {
      const Slot same =
        Ties ? vtkExtractionCell::Identify(this->Table, what, codes, slot) : slot;
      ids[slot] = this->template GetId<Write>(around, i, what, codes, same);
    }
    bool isInverted = false;
    if (Write)
    {
      vtkIdType vertices[8];
      for (int v = 0; v < 8; ++v)
      {
        vertices[v] = this->GetVertex(around, i, v);
      }
      isInverted = this->Orientation.IsInverted(vtkIsotable::HEXAHEDRON, vertices);
    }
    const int size = this->SimplexSize;
    for (const vtkIsotable::Simplex& simplex : found.Simplices)
    {
      vtkIdType points[4] = {};
      for (int p = 0; p < size; ++p)
      {
        points[p] = ids[simplex[p]];
      }
      if (Ties && vtkExtractionCell::IsCollapsed(points, size))
      {
        local.Report.CollapsedSimplices += !Write;
        continue;
      }
      if (Write)
      {
        if (isInverted)
        {
          std::swap(points[0], points[1]);
        }
        std::copy_n(points, size, this->Connectivity + place.Simplices * size);
        this->Mesh.ItemIds->SetValue(place.Simplices, item);
        if (this->Context.KeepCellIds)
        {
          this->Mesh.CellIds[place.Simplices] = around.FirstCell + i;
        }
      }
      ++place.Simplices;
    }
    for (const vtkIsotable::Triangle& triangle : found.Boundary)
    {
      std::array<vtkIdType, 3> points{ { ids[triangle[0]], ids[triangle[1]], ids[triangle[2]] } };
      if (!this->Context.GenerateBoundaries ||
        (Ties && vtkExtractionCell::IsCollapsed(points.data(), 3)))
      {
        continue;
      }
      if (Write)
      {
        if (isInverted)
        {
          std::swap(points[0], points[1]);
        }
        this->Mesh.Triangles[place.Triangles] = points;
        this->Mesh.TriangleItemIds->SetValue(place.Triangles, item);
        this->Mesh.TriangleSides->SetValue(place.Triangles, triangle[3]);
        if (this->Context.KeepCellIds)
        {
          this->Mesh.TriangleCellIds[place.Triangles] = around.FirstCell + i;
        }
      }
      ++place.Triangles;
    }
  }

  const vtkExtractionContext& Context;
  const vtkExtractionValues& Values;
  vtkExtractionScalars<T> Scalars;
  vtkExtractionMesh& Mesh;
  const vtkIsotable& Table;
  std::vector<SlotPlace> Places;
  vtkCellOrientation Orientation;
  vtkIdType Nx;
  vtkIdType Ny;
  vtkIdType Nz;
  int SimplexSize;
  std::vector<vtkIdType> PointOffsets;
  std::vector<RowCount> CellOffsets;
  vtkIdType* Connectivity = nullptr;
  vtkSMPThreadLocal<Local> Locals;
};
}

bool vtkStructuredExtraction::Execute(
  const vtkExtractionContext& context, const int dimensions[3], vtkExtractionMesh& mesh)
{
  context.Report->Cells += vtkIdType(dimensions[0] - 1) * (dimensions[1] - 1) * (dimensions[2] - 1);
  return vtkExtractionDispatch::Execute(context.Scalars, [&](const auto* scalars) {
    using T = std::decay_t<decltype(*scalars)>;
    return Extractor<T>(context, dimensions, scalars, mesh).Execute();
  });
}
