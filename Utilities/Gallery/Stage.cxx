// SPDX-License-Identifier: BSD-3-Clause
#include "Gallery/Stage.h"

#include "Gallery/DrawCounter.h"
#include "Gallery/Look.h"
#include "Gallery/GalleryImage.h"
#include "Gallery/Scene.h"
#include "Gallery/Stopwatch.h"

#include "vtkAlgorithm.h"
#include "vtkFlowVolume.h"
#include "vtkIntervalVolume.h"
#include "vtkScalarsToColors.h"
#include "vtkSimplexTimeSlice.h"
#include "vtkTimeVaryingIntervalVolume.h"

#include <algorithm>
#include <map>

namespace gallery
{
namespace
{
/// Heights of a caption and of the legend, in lines of text.
constexpr double CAPTION_LINES = 2.4;
constexpr double LEGEND_LINES = 4.4;

/// Font size at which lines and points have the size set by their scene. They scale with the font
/// size.
constexpr double FONT_OF_LINES = 18.0;

/// Width of the gap between panels with a gradient background, as a fraction of the image's width.
/// Without a gap, such panels would appear as one.
constexpr double GAP = 0.01;
}

Stage::Stage(const ImageSize& size)
  : Width(size.Samples * size.Width)
  , Height(size.Samples * size.Height)
  , Samples(size.Samples)
{
  this->Report.Width = size.Width;
  this->Report.Height = size.Height;
}

Stage::~Stage() = default;

int Stage::GetFontSize() const
{
  return std::max(9 * this->Samples, static_cast<int>(0.022 * this->Height + 0.5));
}

Panel& Stage::AddPanel(const std::string& caption)
{
  this->Panels.push_back(std::make_unique<Panel>(caption));
  return *this->Panels.back();
}

Panel& Stage::AddPanel(const std::string& caption, const vtkVector3d& from, const vtkVector3d& up)
{
  Panel& panel = this->AddPanel(caption);
  if (this->Panels.size() > 1)
  {
    panel.ShareCamera(*this->Panels.front());
  }
  else
  {
    panel.LookFrom(from, up);
  }
  return panel;
}

void Stage::SetColorBar(
  const std::string& title, vtkScalarsToColors* colors, double lower, double upper)
{
  vtkSmartPointer<vtkScalarsToColors> colorMap = colors;
  this->Legend = [title, colorMap, lower, upper](
                   vtkRenderer* overlay, double x, double width, int font)
  { AddColorBar(overlay, title, colorMap, lower, upper, x, 1.9 * font, width, font); };
}

void Stage::SetColorKey(const std::string& title, const std::vector<ColorEntry>& entries)
{
  this->Legend = [title, entries](vtkRenderer* overlay, double x, double, int font)
  { AddColorKey(overlay, title, entries, x, 1.5 * font, font); };
}

vtkSmartPointer<vtkUnstructuredGrid> Stage::Run(vtkAlgorithm* filter)
{
  const Stopwatch watch;
  filter->Update();
  this->Report.ExtractSeconds += watch.Seconds();
  ++this->Report.Filters;
  auto tetrahedra = vtkSmartPointer<vtkUnstructuredGrid>::New();
  tetrahedra->ShallowCopy(filter->GetOutputDataObject(0));
  this->Report.Tetrahedra += tetrahedra->GetNumberOfCells();
  return tetrahedra;
}

vtkSmartPointer<vtkUnstructuredGrid> Stage::Extract(vtkIntervalVolume* filter, vtkDataObject* input)
{
  filter->SetInputDataObject(input);
  filter->SetSizeWarningLimit(0);
  vtkSmartPointer<vtkUnstructuredGrid> tetrahedra = this->Run(filter);
  vtkUnstructuredGrid* boundaries =
    vtkUnstructuredGrid::SafeDownCast(filter->GetOutputDataObject(1));
  this->Report.Intervals += filter->GetNumberOfIntervals();
  this->Report.Criteria += filter->GetNumberOfCriteria();
  this->Report.BoundaryTriangles += boundaries ? boundaries->GetNumberOfCells() : 0;
  this->Report.AddExtraction(filter->GetReport());
  if (this->Report.Criteria > 0)
  {
    this->Report.Features.insert("criteria");
  }
  if (this->Report.BoundaryTriangles > 0)
  {
    this->Report.Features.insert("boundaries");
  }
  return tetrahedra;
}

vtkSmartPointer<vtkUnstructuredGrid> Stage::Extract(
  vtkTimeVaryingIntervalVolume* filter, vtkAlgorithm* source)
{
  filter->SetInputConnection(source->GetOutputPort());
  filter->SetSizeWarningLimit(0);
  vtkSmartPointer<vtkUnstructuredGrid> tetrahedra = this->Run(filter);
  vtkInterlumeReport* report = filter->GetReport();
  this->Report.Intervals += filter->GetNumberOfIntervals();
  this->Report.Slabs = std::max(this->Report.Slabs, static_cast<int>(report->GetNumber("Slabs")));
  this->Report.Simplices += report->GetNumber("Simplices");
  this->Report.AddExtraction(report);
  this->Report.Features.insert("time");
  for (int kind = 0; kind < vtkTimeVaryingIntervalVolume::NUMBER_OF_BOUNDARY_KINDS; ++kind)
  {
    const bool isSurface = kind <= vtkTimeVaryingIntervalVolume::UPPER_SURFACE_AT_END;
    const vtkIdType cells = report->GetNumber("Boundaries", kind);
    (isSurface ? this->Report.BoundaryTriangles : this->Report.Tetrahedra) += cells;
    if (cells > 0)
    {
      this->Report.Features.insert(isSurface ? "boundaries" : "time-boundaries");
    }
  }
  return tetrahedra;
}

vtkSmartPointer<vtkUnstructuredGrid> Stage::Extract(vtkFlowVolume* filter, vtkDataObject* input)
{
  filter->SetInputDataObject(input);
  vtkSmartPointer<vtkUnstructuredGrid> tetrahedra = this->Run(filter);
  this->Report.Intervals += filter->GetNumberOfIntervals();
  this->Report.Features.insert("flow");
  for (int port = 1; port <= 2; ++port)
  {
    const vtkIdType cells =
      vtkUnstructuredGrid::SafeDownCast(filter->GetOutputDataObject(port))->GetNumberOfCells();
    this->Report.BoundaryTriangles += cells;
    if (cells > 0)
    {
      this->Report.Features.insert(port == 1 ? "stream-surfaces" : "time-surfaces");
    }
  }
  vtkInterlumeReport* report = filter->GetReport();
  this->Report.FlowCells += report->GetNumber("Cells");
  this->Report.SkippedFlowCells += SumValues(report,
                                     { "CellsWithoutResult", "CellsBetweenSurfaces", "CellsOnSeams",
                                       "CellsAcrossSurfaces", "CellsWithTimeJumps" }) -
    report->GetNumber("CellsCut");
  this->Report.InflowPasses += report->GetNumber("InflowPasses");
  this->Report.TimePasses += report->GetNumber("TimePasses");
  return tetrahedra;
}

vtkSmartPointer<vtkUnstructuredGrid> Stage::Extract(
  vtkSimplexTimeSlice* filter, vtkDataObject* simplices)
{
  filter->SetInputDataObject(simplices);
  this->Report.Features.insert("time-slices");
  return this->Run(filter);
}

Stage::Cell Stage::GetCell(std::size_t panel) const
{
  const int count = static_cast<int>(this->Panels.size());
  const int columns = this->Columns > 0 ? this->Columns : count;
  const int rows = (count + columns - 1) / columns;
  const int column = static_cast<int>(panel) % columns;
  const int row = static_cast<int>(panel) / columns;
  const int font = this->GetFontSize();
  const int legend = this->Legend ? static_cast<int>(LEGEND_LINES * font) : 0;
  const int captionHeight =
    this->Panels[panel]->GetCaption().empty() ? 0 : static_cast<int>(CAPTION_LINES * font);
  const bool isGradient = this->Panels[panel]->GetRenderer()->GetGradientBackground();
  const int gap = isGradient ? static_cast<int>(0.5 * GAP * this->Width) : 0;
  const int left = this->Width * column / columns + (column > 0 ? gap : 0);
  const int right = this->Width * (column + 1) / columns - (column + 1 < columns ? gap : 0);
  const int bottom = legend + (this->Height - legend) * (rows - 1 - row) / rows;
  const int top = legend + (this->Height - legend) * (rows - row) / rows;
  return { left, bottom, right - left, top - bottom, captionHeight };
}

vtkSmartPointer<vtkImageData> Stage::Render()
{
  const Stopwatch watch;
  this->FitCameras();
  vtkSmartPointer<vtkImageData> image = this->DrawCaptions();
  for (std::size_t i = 0; i < this->Panels.size(); ++i)
  {
    Panel& panel = *this->Panels[i];
    const DrawCounter counter(panel.GetRenderer());
    const Cell cell = this->GetCell(i);
    vtkSmartPointer<vtkImageData> drawing =
      panel.Draw(cell.Width, cell.Height - cell.Caption, this->GetFontSize() / FONT_OF_LINES);
    Paste(image, drawing, cell.Left, cell.Bottom + cell.Caption);
    const BufferCount used = CountBuffers(panel, this->Report.Features);
    this->Report.Buffers += used.Buffers;
    this->Report.Bytes += used.Bytes;
    this->Report.SurfacePanels += counter.GetPasses() > 0 ? 1 : 0;
    this->Report.OcclusionPanels += used.ScreenPasses > 0 ? 1 : 0;
    this->Report.Passes += used.ScreenPasses + counter.GetPasses();
    AddVolumeReports(panel, this->Report);
  }
  this->Report.Panels = static_cast<int>(this->Panels.size());
  image = DownsampleRgbImage(image, this->Samples);
  this->Report.RenderSeconds = watch.Seconds();
  return image;
}

vtkSmartPointer<vtkImageData> Stage::RenderFrame(double fraction, const ImageSize& size)
{
  const SceneReport report = this->Report;
  const int previous[3] = { this->Width, this->Height, this->Samples };
  this->Width = size.Samples * size.Width;
  this->Height = size.Samples * size.Height;
  this->Samples = size.Samples;
  this->Show(fraction);
  vtkSmartPointer<vtkImageData> frame = this->Render();
  this->Width = previous[0];
  this->Height = previous[1];
  this->Samples = previous[2];
  this->Report = report;
  return frame;
}

vtkSmartPointer<vtkImageData> Stage::DrawCaptions()
{
  const int font = this->GetFontSize();
  vtkNew<vtkRenderer> overlay;
  ApplyLook(overlay);
  for (std::size_t i = 0; i < this->Panels.size(); ++i)
  {
    const Cell cell = this->GetCell(i);
    AddText(overlay, this->Panels[i]->GetCaption(), cell.Left + 0.5 * cell.Width,
      cell.Bottom + 0.5 * cell.Caption, font);
  }
  if (this->Legend)
  {
    this->Legend(overlay, 0.5 * this->Width, 0.42 * this->Width, font);
  }
  vtkSmartPointer<vtkRenderWindow> window = MakeWindow(this->Width, this->Height);
  window->AddRenderer(overlay);
  return GrabImage(window);
}

const std::vector<std::unique_ptr<Panel>>& Stage::FitPanels()
{
  this->FitCameras();
  return this->Panels;
}

void Stage::FitCameras()
{
  std::map<vtkCamera*, std::vector<vtkVector3d>> points;
  for (const std::unique_ptr<Panel>& panel : this->Panels)
  {
    const std::vector<vtkVector3d> panelPoints = panel->GetPoints();
    std::vector<vtkVector3d>& shared = points[panel->GetCamera()];
    shared.insert(shared.end(), panelPoints.begin(), panelPoints.end());
  }
  for (std::size_t i = 0; i < this->Panels.size(); ++i)
  {
    const Cell cell = this->GetCell(i);
    this->Panels[i]->Fit(points[this->Panels[i]->GetCamera()],
      static_cast<double>(cell.Width) / (cell.Height - cell.Caption));
  }
}

vtkSmartPointer<vtkImageData> RenderScene(
  const Scene& scene, const ImageSize& size, SceneReport& report)
{
  return RenderScene(scene, size, report, 0, [](vtkImageData*) {});
}

vtkSmartPointer<vtkImageData> RenderScene(const Scene& scene, const ImageSize& size,
  SceneReport& report, int frames, const std::function<void(vtkImageData* frame)>& take)
{
  const Stopwatch watch;
  Stage stage(size);
  scene.Build(stage);
  const double buildSeconds = watch.Seconds();
  vtkSmartPointer<vtkImageData> image = stage.Render();
  report = stage.GetReport();
  report.Id = scene.Id;
  report.Figure = scene.Figure;
  report.BuildSeconds = buildSeconds;
  report.Frames = stage.HasAnimation() ? frames : 0;
  const ImageSize frameSize = { size.Width / 2, size.Height / 2, std::min(size.Samples, 2) };
  const Stopwatch frameWatch;
  for (int i = 0; i < report.Frames; ++i)
  {
    take(stage.RenderFrame(static_cast<double>(i) / report.Frames, frameSize));
  }
  report.FrameSeconds = frameWatch.Seconds();
  return image;
}
}
