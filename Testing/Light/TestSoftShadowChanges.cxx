// SPDX-License-Identifier: BSD-3-Clause
// A random sequence of changes to area lights and soft shadows. After each change, the image equals
// that of a new mapper.
#include "Support/Images/ShadowCases.h"
#include "Support/Drawing/ShadowImage.h"
#include "Support/Images/VolumeStage.h"
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Checks/ReferenceRandom.h"

#include "vtkAreaLight.h"
#include "vtkColorTransferFunction.h"
#include "vtkNew.h"
#include "vtkRenderWindow.h"
#include "vtkShadowedSliceMapper.h"

#include <iostream>

int TestSoftShadowChanges(int, char*[])
{
  using namespace reference;
  using Mapper = vtkShadowedSliceMapper;
  constexpr int changes = 60;
  Check check;
  Random numbers(29);
  const auto pick = [&numbers](int number)
  { return std::min(static_cast<int>(numbers.Get(0.0, number)), number - 1); };

  auto scene = MakeScene(MakeImage(24, TwoBoxes), MakeTranslucentProperty(0.8, true));
  scene.Size = { { 40, 40 } };
  auto light = vtkSmartPointer<vtkAreaLight>::New();
  light->SetPosition(-2.0, 2.0, 2.0);
  light->SetConeAngle(180.0);
  scene.Lights = { light };
  vtkNew<vtkColorTransferFunction> transmission;
  transmission->AddRGBPoint(0.0, 1.0, 0.5, 0.2);
  vtkNew<Mapper> mapper;
  mapper->SetNumberOfLightSamples(4);
  VolumeStage stage(scene.Size);
  SetScene(stage, mapper, scene);
  int soft = 0;
  for (int i = 0; i < changes; ++i)
  {
    Configure(mapper, scene);
    stage.SetLights(scene.Lights);
    const RgbaImage found = stage.CaptureBytes();
    soft += mapper->GetReport()->GetNumber("SoftShadowPasses") > 0 ? 1 : 0;

    vtkNew<Mapper> other;
    other->SetSoftShadowMethod(mapper->GetSoftShadowMethod());
    other->SetNumberOfLightSamples(mapper->GetNumberOfLightSamples());
    other->SetLightBufferSize(mapper->GetLightBufferSize());
    VolumeStage fresh(scene.Size);
    SetScene(fresh, other, scene);
    check.Near(
      CompareImages(found, fresh.CaptureBytes()).Max, 0.0, 0.0, "image " + std::to_string(i), 1.0);

    const int size = pick(4);
    switch (pick(8))
    {
      case 0:
        mapper->SetSoftShadowMethod(pick(2));
        break;
      case 1:
        mapper->SetNumberOfLightSamples(1 << pick(4));
        break;
      case 2:
        light->SetSize(0.5 * size, 0.5 * size);
        break;
      case 3:
        light->SetShape(pick(2));
        break;
      case 4:
        mapper->SetLightBufferSize(48 * size);
        break;
      case 5:
        scene.TransmissionColor = scene.TransmissionColor ? nullptr : transmission.Get();
        break;
      case 6:
      {
        const Double3 direction = numbers.GetDirection();
        light->SetPosition(3.0 * direction[0], 3.0 * direction[1], 3.0 * direction[2]);
        break;
      }
      default:
        light->SetPositional(!light->GetPositional());
        light->SetConeAngle(180.0);
        break;
    }
  }
  std::cout << soft << " images of " << changes << " with soft shadows\n";
  check.That(soft > changes / 3, "number of images with soft shadows");
  return check.Result();
}
