// SPDX-License-Identifier: BSD-3-Clause
// Extremes of volumes that vtkShadowedScenePass draws together, each by its name: at the same
// place, touching, empty, transparent, hidden, many, of very different size, with faults, a context
// remade.
#include "Support/Pages/StabilityCase.h"
#include "SceneStage.h"

#include "vtkActor.h"
#include "vtkCommand.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkShadowedSliceMapper.h"
#include "vtkTestErrorObserver.h"
#include "vtkVolume.h"
#include "vtkVolumeCollection.h"
#include "vtkVolumeProperty.h"

#include <array>
#include <functional>
#include <string>

namespace
{
using namespace reference;
using Change = std::function<void(SceneStage&)>;
using Box = std::array<double, 6>;

const Box SMOKE{ { -0.4, 0.4, -0.4, 0.4, 0.1, 0.5 } };
constexpr double EXTINCTION = 2.0;

vtkVolume* GetVolume(SceneStage& stage, int index)
{
  return vtkVolume::SafeDownCast(stage.Stage.GetRenderer()->GetVolumes()->GetItemAsObject(index));
}

vtkShadowedSliceMapper* GetMapper(SceneStage& stage, int index)
{
  return vtkShadowedSliceMapper::SafeDownCast(GetVolume(stage, index)->GetMapper());
}

/// A floor, a sun, and volumes over it.
class VolumeTable
{
public:
  VolumeTable(int argc, char* argv[])
    : Catalogue("TestShadowedVolumesExtremes", argc, argv)
  {
    this->Catalogue.SetClass("vtkShadowedScenePass");
  }

  RgbaPicture Draw(const Change& add, double scale = 1.0)
  {
    SceneStage stage(64, 2.0 * scale);
    stage.Add(MakeRectangle(
      { { -scale, -scale, 0.0 } }, { { 2.0 * scale, 0.0, 0.0 } }, { { 0.0, 2.0 * scale, 0.0 } }));
    stage.Stage.SetLights({ MakeSun({ { 0.6, 0.2, -1.0 } }) });
    add(stage);
    RgbaPicture picture = stage.Draw();
    this->Together = stage.GetReport()->GetNumber("VolumesInSharedSlices");
    return picture;
  }

  /// Two scenes have the same picture, and so many volumes are drawn together in the first one.
  void Equal(const std::string& name, const std::string& extreme, const Change& add, int together,
    const Change& expected, double bound, const std::string& as)
  {
    const RgbaPicture found = this->Draw(add);
    const bool isTogether = this->Together == together;
    this->Catalogue.Check(name + "-count", extreme, std::to_string(together) + " drawn together",
      std::to_string(this->Together), isTogether);
    this->Catalogue.Measure(name, extreme, "largest difference from " + as,
      ComparePictures(found, this->Draw(expected)).Max, bound);
  }

  StabilityCatalogue Catalogue;
  int Together = 0;
};

void AddWhole(SceneStage& stage)
{
  stage.AddSmoke(SMOKE, EXTINCTION);
}

/// Cuts the box into so many parts along each axis.
void AddParts(SceneStage& stage, const std::array<int, 3>& parts)
{
  for (int part = 0; part < parts[0] * parts[1] * parts[2]; ++part)
  {
    const std::array<int, 3> place{ { part % parts[0], part / parts[0] % parts[1],
      part / parts[0] / parts[1] } };
    Box box{};
    for (int axis = 0; axis < 3; ++axis)
    {
      const double extent = (SMOKE[2 * axis + 1] - SMOKE[2 * axis]) / parts[axis];
      box[2 * axis] = SMOKE[2 * axis] + place[axis] * extent;
      box[2 * axis + 1] = box[2 * axis] + extent;
    }
    stage.AddSmoke(box, EXTINCTION, 4);
  }
}

void AddSecond(SceneStage& stage)
{
  AddWhole(stage);
  stage.AddSmoke({ { -0.1, 0.6, -0.5, 0.2, 0.6, 0.9 } }, EXTINCTION);
}

void TestPlaces(VolumeTable& table)
{
  table.Equal(
    "volumes-same-place", "two volumes at the same place",
    [](SceneStage& stage)
    {
      stage.AddSmoke(SMOKE, 0.5 * EXTINCTION);
      stage.AddSmoke(SMOKE, 0.5 * EXTINCTION);
    },
    2, AddWhole, 0.002, "one of twice the density");
  table.Equal(
    "volumes-touching", "two volumes with a common face",
    [](SceneStage& stage) {
      AddParts(stage, { { 2, 1, 1 } });
    },
    2, AddWhole, 0.02, "one of both");
  table.Equal(
    "volumes-eight", "eight volumes with a common corner",
    [](SceneStage& stage) {
      AddParts(stage, { { 2, 2, 2 } });
    },
    8, AddWhole, 0.02, "one of all");
}

void TestNothing(VolumeTable& table)
{
  table.Equal(
    "volumes-hidden", "one of two volumes hidden",
    [](SceneStage& stage)
    {
      AddSecond(stage);
      GetVolume(stage, 1)->VisibilityOff();
    },
    0, AddWhole, 0.0, "the other one alone");
  table.Equal(
    "volumes-empty", "one of two volumes without points",
    [](SceneStage& stage)
    {
      AddSecond(stage);
      GetMapper(stage, 1)->SetInputData(vtkNew<vtkImageData>());
    },
    0, AddWhole, 0.0, "the other one alone");
  table.Equal(
    "volumes-transparent", "one of two volumes wholly transparent",
    [](SceneStage& stage)
    {
      AddSecond(stage);
      vtkPiecewiseFunction* opacity = GetVolume(stage, 1)->GetProperty()->GetScalarOpacity();
      opacity->RemoveAllPoints();
      opacity->AddPoint(0.0, 0.0);
      opacity->AddPoint(2.0, 0.0);
    },
    2, AddWhole, 0.05, "the other one alone");
  table.Equal(
    "volumes-1-to-1000", "two volumes whose voxels are 1 to 1000",
    [](SceneStage& stage)
    {
      AddWhole(stage);
      stage.AddSmoke({ { 0.5, 0.5008, 0.0, 0.0008, 0.5, 0.5004 } }, EXTINCTION);
    },
    0, AddWhole, 1e-3, "the large one alone");
}

void TestFaults(VolumeTable& table)
{
  vtkNew<vtkTest::ErrorObserver> observer;
  table.Equal(
    "volumes-no-scalars", "one of three volumes without scalars",
    [&observer](SceneStage& stage)
    {
      AddSecond(stage);
      stage.AddSmoke({ { -0.6, 0.0, 0.0, 0.6, 0.3, 0.7 } }, EXTINCTION);
      GetMapper(stage, 2)->AddObserver(vtkCommand::ErrorEvent, observer);
      GetMapper(stage, 2)->GetInput()->GetPointData()->SetScalars(nullptr);
    },
    2, AddSecond, 0.0, "the others alone");
  table.Catalogue.Check("volumes-no-scalars-error", "one of three volumes without scalars",
    "an error names it", observer->GetErrorMessage(),
    observer->GetErrorMessage().find("no scalars") != std::string::npos);
  const RgbaPicture picture = table.Draw(
    [](SceneStage& stage)
    {
      AddWhole(stage);
      vtkNew<vtkVolume> again;
      again->SetMapper(GetMapper(stage, 0));
      again->SetProperty(GetVolume(stage, 0)->GetProperty());
      stage.Stage.GetRenderer()->AddVolume(again);
    });
  table.Catalogue.Check("volumes-one-mapper", "one mapper with two volumes",
    "none is drawn together, and something is seen",
    std::to_string(table.Together) + ", " + std::to_string(LargestAlpha(picture)),
    table.Together == 0 && LargestAlpha(picture) > 0.5);
}

void TestSizes(VolumeTable& table)
{
  const RgbaPicture expected = table.Draw(AddSecond);
  for (const double scale : { 1e-5, 1e5 })
  {
    const RgbaPicture found = table.Draw(
      [scale](SceneStage& stage)
      {
        for (const Box& box : { SMOKE, Box{ { -0.1, 0.6, -0.5, 0.2, 0.6, 0.9 } } })
        {
          Box scaled{};
          for (std::size_t i = 0; i < 6; ++i)
          {
            scaled[i] = scale * box[i];
          }
          stage.AddSmoke(scaled, EXTINCTION);
        }
        for (int i = 0; i < 2; ++i)
        {
          GetVolume(stage, i)->GetProperty()->SetScalarOpacityUnitDistance(0.1 * scale);
        }
      },
      scale);
    table.Catalogue.Measure("volumes-size-" + std::string(scale < 1.0 ? "small" : "large"),
      "two volumes " + std::string(scale < 1.0 ? "1e-5" : "1e5") + " times as large",
      "mean difference", ComparePictures(found, expected).Mean, 1e-3);
  }
}

void TestContext(VolumeTable& table)
{
  SceneStage stage(64);
  stage.Stage.SetLights({ MakeSun({ { 0.6, 0.2, -1.0 } }) });
  AddSecond(stage);
  const RgbaPicture before = stage.Draw();
  stage.Stage.GetWindow()->Finalize();
  const RgbaPicture after = stage.Draw();
  table.Catalogue.Measure("volumes-context-remade",
    "a context that is lost and made again, of two volumes and no actor",
    "largest difference from before", ComparePictures(after, before).Max, 0.0);
  const int together = stage.GetReport()->GetNumber("VolumesInSharedSlices");
  table.Catalogue.Check("volumes-no-actor", "two volumes and no actor", "2 drawn together",
    std::to_string(together), together == 2);
}

}

int TestShadowedVolumesExtremes(int argc, char* argv[])
{
  VolumeTable table(argc, argv);
  TestPlaces(table);
  TestNothing(table);
  TestFaults(table);
  TestSizes(table);
  TestContext(table);
  return table.Catalogue.GetExitCode();
}
