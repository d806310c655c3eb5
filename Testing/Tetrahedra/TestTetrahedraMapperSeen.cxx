// SPDX-License-Identifier: BSD-3-Clause
// Compares the cells and points that vtkHardwareSelector returns at every pixel with view rays
// through all tetrahedra.
#include "Support/Arrays/ReferenceIndices.h"
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Drawing/ImageCases.h"
#include "Support/Images/CameraSettings.h"
#include "Support/Images/ReferenceRay.h"
#include "Support/Images/VolumeStage.h"
#include "Support/Meshes/ReferenceField.h"
#include "Tetrahedra/MapperImage.h"

#include "vtkActor.h"
#include "vtkAppendFilter.h"
#include "vtkCamera.h"
#include "vtkDataObject.h"
#include "vtkHardwareSelector.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkTimeWeightedTetrahedraMapper.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace
{

using namespace reference;
using Mapper = vtkTimeWeightedTetrahedraMapper;
using Cells = std::set<vtkIdType>;

/// Relative tolerance of the optical depth in front of the cell. Cells on both sides of a face are
/// accepted if the face is this close to half of the pixel's opacity.
constexpr double Tolerance = 1e-4;

double GetOpticalDepth(const std::vector<RaySegment>& segments)
{
  double total = 0.0;
  for (const RaySegment& segment : segments)
  {
    total += segment.OpticalDepth;
  }
  return total;
}

/// Returns the cells that may be seen at a pixel; empty if none is seen.
Cells FindExpected(const std::vector<RaySegment>& segments, Blend how)
{
  Cells cells;
  if (how == Blend::MaximumIntensity)
  {
    double maximum = -1e300;
    for (const RaySegment& segment : segments)
    {
      maximum = std::max(maximum, segment.Maximum);
    }
    for (const RaySegment& segment : segments)
    {
      if (segment.Maximum > maximum - 1e-6 && segment.OpacityAtMaximum > 0.0)
      {
        cells.insert(segment.Cell);
      }
    }
    return cells;
  }
  const double half = -std::log1p(0.5 * std::expm1(-GetOpticalDepth(segments)));
  double inFront = 0.0;
  for (const RaySegment& segment : segments)
  {
    const double next = inFront + segment.OpticalDepth;
    if (segment.OpticalDepth > 0.0 && inFront <= half * (1.0 + Tolerance) &&
      next >= half * (1.0 - Tolerance))
    {
      cells.insert(segment.Cell);
    }
    inFront = next;
  }
  return cells;
}

/// Returns a mesh with random scalars `f`, cell layers and an extent in time.
vtkSmartPointer<vtkUnstructuredGrid> MakeGrid(int cubes, unsigned int seed)
{
  auto grid = MakeBox({ { cubes, cubes, cubes } });
  AddRandomField(grid, seed, "f");
  grid->GetPointData()->SetActiveScalars("f");
  AddRandomField(grid, seed + 1, "DeltaT");
  AddSlabIndices(grid, "IntervalId", 0, 3);
  return grid;
}

/// Selects at all pixels.
class Selection
{
public:
  Selection(VolumeStage& stage, int association)
  {
    const int* size = stage.GetRenderer()->GetSize();
    this->Selector->SetRenderer(stage.GetRenderer());
    this->Selector->SetFieldAssociation(association);
    this->Selector->SetArea(
      0, 0, static_cast<unsigned int>(size[0] - 1), static_cast<unsigned int>(size[1] - 1));
    this->Selector->CaptureBuffers();
  }

  vtkHardwareSelector::PixelInformation Get(int i, int j)
  {
    const unsigned int pixel[2] = { static_cast<unsigned int>(i), static_cast<unsigned int>(j) };
    return this->Selector->GetPixelInformation(pixel);
  }

private:
  vtkNew<vtkHardwareSelector> Selector;
};

void SetUp(VolumeStage& stage, Mapper* mapper, const ImageCase& what)
{
  Configure(mapper, what);
  stage.SetVolume(mapper, what.Property);
  stage.SetCamera(what.Camera);
  for (vtkActor* actor : what.Actors)
  {
    stage.AddActor(actor);
  }
  stage.Render();
}

/// Compares the cells at all pixels.
void Compare(Check& check, const ImageCase& what, VolumeStage& stage, const std::string& name)
{
  Selection selection(stage, vtkDataObject::FIELD_ASSOCIATION_CELLS);
  const auto segments = MakeReferenceSegments(what.Grid, what.Property, what.Camera, what.Settings);
  int seen = 0;
  int ambiguous = 0;
  int behind = 0;
  int different = 0;
  double densest = 0.0;
  for (const std::vector<RaySegment>& ray : segments)
  {
    densest = std::max(densest, GetOpticalDepth(ray));
  }
  std::size_t pixel = 0;
  for (const auto& [j, i] : AllIndices(what.Settings.Size[1], what.Settings.Size[0]))
  {
    const std::vector<RaySegment>& ray = segments[pixel++];
    const Cells expected = FindExpected(ray, what.Settings.How);
    const vtkHardwareSelector::PixelInformation found = selection.Get(i, j);
    const bool isCell = found.Valid && found.Prop == stage.GetVolume();
    const bool isNearlyEmpty = expected.empty() || GetOpticalDepth(ray) < 1e-6 * densest;
    const bool isSame = isCell ? expected.count(found.AttributeID) > 0 : isNearlyEmpty;
    seen += expected.empty() ? 0 : 1;
    ambiguous += expected.size() > 1 ? 1 : 0;
    behind += !expected.empty() && expected.count(ray.front().Cell) == 0 ? 1 : 0;
    different += isSame ? 0 : 1;
  }
  std::cout << name << ": " << seen << " pixels, " << behind << " behind the first cell, "
            << ambiguous << " ambiguous, " << different << " different\n";
  check.That(seen > 300, name + ": " + std::to_string(seen) + " pixels");
  // The maximum is usually on a face of two cells.
  check.That(ambiguous < seen / 20 || what.Settings.How == Blend::MaximumIntensity,
    name + ": " + std::to_string(ambiguous) + " are ambiguous");
  check.Equal(different, 0, name + ": pixels that differ");
}

void CompareBothPaths(Check& check, const ImageCase& what, const std::string& name)
{
  for (int path : AllRenderPaths())
  {
    vtkNew<Mapper> mapper;
    mapper->SetRenderPath(path);
    VolumeStage stage(what.Settings.Size);
    SetUp(stage, mapper, what);
    Compare(check, what, stage, name + ", " + GetPathName(path));
  }
}

ImageCase MakeSeenCase(int cubes, bool parallel, const std::array<int, 2>& size = { { 96, 80 } })
{
  // A third of the scalars is transparent.
  auto property =
    MakeProperty({ { 0.0, { { 1.0, 0.1, 0.0 } }, 0.0 }, { 0.33, { { 1.0, 0.1, 0.0 } }, 0.0 },
                   { 0.5, { { 0.0, 0.9, 0.3 } }, 2.0 }, { 1.0, { { 0.0, 0.1, 1.0 } }, 0.3 } },
      0.5);
  return MakeCase(MakeGrid(cubes, 5), property, { { -0.5, -0.3, -0.8 } }, parallel, size);
}

void TestBlends(Check& check, bool parallel)
{
  for (Blend how : { Blend::Composite, Blend::OpticalDepth, Blend::Additive, Blend::Priority,
         Blend::MaximumIntensity })
  {
    for (bool hasExtent : { false, true })
    {
      ImageCase what = MakeSeenCase(5, parallel);
      what.Settings.How = how;
      what.Settings.Arrays.DeltaT = hasExtent ? "DeltaT" : "";
      what.Settings.Priorities = { { 1, 7.0 } };
      CompareBothPaths(check, what,
        "blend " + std::to_string(static_cast<int>(how)) + (parallel ? ", parallel" : "") +
          (hasExtent ? ", in time" : ""));
    }
  }
}

/// Tests tetrahedra that overlap, cell scalars, mean extinctions, and dense and thin media.
void TestMedia(Check& check)
{
  ImageCase what = MakeSeenCase(4, false);
  vtkNew<vtkAppendFilter> both;
  both->AddInputData(what.Grid);
  auto other = MakeGrid(3, 9);
  MovePoints(other, { { 0.01, 0.02, 0.03 } }, 0.9);
  both->AddInputData(other);
  both->Update();
  what.Grid = both->GetOutput();
  what.Settings.How = Blend::OpticalDepth;
  CompareBothPaths(check, what, "overlapping");

  what = MakeSeenCase(5, false);
  what.Settings.Mode = Integration::AverageColor;
  CompareBothPaths(check, what, "mean extinctions");
  for (double unit : { 1e-3, 1e3 })
  {
    what = MakeSeenCase(5, true);
    what.Property->SetScalarOpacityUnitDistance(unit);
    CompareBothPaths(check, what, "unit distance " + std::to_string(unit));
  }
  what = MakeSeenCase(5, false);
  what.Settings.Arrays.Scalars = "IntervalId";
  what.Settings.Arrays.OfCells = true;
  CompareBothPaths(check, what, "cell scalars");
}

void TestOpaque(Check& check, bool parallel)
{
  for (double behind : { -1.5, -0.2, 0.3, 1.5 })
  {
    ImageCase what = MakeSeenCase(5, parallel);
    AddPlane(what, behind, { { 1.0, 1.0, 1.0 } });
    const std::string name = "plane at " + std::to_string(behind);
    if (behind > -1.0)
    {
      CompareBothPaths(check, what, name);
      continue;
    }
    vtkNew<Mapper> mapper;
    VolumeStage stage(what.Settings.Size);
    SetUp(stage, mapper, what);
    Selection selection(stage, vtkDataObject::FIELD_ASSOCIATION_CELLS);
    check.That(selection.Get(48, 40).Prop == what.Actors[0], name + ": the plane is selected");
  }
}

/// Tests that selection has full detail while images are reduced.
void TestReducedImage(Check& check)
{
  const ImageCase what = MakeSeenCase(20, false, { { 64, 48 } });
  vtkNew<Mapper> mapper;
  mapper->AutoAdjustLevelOfDetailOn();
  VolumeStage stage(what.Settings.Size);
  stage.GetWindow()->SetDesiredUpdateRate(1e6);
  SetUp(stage, mapper, what);
  check.That(mapper->GetReport()->GetCount("TetrahedronStride") > 1, "the image shows a subset");
  Compare(check, what, stage, "reduced");
}

/// Tests two volumes in one renderer. At each pixel, the closer of the two cells is selected.
void TestTwoVolumes(Check& check)
{
  std::array<ImageCase, 2> cases{ { MakeSeenCase(5, false), MakeSeenCase(4, false) } };
  MovePoints(cases[1].Grid, { { 0.37, -0.2, 0.31 } }, 0.6);
  cases[1].Camera = cases[0].Camera;
  cases[1].Property->SetScalarOpacityUnitDistance(0.05);
  std::array<vtkNew<Mapper>, 2> mappers;
  VolumeStage stage(cases[0].Settings.Size);
  SetUp(stage, mappers[0], cases[0]);
  Configure(mappers[1], cases[1]);
  vtkNew<vtkVolume> second;
  second->SetMapper(mappers[1]);
  second->SetProperty(cases[1].Property);
  stage.GetRenderer()->AddVolume(second);
  stage.Render();
  const std::array<vtkVolume*, 2> volumes{ { stage.GetVolume(), second } };
  std::array<std::vector<std::vector<RaySegment>>, 2> segments;
  for (int k = 0; k < 2; ++k)
  {
    segments[k] =
      MakeReferenceSegments(cases[k].Grid, cases[k].Property, cases[k].Camera, cases[k].Settings);
  }
  Selection selection(stage, vtkDataObject::FIELD_ASSOCIATION_CELLS);
  int seen[2] = { 0, 0 };
  int different = 0;
  std::size_t pixel = 0;
  for (const auto& [j, i] : AllIndices(cases[0].Settings.Size[1], cases[0].Settings.Size[0]))
  {
    // Entries of the cells that may be seen, with their volumes.
    std::map<double, std::pair<int, vtkIdType>> entries;
    for (int k = 0; k < 2; ++k)
    {
      const std::vector<RaySegment>& ray = segments[k][pixel];
      const Cells cells = FindExpected(ray, Blend::Composite);
      for (const RaySegment& segment : ray)
      {
        if (cells.count(segment.Cell) > 0)
        {
          entries[segment.Entry] = { k, segment.Cell };
        }
      }
    }
    ++pixel;
    const vtkHardwareSelector::PixelInformation found = selection.Get(i, j);
    if (entries.empty())
    {
      different += found.Valid ? 1 : 0;
      continue;
    }
    const auto& [first, expected] = *entries.begin();
    ++seen[expected.first];
    // The depth buffer cannot order cells whose entries are almost equal.
    const bool isSame = std::any_of(entries.begin(), entries.end(),
      [&, first = first](const auto& entry)
      {
        return entry.first < first + 1e-4 && found.Prop == volumes[entry.second.first] &&
          found.AttributeID == entry.second.second;
      });
    different += found.Valid && isSame ? 0 : 1;
  }
  check.That(seen[0] > 300 && seen[1] > 300, "both volumes are seen");
  check.That(different <= 3, "two volumes: " + std::to_string(different) + " pixels differ");
}

/// Tests that each pixel shows the closest corner of the cell that is seen there.
void TestPoints(Check& check, bool parallel)
{
  const ImageCase what = MakeSeenCase(5, parallel);
  vtkNew<Mapper> mapper;
  VolumeStage stage(what.Settings.Size);
  SetUp(stage, mapper, what);
  Selection selection(stage, vtkDataObject::FIELD_ASSOCIATION_POINTS);
  const auto segments = MakeReferenceSegments(what.Grid, what.Property, what.Camera, what.Settings);
  const PixelRays rays(what.Camera, what.Settings.Size);
  int shown = 0;
  int different = 0;
  std::size_t pixel = 0;
  vtkNew<vtkIdList> corners;
  for (const auto& [j, i] : AllIndices(what.Settings.Size[1], what.Settings.Size[0]))
  {
    const Cells cells = FindExpected(segments[pixel++], Blend::Composite);
    vtkIdType expected = -1;
    double smallest = 3.0;
    if (!cells.empty())
    {
      what.Grid->GetCellPoints(*cells.begin(), corners);
    }
    for (vtkIdType k = 0; !cells.empty() && k < 4; ++k)
    {
      const double* x = what.Grid->GetPoint(corners->GetId(k));
      const auto at = rays.Project({ x[0], x[1], x[2] });
      const double distance = std::hypot((*at)[0] - i - 0.5, (*at)[1] - j - 0.5);
      expected = distance < smallest ? corners->GetId(k) : expected;
      smallest = std::min(smallest, distance);
    }
    const vtkHardwareSelector::PixelInformation found = selection.Get(i, j);
    const bool isSame = expected < 0 ? !found.Valid : found.Valid && found.AttributeID == expected;
    shown += expected >= 0 ? 1 : 0;
    different += isSame || cells.size() > 1 ? 0 : 1;
  }
  check.That(shown > 100, "points: " + std::to_string(shown) + " pixels");
  check.That(different <= 2, "points: " + std::to_string(different) + " pixels differ");
}

}

int TestTetrahedraMapperSeen(int, char*[])
{
  Check check;
  for (bool parallel : { true, false })
  {
    TestBlends(check, parallel);
    TestOpaque(check, parallel);
    TestPoints(check, parallel);
  }
  TestMedia(check);
  TestReducedImage(check);
  TestTwoVolumes(check);
  return check.Result();
}
