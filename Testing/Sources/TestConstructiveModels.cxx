// SPDX-License-Identifier: BSD-3-Clause
// Documented bounds of the models, volumes of models composed of boxes, spheres and tori, density
// and color at known points, and the source that samples the models.
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Checks/ReferenceProgress.h"

#include "vtkConstructiveModelSource.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkSpatialObject.h"

#include <cmath>
#include <map>
#include <set>
#include <string>

namespace
{

using namespace reference;

const double Pi = std::acos(-1.0);

// The documented bounds.
const double Boxes[vtkConstructiveModelSource::NUMBER_OF_MODELS][6] = { { -0.5, 0.5, -0.5, 0.5,
                                                                          -0.5, 0.5 },
  { -0.25, 0.25, -0.25, 0.25, 0.0, 1.23 }, { -0.98, 0.98, -0.98, 0.98, -0.31, 0.31 },
  { -0.5, 0.68, -0.6, 0.5, -0.5, 0.78 }, { -0.75, 0.75, -0.75, 0.75, -0.75, 0.75 },
  { -0.55, 0.55, -0.62, 0.4, 0.0, 1.32 }, { -1.05, 1.0, -1.0, 1.05, -0.05, 1.5 },
  { -0.45, 0.45, -0.25, 0.25, 0.0, 0.55 }, { -0.17, 0.17, -0.17, 0.17, 0.0, 0.72 } };

bool IsBoundTight(int model)
{
  return model != vtkConstructiveModelSource::RINGS &&
    model != vtkConstructiveModelSource::TEDDY_BEAR;
}

// Checks that the density of a sampled model is confined to its documented bounding box and extends
// close to each of its sides. Returns the volume.
double CheckBox(int model, Check& check)
{
  vtkNew<vtkConstructiveModelSource> source;
  source->SetModel(model);
  source->SetResolution(100);
  // Noise is slow to evaluate, and the volume of the noisy sphere is unknown.
  source->SetNumberOfSubsamples(model == vtkConstructiveModelSource::HYPERTEXTURE_SPHERE ? 1 : 2);
  source->Update();
  vtkImageData* image = source->GetOutput();
  vtkDataArray* values = image->GetPointData()->GetScalars();
  const double* spacing = image->GetSpacing();
  double bounds[6];
  source->GetRoot()->GetBounds(bounds);
  const double* box = Boxes[model];
  for (int side = 0; side < 6 && IsBoundTight(model); ++side)
  {
    check.Near(bounds[side], box[side], 1e-12, "a bound", 1.0);
  }
  double sum = 0.0;
  int outside = 0;
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    double x[3];
    image->GetPoint(i, x);
    const double density = values->GetTuple1(i);
    sum += density;
    for (int axis = 0; axis < 3; ++axis)
    {
      // The subsamples of a point extend half the spacing to each side.
      outside += density > 0.0 &&
        (x[axis] + 0.5 * spacing[axis] < box[2 * axis] ||
          x[axis] - 0.5 * spacing[axis] > box[2 * axis + 1]);
    }
  }
  check.Equal(outside, 0, "points with density outside the box");
  return sum * spacing[0] * spacing[1] * spacing[2];
}

void CheckBoxes(Check& check)
{
  const double lens = 0.5 * 0.5 + 0.28 * 0.28;
  const double d = std::sqrt(0.4 * 0.4 + 0.32 * 0.32 + 0.5 * 0.5);
  // Volume of the intersection of two spheres.
  const double shared = Pi * (0.78 - d) * (0.78 - d) *
    (d * d + 2.0 * d * 0.78 - 3.0 * (lens - 2.0 * 0.5 * 0.28)) / (12.0 * d);
  const double fuzzy = 4.0 * Pi *
    (std::pow(0.2, 3) / 3.0 +
      (0.25 * (std::pow(0.5, 3) - std::pow(0.2, 3)) / 3.0 -
        (std::pow(0.5, 5) - std::pow(0.2, 5)) / 5.0) /
        (0.25 - 0.04));
  const double volumes[vtkConstructiveModelSource::NUMBER_OF_MODELS] = { fuzzy, 0.0,
    2.0 * Pi * Pi * (0.65 * 0.0036 + 6.0 * 0.26 * 0.0025),
    4.0 / 3.0 * Pi * (std::pow(0.5, 3) + std::pow(0.28, 3)) - shared, 0.0, 0.0, 0.0, 0.0, 0.0 };
  std::set<std::string> names;
  for (int model = 0; model < vtkConstructiveModelSource::NUMBER_OF_MODELS; ++model)
  {
    const char* name = vtkConstructiveModelSource::GetModelName(model);
    check.SetContext(name);
    names.insert(name);
    const double volume = CheckBox(model, check);
    check.That(volume > 0.0, "there is density");
    if (volumes[model] > 0.0)
    {
      check.Near(volume, volumes[model], 0.02, "volume");
    }
  }
  check.Equal(names.size(), vtkConstructiveModelSource::NUMBER_OF_MODELS, "the names differ");
  check.That(!vtkConstructiveModelSource::GetModelName(-1) &&
      !vtkConstructiveModelSource::MakeModel(9) && !vtkConstructiveModelSource::MakeModel(-1),
    "invalid model indices are rejected");
}

// Models composed of boxes have sides at multiples of 0.01. Their volume is the total volume of the
// cells of that size whose centers are inside.
void CheckHundredths(Check& check)
{
  const std::map<int, double> volumes = { { vtkConstructiveModelSource::ROBOT,
                                            std::pow(0.28, 3) + std::pow(0.5, 3) +
                                              2.0 * 0.16 * 0.2 * 0.45 },
    // The floor and two walls, minus the walls' overlap and the window opening, plus the cross in
    // the window.
    { vtkConstructiveModelSource::ROOM,
      2.05 * 2.05 * 0.05 + 2.05 * 0.05 * 1.5 + 2.0 * 0.05 * 1.5 - 0.05 * 0.8 * 0.7 +
        0.05 * (0.8 * 0.04 + 0.7 * 0.04 - 0.04 * 0.04) },
    { vtkConstructiveModelSource::DESK, 0.9 * 0.5 * 0.05 + 4.0 * 0.06 * 0.06 * 0.5 },
    { vtkConstructiveModelSource::CHAIR,
      0.34 * 0.34 * 0.04 + 0.34 * 0.04 * 0.4 + 4.0 * 0.04 * 0.04 * 0.28 } };
  for (const auto& [model, volume] : volumes)
  {
    check.SetContext(std::string("volume, ") + vtkConstructiveModelSource::GetModelName(model));
    vtkNew<vtkConstructiveVolume> source;
    source->SetRoot(vtkConstructiveModelSource::MakeModel(model));
    double bounds[6];
    int dimensions[3];
    for (int axis = 0; axis < 3; ++axis)
    {
      const double* box = Boxes[model] + 2 * axis;
      dimensions[axis] = static_cast<int>(std::lround(100.0 * (box[1] - box[0])));
      bounds[2 * axis] = box[0] + 0.005;
      bounds[2 * axis + 1] = box[1] - 0.005;
    }
    source->SetBounds(bounds);
    source->SetDimensions(dimensions[0], dimensions[1], dimensions[2]);
    source->Update();
    vtkDataArray* values = source->GetOutput()->GetPointData()->GetScalars();
    double sum = 0.0;
    for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
    {
      sum += values->GetTuple1(i);
    }
    check.Near(sum * 1e-6, volume, 1e-9, "volume");
  }
}

void CheckPositions(Check& check)
{
  struct Position
  {
    int Model;
    double X[3];
    double Density;
  };
  // Points inside and outside. Each point tests a detail of its model.
  const Position positions[] = {
    { vtkConstructiveModelSource::ROBOT, { 0.0, 0.0, 1.1 }, 1.0 },
    { vtkConstructiveModelSource::ROBOT, { 0.2, 0.0, 1.1 }, 0.0 },
    { vtkConstructiveModelSource::ROBOT, { 0.14, 0.05, 0.2 }, 1.0 },
    { vtkConstructiveModelSource::ROBOT, { 0.0, 0.0, 0.2 }, 0.0 },
    { vtkConstructiveModelSource::RINGS, { 0.65, 0.0, 0.0 }, 1.0 },
    { vtkConstructiveModelSource::RINGS, { 0.91, 0.0, 0.0 }, 1.0 },
    { vtkConstructiveModelSource::RINGS, { 0.39, 0.0, 0.0 }, 1.0 },
    { vtkConstructiveModelSource::RINGS, { 0.78, 0.0, 0.0 }, 0.0 },
    { vtkConstructiveModelSource::RINGS, { 0.0, 0.0, 0.0 }, 0.0 },
    { vtkConstructiveModelSource::HYPERTEXTURE_SPHERE, { 0.0, 0.0, 0.0 }, 1.0 },
    { vtkConstructiveModelSource::ROOM, { 0.2, 1.02, 0.6 }, 0.0 },
    { vtkConstructiveModelSource::ROOM, { 0.0, 1.02, 0.6 }, 1.0 },
    { vtkConstructiveModelSource::ROOM, { 0.6, 1.02, 0.6 }, 1.0 },
    { vtkConstructiveModelSource::ROOM, { 0.0, 0.0, 0.7 }, 0.0 },
    { vtkConstructiveModelSource::DESK, { 0.0, 0.0, 0.52 }, 1.0 },
    { vtkConstructiveModelSource::DESK, { 0.0, 0.0, 0.3 }, 0.0 },
    { vtkConstructiveModelSource::DESK, { 0.43, -0.23, 0.3 }, 1.0 },
    { vtkConstructiveModelSource::CHAIR, { 0.0, 0.15, 0.6 }, 1.0 },
    { vtkConstructiveModelSource::CHAIR, { 0.0, -0.15, 0.6 }, 0.0 },
    { vtkConstructiveModelSource::CHAIR, { -0.15, -0.15, 0.1 }, 1.0 },
  };
  for (const Position& position : positions)
  {
    check.SetContext(vtkConstructiveModelSource::GetModelName(position.Model));
    vtkSpatialObject::Sample sample;
    vtkConstructiveModelSource::MakeModel(position.Model)->Evaluate(position.X, sample);
    check.Near(sample.Density, position.Density, 0.0,
      "density at " + std::to_string(position.X[0]) + " " + std::to_string(position.X[1]) + " " +
        std::to_string(position.X[2]));
  }
  check.SetContext("teddy bear");
  const auto bear = vtkConstructiveModelSource::MakeModel(vtkConstructiveModelSource::TEDDY_BEAR);
  const double eye[3] = { 0.1, -0.27, 0.98 };
  const double belly[3] = { 0.0, 0.0, 0.4 };
  vtkSpatialObject::Sample sample;
  bear->Evaluate(eye, sample);
  check.That(sample.Density == 1.0 && sample.Color[0] < 0.1, "a black eye");
  bear->Evaluate(belly, sample);
  check.That(sample.Density > 0.5 && sample.Color[0] > 0.6, "a brown belly");
}

void CheckSource(Check& check)
{
  check.SetContext("source");
  vtkNew<vtkConstructiveModelSource> source;
  check.Equal(source->GetModel(), vtkConstructiveModelSource::ROBOT, "model");
  check.Equal(source->GetWholeExtent()[5], 127, "points along the longest side minus one");
  source->SetModel(99);
  check.Equal(source->GetModel(), vtkConstructiveModelSource::CHAIR, "clamped model");
  source->SetResolution(1000000);
  check.Equal(source->GetResolution(), 2048, "clamped resolution");
  source->SetResolution(40);
  check.Equal(source->GetWholeExtent()[5], 39, "points along the longest side minus one");
  CheckPrinted(Print(source), { "Model: chair", "Resolution: 40" }, check);
}

}

int TestConstructiveModels(int, char*[])
{
  return RunChecks({ CheckBoxes, CheckHundredths, CheckPositions, CheckSource });
}
