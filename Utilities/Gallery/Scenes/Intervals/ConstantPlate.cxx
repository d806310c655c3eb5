// SPDX-License-Identifier: BSD-3-Clause
// A plate of constant hypercubes without and with its time extent.

#include "Gallery/Look.h"
#include "Gallery/Scene.h"
#include "Gallery/Stage.h"
#include "Gallery/Volumes.h"

#include "Support/Images/HypercubePlate.h"
#include "Support/Images/VolumeStage.h"

#include "vtkAlgorithm.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkTimeVaryingIntervalVolume.h"
#include "vtkTimeWeightedTetrahedraMapper.h"
#include "vtkVolumeProperty.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <string>

namespace
{
constexpr int CELLS = 8;

/// Half the height of the region that MeasureDeviation() renders, in cells. It is less than half
/// the height of the plate, so that the plate covers all pixels.
constexpr double MEASURED = 0.48 * CELLS;

/// Renders the plate from the front in parallel projection, and returns the standard deviation of
/// the opacity over all pixels.
double MeasureDeviation(vtkVolume* plate)
{
  vtkNew<vtkCamera> camera;
  camera->ParallelProjectionOn();
  camera->SetParallelScale(MEASURED);
  camera->SetFocalPoint(0.0, 0.0, 0.5);
  camera->SetPosition(0.0, 0.0, 2.0 * CELLS);
  camera->SetClippingRange(CELLS, 3.0 * CELLS);
  const std::array<int, 2> size = { { 400, 400 } };
  reference::VolumeStage stage(size);
  stage.SetVolume(gallery::GetMapper(plate), plate->GetProperty());
  stage.SetCamera(camera);
  const reference::RgbaImage image = stage.Capture();

  const double pixels = static_cast<double>(image.Width) * image.Height;
  double sum = 0.0;
  double squares = 0.0;
  for (int j = 0; j < image.Height; ++j)
  {
    for (int i = 0; i < image.Width; ++i)
    {
      sum += image.At(i, j)[3];
      squares += image.At(i, j)[3] * image.At(i, j)[3];
    }
  }
  const double mean = sum / pixels;
  return std::sqrt(std::max(squares / pixels - mean * mean, 0.0));
}

/// Formats \a deviation with few digits, so that the text does not depend on the OpenGL driver.
std::string ToText(double deviation)
{
  std::array<char, 64> text;
  std::snprintf(text.data(), text.size(), deviation < 1e-5 ? "below 0.00001" : "%.4f", deviation);
  return text.data();
}

void Build(gallery::Stage& stage)
{
  vtkNew<vtkTimeVaryingIntervalVolume> interval;
  interval->SetInterval(0, -1.0, 1.0);
  vtkSmartPointer<vtkUnstructuredGrid> tetrahedra =
    stage.Extract(interval, reference::MakeHypercubePlate(CELLS, 2, 1.0, true));

  // With this extinction, the mean opacity without weighting by duration is about the same as with
  // it.
  vtkSmartPointer<vtkVolume> without =
    gallery::MakeVolumeOfIntervals(tetrahedra, { { gallery::IntervalColor(0), 0.22 } });
  gallery::GetMapper(without)->SetDeltaTArrayName("");
  gallery::GetMapper(without)->SetBlendModeToOpticalDepth();
  vtkSmartPointer<vtkVolume> with =
    gallery::MakeVolumeOfIntervals(tetrahedra, { { gallery::IntervalColor(0), 1.1 } });

  stage.SetColumns(2);
  const std::string deviation = ": standard deviation of opacity ";
  for (const vtkVector3d& from : { vtkVector3d(0.0, 0.0, 1.0), vtkVector3d(0.45, -0.8, 0.9) })
  {
    const bool isFront = from[0] == 0.0;
    for (vtkVolume* plate : { without.Get(), with.Get() })
    {
      const std::string name = plate == with ? "with Δt" : "without Δt";
      gallery::Panel& panel = stage.AddPanel(
        isFront ? name + deviation + ToText(MeasureDeviation(plate)) : name + ", obliquely");
      panel.Add(plate);
      panel.UseParallelProjection();
      panel.LookFrom(from, { 0.0, 1.0, 0.0 });
    }
  }
}

const gallery::SceneRegistration registration(
  { "constant-plate", "3.14", "A plate of constant hypercubes, without and with Δt",
    "A plate of 8 x 8 constant hypercubes, whose points move by part of a cell between two time "
    "steps, projected along time. The tetrahedra overlap. On the left each has the same weight, "
    "and the overlap is visible as a pattern (figure 3.14). On the right each is weighted by its "
    "duration Δt, and the plate is uniform (figure 3.19). The lower row shows the plate obliquely, "
    "where its edges are thinner. If the points did not move, all 4-simplices would project to the "
    "same tetrahedra and hide the error.",
    {}, &Build });
}
