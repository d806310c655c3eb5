// SPDX-License-Identifier: BSD-3-Clause
#include "ParaView/Extractions/PieceWriter.h"

#include "vtkCell.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"
#include "vtkXMLUnstructuredGridWriter.h"

#include <algorithm>
#include <fstream>
#include <functional>
#include <numeric>
#include <stdexcept>
#include <vector>

namespace
{
// For each cell, the slab that its centre falls into.
std::vector<int> SlabOfCell(vtkUnstructuredGrid* grid, int count)
{
  const vtkIdType cells = grid->GetNumberOfCells();
  std::vector<double> centre(cells);
  for (vtkIdType cell = 0; cell < cells; ++cell)
  {
    double bounds[6];
    grid->GetCellBounds(cell, bounds);
    centre[cell] = bounds[0] + bounds[1];
  }
  std::vector<vtkIdType> order(cells);
  std::iota(order.begin(), order.end(), vtkIdType{ 0 });
  std::stable_sort(order.begin(), order.end(),
    [&centre](vtkIdType a, vtkIdType b) { return centre[a] < centre[b]; });
  std::vector<int> slab(cells);
  for (vtkIdType i = 0; i < cells; ++i)
  {
    slab[order[i]] = static_cast<int>(i * count / cells);
  }
  return slab;
}

std::vector<bool> PointsOfSlab(
  vtkUnstructuredGrid* grid, const std::vector<int>& slabOfCell, int slab)
{
  std::vector<bool> used(grid->GetNumberOfPoints(), false);
  vtkNew<vtkIdList> corners;
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    if (slabOfCell[cell] == slab)
    {
      grid->GetCellPoints(cell, corners);
      std::for_each(
        corners->begin(), corners->end(), [&used](vtkIdType point) { used[point] = true; });
    }
  }
  return used;
}

// The cells that touch the slab, its own and ghosts, with the points they need.
class Piece
{
public:
  Piece(vtkUnstructuredGrid* grid, const std::vector<int>& slabOfCell, int slab)
    : Source(grid)
    , NewIds(grid->GetNumberOfPoints(), -1)
  {
    const std::vector<bool> touched = PointsOfSlab(grid, slabOfCell, slab);
    vtkNew<vtkIdList> corners;
    for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
    {
      grid->GetCellPoints(cell, corners);
      if (std::any_of(
            corners->begin(), corners->end(), [&touched](vtkIdType p) { return touched[p]; }))
      {
        this->Cells.push_back(cell);
        this->Points.insert(this->Points.end(), corners->begin(), corners->end());
        this->Ghosts->InsertNextValue(
          slabOfCell[cell] == slab ? 0 : vtkDataSetAttributes::DUPLICATECELL);
      }
    }
    this->Ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
    std::sort(this->Points.begin(), this->Points.end(), std::greater<vtkIdType>());
    this->Points.erase(std::unique(this->Points.begin(), this->Points.end()), this->Points.end());
    for (std::size_t i = 0; i < this->Points.size(); ++i)
    {
      this->NewIds[this->Points[i]] = static_cast<vtkIdType>(i);
    }
  }

  vtkSmartPointer<vtkUnstructuredGrid> Make(const char* array) const
  {
    auto piece = vtkSmartPointer<vtkUnstructuredGrid>::New();
    vtkNew<vtkPoints> points;
    points->SetDataType(this->Source->GetPoints()->GetDataType());
    vtkNew<vtkIdTypeArray> globalIds;
    vtkDataArray* sourceIds = this->Source->GetPointData()->GetGlobalIds();
    globalIds->SetName(sourceIds->GetName());
    vtkDataArray* values = this->Source->GetPointData()->GetArray(array);
    auto pieceValues = vtkSmartPointer<vtkDataArray>::Take(values->NewInstance());
    pieceValues->SetName(array);
    for (vtkIdType point : this->Points)
    {
      points->InsertNextPoint(this->Source->GetPoint(point));
      globalIds->InsertNextValue(static_cast<vtkIdType>(sourceIds->GetTuple1(point)));
      pieceValues->InsertNextTuple(point, values);
    }
    piece->SetPoints(points);
    piece->GetPointData()->SetGlobalIds(globalIds);
    piece->GetPointData()->SetScalars(pieceValues);

    piece->AllocateEstimate(static_cast<vtkIdType>(this->Cells.size()), 8);
    vtkNew<vtkIdList> corners;
    for (vtkIdType cell : this->Cells)
    {
      this->Source->GetCellPoints(cell, corners);
      std::transform(corners->begin(), corners->end(), corners->begin(),
        [this](vtkIdType point) { return this->NewIds[point]; });
      piece->InsertNextCell(this->Source->GetCellType(cell), corners);
    }
    piece->GetCellData()->AddArray(this->Ghosts);
    return piece;
  }

private:
  vtkUnstructuredGrid* Source;
  std::vector<vtkIdType> Cells;
  std::vector<vtkIdType> Points; // in the order they get
  std::vector<vtkIdType> NewIds;
  vtkNew<vtkUnsignedCharArray> Ghosts;
};

// The name of an array's type in an XML file, for the types that a piece has.
std::string TypeName(vtkDataArray* array)
{
  const std::string kind = array->GetDataType() == VTK_FLOAT || array->GetDataType() == VTK_DOUBLE
    ? "Float"
    : (array->GetDataType() == VTK_UNSIGNED_CHAR ? "UInt" : "Int");
  return kind + std::to_string(8 * array->GetDataTypeSize());
}

void WriteArray(std::ostream& os, vtkDataArray* array, int components = 1)
{
  os << "<PDataArray type=\"" << TypeName(array) << "\" Name=\"" << array->GetName()
     << "\" NumberOfComponents=\"" << components << "\""
     << (array->GetDataType() == VTK_ID_TYPE ? " IdType=\"1\"" : "") << "/>\n";
}

std::string PieceName(const std::string& path, int piece)
{
  return path + "_" + std::to_string(piece) + ".vtu";
}

void WriteSummary(vtkUnstructuredGrid* piece, const char* array, int count, const std::string& path)
{
  vtkPointData* pointData = piece->GetPointData();
  std::ofstream os(path + ".pvtu");
  os << "<VTKFile type=\"PUnstructuredGrid\" version=\"1.0\">\n<PUnstructuredGrid>\n"
     << "<PPointData Scalars=\"" << array << "\" GlobalIds=\""
     << pointData->GetGlobalIds()->GetName() << "\">\n";
  WriteArray(os, pointData->GetArray(array));
  WriteArray(os, pointData->GetGlobalIds());
  os << "</PPointData>\n<PCellData>\n";
  WriteArray(os, piece->GetCellData()->GetArray(vtkDataSetAttributes::GhostArrayName()));
  os << "</PCellData>\n<PPoints>\n";
  piece->GetPoints()->GetData()->SetName("Points");
  WriteArray(os, piece->GetPoints()->GetData(), 3);
  os << "</PPoints>\n";
  for (int i = 0; i < count; ++i)
  {
    const std::string name = PieceName(path, i);
    os << "<Piece Source=\"" << name.substr(name.rfind('/') + 1) << "\"/>\n";
  }
  os << "</PUnstructuredGrid>\n</VTKFile>\n";
  if (!os.flush())
  {
    throw std::runtime_error("cannot write " + path + ".pvtu");
  }
}
}

void WritePieces(vtkUnstructuredGrid* grid, const char* array, int count, const std::string& path)
{
  const std::vector<int> slabOfCell = SlabOfCell(grid, count);
  for (int i = 0; i < count; ++i)
  {
    auto piece = Piece(grid, slabOfCell, i).Make(array);
    vtkNew<vtkXMLUnstructuredGridWriter> writer;
    writer->SetInputData(piece);
    writer->SetDataModeToBinary();
    writer->SetFileName(PieceName(path, i).c_str());
    if (writer->Write() != 1)
    {
      throw std::runtime_error("cannot write " + PieceName(path, i));
    }
    if (i == 0)
    {
      WriteSummary(piece, array, count, path);
    }
  }
}
