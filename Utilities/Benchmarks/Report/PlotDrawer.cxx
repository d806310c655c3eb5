// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Report/PlotDrawer.h"

#include "Benchmarks/Report/BenchChart.h"

#include "vtkChartXY.h"
#include "vtkContextActor.h"
#include "vtkContextScene.h"
#include "vtkNew.h"
#include "vtkPNGWriter.h"
#include "vtkRenderer.h"
#include "vtkTextActor.h"
#include "vtkTextProperty.h"
#include "vtkWindowToImageFilter.h"

#include <cstdlib>
#include <filesystem>
#include <stdexcept>

namespace
{
const int Width = 1200;
const int Height = 860;
const int CaptionHeight = 58;
const int RightMargin = 28;
}

PlotDrawer::PlotDrawer(const std::string& folder, const std::string& caption)
  : Folder(folder)
  , Caption(caption)
{
  const char* display = std::getenv("DISPLAY");
  if (this->Window->IsA("vtkXOpenGLRenderWindow") && (!display || !*display))
  {
    throw std::runtime_error("plots need a display here: run the program under xvfb-run -a");
  }
  this->Window->SetOffScreenRendering(1);
  this->Window->SetMultiSamples(8);
  this->Window->SetSize(Width, Height);
  std::filesystem::create_directories(folder);
}

std::vector<BenchPlot> PlotDrawer::Draw(const std::vector<BenchPlot>& plots) const
{
  std::vector<BenchPlot> drawn;
  for (const BenchPlot& plot : plots)
  {
    if (!plot.AllSeries.empty())
    {
      this->Draw(plot);
      drawn.push_back(plot);
    }
  }
  return drawn;
}

void PlotDrawer::Draw(const BenchPlot& plot) const
{
  vtkNew<vtkRenderer> renderer;
  renderer->SetBackground(1.0, 1.0, 1.0);
  this->Window->AddRenderer(renderer);

  vtkNew<vtkChartXY> chart;
  chart->SetAutoSize(false);
  chart->SetSize(vtkRectf(0.0f, CaptionHeight, Width - RightMargin, Height - CaptionHeight - 8));
  FillChart(chart, plot);
  vtkNew<vtkContextActor> actor;
  actor->GetScene()->AddItem(chart);
  actor->GetScene()->SetRenderer(renderer);
  renderer->AddActor(actor);

  vtkNew<vtkTextActor> caption;
  caption->SetInput(this->Caption.c_str());
  caption->GetTextProperty()->SetColor(0.35, 0.35, 0.35);
  caption->GetTextProperty()->SetFontSize(16);
  caption->SetPosition(24.0, 10.0);
  renderer->AddViewProp(caption);
  this->Window->Render();

  vtkNew<vtkWindowToImageFilter> picture;
  picture->SetInput(this->Window);
  picture->ReadFrontBufferOff();
  vtkNew<vtkPNGWriter> writer;
  const std::string path = (std::filesystem::path(this->Folder) / (plot.Name + ".png")).string();
  writer->SetFileName(path.c_str());
  writer->SetInputConnection(picture->GetOutputPort());
  writer->Write();
  this->Window->RemoveRenderer(renderer);
  if (!std::filesystem::exists(path))
  {
    throw std::runtime_error("cannot write " + path);
  }
}
