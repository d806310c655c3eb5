// SPDX-License-Identifier: BSD-3-Clause
#include "Draw/TetrahedraRenderer.h"

#include "Draw/PieceImage.h"
#include "Draw/TetrahedraSelection.h"
#include "Loader/OpenGLFunctions.h"
#include "Loader/SoftwareOpenGL.h"
#include "Offscreen/ImageQuad.h"
#include "Offscreen/SceneDepth.h"
#include "OpenGL/OpenGLRasterizer.h"
#include "Pieces/PieceExchange.h"
#include "Refinement/RenderProgress.h"

#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
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
#include <limits>
#include <optional>
#include <utility>

namespace interlume
{

using Mapper = vtkTimeWeightedTetrahedraMapper;

namespace
{
/// With more tetrahedra, MPVONC sorting takes longer than drawing.
constexpr std::uint32_t MPVONC_LIMIT = 1000000;
/// Estimated time per unit of LevelOfDetail::GetCost(), for one thread or a GPU.
constexpr double CPU_SECONDS = 2e-7;
constexpr double GPU_SECONDS = 1e-8;
/// Tolerance of the transfer functions of subsets. Segments that cross control points of curved
/// functions or color tables take a large part of the time.
constexpr double SUBSET_TOLERANCE = 0.01;
/// Fractions of an image's progress after building the mesh, its colors or a subset, and the order.
constexpr double MESHED = 0.15;
constexpr double COLORED = 0.2;
constexpr double ARRANGED = 0.3;
/// Level of detail of samples: half of the tetrahedra, and half of the image's width and height.
constexpr int SAMPLE_LEVEL = 2;

/// Returns the estimated time per unit of LevelOfDetail::GetCost().
double GetCostSeconds(int renderPath)
{
  return renderPath == Mapper::OPENGL_PATH
    ? GPU_SECONDS
    : CPU_SECONDS / vtkSMPTools::GetEstimatedNumberOfThreads();
}

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
  /// Draws subsets, so that the buffers of the mesh remain; null if no subset was drawn.
  std::unique_ptr<OpenGLRasterizer> SubsetRasterizer;
  std::optional<DrawnState> Drawn;
  vtkIdType NumberDrawn = 0;
  /// Draws the passes of a selection; null if the last image was not a selection.
  std::unique_ptr<TetrahedraSelection> Selection;

  void RemoveSelection(vtkWindow* window)
  {
    if (this->Selection)
    {
      this->Selection->ReleaseGraphicsResources(window);
      this->Selection.reset();
    }
  }
};

TetrahedraRenderer::TetrahedraRenderer() = default;

TetrahedraRenderer::~TetrahedraRenderer() = default;

bool TetrahedraRenderer::IsMeshCurrent(const Request& request) const
{
  return this->MeshState.Grid == request.Grid && this->MeshState.Time == request.Grid->GetMTime() &&
    this->MeshState.Arrays == request.Arrays;
}

Error TetrahedraRenderer::UpdateMesh(const Request& request, TetrahedraReport& report)
{
  const MeshKey& before = this->MeshState;
  const TetrahedraArrays& arrays = request.Arrays;
  if (this->IsMeshCurrent(request))
  {
    return {};
  }
  report.ValuesUpdated = true;
  report.MeshRebuilt =
    !before.Grid || !this->MeshBuilder.IsSame(request.Grid, arrays, this->Full.Mesh);
  this->MeshState = MeshKey();
  this->Property = nullptr;
  if (report.MeshRebuilt)
  {
    this->Boundary = nullptr;
    BoundaryFaces::Clear(this->Full.Fields);
    this->Full.Order.Reset();
    this->Subset = TetrahedraSubset();
    this->Reduced.Mesh = TetrahedraMesh();
    this->Reduced.Fields = TetrahedraFields();
    if (Error error = this->MeshBuilder.Build(request.Grid, arrays, this->Full.Mesh))
    {
      return error;
    }
    ++this->Full.Frame.Versions.Mesh;
  }
  const std::vector<int> layers = this->Full.Fields.Layers;
  TetrahedraBuilder::BuildDeltaTAndLayers(arrays, this->Full.Mesh, this->Full.Fields);
  if (layers != this->Full.Fields.Layers)
  {
    this->Full.Order.ResetLayers();
  }
  this->MeshState = { request.Grid, request.Grid->GetMTime(), arrays };
  this->Full.Mesh.CellStride = request.CellStride;
  ++this->Full.Frame.Versions.Values;
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
  const std::vector<float> scalars = std::move(this->Full.Fields.Scalars);
  if (Error error = TetrahedraBuilder::BuildColors(
        request.Arrays, this->Full.Mesh, property, unit, this->Full.Fields))
  {
    return error;
  }
  // The property may select a different scalar component.
  this->Full.Frame.Versions.Values += scalars == this->Full.Fields.Scalars ? 0 : 1;
  if (this->Full.Fields.Kind == TetrahedraFields::SCALARS)
  {
    this->Pieces.Build(property, 0, this->Full.Fields.Range, unit);
  }
  this->Property = property;
  this->PropertyTime = property->GetMTime();
  this->ColorUnit = unit;
  this->HasOneColor = this->HasSingleColor();
  ++this->Full.Frame.Versions.Colors;
  return {};
}

bool TetrahedraRenderer::HasSingleColor() const
{
  if (this->Full.Fields.Kind == TetrahedraFields::SCALARS)
  {
    return this->Pieces.HasConstantColor();
  }
  const auto& colors = this->Full.Fields.Colors;
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
  this->Full.Frame.IsPulled = false;
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
  this->Full.Frame.IsPulled = report.SilhouetteShader == Mapper::VERTEX_SHADER;
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
  else if (!this->Shown->Frame.Surface && this->HasOneColor)
  {
    report.SortReason = "there is a single color";
  }
  else if (request.Arrays.DeltaT)
  {
    report.SortMode = Mapper::CENTROID_SORT;
    report.SortReason = "tetrahedra with an extent in time overlap";
  }
  else if (this->Full.Mesh.GetNumberOfTetrahedra() > MPVONC_LIMIT)
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
  if (this->Shown == &this->Reduced && report.SortMode == Mapper::MPVONC_SORT)
  {
    report.SortMode = Mapper::CENTROID_SORT;
    report.SortReason = "a subset of the tetrahedra has no visibility order";
  }
}

bool TetrahedraRenderer::UpdateOrder(
  const Request& request, RenderProgress* progress, TetrahedraReport& report)
{
  TetrahedraOrder& order = this->Shown->Order;
  report.Passes = 1;
  if (report.BlendMode == Mapper::PRIORITY_BLEND)
  {
    order.ComputeLayerOrder(this->Shown->Fields.Layers, request.Mapper->GetLayerPriorities());
    report.Layers = order.GetNumberOfLayers();
    report.Passes = report.Layers;
  }
  else
  {
    const auto kind = report.SortMode == Mapper::CENTROID_SORT ? TetrahedraOrder::CENTROID
      : report.SortMode == Mapper::MPVONC_SORT                 ? TetrahedraOrder::VISIBILITY
                                                               : TetrahedraOrder::NONE;
    const auto isAborted = [progress]() { return progress && progress->IsAborted(COLORED); };
    if (!order.Compute(kind, this->Shown->Mesh, this->Shown->Frame.View, isAborted))
    {
      return false;
    }
    report.Sorted = order.WasComputed();
  }
  this->Shown->Frame.Versions.Order += order.WasComputed() ? 1 : 0;
  if (report.SortMode == Mapper::MPVONC_SORT)
  {
    report.Cycles = order.GetCycles();
    report.Gaps = order.GetGaps();
  }
  report.HasAdjacency = order.HasAdjacency();
  return !progress || !progress->IsAborted(ARRANGED);
}

double TetrahedraRenderer::BeginPass(
  vtkRenderer* renderer, vtkVolume* volume, const Request& request, TetrahedraReport& report)
{
  if (renderer->GetSelector())
  {
    return std::numeric_limits<double>::infinity();
  }
  const double allocated = volume->GetAllocatedRenderTime();
  if (!request.Mapper->GetProgressiveRendering() || request.CellStride > 1)
  {
    this->Refinement.Clear();
    this->ReleaseSample(vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow()));
    return request.Mapper->GetAutoAdjustLevelOfDetail() ? allocated
                                                        : std::numeric_limits<double>::infinity();
  }
  this->ChooseRenderPath(
    request, vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow()), report);
  if (this->IsMeshCurrent(request))
  {
    this->UpdateLevels(renderer, report);
  }
  const double fullSeconds = this->IsMeshCurrent(request)
    ? this->LevelOfDetail.GetExpectedSeconds(0)
    : 2.0 * GetCostSeconds(report.RenderPath) *
      static_cast<double>(request.Grid->GetNumberOfCells());
  const double seconds = this->Refinement.Begin(
    renderer, volume, ImageKey(renderer, volume, request.Mapper), fullSeconds, allocated);
  // DrawInSoftware shows the last image again if nothing has changed.
  return seconds == ImageRefinement::REUSED ? std::numeric_limits<double>::infinity() : seconds;
}

Error TetrahedraRenderer::EndPass(const Error& error, bool isFinal)
{
  if (error)
  {
    this->Refinement.Clear();
  }
  else
  {
    this->Refinement.End(isFinal);
  }
  return error;
}

bool TetrahedraRenderer::NeedsSample(
  const Request& request, vtkVolume* volume, double seconds) const
{
  if (!request.Mapper->GetProgressiveRendering() || request.CellStride > 1 ||
    seconds > ImageRefinement::FIRST_SECONDS ||
    request.Grid->GetNumberOfCells() < 2 * GridSample::SIZE)
  {
    return false;
  }
  vtkVolumeProperty* property = volume->GetProperty();
  const bool isColored = this->Property == property && this->PropertyTime == property->GetMTime();
  const bool needsSubset = this->LevelOfDetail.GetExpectedSeconds(1) > seconds;
  return !this->IsMeshCurrent(request) ||
    (needsSubset && (!isColored || this->Reduced.Mesh.Corners.empty()));
}

Error TetrahedraRenderer::RenderSample(
  vtkRenderer* renderer, vtkVolume* volume, const Request& request, TetrahedraReport& report)
{
  this->Sample.Update(request.Grid, request.Arrays);
  if (!this->SampleRenderer)
  {
    this->SampleRenderer = std::make_unique<TetrahedraRenderer>();
  }
  Request sampled = request;
  sampled.Grid = this->Sample.GetGrid();
  sampled.Arrays = this->Sample.GetArrays();
  sampled.Boundary = nullptr;
  sampled.CellStride = this->Sample.GetStride();
  return this->SampleRenderer->Render(renderer, volume, sampled, report);
}

void TetrahedraRenderer::ReleaseSample(vtkOpenGLRenderWindow* window)
{
  if (this->SampleRenderer)
  {
    // Releasing a framebuffer unbinds the current framebuffer.
    window->GetState()->PushFramebufferBindings();
    this->SampleRenderer->ReleaseGraphicsResources(window);
    window->GetState()->PopFramebufferBindings();
    this->SampleRenderer.reset();
    this->Sample = GridSample();
  }
}

void TetrahedraRenderer::UpdateLevels(vtkRenderer* renderer, TetrahedraReport& report)
{
  const std::array<int, 3> conditions{ { report.RenderPath, renderer->GetSize()[0],
    renderer->GetSize()[1] } };
  const int mesh = this->Full.Frame.Versions.Mesh;
  const std::uint32_t tetrahedra = this->Full.Mesh.GetNumberOfTetrahedra();
  if (conditions != this->LevelConditions)
  {
    this->LevelOfDetail.Reset(tetrahedra, GetCostSeconds(report.RenderPath));
  }
  else if (mesh != this->LevelMesh)
  {
    this->LevelOfDetail.ReplaceMesh(tetrahedra);
  }
  this->LevelConditions = conditions;
  this->LevelMesh = mesh;
}

int TetrahedraRenderer::ChooseLevel(
  vtkRenderer* renderer, double seconds, const Request& request, TetrahedraReport& report)
{
  this->UpdateLevels(renderer, report);
  const std::uint32_t tetrahedra = this->Full.Mesh.GetNumberOfTetrahedra();
  const int level = request.CellStride > 1 ? SAMPLE_LEVEL : this->LevelOfDetail.Choose(seconds);
  report.PixelStride = this->LevelOfDetail.GetPixelStride(level);
  const std::uint32_t subset = this->LevelOfDetail.GetSubsetSize(level);
  report.TetrahedronStride = subset > 0 ? static_cast<int>(tetrahedra / subset) : 1;
  return level;
}

Error TetrahedraRenderer::UpdateFrame(vtkRenderer* renderer, vtkVolume* volume,
  const Request& request, std::uint32_t subset, TetrahedraReport& report)
{
  TetrahedraFrame& frame = this->Full.Frame;
  if (Error error = frame.View.Set(renderer, volume, this->Full.Mesh, report.PixelStride))
  {
    return error;
  }
  vtkVolumeProperty* property = volume->GetProperty();
  frame.ExtinctionUnit = frame.View.GetUnit() / property->GetScalarOpacityUnitDistance();
  if (Error error = this->UpdateColors(request, property, frame.ExtinctionUnit))
  {
    return error;
  }
  report.ControlPoints =
    this->Full.Fields.Kind == TetrahedraFields::SCALARS ? this->Pieces.GetNumberOfPieces() + 1 : 0;
  this->UpdateBoundary(renderer, request, report);
  frame.Mesh = &this->Full.Mesh;
  frame.Fields = &this->Full.Fields;
  frame.Pieces = &this->Pieces;
  frame.Blend = GetBlend(report.BlendMode);
  frame.IsExact = request.Mapper->GetIntegrationMode() == Mapper::LINEAR_SEGMENT;
  frame.PixelStride = report.PixelStride;
  this->Shown = &this->Full;
  if (subset > 0)
  {
    this->UpdateSubset(subset);
  }
  return {};
}

void TetrahedraRenderer::UpdateSubset(std::uint32_t number)
{
  Detail& reduced = this->Reduced;
  TetrahedraFrame::Changes versions = reduced.Frame.Versions;
  reduced.Frame = this->Full.Frame;
  reduced.Frame.Pieces = &this->SubsetPieces;
  if (this->SubsetColors != this->Full.Frame.Versions.Colors &&
    this->Full.Fields.Kind == TetrahedraFields::SCALARS)
  {
    this->SubsetPieces.Build(
      this->Property, 0, this->Full.Fields.Range, this->ColorUnit, SUBSET_TOLERANCE);
    this->SubsetColors = this->Full.Frame.Versions.Colors;
  }
  if (this->Subset.Update(reduced.Frame, number, reduced.Mesh, reduced.Fields))
  {
    reduced.Order.Reset();
    ++versions.Mesh;
    ++versions.Values;
    ++versions.Colors;
  }
  versions.Surface = this->Full.Frame.Versions.Surface;
  versions.Boundary = this->Full.Frame.Versions.Boundary;
  reduced.Frame.Versions = versions;
  reduced.Frame.Mesh = &reduced.Mesh;
  reduced.Frame.Fields = &reduced.Fields;
  this->Shown = &reduced;
}

Error TetrahedraRenderer::ArrangeFrame(
  const Request& request, RenderProgress* progress, TetrahedraReport& report)
{
  this->ChooseSort(request, report);
  if (!this->UpdateOrder(request, progress, report))
  {
    return {};
  }
  const Error error = this->ClipMesh(request, this->Shown->Order.Get());
  report.TetrahedraClipped = error ? 0 : this->Shown->Clip.GetNumberOfClippedTetrahedra();
  return error;
}

Error TetrahedraRenderer::ClipMesh(const Request& request, const std::vector<std::uint32_t>* order)
{
  const TetrahedraView& view = this->Shown->Frame.View;
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
  this->Shown->Clip.Append(
    this->Shown->Mesh, this->Shown->Fields, planes, view.GetRays().Viewpoint, order);
  this->Shown->Frame.Order = this->Shown->Clip.IsActive() ? &this->Shown->Clip.GetOrder() : order;
  this->Shown->Frame.Planes = this->Shown->Clip.GetPlanes();
  return {};
}

bool TetrahedraRenderer::DrawFrame(vtkRenderer* renderer, vtkVolume* volume,
  WindowResources& resources, RenderProgress& progress, TetrahedraReport& report)
{
  if (report.RenderPath == Mapper::OPENGL_PATH)
  {
    auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
    if (const Error error =
          resources.Rasterizer.FindError(window, this->Shown->Frame)
            .Then([&] { return this->DrawWithOpenGL(renderer, volume, resources, report); }))
    {
      report.RenderPath = Mapper::SOFTWARE_PATH;
      report.PathReason = error.GetMessage();
      report.SilhouetteShader = 0;
      report.ShaderReason.clear();
    }
  }
  return report.RenderPath != Mapper::SOFTWARE_PATH ||
    this->DrawInSoftware(renderer, resources, progress, report);
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
  const bool isSelection = renderer->GetSelector() != nullptr;
  if (!isSelection)
  {
    this->GetResources(window).RemoveSelection(window);
  }
  Error error = isSelection ? this->Select(renderer, volume, request, *window, report)
    : request.Pieces        ? this->RenderPieces(renderer, volume, request, *window, report)
                            : this->RenderMesh(renderer, volume, request, *window, report);
  this->Shown->Clip.Remove(this->Shown->Mesh, this->Shown->Fields);
  report.Seconds = vtkTimerLog::GetUniversalTime() - start;
  report.MemoryBytes = this->GetMemoryBytes();
  return error;
}

Error TetrahedraRenderer::RenderMesh(vtkRenderer* renderer, vtkVolume* volume,
  const Request& request, vtkOpenGLRenderWindow& window, TetrahedraReport& report)
{
  const double seconds = this->BeginPass(renderer, volume, request, report);
  if (this->NeedsSample(request, volume, seconds))
  {
    Error error = this->RenderSample(renderer, volume, request, report);
    report.Tetrahedra = request.Grid->GetNumberOfCells();
    return this->EndPass(error, false);
  }
  RenderProgress progress(&window, request.Mapper);
  if (progress.IsAborted(0.0))
  {
    return {};
  }
  Error error = this->UpdateMesh(request, report);
  this->CountTetrahedra(request, report);
  if (error || this->Full.Mesh.Corners.empty())
  {
    return this->EndPass(error, true);
  }
  if (progress.IsAborted(MESHED))
  {
    return {};
  }
  this->ChooseBlend(request, report);
  this->ChooseRenderPath(request, &window, report);
  this->ChooseShader(request, &window, report);
  const int level = this->ChooseLevel(renderer, seconds, request, report);
  error =
    this->UpdateFrame(renderer, volume, request, this->LevelOfDetail.GetSubsetSize(level), report);
  if (!error && progress.IsAborted(COLORED))
  {
    return {};
  }
  // Changes of the data take time only once, so the level of detail does not depend on it.
  const double start = vtkTimerLog::GetUniversalTime();
  error = error ? error : this->ArrangeFrame(request, &progress, report);
  if (error)
  {
    return this->EndPass(error, true);
  }
  WindowResources& resources = this->GetResources(&window);
  if (progress.WasAborted() || !this->DrawFrame(renderer, volume, resources, progress, report))
  {
    return {};
  }
  if (request.Mapper->GetAutoAdjustLevelOfDetail() && report.RenderPath == Mapper::OPENGL_PATH)
  {
    // OpenGL is asynchronous. Wait, because the level of detail depends on the time until drawing
    // is complete.
    glFinish();
  }
  // The software path may show the previous image or parts of it again.
  if (report.RenderPath == Mapper::OPENGL_PATH ||
    (report.UploadedImageBytes > 0 && this->Rasterizer.WasComplete()))
  {
    this->LevelOfDetail.AddMeasurement(level, vtkTimerLog::GetUniversalTime() - start);
  }
  return this->EndPass({}, level == 0);
}

Error TetrahedraRenderer::DrawWithOpenGL(
  vtkRenderer* renderer, vtkVolume* volume, WindowResources& resources, TetrahedraReport& report)
{
  if (this->Shown == &this->Reduced && !resources.SubsetRasterizer)
  {
    resources.SubsetRasterizer = std::make_unique<OpenGLRasterizer>();
  }
  OpenGLRasterizer& rasterizer =
    this->Shown == &this->Reduced ? *resources.SubsetRasterizer : resources.Rasterizer;
  Error error = rasterizer.Draw(renderer, this->Shown->Frame,
    SceneDepth::MayOcclude(renderer, volume) || this->IsCutByFarPlane(), report);
  report.TetrahedraDrawn =
    static_cast<vtkIdType>(this->Shown->Frame.Order ? this->Shown->Frame.Order->size()
                                                    : this->Shown->Mesh.GetNumberOfTetrahedra());
  return error;
}

bool TetrahedraRenderer::DrawInSoftware(vtkRenderer* renderer, WindowResources& resources,
  RenderProgress& progress, TetrahedraReport& report)
{
  this->ReadDepth(renderer);
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  report.Features = this->GetFeatures();
  const DrawnState state = { this->Shown->Frame, false, this->Depth.GetDepths(), {} };
  // Reuse the image if neither the camera nor the scene changed.
  if (!(resources.Drawn == state))
  {
    const auto isAborted = [&progress](double fraction)
    { return progress.IsAborted(ARRANGED + (1.0 - ARRANGED) * fraction); };
    if (!this->Rasterizer.Draw(this->Shown->Frame, isAborted))
    {
      return false;
    }
    report.UploadedImageBytes = resources.Quad.Upload(window, this->Shown->Frame.View.GetWidth(),
      this->Shown->Frame.View.GetHeight(), this->Rasterizer.GetColors());
    resources.Drawn = state;
    resources.NumberDrawn = this->Rasterizer.GetNumberOfDrawnTetrahedra();
  }
  report.TetrahedraDrawn = resources.NumberDrawn;
  report.Buffers = 1;
  report.BufferBytes = 16 * static_cast<vtkIdType>(this->Shown->Frame.View.GetWidth()) *
    this->Shown->Frame.View.GetHeight();
  resources.Quad.Draw(window);
  return true;
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
  if (error || this->Full.Mesh.Corners.empty())
  {
    return error;
  }
  error = this->UpdateFrame(renderer, volume, request, 0, report);
  // Selection needs no order, except for layers.
  const bool isSorted = !renderer->GetSelector() || report.BlendMode == Mapper::PRIORITY_BLEND;
  return error ? error
    : isSorted ? this->ArrangeFrame(request, nullptr, report)
               : this->ClipMesh(request, nullptr);
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
  const bool hasPiece = request.Grid && !error && !this->Full.Mesh.Corners.empty();

  // Redraw in all processes if something changed in any of them.
  std::array<int, 2> size{ { 0, 0 } };
  std::array<int, 2> origin{ { 0, 0 } };
  renderer->GetTiledSizeAndOrigin(&size[0], &size[1], &origin[0], &origin[1]);
  const bool hasDepth = this->Depth.Read(renderer);
  DrawnState state;
  if (hasPiece)
  {
    state.Frame = this->Full.Frame;
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
    PieceImage image(pieces, hasPiece ? &this->Full.Frame : nullptr, pixels, this->Rasterizer);
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

Error TetrahedraRenderer::Select(vtkRenderer* renderer, vtkVolume* volume, const Request& request,
  vtkOpenGLRenderWindow& window, TetrahedraReport& report)
{
  WindowResources& resources = this->GetResources(&window);
  std::unique_ptr<TetrahedraSelection>& selection = resources.Selection;
  if (!selection || !selection->IsFound(renderer, volume))
  {
    resources.RemoveSelection(&window);
    this->ChooseBlend(request, report);
    const Error error = this->UpdatePiece(renderer, volume, request, report);
    if (error || this->Full.Mesh.Corners.empty())
    {
      return error;
    }
    // Both render paths select with the software rasterizer.
    TetrahedraSelection::ReadDepth(renderer, this->Depth);
    this->SetOpaqueDepth();
    TetrahedraFrame frame = this->Full.Frame;
    frame.IsSelection = true;
    selection = std::make_unique<TetrahedraSelection>();
    vtkDataSet* ids = request.Mapper->GetSelectionIds();
    selection->Find(
      renderer, volume, frame, this->Full.Clip, { request.Grid, ids }, this->Rasterizer);
  }
  selection->Draw(renderer);
  return {};
}

void TetrahedraRenderer::UpdateBoundary(
  vtkRenderer* renderer, const Request& request, TetrahedraReport& report)
{
  this->Full.Frame.Surface = nullptr;
  if (!request.Boundary)
  {
    if (this->Boundary)
    {
      BoundaryFaces::Clear(this->Full.Fields);
      this->Boundary = nullptr;
      ++this->Full.Frame.Versions.Surface;
    }
    return;
  }
  if (report.BlendMode != Mapper::COMPOSITE_BLEND)
  {
    return;
  }
  if (this->Boundary != request.Boundary || this->BoundaryTime != request.Boundary->GetMTime() ||
    !(this->BoundaryMaterials == request.BoundaryMaterials))
  {
    this->Boundary = request.Boundary;
    this->BoundaryTime = request.Boundary->GetMTime();
    this->BoundaryMaterials = request.BoundaryMaterials;
    this->BoundaryCounts = BoundaryFaces::Build(request.Boundary, request.Grid, this->Full.Mesh,
      request.BoundaryMaterials, this->Full.Fields);
    ++this->Full.Frame.Versions.Surface;
    ++this->Full.Frame.Versions.Boundary;
  }
  report.BoundaryTriangles = this->BoundaryCounts.Triangles;
  report.UnmatchedTriangles = this->BoundaryCounts.Unmatched;
  if (this->BoundaryCounts.Triangles > 0)
  {
    const BoundaryShading before = this->Shading;
    this->Shading.Set(renderer, this->Full.Frame.View, request.BoundarySources);
    this->Full.Frame.Versions.Surface += before == this->Shading ? 0 : 1;
    this->Full.Frame.Versions.Boundary += before.HasSameImages(this->Shading) ? 0 : 1;
    this->Full.Frame.Surface = &this->Shading;
  }
}

void TetrahedraRenderer::ReadDepth(vtkRenderer* renderer)
{
  this->Depth.Read(renderer);
  this->SetOpaqueDepth();
}

void TetrahedraRenderer::SetOpaqueDepth()
{
  this->Depth.Resample(
    this->Shown->Frame.View, this->Shown->Frame.PixelStride, this->IsCutByFarPlane());
  this->Shown->Frame.Opaque =
    this->Depth.GetDepths().empty() ? nullptr : this->Depth.GetDepths().data();
}

bool TetrahedraRenderer::IsCutByFarPlane() const
{
  return this->Shown->Mesh.HasPointBehind(this->Shown->Frame.View.GetFarPlane(), 0.0);
}

vtkIdType TetrahedraRenderer::GetMemoryBytes() const
{
  std::size_t bytes =
    this->MeshBuilder.GetBytes() + this->Rasterizer.GetBytes() + this->Subset.GetBytes();
  bytes += this->SampleRenderer ? this->SampleRenderer->GetMemoryBytes() : 0;
  const auto add = [&bytes](const auto& values) { bytes += values.capacity() * sizeof(values[0]); };
  for (const Detail* detail : { &this->Full, &this->Reduced })
  {
    bytes += detail->Order.GetBytes();
    add(detail->Mesh.Points);
    add(detail->Mesh.Corners);
    add(detail->Mesh.Cells);
    add(detail->Fields.Scalars);
    add(detail->Fields.Colors);
    add(detail->Fields.DeltaT);
    add(detail->Fields.Layers);
    add(detail->Fields.Normals);
  }
  return static_cast<vtkIdType>(bytes);
}

std::string TetrahedraRenderer::GetFeatures() const
{
  const TetrahedraFrame& frame = this->Shown->Frame;
  std::string features = this->Shown->Fields.Kind == TetrahedraFields::SCALARS ? "scalars"
    : this->Shown->Fields.Kind == TetrahedraFields::POINT_COLORS               ? "point-colors"
                                                                               : "cell-colors";
  features += frame.View.IsParallel() ? " parallel" : " perspective";
  features += this->Shown->Fields.DeltaT.empty() ? "" : " delta-t";
  features += frame.Opaque ? " opaque" : "";
  features += frame.Surface ? " surface" : "";
  return features + (frame.IsExact ? " exact" : " average");
}

void TetrahedraRenderer::ReleaseGraphicsResources(vtkWindow* window)
{
  if (this->SampleRenderer)
  {
    this->SampleRenderer->ReleaseGraphicsResources(window);
  }
  for (auto& resources : this->Windows)
  {
    if (!window || resources.first == window)
    {
      resources.second->Quad.ReleaseGraphicsResources(resources.first);
      resources.second->Rasterizer.ReleaseGraphicsResources(resources.first);
      if (resources.second->SubsetRasterizer)
      {
        resources.second->SubsetRasterizer->ReleaseGraphicsResources(resources.first);
      }
      resources.second->RemoveSelection(resources.first);
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
