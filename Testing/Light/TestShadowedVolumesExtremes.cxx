// SPDX-License-Identifier: BSD-3-Clause
// Extreme and invalid sets of volumes that vtkShadowedScenePass draws in shared slices: at the same
// position, touching, empty, transparent, hidden, many, of very different sizes, with errors, with
// a recreated OpenGL context.
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

/// Draws a floor lit by a sun, with volumes above the floor.
class VolumeTable
{
public:
  VolumeTable(int argc, char* argv[])
    : Catalogue("TestShadowedVolumesExtremes", argc, argv)
  {
    this->Catalogue.SetClass("vtkShadowedScenePass");
  }

  RgbaImage Draw(const Change& add, double scale = 1.0)
  {
    SceneStage stage(64, 2.0 * scale);
    stage.Add(MakeRectangle(
      { { -scale, -scale, 0.0 } }, { { 2.0 * scale, 0.0, 0.0 } }, { { 0.0, 2.0 * scale, 0.0 } }));
    stage.Stage.SetLights({ MakeSun({ { 0.6, 0.2, -1.0 } }) });
    add(stage);
    RgbaImage image = stage.Draw();
    this->Shared = stage.GetReport()->GetNumber("VolumesInSharedSlices");
    return image;
  }

  /// Compares the images of two scenes, and checks the number of volumes in shared slices in the
  /// first scene.
  void Equal(const std::string& name, const std::string& extreme, const Change& add, int shared,
    const Change& expected, double bound, const std::string& reference)
  {
    const RgbaImage found = this->Draw(add);
    const bool isExpected = this->Shared == shared;
    this->Catalogue.Check(name + "-count", extreme, std::to_string(shared) + " in shared slices",
      std::to_string(this->Shared), isExpected);
    this->Catalogue.Measure(name, extreme, "largest difference from " + reference,
      CompareImages(found, this->Draw(expected)).Max, bound);
  }

  StabilityCatalogue Catalogue;
  int Shared = 0;
};

void AddOne(SceneStage& stage)
{
  stage.AddSmoke(SMOKE, EXTINCTION);
}

/// Adds smoke that is divided into the given number of parts along each axis.
void AddParts(SceneStage& stage, const std::array<int, 3>& parts)
{
  for (int part = 0; part < parts[0] * parts[1] * parts[2]; ++part)
  {
    const std::array<int, 3> index{ { part % parts[0], part / parts[0] % parts[1],
      part / parts[0] / parts[1] } };
    Box box{};
    for (int axis = 0; axis < 3; ++axis)
    {
      const double extent = (SMOKE[2 * axis + 1] - SMOKE[2 * axis]) / parts[axis];
      box[2 * axis] = SMOKE[2 * axis] + index[axis] * extent;
      box[2 * axis + 1] = box[2 * axis] + extent;
    }
    stage.AddSmoke(box, EXTINCTION, 4);
  }
}

void AddSecond(SceneStage& stage)
{
  AddOne(stage);
  stage.AddSmoke({ { -0.1, 0.6, -0.5, 0.2, 0.6, 0.9 } }, EXTINCTION);
}

void TestPositions(VolumeTable& table)
{
  table.Equal(
    "volumes-same-place", "two volumes at the same position",
    [](SceneStage& stage)
    {
      stage.AddSmoke(SMOKE, 0.5 * EXTINCTION);
      stage.AddSmoke(SMOKE, 0.5 * EXTINCTION);
    },
    2, AddOne, 0.002, "one volume of twice the density");
  table.Equal(
    "volumes-touching", "two volumes with a common face",
    [](SceneStage& stage) {
      AddParts(stage, { { 2, 1, 1 } });
    },
    2, AddOne, 0.02, "one volume of both");
  table.Equal(
    "volumes-eight", "eight volumes with a common corner",
    [](SceneStage& stage) {
      AddParts(stage, { { 2, 2, 2 } });
    },
    8, AddOne, 0.02, "one volume of all");
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
    0, AddOne, 0.0, "the other volume");
  table.Equal(
    "volumes-empty", "one of two volumes without points",
    [](SceneStage& stage)
    {
      AddSecond(stage);
      GetMapper(stage, 1)->SetInputData(vtkNew<vtkImageData>());
    },
    0, AddOne, 0.0, "the other volume");
  table.Equal(
    "volumes-transparent", "one of two volumes fully transparent",
    [](SceneStage& stage)
    {
      AddSecond(stage);
      vtkPiecewiseFunction* opacity = GetVolume(stage, 1)->GetProperty()->GetScalarOpacity();
      opacity->RemoveAllPoints();
      opacity->AddPoint(0.0, 0.0);
      opacity->AddPoint(2.0, 0.0);
    },
    2, AddOne, 0.05, "the other volume");
  table.Equal(
    "volumes-1-to-1000", "two volumes with a ratio of voxel sizes of 1000",
    [](SceneStage& stage)
    {
      AddOne(stage);
      stage.AddSmoke({ { 0.5, 0.5008, 0.0, 0.0008, 0.5, 0.5004 } }, EXTINCTION);
    },
    0, AddOne, 1e-3, "the large volume");
}

void TestErrors(VolumeTable& table)
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
    2, AddSecond, 0.0, "the other volumes");
  table.Catalogue.Check("volumes-no-scalars-error", "one of three volumes without scalars",
    "an error names the problem", observer->GetErrorMessage(),
    observer->GetErrorMessage().find("no scalars") != std::string::npos);
  const RgbaImage image = table.Draw(
    [](SceneStage& stage)
    {
      AddOne(stage);
      vtkNew<vtkVolume> again;
      again->SetMapper(GetMapper(stage, 0));
      again->SetProperty(GetVolume(stage, 0)->GetProperty());
      stage.Stage.GetRenderer()->AddVolume(again);
    });
  table.Catalogue.Check("volumes-one-mapper", "one mapper with two volumes",
    "no shared slices, and an image that is not empty",
    std::to_string(table.Shared) + ", " + std::to_string(LargestAlpha(image)),
    table.Shared == 0 && LargestAlpha(image) > 0.5);
}

void TestSizes(VolumeTable& table)
{
  const RgbaImage expected = table.Draw(AddSecond);
  for (const double scale : { 1e-5, 1e5 })
  {
    const RgbaImage found = table.Draw(
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
      "two volumes " + std::string(scale < 1.0 ? "1e-5" : "1e5") + " times the size",
      "mean difference", CompareImages(found, expected).Mean, 1e-3);
  }
}

void TestContext(VolumeTable& table)
{
  SceneStage stage(64);
  stage.Stage.SetLights({ MakeSun({ { 0.6, 0.2, -1.0 } }) });
  AddSecond(stage);
  const RgbaImage before = stage.Draw();
  stage.Stage.GetWindow()->Finalize();
  const RgbaImage after = stage.Draw();
  table.Catalogue.Measure("volumes-context-remade",
    "an OpenGL context that is lost and created again, two volumes and no actor",
    "largest difference from the previous image", CompareImages(after, before).Max, 0.0);
  const int shared = stage.GetReport()->GetNumber("VolumesInSharedSlices");
  table.Catalogue.Check("volumes-no-actor", "two volumes and no actor", "2 in shared slices",
    std::to_string(shared), shared == 2);
}

}

int TestShadowedVolumesExtremes(int argc, char* argv[])
{
  VolumeTable table(argc, argv);
  TestPositions(table);
  TestNothing(table);
  TestErrors(table);
  TestSizes(table);
  TestContext(table);
  return table.Catalogue.GetExitCode();
}
