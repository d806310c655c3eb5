// SPDX-License-Identifier: BSD-3-Clause
#include "Draw/TetrahedraRenderer.h"

#include "Draw/PieceImage.h"
#include "Loader/OpenGLFunctions.h"
#include "Loader/SoftwareOpenGL.h"
#include "Offscreen/ImageQuad.h"
#include "Offscreen/SceneDepth.h"
#include "OpenGL/OpenGLRasterizer.h"
#include "OpenGL/TetrahedraSelection.h"
#include "Pieces/PieceExchange.h"

#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkHardwareSelector.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkSMPTools.h"
#include "vtkTexture.h"
#include "vtkTimeWeightedTetrahedraMapper.h"
#include "vtkTimerLog.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace interlume
{

using Mapper = vtkTimeWeightedTetrahedraMapper;

namespace
{
/// With more tetrahedra, MPVONC sorting takes longer than drawing.
constexpr std::uint32_t MPVONC_LIMIT = 1000000;

TetrahedraFrame::Blends GetBlend(int mode)
{
  switch (mode)
  {
    case Mapper::MAXIMUM_INTENSITY_BLEND:
      return TetrahedraFrame::MAXIMUM;
    case Mapper::ADDITIVE_BLEND:
      return TetrahedraFrame::ADDITIVE;
    case Mapper::PRIORITY_BLEND:
      return TetrahedraFrame::PRIORITY;
    case Mapper::OPTICAL_DEPTH_BLEND:
      return TetrahedraFrame::OPTICAL_DEPTH;
    default:
      return TetrahedraFrame::COMPOSITE;
  }
}
}

/// State from which the last image of the software path was drawn.
struct TetrahedraRenderer::DrawnState
{
  TetrahedraFrame Frame;
  /// If true, the image combines the partitions of several processes, and Opaque is the depth of
  /// this process's surfaces.
  bool IsPiece = false;
  std::vector<float> Opaque;
  /// Ranks of the processes, from front to back; empty if the blend mode needs no order.
  std::vector<int> PieceOrder;

  bool operator==(const DrawnState& other) const
  {
    return this->Frame.HasSameImage(other.Frame) && this->IsPiece == other.IsPiece &&
      this->Opaque == other.Opaque && this->PieceOrder == other.PieceOrder;
  }
};

struct TetrahedraRenderer::WindowResources
{
  ImageQuad Quad;
  OpenGLRasterizer Rasterizer;
  std::optional<DrawnState> Drawn;
  vtkIdType NumberDrawn = 0;
};

TetrahedraRenderer::TetrahedraRenderer() = default;

TetrahedraRenderer::~TetrahedraRenderer() = default;

Error TetrahedraRenderer::UpdateMesh(const Request& request, TetrahedraReport& report)
{
  const MeshKey& before = this->MeshState;
  const TetrahedraArrays& arrays = request.Arrays;
  const bool isSame = before.Grid == request.Grid && before.Time == request.Grid->GetMTime() &&
    before.Arrays == arrays;
  if (isSame)
  {
    return {};
  }
  report.ValuesUpdated = true;
  report.MeshRebuilt = !before.Grid || !this->MeshBuilder.IsSame(request.Grid, arrays, this->Mesh);
  this->MeshState = MeshKey();
  this->Property = nullptr;
  if (report.MeshRebuilt)
  {
    this->Boundary = nullptr;
    BoundaryFaces::Clear(this->Fields);
    this->Order.Reset();
    this->LevelOfDetail.Reset();
    if (Error error = this->MeshBuilder.Build(request.Grid, arrays, this->Mesh))
    {
      return error;
    }
    ++this->Frame.Versions.Mesh;
  }
  const std::vector<int> layers = this->Fields.Layers;
  TetrahedraBuilder::BuildDeltaTAndLayers(arrays, this->Mesh, this->Fields);
  if (layers != this->Fields.Layers)
  {
    this->Order.ResetLayers();
  }
  this->MeshState = { request.Grid, request.Grid->GetMTime(), arrays };
  ++this->Frame.Versions.Values;
  return {};
}

Error TetrahedraRenderer::UpdateColors(
  const Request& request, vtkVolumeProperty* property, double unit)
{
  if (this->Property == property && this->PropertyTime == property->GetMTime() &&
    this->ColorUnit == unit)
  {
    return {};
  }
  const std::vector<float> scalars = std::move(this->Fields.Scalars);
  if (Error error =
        TetrahedraBuilder::BuildColors(request.Arrays, this->Mesh, property, unit, this->Fields))
  {
    return error;
  }
  // The property may select a different scalar component.
  this->Frame.Versions.Values += scalars == this->Fields.Scalars ? 0 : 1;
  if (this->Fields.Kind == TetrahedraFields::SCALARS)
  {
    this->Pieces.Build(property, 0, this->Fields.Range, unit);
  }
  this->Property = property;
  this->PropertyTime = property->GetMTime();
  this->ColorUnit = unit;
  this->HasOneColor = this->HasSingleColor();
  ++this->Frame.Versions.Colors;
  return {};
}

bool TetrahedraRenderer::HasSingleColor() const
{
  if (this->Fields.Kind == TetrahedraFields::SCALARS)
  {
    return this->Pieces.HasConstantColor();
  }
  const auto& colors = this->Fields.Colors;
  return std::all_of(colors.begin(), colors.end(),
    [&colors](const std::array<float, 4>& color)
    { return std::equal(color.begin(), color.begin() + 3, colors[0].begin()); });
}

void TetrahedraRenderer::ChooseBlend(const Request& request, TetrahedraReport& report)
{
  report.BlendMode = request.Mapper->GetBlendMode();
  report.BlendReason = "set by the user";
  if (request.Mapper->GetBlendMode() == Mapper::AUTOMATIC_BLEND)
  {
    const bool hasTime = request.Pieces ? request.Pieces->GetBlend() == Mapper::OPTICAL_DEPTH_BLEND
                                        : request.Arrays.DeltaT != nullptr;
    report.BlendMode = hasTime ? static_cast<int>(Mapper::OPTICAL_DEPTH_BLEND)
                               : static_cast<int>(Mapper::COMPOSITE_BLEND);
    report.BlendReason = hasTime
      ? "tetrahedra with an extent in time overlap and have no visibility order"
      : "tetrahedra without an extent in time have a visibility order";
  }
}

void TetrahedraRenderer::ChooseRenderPath(
  const Request& request, vtkOpenGLRenderWindow* window, TetrahedraReport& report)
{
  report.RenderPath = request.Mapper->GetRenderPath();
  report.PathReason = "set by the user";
  if (request.Mapper->GetRenderPath() == Mapper::AUTOMATIC_PATH)
  {
    const bool isSoftware = SoftwareOpenGL::IsUsed(window);
    report.RenderPath = isSoftware ? Mapper::SOFTWARE_PATH : Mapper::OPENGL_PATH;
    report.PathReason = isSoftware ? "OpenGL is a software implementation" : "OpenGL runs on a GPU";
  }
}

void TetrahedraRenderer::ChooseShader(
  const Request& request, vtkOpenGLRenderWindow* window, TetrahedraReport& report)
{
  this->Frame.IsPulled = false;
  if (report.RenderPath != Mapper::OPENGL_PATH)
  {
    return;
  }
  report.SilhouetteShader = request.Mapper->GetSilhouetteShader();
  report.ShaderReason = "set by the user";
  if (request.Mapper->GetSilhouetteShader() == Mapper::AUTOMATIC_SHADER)
  {
    const bool isSoftware = SoftwareOpenGL::IsUsed(window);
    report.SilhouetteShader = isSoftware ? Mapper::GEOMETRY_SHADER : Mapper::VERTEX_SHADER;
    report.ShaderReason =
      isSoftware ? "OpenGL is a software implementation" : "many GPUs have slow geometry shaders";
  }
  this->Frame.IsPulled = report.SilhouetteShader == Mapper::VERTEX_SHADER;
}

void TetrahedraRenderer::ChooseSort(const Request& request, TetrahedraReport& report)
{
  report.SortMode = Mapper::NO_SORT;
  if (report.BlendMode != Mapper::COMPOSITE_BLEND)
  {
    report.SortReason = "the blend mode needs no order";
  }
  else if (request.Mapper->GetSortMode() != Mapper::AUTOMATIC_SORT)
  {
    report.SortMode = request.Mapper->GetSortMode();
    report.SortReason = "set by the user";
  }
  else if (!this->Frame.Surface && this->HasOneColor)
  {
    report.SortReason = "there is a single color";
  }
  else if (request.Arrays.DeltaT)
  {
    report.SortMode = Mapper::CENTROID_SORT;
    report.SortReason = "tetrahedra with an extent in time overlap";
  }
  else if (this->Mesh.GetNumberOfTetrahedra() > MPVONC_LIMIT)
  {
    report.SortMode = Mapper::CENTROID_SORT;
    report.SortReason = "there are more than " + std::to_string(MPVONC_LIMIT) + " tetrahedra";
  }
  else
  {
    report.SortMode = Mapper::MPVONC_SORT;
    report.SortReason =
      "colors differ, and there are at most " + std::to_string(MPVONC_LIMIT) + " tetrahedra";
  }
}

const std::vector<std::uint32_t>* TetrahedraRenderer::UpdateOrder(
  const Request& request, TetrahedraReport& report)
{
  const std::vector<std::uint32_t>* order = nullptr;
  report.Passes = 1;
  if (report.BlendMode == Mapper::PRIORITY_BLEND)
  {
    order =
      this->Order.ComputeLayerOrder(this->Fields.Layers, request.Mapper->GetLayerPriorities());
    report.Layers = this->Order.GetNumberOfLayers();
    report.Passes = report.Layers;
  }
  else
  {
    const auto kind = report.SortMode == Mapper::CENTROID_SORT ? TetrahedraOrder::CENTROID
      : report.SortMode == Mapper::MPVONC_SORT                 ? TetrahedraOrder::VISIBILITY
                                                               : TetrahedraOrder::NONE;
    order = this->Order.Compute(kind, this->Mesh, this->Frame.View);
    report.Sorted = this->Order.WasComputed();
  }
  this->Frame.Versions.Order += this->Order.WasComputed() ? 1 : 0;
  if (report.SortMode == Mapper::MPVONC_SORT)
  {
    report.Cycles = this->Order.GetCycles();
    report.Gaps = this->Order.GetGaps();
  }
  report.HasAdjacency = this->Order.HasAdjacency();
  return order;
}

int TetrahedraRenderer::ChooseLevel(
  vtkRenderer* renderer, vtkVolume* volume, const Request& request, TetrahedraReport& report)
{
  const std::array<int, 3> conditions{ { report.RenderPath, renderer->GetSize()[0],
    renderer->GetSize()[1] } };
  if (conditions != this->LevelConditions)
  {
    this->LevelOfDetail.Reset();
    this->LevelConditions = conditions;
  }
  const int level = request.Mapper->GetAutoAdjustLevelOfDetail() && !renderer->GetSelector()
    ? this->LevelOfDetail.Choose(
        volume->GetAllocatedRenderTime(), this->Mesh.GetNumberOfTetrahedra())
    : 0;
  report.PixelStride = interlume::LevelOfDetail::GetPixelStride(level);
  this->Frame.TetrahedronStride = interlume::LevelOfDetail::GetTetrahedronStride(level);
  report.TetrahedronStride = static_cast<int>(this->Frame.TetrahedronStride);
  return level;
}

Error TetrahedraRenderer::UpdateFrame(
  vtkRenderer* renderer, vtkVolume* volume, const Request& request, TetrahedraReport& report)
{
  if (Error error = this->Frame.View.Set(renderer, volume, this->Mesh, report.PixelStride))
  {
    return error;
  }
  vtkVolumeProperty* property = volume->GetProperty();
  this->Frame.ExtinctionUnit =
    this->Frame.View.GetUnit() / property->GetScalarOpacityUnitDistance();
  if (Error error = this->UpdateColors(request, property, this->Frame.ExtinctionUnit))
  {
    return error;
  }
  report.ControlPoints =
    this->Fields.Kind == TetrahedraFields::SCALARS ? this->Pieces.GetNumberOfPieces() + 1 : 0;
  this->UpdateBoundary(renderer, request, report);
  this->ChooseSort(request, report);
  if (Error error = this->ClipMesh(request, this->UpdateOrder(request, report)))
  {
    return error;
  }
  report.TetrahedraClipped = this->Clip.GetNumberOfClippedTetrahedra();

  this->Frame.Mesh = &this->Mesh;
  this->Frame.Fields = &this->Fields;
  this->Frame.Pieces = &this->Pieces;
  this->Frame.Blend = GetBlend(report.BlendMode);
  this->Frame.IsExact = request.Mapper->GetIntegrationMode() == Mapper::LINEAR_SEGMENT;
  this->Frame.PixelStride = report.PixelStride;
  return {};
}

Error TetrahedraRenderer::ClipMesh(const Request& request, const std::vector<std::uint32_t>* order)
{
  const TetrahedraView& view = this->Frame.View;
  std::vector<PlaneClip::Plane> planes{ view.GetNearPlane() };
  vtkPlaneCollection* clipping = request.Mapper->GetClippingPlanes();
  const int number = clipping ? clipping->GetNumberOfItems() : 0;
  for (int i = 0; i < number; ++i)
  {
    vtkPlane* plane = clipping->GetItem(i);
    planes.push_back(view.GetPlane(plane->GetNormal(), plane->GetOrigin()));
    if (!std::isfinite(planes.back().w))
    {
      return "clipping plane " + std::to_string(i) +
        " has a normal of length 0, or its normal or origin is not finite; correct the plane";
    }
  }
  this->Clip.Append(this->Mesh, this->Fields, planes, view.GetRays().Viewpoint, order);
  this->Frame.Order = this->Clip.IsActive() ? &this->Clip.GetOrder() : order;
  this->Frame.Planes = this->Clip.GetPlanes();
  return {};
}

void TetrahedraRenderer::DrawFrame(
  vtkRenderer* renderer, vtkVolume* volume, WindowResources& resources, TetrahedraReport& report)
{
  if (report.RenderPath == Mapper::OPENGL_PATH)
  {
    auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
    if (const Error error =
          resources.Rasterizer.FindError(window, this->Frame)
            .Then([&] { return this->DrawWithOpenGL(renderer, volume, resources, report); }))
    {
      report.RenderPath = Mapper::SOFTWARE_PATH;
      report.PathReason = error.GetMessage();
      report.SilhouetteShader = 0;
      report.ShaderReason.clear();
    }
  }
  if (report.RenderPath == Mapper::SOFTWARE_PATH)
  {
    this->DrawInSoftware(renderer, resources, report);
  }
}

TetrahedraRenderer::WindowResources& TetrahedraRenderer::GetResources(vtkWindow* window)
{
  std::unique_ptr<WindowResources>& resources = this->Windows[window];
  if (!resources)
  {
    resources = std::make_unique<WindowResources>();
  }
  return *resources;
}

void TetrahedraRenderer::CountTetrahedra(const Request& request, TetrahedraReport& report) const
{
  report.Tetrahedra = request.Grid->GetNumberOfCells();
  report.FlatTetrahedra = this->MeshBuilder.GetNumberOfFlatTetrahedra();
  report.NonFiniteTetrahedra = this->MeshBuilder.GetNumberOfNonFiniteTetrahedra();
}

Error TetrahedraRenderer::Render(
  vtkRenderer* renderer, vtkVolume* volume, const Request& request, TetrahedraReport& report)
{
  const double start = vtkTimerLog::GetUniversalTime();
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  if (!window)
  {
    return { "the render window is not a vtkOpenGLRenderWindow; use an OpenGL window",
      ErrorCode::OpenGL };
  }
  if (request.Pieces)
  {
    Error error = this->RenderPieces(renderer, volume, request, *window, report);
    this->Clip.Remove(this->Mesh, this->Fields);
    report.Seconds = vtkTimerLog::GetUniversalTime() - start;
    report.MemoryBytes = this->GetMemoryBytes();
    return error;
  }
  Error error = this->UpdateMesh(request, report);
  this->CountTetrahedra(request, report);
  if (error || this->Mesh.Corners.empty())
  {
    return error;
  }
  this->ChooseBlend(request, report);
  this->ChooseRenderPath(request, window, report);
  this->ChooseShader(request, window, report);
  const int level = this->ChooseLevel(renderer, volume, request, report);
  error = this->UpdateFrame(renderer, volume, request, report);
  if (error)
  {
    return error;
  }
  WindowResources& resources = this->GetResources(window);
  vtkHardwareSelector* selector = renderer->GetSelector();
  if (selector)
  {
    this->Select(renderer, selector, resources);
  }
  else
  {
    this->DrawFrame(renderer, volume, resources, report);
  }
  this->Clip.Remove(this->Mesh, this->Fields);
  if (selector)
  {
    return {};
  }
  if (request.Mapper->GetAutoAdjustLevelOfDetail() && report.RenderPath == Mapper::OPENGL_PATH)
  {
    // OpenGL is asynchronous. Wait, because the level of detail depends on the time until drawing
    // is complete.
    glFinish();
  }
  report.Seconds = vtkTimerLog::GetUniversalTime() - start;
  this->LevelOfDetail.AddMeasurement(level, report.Seconds);
  report.MemoryBytes = this->GetMemoryBytes();
  return {};
}

Error TetrahedraRenderer::DrawWithOpenGL(
  vtkRenderer* renderer, vtkVolume* volume, WindowResources& resources, TetrahedraReport& report)
{
  Error error = resources.Rasterizer.Draw(renderer, this->Frame,
    SceneDepth::MayOcclude(renderer, volume) || this->IsCutByFarPlane(), report);
  report.TetrahedraDrawn = static_cast<vtkIdType>(
    this->Frame.Order ? this->Frame.Order->size() : this->Mesh.GetNumberOfTetrahedra());
  return error;
}

void TetrahedraRenderer::DrawInSoftware(
  vtkRenderer* renderer, WindowResources& resources, TetrahedraReport& report)
{
  this->ReadDepth(renderer);
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  report.Features = this->GetFeatures();
  const DrawnState state = { this->Frame, false, this->Depth.GetDepths(), {} };
  // Reuse the image if neither the camera nor the scene changed.
  if (!(resources.Drawn == state))
  {
    const auto isAborted = [window]() { return window->CheckAbortStatus() != 0; };
    if (!this->Rasterizer.Draw(this->Frame, isAborted))
    {
      return;
    }
    report.UploadedImageBytes = resources.Quad.Upload(window, this->Frame.View.GetWidth(),
      this->Frame.View.GetHeight(), this->Rasterizer.GetColors());
    resources.Drawn = state;
    resources.NumberDrawn = this->Rasterizer.GetNumberOfDrawnTetrahedra();
  }
  report.TetrahedraDrawn = resources.NumberDrawn;
  report.Buffers = 1;
  report.BufferBytes =
    16 * static_cast<vtkIdType>(this->Frame.View.GetWidth()) * this->Frame.View.GetHeight();
  resources.Quad.Draw(window);
}

Error TetrahedraRenderer::UpdatePiece(
  vtkRenderer* renderer, vtkVolume* volume, const Request& request, TetrahedraReport& report)
{
  if (!request.Grid)
  {
    return {};
  }
  Error error = this->UpdateMesh(request, report);
  this->CountTetrahedra(request, report);
  if (error || this->Mesh.Corners.empty())
  {
    return error;
  }
  this->Frame.TetrahedronStride = 1;
  return this->UpdateFrame(renderer, volume, request, report);
}

std::vector<int> TetrahedraRenderer::FindPieceOrder(
  vtkRenderer* renderer, vtkVolume* volume, const PieceExchange& pieces)
{
  if (!pieces.GetOrder())
  {
    return {};
  }
  // Compute the order in one process, so that rounding cannot cause different orders.
  std::vector<int> order(static_cast<std::size_t>(pieces.GetNumberOfRanks()), 0);
  if (pieces.GetRank() == 0)
  {
    order = pieces.GetOrder()->Compute(TetrahedraView::FindEye(renderer, volume));
  }
  pieces.ReduceMax(order);
  return order;
}

Error TetrahedraRenderer::RenderPieces(vtkRenderer* renderer, vtkVolume* volume,
  const Request& request, vtkOpenGLRenderWindow& window, TetrahedraReport& report)
{
  const PieceExchange& pieces = *request.Pieces;
  WindowResources& resources = this->GetResources(&window);
  report.Processes = pieces.GetNumberOfRanks();
  report.RenderPath = Mapper::SOFTWARE_PATH;
  report.PathReason = "the images of several processes are combined on the CPU";
  this->ChooseBlend(request, report);
  const Error error = this->UpdatePiece(renderer, volume, request, report);
  const bool hasPiece = request.Grid && !error && !this->Mesh.Corners.empty();

  // Redraw in all processes if something changed in any of them.
  std::array<int, 2> size{ { 0, 0 } };
  std::array<int, 2> origin{ { 0, 0 } };
  renderer->GetTiledSizeAndOrigin(&size[0], &size[1], &origin[0], &origin[1]);
  const bool hasDepth = this->Depth.Read(renderer);
  DrawnState state;
  if (hasPiece)
  {
    state.Frame = this->Frame;
  }
  state.Frame.Blend = GetBlend(report.BlendMode);
  state.IsPiece = true;
  state.Opaque = this->Depth.GetBuffer();
  state.PieceOrder = FindPieceOrder(renderer, volume, pieces);
  std::vector<int> all{ resources.Drawn == state ? 0 : 1, hasDepth ? 1 : 0, size[0], size[1],
    -size[0], -size[1] };
  pieces.ReduceMax(all);
  if (all[2] != -all[4] || all[3] != -all[5])
  {
    return "the viewports of the processes have different sizes; use the same window and viewport "
           "size in all processes";
  }
  if (all[0] != 0)
  {
    const auto pixels = static_cast<std::size_t>(size[0]) * static_cast<std::size_t>(size[1]);
    std::vector<float> depths = this->Depth.GetBuffer();
    depths.resize(all[1] != 0 ? pixels : 0, 1.0f);
    const std::vector<bool> isShown = PieceImage::FindShownPixels(pieces, depths);
    this->Depth.SetBuffer(depths, size);
    if (hasPiece)
    {
      this->SetOpaqueDepth();
    }
    PieceImage image(pieces, hasPiece ? &this->Frame : nullptr, pixels, this->Rasterizer);
    std::vector<float> colors =
      image.Draw(state.Frame.Blend, request.Mapper->GetLayerPriorities(), state.PieceOrder);
    for (std::size_t p = 0; p < pixels; ++p)
    {
      if (isShown.empty() ? pieces.GetRank() != 0 : !isShown[p])
      {
        std::fill_n(colors.begin() + static_cast<std::ptrdiff_t>(4 * p), 4, 0.0f);
      }
    }
    report.UploadedImageBytes = resources.Quad.Upload(&window, size[0], size[1], colors);
    resources.Drawn = state;
    resources.NumberDrawn = hasPiece ? this->Rasterizer.GetNumberOfDrawnTetrahedra() : 0;
  }
  report.Features = hasPiece ? this->GetFeatures() : "";
  report.TetrahedraDrawn = resources.NumberDrawn;
  report.Buffers = 1;
  report.BufferBytes = 16 * static_cast<vtkIdType>(size[0]) * size[1];
  resources.Quad.Draw(&window);
  return error;
}

void TetrahedraRenderer::Select(
  vtkRenderer* renderer, vtkHardwareSelector* selector, WindowResources& resources)
{
  selector->BeginRenderProp();
  selector->UpdateMaximumCellId(this->MeshState.Grid->GetNumberOfCells());
  if (TetrahedraSelection::IsDrawn(selector))
  {
    this->DrawSelection(renderer, selector, resources);
  }
  selector->EndRenderProp();
}

void TetrahedraRenderer::DrawSelection(
  vtkRenderer* renderer, vtkHardwareSelector* selector, WindowResources& resources)
{
  // Cell ids depend neither on order nor on color. Both render paths draw them with the software
  // rasterizer.
  this->Frame.Blend = TetrahedraFrame::SELECTION;
  this->Frame.Order = this->Clip.IsActive() ? &this->Clip.GetOrder() : nullptr;
  this->ReadDepth(renderer);
  this->Rasterizer.Draw(this->Frame, []() { return false; });
  std::vector<vtkIdType> cells;
  cells.reserve(this->Rasterizer.GetTetrahedra().size());
  for (std::uint32_t tetrahedron : this->Rasterizer.GetTetrahedra())
  {
    const std::uint32_t original = tetrahedron ? this->Clip.GetOriginal(tetrahedron - 1) : 0;
    const vtkIdType cell =
      this->Mesh.Cells.empty() ? static_cast<vtkIdType>(original) : this->Mesh.Cells[original];
    cells.push_back(tetrahedron ? cell + 1 : 0);
  }
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  const TetrahedraView& view = this->Frame.View;
  resources.Quad.Upload(window, view.GetWidth(), view.GetHeight(),
    TetrahedraSelection::MakeImage(selector, view, cells, this->Rasterizer.GetDepths()), false);
  resources.Quad.Draw(window, "SELECTION");
  resources.Drawn.reset();
}

void TetrahedraRenderer::UpdateBoundary(
  vtkRenderer* renderer, const Request& request, TetrahedraReport& report)
{
  this->Frame.Surface = nullptr;
  if (!request.Boundary)
  {
    if (this->Boundary)
    {
      BoundaryFaces::Clear(this->Fields);
      this->Boundary = nullptr;
      ++this->Frame.Versions.Surface;
    }
    return;
  }
  if (report.BlendMode != Mapper::COMPOSITE_BLEND)
  {
    return;
  }
  if (this->Boundary != request.Boundary || this->BoundaryTime != request.Boundary->GetMTime())
  {
    this->Boundary = request.Boundary;
    this->BoundaryTime = request.Boundary->GetMTime();
    this->BoundaryCounts =
      BoundaryFaces::Build(request.Boundary, request.Grid, this->Mesh, this->Fields);
    ++this->Frame.Versions.Surface;
    ++this->Frame.Versions.Boundary;
  }
  report.BoundaryTriangles = this->BoundaryCounts.Triangles;
  report.UnmatchedTriangles = this->BoundaryCounts.Unmatched;
  if (this->BoundaryCounts.Triangles > 0)
  {
    const BoundaryShading before = this->Shading;
    this->Shading.Set(renderer, this->Frame.View, request.Mapper->GetBoundaryProperty(),
      request.Mapper->GetBoundaryTexture());
    this->Frame.Versions.Surface += before == this->Shading ? 0 : 1;
    this->Frame.Versions.Boundary += before.HasSameImage(this->Shading) ? 0 : 1;
    this->Frame.Surface = &this->Shading;
  }
}

void TetrahedraRenderer::ReadDepth(vtkRenderer* renderer)
{
  this->Depth.Read(renderer);
  this->SetOpaqueDepth();
}

void TetrahedraRenderer::SetOpaqueDepth()
{
  this->Depth.Resample(this->Frame.View, this->Frame.PixelStride, this->IsCutByFarPlane());
  this->Frame.Opaque = this->Depth.GetDepths().empty() ? nullptr : this->Depth.GetDepths().data();
}

bool TetrahedraRenderer::IsCutByFarPlane() const
{
  return this->Mesh.HasPointBehind(this->Frame.View.GetFarPlane(), 0.0);
}

vtkIdType TetrahedraRenderer::GetMemoryBytes() const
{
  std::size_t bytes =
    this->MeshBuilder.GetBytes() + this->Order.GetBytes() + this->Rasterizer.GetBytes();
  const auto add = [&bytes](const auto& values) { bytes += values.capacity() * sizeof(values[0]); };
  add(this->Mesh.Points);
  add(this->Mesh.Corners);
  add(this->Mesh.Cells);
  add(this->Fields.Scalars);
  add(this->Fields.Colors);
  add(this->Fields.DeltaT);
  add(this->Fields.Layers);
  add(this->Fields.Normals);
  return static_cast<vtkIdType>(bytes);
}

std::string TetrahedraRenderer::GetFeatures() const
{
  const TetrahedraFrame& frame = this->Frame;
  std::string features = this->Fields.Kind == TetrahedraFields::SCALARS ? "scalars"
    : this->Fields.Kind == TetrahedraFields::POINT_COLORS               ? "point-colors"
                                                                        : "cell-colors";
  features += frame.View.IsParallel() ? " parallel" : " perspective";
  features += this->Fields.DeltaT.empty() ? "" : " delta-t";
  features += frame.Opaque ? " opaque" : "";
  features += frame.Surface ? " surface" : "";
  return features + (frame.IsExact ? " exact" : " average");
}

void TetrahedraRenderer::ReleaseGraphicsResources(vtkWindow* window)
{
  for (auto& resources : this->Windows)
  {
    if (!window || resources.first == window)
    {
      resources.second->Quad.ReleaseGraphicsResources(resources.first);
      resources.second->Rasterizer.ReleaseGraphicsResources(resources.first);
    }
  }
  if (window)
  {
    this->Windows.erase(window);
  }
  else
  {
    this->Windows.clear();
  }
}

}
