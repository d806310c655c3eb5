// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTimeWeightedTetrahedraMapper.h"

#include "Common/ArrayCheck.h"
#include "Common/FiniteNumbers.h"
#include "Common/GridCheck.h"
#include "Draw/TetrahedraRenderer.h"
#include "Loader/SoftwareOpenGL.h"
#include "Offscreen/PeelingDeferral.h"
#include "Pieces/PieceExchange.h"

#include "vtkAlgorithmOutput.h"
#include "vtkBoundingBox.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkExecutive.h"
#include "vtkInformation.h"
#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPointData.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkTexture.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace
{
const char* const DELTA_T = "DeltaT";
/// Largest number of ids with a property or a texture: material 0 is for all other ids.
constexpr std::size_t MAXIMUM_BOUNDARY_IDS = 255;

/// Sets or removes the object of an id. Returns false if nothing changes.
template <typename Object>
bool SetById(std::map<int, vtkSmartPointer<Object>>& objects, int id, Object* object)
{
  if (!object)
  {
    return objects.erase(id) > 0;
  }
  vtkSmartPointer<Object>& entry = objects[id];
  const bool isNew = entry != object;
  entry = object;
  return isNew;
}

template <typename Object>
Object* GetById(const std::map<int, vtkSmartPointer<Object>>& objects, int id)
{
  const auto found = objects.find(id);
  return found == objects.end() ? nullptr : found->second.Get();
}

/// Sets the materials of the boundary triangles. Returns an error if their ids cannot be used; all
/// triangles then have the first material.
interlume::Error FindBoundaryMaterials(
  vtkTimeWeightedTetrahedraMapper* mapper, interlume::TetrahedraRenderer::Request& request)
{
  // Without texture coordinates, textures are ignored.
  const bool isTextured = request.Boundary && request.Boundary->GetPointData()->GetTCoords();
  const auto use = [isTextured](vtkTexture* texture) { return isTextured ? texture : nullptr; };
  request.BoundarySources = { { mapper->GetBoundaryProperty(),
    use(mapper->GetBoundaryTexture()) } };
  const std::vector<int> ids = mapper->GetBoundaryIds();
  const std::string name = mapper->GetBoundaryIdArrayName();
  if (!request.Boundary || name.empty() || ids.empty())
  {
    return {};
  }
  if (ids.size() > MAXIMUM_BOUNDARY_IDS)
  {
    return std::to_string(ids.size()) + " boundary ids have a property or a texture, but at most " +
      std::to_string(MAXIMUM_BOUNDARY_IDS) + " can have some; remove the others";
  }
  if (interlume::Error error =
        interlume::ArrayCheck::FindCellError(request.Boundary, "boundary", name, 1))
  {
    return error.Within("", " for the boundary ids");
  }
  request.BoundaryMaterials.Ids = request.Boundary->GetCellData()->GetArray(name.c_str());
  for (const int id : ids)
  {
    vtkProperty* property = mapper->GetBoundaryProperty(id);
    vtkTexture* texture = mapper->GetBoundaryTexture(id);
    request.BoundaryMaterials.Numbers[id] =
      static_cast<unsigned char>(request.BoundarySources.size());
    request.BoundarySources.push_back({ property ? property : mapper->GetBoundaryProperty(),
      use(texture ? texture : mapper->GetBoundaryTexture()) });
  }
  return {};
}
}

vtkStandardNewMacro(vtkTimeWeightedTetrahedraMapper);

vtkTimeWeightedTetrahedraMapper::vtkTimeWeightedTetrahedraMapper()
  : Peels(std::make_unique<interlume::PeelingDeferral>())
  , Renderer(std::make_unique<interlume::TetrahedraRenderer>())
{
  this->SetNumberOfInputPorts(2);
  this->BlendMode = AUTOMATIC_BLEND;
  this->BoundaryProperty = vtkSmartPointer<vtkProperty>::New();
  this->BoundaryProperty->SetOpacity(0.5);
  interlume::TetrahedraReport().CopyTo(this->Report);
}

vtkTimeWeightedTetrahedraMapper::~vtkTimeWeightedTetrahedraMapper() = default;

int vtkTimeWeightedTetrahedraMapper::FillInputPortInformation(int port, vtkInformation* info)
{
  if (port == 0)
  {
    info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkUnstructuredGrid");
    return 1;
  }
  info->Remove(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE());
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkUnstructuredGrid");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return 1;
}

void vtkTimeWeightedTetrahedraMapper::SetDeltaTArrayName(const char* name)
{
  const std::string text = name ? name : "";
  if (this->HasDeltaTArrayName != (name != nullptr) || this->DeltaTArrayName != text)
  {
    this->HasDeltaTArrayName = name != nullptr;
    this->DeltaTArrayName = text;
    this->Modified();
  }
}

const char* vtkTimeWeightedTetrahedraMapper::GetDeltaTArrayName() const
{
  return this->HasDeltaTArrayName ? this->DeltaTArrayName.c_str() : nullptr;
}

void vtkTimeWeightedTetrahedraMapper::SetLayerArrayName(const char* name)
{
  const std::string text = name ? name : "";
  if (this->LayerArrayName != text)
  {
    this->LayerArrayName = text;
    this->Modified();
  }
}

const char* vtkTimeWeightedTetrahedraMapper::GetLayerArrayName() const
{
  return this->LayerArrayName.c_str();
}

void vtkTimeWeightedTetrahedraMapper::SetLayerPriority(int layer, double priority)
{
  const auto found = this->LayerPriorities.find(layer);
  if (found == this->LayerPriorities.end() || found->second != priority)
  {
    this->LayerPriorities[layer] = priority;
    this->Modified();
  }
}

double vtkTimeWeightedTetrahedraMapper::GetLayerPriority(int layer) const
{
  const auto found = this->LayerPriorities.find(layer);
  return found == this->LayerPriorities.end() ? layer : found->second;
}

void vtkTimeWeightedTetrahedraMapper::RemoveAllLayerPriorities()
{
  if (!this->LayerPriorities.empty())
  {
    this->LayerPriorities.clear();
    this->Modified();
  }
}

void vtkTimeWeightedTetrahedraMapper::SetBoundaryData(vtkDataSet* triangles)
{
  this->SetInputDataInternal(1, triangles);
}

void vtkTimeWeightedTetrahedraMapper::SetBoundaryProperty(vtkProperty* property)
{
  if (property && property != this->BoundaryProperty)
  {
    this->BoundaryProperty = property;
    this->Modified();
  }
}

vtkProperty* vtkTimeWeightedTetrahedraMapper::GetBoundaryProperty() const
{
  return this->BoundaryProperty;
}

vtkCxxSetSmartPointerMacro(vtkTimeWeightedTetrahedraMapper, BoundaryTexture, vtkTexture);

vtkTexture* vtkTimeWeightedTetrahedraMapper::GetBoundaryTexture() const
{
  return this->BoundaryTexture;
}

void vtkTimeWeightedTetrahedraMapper::SetBoundaryIdArrayName(const char* name)
{
  const std::string text = name ? name : "";
  if (text != this->BoundaryIdArrayName)
  {
    this->BoundaryIdArrayName = text;
    this->Modified();
  }
}

void vtkTimeWeightedTetrahedraMapper::SetBoundaryProperty(int id, vtkProperty* property)
{
  if (SetById(this->BoundaryProperties, id, property))
  {
    this->Modified();
  }
}

vtkProperty* vtkTimeWeightedTetrahedraMapper::GetBoundaryProperty(int id) const
{
  return GetById(this->BoundaryProperties, id);
}

void vtkTimeWeightedTetrahedraMapper::SetBoundaryTexture(int id, vtkTexture* texture)
{
  if (SetById(this->BoundaryTextures, id, texture))
  {
    this->Modified();
  }
}

vtkTexture* vtkTimeWeightedTetrahedraMapper::GetBoundaryTexture(int id) const
{
  return GetById(this->BoundaryTextures, id);
}

void vtkTimeWeightedTetrahedraMapper::RemoveAllBoundaryIds()
{
  if (!this->BoundaryProperties.empty() || !this->BoundaryTextures.empty())
  {
    this->BoundaryProperties.clear();
    this->BoundaryTextures.clear();
    this->Modified();
  }
}

std::vector<int> vtkTimeWeightedTetrahedraMapper::GetBoundaryIds() const
{
  std::set<int> ids;
  for (const auto& entry : this->BoundaryProperties)
  {
    ids.insert(entry.first);
  }
  for (const auto& entry : this->BoundaryTextures)
  {
    ids.insert(entry.first);
  }
  return { ids.begin(), ids.end() };
}

void vtkTimeWeightedTetrahedraMapper::SetSelectionIds(vtkDataSet* ids)
{
  if (ids != this->SelectionIds)
  {
    this->SelectionIds = ids;
    this->Modified();
  }
}

vtkDataSet* vtkTimeWeightedTetrahedraMapper::GetSelectionIds() const
{
  return this->SelectionIds;
}

vtkMTimeType vtkTimeWeightedTetrahedraMapper::GetMTime()
{
  vtkMTimeType time = std::max(this->Superclass::GetMTime(), this->BoundaryProperty->GetMTime());
  for (const auto& entry : this->BoundaryProperties)
  {
    time = std::max(time, entry.second->GetMTime());
  }
  for (const auto& entry : this->BoundaryTextures)
  {
    time = std::max(time, entry.second->GetMTime());
  }
  return this->BoundaryTexture ? std::max(time, this->BoundaryTexture->GetMTime()) : time;
}

interlume::Error vtkTimeWeightedTetrahedraMapper::FindArrays(
  vtkUnstructuredGrid* grid, interlume::TetrahedraArrays& arrays)
{
  int cellFlag = 0;
  arrays.Scalars = vtkAbstractMapper::GetScalars(
    grid, this->ScalarMode, this->ArrayAccessMode, this->ArrayId, this->ArrayName, cellFlag);
  if (!arrays.Scalars)
  {
    return this->ArrayAccessMode == VTK_GET_ARRAY_BY_NAME && this->ArrayName && *this->ArrayName
      ? std::string("the input has no array \"") + this->ArrayName +
        "\" to color by; select an existing point or cell array with SelectScalarArray"
      : std::string(
          "the input has no scalars to color by; set active scalars or select an array with "
          "SelectScalarArray");
  }
  arrays.HasCellScalars = arrays.Scalars->GetNumberOfTuples() == grid->GetNumberOfCells() &&
    (cellFlag == 1 || this->ScalarMode == VTK_SCALAR_MODE_USE_CELL_FIELD_DATA);
  const std::string extent = this->HasDeltaTArrayName ? this->DeltaTArrayName : DELTA_T;
  arrays.DeltaT = grid->GetPointData()->GetArray(extent.c_str());
  const bool hasExtent = !extent.empty() && (this->HasDeltaTArrayName || arrays.DeltaT);
  const bool hasLayers = this->BlendMode == PRIORITY_BLEND;
  arrays.Layers = hasLayers ? grid->GetCellData()->GetArray(this->LayerArrayName.c_str()) : nullptr;
  using interlume::Error;
  namespace ArrayCheck = interlume::ArrayCheck;
  for (const Error& error :
    { arrays.HasCellScalars ? Error() : ArrayCheck::FindPointError(grid, arrays.Scalars, 0),
      hasExtent
        ? ArrayCheck::FindPointError(grid, "input", extent, 1).Within("", " for the extent in time")
        : Error(),
      hasLayers ? ArrayCheck::FindCellError(grid, "input", this->LayerArrayName, 0)
                    .Within("", " for layers")
                : Error() })
  {
    if (error)
    {
      return error;
    }
  }
  return interlume::GridCheck::FindError(grid);
}

bool vtkTimeWeightedTetrahedraMapper::HasExtentInTime(vtkDataSet* data) const
{
  const std::string extent = this->HasDeltaTArrayName ? this->DeltaTArrayName : DELTA_T;
  return data && !extent.empty() && data->GetPointData()->HasArray(extent.c_str());
}

bool vtkTimeWeightedTetrahedraMapper::DrawsInSoftware(vtkRenderWindow* window) const
{
  auto* openGL = vtkOpenGLRenderWindow::SafeDownCast(window);
  if (this->RenderPath != AUTOMATIC_PATH || !openGL)
  {
    return this->RenderPath == SOFTWARE_PATH;
  }
  // Before the first image is rendered, the window has no context to query.
  openGL->Initialize();
  return interlume::SoftwareOpenGL::IsUsed(openGL);
}

bool vtkTimeWeightedTetrahedraMapper::GatherPieces(
  vtkMultiProcessController* controller, vtkRenderWindow* window)
{
  this->Pieces.reset();
  if (!controller || controller->GetNumberOfProcesses() < 2)
  {
    return false;
  }
  // The elements are the six bounds of the partition, then 1 if it has an extent in time, otherwise
  // 0, and then 1 if it is drawn with OpenGL, otherwise 0.
  constexpr double none = std::numeric_limits<double>::max();
  std::array<double, 8> own{ { none, -none, none, -none, none, -none,
    this->HasExtentInTime(this->GetDataSetInput()) ? 1.0 : 0.0,
    this->DrawsInSoftware(window) ? 0.0 : 1.0 } };
  if (this->GetInput() && this->GetInput()->GetNumberOfCells() > 0)
  {
    std::copy_n(this->GetOwnBounds(), 6, own.begin());
  }
  std::vector<std::array<double, 8>> all(
    static_cast<std::size_t>(controller->GetNumberOfProcesses()));
  controller->AllGather(own.data(), all.data()->data(), 8);
  std::vector<interlume::PieceOrder::Box> boxes;
  vtkBoundingBox allBounds;
  bool isInTime = false;
  bool usesOpenGL = false;
  for (const std::array<double, 8>& piece : all)
  {
    interlume::PieceOrder::Box box;
    std::copy_n(piece.begin(), 6, box.begin());
    boxes.push_back(box);
    allBounds.AddBox(vtkBoundingBox(box.data()));
    isInTime = isInTime || piece[6] > 0.0;
    usesOpenGL = usesOpenGL || piece[7] > 0.0;
  }
  if (!allBounds.IsValid())
  {
    return false;
  }
  int blend = this->BlendMode;
  if (blend == AUTOMATIC_BLEND)
  {
    blend = isInTime ? static_cast<int>(OPTICAL_DEPTH_BLEND) : static_cast<int>(COMPOSITE_BLEND);
  }
  std::unique_ptr<interlume::PieceOrder> order;
  if (blend == COMPOSITE_BLEND)
  {
    order = std::make_unique<interlume::PieceOrder>(boxes);
    if (isInTime || usesOpenGL || !order->IsPossible())
    {
      return false;
    }
  }
  std::array<double, 6> bounds{};
  allBounds.GetBounds(bounds.data());
  this->Pieces =
    std::make_unique<interlume::PieceExchange>(controller, blend, bounds, std::move(order));
  return true;
}

double* vtkTimeWeightedTetrahedraMapper::GetOwnBounds()
{
  double* const bounds = this->Superclass::GetBounds();
  auto* input = vtkPointSet::SafeDownCast(this->GetDataSetInput());
  if (input && input->GetPoints() && !interlume::FiniteNumbers::AreFinite(bounds, 6))
  {
    // The superclass includes points at infinity, but they are not drawn.
    vtkBoundingBox box;
    for (vtkIdType p = 0; p < input->GetNumberOfPoints(); ++p)
    {
      double x[3];
      input->GetPoint(p, x);
      if (interlume::FiniteNumbers::AreFinite(x, 3))
      {
        box.AddPoint(x);
      }
    }
    box.GetBounds(bounds);
  }
  return bounds;
}

double* vtkTimeWeightedTetrahedraMapper::GetBounds()
{
  if (!this->Pieces)
  {
    return this->GetOwnBounds();
  }
  std::copy(this->Pieces->GetBounds().begin(), this->Pieces->GetBounds().end(), this->Bounds);
  return this->Bounds;
}

bool vtkTimeWeightedTetrahedraMapper::GetRefinementPending() const
{
  return this->Renderer->IsRefinementPending();
}

void vtkTimeWeightedTetrahedraMapper::Render(vtkRenderer* renderer, vtkVolume* volume)
{
  if (this->Peels->Defer(this, renderer, volume))
  {
    return;
  }
  auto* grid = vtkUnstructuredGrid::SafeDownCast(this->GetInput());
  int width = 0;
  int height = 0;
  int left = 0;
  int bottom = 0;
  renderer->GetTiledSizeAndOrigin(&width, &height, &left, &bottom);
  interlume::TetrahedraReport report;
  report.CopyTo(this->Report);
  const bool hasGrid = grid && grid->GetNumberOfCells() > 0;
  interlume::TetrahedraRenderer::Request request;
  request.Mapper = this;
  request.Pieces = renderer->GetSelector() ? nullptr : this->Pieces.get();
  if ((!hasGrid && !request.Pieces) || width <= 0 || height <= 0)
  {
    return;
  }
  request.Boundary = vtkDataSet::SafeDownCast(
    this->GetNumberOfInputConnections(1) > 0 ? this->GetExecutive()->GetInputData(1, 0) : nullptr);
  interlume::Error error = hasGrid ? this->FindArrays(grid, request.Arrays) : interlume::Error();
  request.Grid = hasGrid && !error ? grid : nullptr;
  error = error ? error : FindBoundaryMaterials(this, request);
  // Other processes wait for this one, so it must participate even if its partition has an error.
  if (request.Grid || request.Pieces)
  {
    const interlume::Error drawing = this->Renderer->Render(renderer, volume, request, report);
    error = error ? error : drawing;
  }
  report.CopyTo(this->Report);
  this->TimeToDraw = report.Seconds;
  // Report a message once for each state of the inputs and the mapper, not for every image.
  const vtkMTimeType state = std::max({ grid ? grid->GetMTime() : 0,
    request.Boundary ? request.Boundary->GetMTime() : 0, this->GetMTime() });
  if (error && state != this->MessageTime)
  {
    vtkErrorMacro(<< error);
  }
  const bool isUnmatched = report.BoundaryTriangles == 0 && report.UnmatchedTriangles > 0;
  if (isUnmatched && !request.Pieces && state != this->MessageTime)
  {
    vtkWarningMacro("None of the " << report.UnmatchedTriangles
                                   << " boundary triangles is a face of a tetrahedron. Pass the "
                                      "boundary that was extracted together with the tetrahedra.");
  }
  this->MessageTime = state;
}

void vtkTimeWeightedTetrahedraMapper::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Renderer->ReleaseGraphicsResources(window);
  this->Superclass::ReleaseGraphicsResources(window);
}

void vtkTimeWeightedTetrahedraMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "IntegrationMode: " << this->IntegrationMode << "\n";
  os << indent << "SortMode: " << this->SortMode << "\n";
  os << indent << "RenderPath: " << this->RenderPath << "\n";
  os << indent << "SilhouetteShader: " << this->SilhouetteShader << "\n";
  os << indent
     << "DeltaTArrayName: " << (this->HasDeltaTArrayName ? this->DeltaTArrayName.c_str() : "(none)")
     << "\n";
  os << indent << "LayerArrayName: " << this->LayerArrayName << "\n";
  os << indent << "LayerPriorities: " << this->LayerPriorities.size() << "\n";
  for (const auto& layer : this->LayerPriorities)
  {
    os << indent.GetNextIndent() << "LayerPriority " << layer.first << ": " << layer.second << "\n";
  }
  os << indent << "BoundaryProperty:\n";
  this->BoundaryProperty->PrintSelf(os, indent.GetNextIndent());
  os << indent << "BoundaryTexture: " << this->BoundaryTexture.Get() << "\n";
  os << indent << "BoundaryIdArrayName: " << this->BoundaryIdArrayName << "\n";
  os << indent << "BoundaryIds: " << this->GetBoundaryIds().size() << "\n";
  os << indent << "SelectionIds: " << this->SelectionIds.Get() << "\n";
  os << indent << "AutoAdjustLevelOfDetail: " << this->AutoAdjustLevelOfDetail << "\n";
  os << indent << "ProgressiveRendering: " << this->ProgressiveRendering << "\n";
  os << indent << "Processes: " << (this->Pieces ? this->Pieces->GetNumberOfRanks() : 1) << "\n";
  os << indent << "Report:\n";
  this->Report->PrintSelf(os, indent.GetNextIndent());
}
