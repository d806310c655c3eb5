// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFlowBoundary.h"

#include "Common/AbortCheck.h"
#include "Common/CellArrayConversion.h"
#include "Common/Error.h"
#include "Common/ReportValue.h"
#include "Common/StageProgress.h"
#include "Common/Vectors.h"
#include "Fields/BoundaryPatches.h"
#include "Fields/FieldVectors.h"
#include "Fields/MergedDataSets.h"
#include "Fields/NonconformingInterfaces.h"
#include "Fields/UnstructuredFlowField.h"
#include "Numerics/SpeedScale.h"
#include "Samples/OutputPiece.h"

#include "vtkCell.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDataObject.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <unordered_map>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/vec3.hpp>

vtkStandardNewMacro(vtkFlowBoundary);

namespace
{
constexpr const char* VectorsName = "Vectors";

/// An outer face, its points in outward order, and the flow through it.
struct BoundaryFace
{
  vtkIdType Id = 0;
  int Size = 0;
  vtkIdType Points[4] = {};
  double Area = 0.0;
  double Rate = 0.0;
  int Direction = vtkFlowBoundary::NEITHER;
  int Region = -1;
};

/// Removes repeated points from a face with collapsed edges.
void RemoveRepeatedPoints(BoundaryFace& face)
{
  int size = 0;
  for (int i = 0; i < face.Size; ++i)
  {
    if (std::find(face.Points, face.Points + size, face.Points[i]) == face.Points + size)
    {
      face.Points[size++] = face.Points[i];
    }
  }
  face.Size = size;
}

struct BoundaryRegion
{
  int Direction;
  /// Index of its patch among the patches of the same direction.
  int Patch;
  double Rate = 0.0;
  double Area = 0.0;
};

/**
 * Finds the outer faces of a field and divides them into regions.
 */
class Boundary
{
public:
  Boundary(vtkUnstructuredGrid* grid, const interlume::UnstructuredFlowField& field)
    : Grid(grid)
    , Field(field)
    , Speed(field.GetSpeedScale() > 0.0 ? field.GetSpeedScale() : 1.0)
  {
    const double* bounds = field.GetBounds();
    this->Origin = { bounds[0], bounds[2], bounds[4] };
    const double length = interlume::Vectors::SafeLength(
      { bounds[1] - bounds[0], bounds[3] - bounds[2], bounds[5] - bounds[4] });
    this->Length = length > 0.0 ? length : 1.0;
  }

  /// \a minimumSpeed is MinimumNormalSpeed.
  void FindFaces(double minimumSpeed)
  {
    for (const vtkIdType id : this->Field.GetOuterFaces())
    {
      BoundaryFace face;
      face.Id = id;
      face.Size = this->Field.GetFacePoints(id, face.Points);
      RemoveRepeatedPoints(face);
      if (face.Size >= 3)
      {
        this->Measure(face, minimumSpeed);
        this->Faces.push_back(face);
      }
    }
  }

  void FindRegions()
  {
    for (const int direction : { vtkFlowBoundary::INFLOW, vtkFlowBoundary::OUTFLOW })
    {
      std::vector<vtkIdType> ids;
      for (const BoundaryFace& face : this->Faces)
      {
        if (face.Direction == direction)
        {
          ids.push_back(face.Id);
        }
      }
      interlume::BoundaryPatches& patches = this->Patches[direction > 0 ? 1 : 0];
      patches.Build(
        ids,
        [this](vtkIdType face, vtkIdType* points)
        { return this->Field.GetFacePoints(face, points); },
        this->Field.GetPositions());
      this->AddRegions(direction, patches);
    }
    this->SortRegions();
  }

  const std::vector<BoundaryFace>& GetFaces() const { return this->Faces; }
  const std::vector<BoundaryRegion>& GetRegions() const { return this->Regions; }
  vtkIdType GetNumberOfSkippedFaces() const { return this->SkippedFaces; }

  void GetParameters(int region, const double x[3], double uv[2]) const
  {
    const BoundaryRegion& found = this->Regions[static_cast<std::size_t>(region)];
    this->Patches[found.Direction > 0 ? 1 : 0].GetParameters(found.Patch, x, uv);
  }

private:
  glm::dvec3 GetCellCenter(vtkIdType cell)
  {
    this->Grid->GetCellPoints(cell, this->CellPoints);
    glm::dvec3 sum(0.0);
    for (vtkIdType i = 0; i < this->CellPoints->GetNumberOfIds(); ++i)
    {
      sum += this->GetPosition(this->CellPoints->GetId(i));
    }
    return sum / static_cast<double>(this->CellPoints->GetNumberOfIds());
  }

  /// Returns the position in units of the field's size, since squares of lengths could overflow.
  glm::dvec3 GetPosition(vtkIdType point) const
  {
    glm::dvec3 x;
    this->Field.GetPositions().Get<3>(point, glm::value_ptr(x));
    return (x - this->Origin) / this->Length;
  }

  bool IsUsable(const glm::dvec3& vector) const
  {
    const double speed = interlume::Vectors::SafeLength(vector);
    return std::isfinite(speed) &&
      (this->Field.GetFillValues().Number == 0 || speed <= this->Speed);
  }

  /// Orients a face outward and integrates over it: over triangles from its center to its edges.
  void Measure(BoundaryFace& face, double minimumSpeed)
  {
    glm::dvec3 corners[4];
    glm::dvec3 vectors[4];
    glm::dvec3 center(0.0);
    glm::dvec3 meanVector(0.0);
    bool isUsable = true;
    for (int i = 0; i < face.Size; ++i)
    {
      corners[i] = this->GetPosition(face.Points[i]);
      this->Field.GetVector(face.Points[i], glm::value_ptr(vectors[i]));
      isUsable = isUsable && this->IsUsable(vectors[i]);
      vectors[i] /= this->Speed;
      center += corners[i] / static_cast<double>(face.Size);
      meanVector += vectors[i] / static_cast<double>(face.Size);
    }
    glm::dvec3 area(0.0);
    for (int i = 0; i < face.Size; ++i)
    {
      const int next = (i + 1) % face.Size;
      const glm::dvec3 part = 0.5 * glm::cross(corners[i] - center, corners[next] - center);
      area += part;
      face.Area += glm::length(part);
      face.Rate += glm::dot(part, (meanVector + vectors[i] + vectors[next]) / 3.0);
    }
    if (glm::dot(area, center - this->GetCellCenter(face.Id / 8)) < 0.0)
    {
      std::reverse(face.Points, face.Points + face.Size);
      face.Rate = -face.Rate;
    }
    this->SkippedFaces += isUsable ? 0 : 1;
    face.Rate = isUsable ? face.Rate : 0.0;
    if (std::abs(face.Rate) > minimumSpeed * face.Area)
    {
      face.Direction = face.Rate > 0.0 ? vtkFlowBoundary::OUTFLOW : vtkFlowBoundary::INFLOW;
    }
    face.Rate = face.Rate * this->Length * this->Speed * this->Length;
    face.Area = face.Area * this->Length * this->Length;
  }

  void AddRegions(int direction, const interlume::BoundaryPatches& patches)
  {
    const auto first = static_cast<int>(this->Regions.size());
    for (int patch = 0; patch < patches.GetNumberOfPatches(); ++patch)
    {
      this->Regions.push_back({ direction, patch });
    }
    for (BoundaryFace& face : this->Faces)
    {
      if (face.Direction == direction)
      {
        face.Region = first + patches.Find(face.Id);
        BoundaryRegion& region = this->Regions[static_cast<std::size_t>(face.Region)];
        region.Rate += face.Rate;
        region.Area += face.Area;
      }
    }
  }

  void SortRegions()
  {
    std::vector<int> order(this->Regions.size());
    for (std::size_t i = 0; i < order.size(); ++i)
    {
      order[i] = static_cast<int>(i);
    }
    // Single precision, so that rounding does not decide between equal rates.
    const auto getKey = [this](int region)
    {
      const double rate = std::abs(this->Regions[static_cast<std::size_t>(region)].Rate);
      return static_cast<float>(rate / this->Length / this->Speed / this->Length);
    };
    std::stable_sort(
      order.begin(), order.end(), [&getKey](int a, int b) { return getKey(a) > getKey(b); });
    std::vector<BoundaryRegion> sorted;
    std::vector<int> numbers(order.size());
    for (const int i : order)
    {
      numbers[static_cast<std::size_t>(i)] = static_cast<int>(sorted.size());
      sorted.push_back(this->Regions[static_cast<std::size_t>(i)]);
    }
    this->Regions = sorted;
    for (BoundaryFace& face : this->Faces)
    {
      face.Region = face.Region < 0 ? -1 : numbers[static_cast<std::size_t>(face.Region)];
    }
  }

  vtkUnstructuredGrid* Grid;
  const interlume::UnstructuredFlowField& Field;
  glm::dvec3 Origin;
  double Length;
  double Speed;
  vtkNew<vtkIdList> CellPoints;
  std::vector<BoundaryFace> Faces;
  std::vector<BoundaryRegion> Regions;
  // Patches of inflow and outflow.
  std::array<interlume::BoundaryPatches, 2> Patches;
  vtkIdType SkippedFaces = 0;
};

/// Returns true if all points of a cell are in a plane. Such a cell has no inside.
bool IsFlat(vtkDataSet* data, vtkIdType cell, vtkIdList* ids)
{
  constexpr double tolerance = 1e-13;
  data->GetCellPoints(cell, ids);
  std::array<glm::dvec3, 8> edges;
  const auto number = static_cast<int>(std::min<vtkIdType>(ids->GetNumberOfIds(), 8));
  glm::dvec3 origin;
  double length = 0.0;
  for (int i = 0; i < number; ++i)
  {
    data->GetPoint(ids->GetId(i), glm::value_ptr(i == 0 ? origin : edges[i]));
    edges[i] = i == 0 ? glm::dvec3(0.0) : edges[i] - origin;
    length = std::max(length, interlume::Vectors::SafeLength(edges[i]));
  }
  for (int i = 1; i < number; ++i)
  {
    for (int j = i + 1; j < number; ++j)
    {
      const glm::dvec3 normal = glm::cross(edges[i] / length, edges[j] / length);
      for (int k = j + 1; k < number; ++k)
      {
        if (std::abs(glm::dot(normal, edges[k] / length)) > tolerance)
        {
          return false;
        }
      }
    }
  }
  return true;
}

/// Hides the cells that IsFlat() finds. The neighbors on both sides then share a face, since points
/// at the same position are merged.
void HideFlatCells(vtkDataSet* data, vtkDataSet* copy)
{
  vtkNew<vtkUnsignedCharArray> ghosts;
  if (vtkUnsignedCharArray* before = data->GetCellGhostArray())
  {
    ghosts->DeepCopy(before);
  }
  else
  {
    ghosts->SetNumberOfValues(data->GetNumberOfCells());
    ghosts->FillValue(0);
  }
  ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < data->GetNumberOfCells(); ++cell)
  {
    // Blanked cells of structured grids are of type VTK_EMPTY_CELL.
    const bool isFlat = data->GetCellType(cell) != VTK_EMPTY_CELL && IsFlat(data, cell, ids);
    ghosts->SetValue(cell,
      static_cast<unsigned char>(
        ghosts->GetValue(cell) | (isFlat ? vtkDataSetAttributes::HIDDENCELL : 0)));
  }
  copy->GetCellData()->AddArray(ghosts);
}

/// Returns the cells of a dataset, with only the vectors, which then have a name.
vtkSmartPointer<vtkUnstructuredGrid> MakeGrid(vtkDataSet* data, vtkDataArray* vectors)
{
  const auto copy = vtkSmartPointer<vtkDataSet>::Take(data->NewInstance());
  copy->CopyStructure(data);
  const auto named = vtkSmartPointer<vtkDataArray>::Take(vectors->NewInstance());
  named->ShallowCopy(vectors);
  named->SetName(VectorsName);
  copy->GetPointData()->AddArray(named);
  copy->GetPointData()->AddArray(data->GetPointGhostArray());
  HideFlatCells(data, copy);
  return interlume::MergedDataSets::Merge({ copy });
}

template <typename Array, typename Container, typename GetValue>
vtkSmartPointer<Array> MakeArray(const char* name, const Container& from, GetValue&& getValue)
{
  auto array = vtkSmartPointer<Array>::New();
  array->SetName(name);
  for (const auto& element : from)
  {
    array->InsertNextValue(getValue(element));
  }
  return array;
}

/// Writes the faces of one region, or all faces.
void Write(const Boundary& boundary, int region, vtkUnstructuredGrid* grid, const char* vectorsName,
  vtkPolyData* output)
{
  std::vector<BoundaryFace> faces = boundary.GetFaces();
  faces.erase(
    std::remove_if(faces.begin(), faces.end(),
      [region](const BoundaryFace& face) { return region >= 0 && face.Region != region; }),
    faces.end());
  vtkNew<vtkPoints> points;
  points->SetDataType(grid->GetPoints()->GetDataType());
  vtkNew<vtkDoubleArray> parameters;
  parameters->SetName("RegionUV");
  parameters->SetNumberOfComponents(2);
  vtkDataArray* from = grid->GetPointData()->GetArray(VectorsName);
  const auto vectors = vtkSmartPointer<vtkDataArray>::Take(from->NewInstance());
  vectors->SetNumberOfComponents(3);
  vectors->SetName(vectorsName);
  // New ids of the points of each region.
  std::unordered_map<int, std::unordered_map<vtkIdType, vtkIdType>> ids;
  vtkNew<vtkCellArray> polygons;
  for (const BoundaryFace& face : faces)
  {
    polygons->InsertNextCell(face.Size);
    for (int i = 0; i < face.Size; ++i)
    {
      const auto added = ids[face.Region].emplace(face.Points[i], points->GetNumberOfPoints());
      if (added.second)
      {
        double x[3];
        double uv[2] = { 0.0, 0.0 };
        grid->GetPoint(face.Points[i], x);
        if (face.Region >= 0)
        {
          boundary.GetParameters(face.Region, x, uv);
        }
        points->InsertNextPoint(x);
        parameters->InsertNextTuple(uv);
        vectors->InsertNextTuple(face.Points[i], from);
      }
      polygons->InsertCellPoint(added.first->second);
    }
  }
  output->SetPoints(points);
  output->SetPolys(polygons);
  output->GetPointData()->SetVectors(vectors);
  output->GetPointData()->SetTCoords(parameters);
  vtkCellData* cells = output->GetCellData();
  cells->SetScalars(MakeArray<vtkIntArray>(
    "FlowDirection", faces, [](const BoundaryFace& face) { return face.Direction; }));
  cells->AddArray(MakeArray<vtkDoubleArray>(
    "FlowRate", faces, [](const BoundaryFace& face) { return face.Rate; }));
  cells->AddArray(MakeArray<vtkIntArray>(
    "RegionId", faces, [](const BoundaryFace& face) { return face.Region; }));
  const std::vector<BoundaryRegion>& regions = boundary.GetRegions();
  output->GetFieldData()->AddArray(MakeArray<vtkDoubleArray>(
    "RegionFlowRate", regions, [](const BoundaryRegion& one) { return one.Rate; }));
  output->GetFieldData()->AddArray(MakeArray<vtkDoubleArray>(
    "RegionArea", regions, [](const BoundaryRegion& one) { return one.Area; }));
}

/// Warns about faces without usable vectors and about nonconforming faces.
void WarnOfField(vtkFlowBoundary* owner, const Boundary& boundary,
  const interlume::UnstructuredFlowField& field, vtkUnstructuredGrid* grid, const char* vectors)
{
  const interlume::FillValues& fill = field.GetFillValues();
  const vtkIdType nonFinite = field.GetNumberOfNonFiniteVectors();
  const std::string effect =
    std::to_string(boundary.GetNumberOfSkippedFaces()) + " faces count as faces without flow.";
  if (boundary.GetNumberOfSkippedFaces() > 0 && fill.Number > 0)
  {
    vtkWarningWithObjectMacro(owner, << fill.Describe(vectors, effect));
  }
  if (boundary.GetNumberOfSkippedFaces() > 0 && nonFinite > 0)
  {
    vtkWarningWithObjectMacro(owner, << interlume::DescribeNonFinite(nonFinite, vectors, effect));
  }
  const auto nonconforming = interlume::NonconformingInterfaces::Find(field);
  if (nonconforming.Number > 0)
  {
    double x[3];
    grid->GetPoint(grid->GetCell(nonconforming.FirstCell)->GetPointId(0), x);
    vtkWarningWithObjectMacro(owner,
      "The mesh of the field is nonconforming at "
        << nonconforming.Number << " cell faces, the first of them in a cell at (" << x[0] << ", "
        << x[1] << ", " << x[2] << "): the neighboring cell has no face with the same points. "
        << "These faces count as a part of the boundary.");
  }
}

void SetBoundaryReport(vtkInterlumeReport* report, const std::vector<BoundaryRegion>& regions = {},
  vtkIdType skipped = 0, const std::vector<std::string>& converted = {})
{
  vtkIdType numbers[2] = { 0, 0 };
  double rates[2] = { 0.0, 0.0 };
  for (const BoundaryRegion& region : regions)
  {
    ++numbers[region.Direction > 0 ? 1 : 0];
    rates[region.Direction > 0 ? 1 : 0] += std::abs(region.Rate);
  }
  interlume::ReportValue::Set(report,
    { { "InflowRegions", numbers[0] }, { "OutflowRegions", numbers[1] }, { "InflowRate", rates[0] },
      { "OutflowRate", rates[1] }, { "SkippedFaces", skipped },
      { "ConvertedCellArrays", converted } });
}
}

vtkFlowBoundary::vtkFlowBoundary()
{
  SetBoundaryReport(this->Report);
  this->SetInputArrayToProcess(
    0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, vtkDataSetAttributes::VECTORS);
}

vtkFlowBoundary::~vtkFlowBoundary() = default;

int vtkFlowBoundary::FillInputPortInformation(int, vtkInformation* info)
{
  interlume::FieldVectors::FillPortInformation(info);
  return 1;
}

int vtkFlowBoundary::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector*)
{
  interlume::OutputPiece::RequestEntireInput(inputs[0]->GetInformationObject(0));
  return 1;
}

int vtkFlowBoundary::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  SetBoundaryReport(this->Report);
  interlume::CellArrayConversion conversion(this, 3);
  const auto selection = interlume::FieldVectors::Select(this, conversion, inputs, outputs);
  const int piece =
    outputs->GetInformationObject(0)->Get(vtkStreamingDemandDrivenPipeline::UPDATE_PIECE_NUMBER());
  if (!selection.Data || piece > 0)
  {
    return 1;
  }
  this->SetProgressText("Finding the boundary");
  auto* vectors = vtkDataArray::SafeDownCast(selection.Array);
  const vtkSmartPointer<vtkUnstructuredGrid> grid = MakeGrid(selection.Data, vectors);
  interlume::UnstructuredFlowField field;
  const interlume::Error error = field.Build(grid, grid->GetPointData()->GetArray(VectorsName), {},
    interlume::StageProgress(this, 0.0, 0.8));
  if (error)
  {
    vtkErrorMacro(<< error.Within("Cannot use the input: ", "."));
    return 1;
  }
  if (this->GetAbortExecute())
  {
    return interlume::AbortCheck::Leave(outputs);
  }
  Boundary boundary(grid, field);
  boundary.FindFaces(this->MinimumNormalSpeed);
  boundary.FindRegions();
  const std::vector<BoundaryRegion>& regions = boundary.GetRegions();
  SetBoundaryReport(
    this->Report, regions, boundary.GetNumberOfSkippedFaces(), conversion.GetNames());
  const auto number = static_cast<int>(regions.size());
  if (this->Region >= number)
  {
    vtkErrorMacro("Region " << this->Region << " does not exist: the boundary has " << number
                            << " regions, numbered from 0. Use ALL (-1) to see them.");
    return 1;
  }
  Write(boundary, this->Region, grid, vectors->GetName(), output);
  WarnOfField(this, boundary, field, grid, vectors->GetName());
  if (regions.empty())
  {
    vtkWarningMacro("No flow passes through the boundary, which has "
      << boundary.GetFaces().size() << " faces: no face has a mean normal speed above "
      << this->MinimumNormalSpeed << " (MinimumNormalSpeed) of the largest speed, "
      << field.GetSpeedScale() << ".");
  }
  this->UpdateProgress(1.0);
  return 1;
}

void vtkFlowBoundary::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Region: " << this->Region << "\n";
  os << indent << "MinimumNormalSpeed: " << this->MinimumNormalSpeed << "\n";
  os << indent << "Report:\n";
  this->Report->PrintSelf(os, indent.GetNextIndent());
}
