// SPDX-License-Identifier: BSD-3-Clause
// Writes a folder for the test of the plugin's Shadowed Slices: shadowed_slices.json, a list of
// pictures (which source, how it was drawn, under which lights, from where), each picture as
// `<name>.png`, and the image on the projective light's screen. ParaView is asked the same and must
// draw the same.
#include "ParaView/Extractions/PictureStage.h"
#include "ParaView/Extractions/TimeVaryingExtraction.h"

#include "vtkAlgorithm.h"
#include "vtkAnalyticFieldSource.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkLightKit.h"
#include "vtkNew.h"
#include "vtkPNGReader.h"
#include "vtkPNGWriter.h"
#include "vtkProjectiveLight.h"
#include "vtkRenderer.h"
#include "vtkShadowedSliceMapper.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <array>
#include <string>
#include <vector>

using nlohmann::json;

namespace
{
// Parts of a gyroid with a haze around, seen from aside, by the light of the kit. `light` is a
// light of the view, `projector` that of the representation.
const json COMMON = { { "source", "AnalyticField" },
  { "source_properties",
    { { "Field", vtkAnalyticFieldSource::GYROID }, { "WholeExtent", { 0, 71, 0, 71, 0, 71 } },
      { "Bounds", { -0.9, 0.9, -0.9, 0.9, -0.9, 0.9 } } } },
  { "array", "f" }, { "size", { 480, 360 } }, { "background", { 0.925, 0.929, 0.933 } },
  { "camera",
    { { "position", { 2.8, -1.25, 1.0 } }, { "focus", { 0.0, 0.0, -0.06 } },
      { "up", { 0.0, 0.0, 1.0 } }, { "angle", 46.0 } } },
  { "colors", { { 0.4, 0.35, 0.45, 0.80 }, { 0.8, 0.87, 0.87, 0.87 }, { 1.3, 0.80, 0.25, 0.15 } } },
  { "opacities", { { 0.5, 0.0 }, { 0.8, 0.1 }, { 1.0, 0.8 } } }, { "unit", 0.05 }, { "shade", 1 },
  { "ambient", 0.15 }, { "kit", 1 }, { "shadows", 1 }, { "number_of_shadows", 1 },
  { "spacing", 0.0 }, { "colored", 0 }, { "crop", json::array() } };

const json SCENE_LIGHT = { { "position", { 1.0, 0.5, 2.0 } }, { "focus", { 0.0, 0.0, 0.0 } },
  { "color", { 1.0, 0.95, 0.85 } }, { "intensity", 0.9 } };

const json PROJECTOR = { { "position", { 0.5, -2.5, 2.0 } }, { "focus", { 0.2, -1.0, 0.8 } },
  { "up", { 0.0, 0.0, 1.0 } }, { "screen", { 1.1, 0.9 } }, { "edge", 0.15 },
  { "color", { 1.0, 1.0, 1.0 } }, { "intensity", 1.2 }, { "image", "light-screen.png" } };

json MakeCase(const std::string& name, const json& changes)
{
  json result = COMMON;
  result.update(changes);
  result["name"] = name;
  return result;
}

std::vector<json> AllCases()
{
  return { MakeCase("slices-light-kit", json::object()),
    MakeCase("slices-unshadowed", { { "shadows", 0 } }),
    MakeCase("slices-plain", { { "shadows", 0 }, { "shade", 0 } }),
    MakeCase("slices-two-lights",
      { { "kit", 0 }, { "light", SCENE_LIGHT }, { "projector", PROJECTOR },
        { "number_of_shadows", 2 } }),
    MakeCase("slices-colored", { { "kit", 0 }, { "light", SCENE_LIGHT }, { "colored", 1 } }),
    MakeCase(
      "slices-cropped", { { "shade", 0 }, { "spacing", 0.04 }, { "crop", { 1.0, 0.6, 0.8 } } }) };
}

// Squares of colours.
void WriteScreen(const std::string& folder)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(64, 64, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  for (int y = 0; y < 64; ++y)
  {
    for (int x = 0; x < 64; ++x)
    {
      auto* pixel = static_cast<unsigned char*>(image->GetScalarPointer(x, y, 0));
      pixel[0] = (x / 16 + y / 16) % 2 ? 255 : 60;
      pixel[1] = 230;
      pixel[2] = y < 32 ? 80 : 255;
    }
  }
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputData(image);
  writer->SetFileName((folder + "/light-screen.png").c_str());
  writer->Write();
}

void AddLights(vtkRenderer* renderer, const json& picture, const std::string& folder)
{
  renderer->AutomaticLightCreationOff();
  if (picture["kit"] == 1)
  {
    vtkNew<vtkLightKit> kit;
    kit->AddLightsToRenderer(renderer);
  }
  if (picture.contains("light"))
  {
    vtkNew<vtkLight> light;
    SetUpLight(light, picture["light"]);
    renderer->AddLight(light);
  }
  if (picture.contains("projector"))
  {
    const json& values = picture["projector"];
    vtkNew<vtkProjectiveLight> light;
    SetUpLight(light, values);
    light->SetPositional(true);
    const std::array<double, 3> up = Triple(values["up"]);
    light->SetViewUp(up[0], up[1], up[2]);
    light->SetScreenSize(values["screen"][0], values["screen"][1]);
    light->SetEdgeWidth(values["edge"]);
    vtkNew<vtkPNGReader> reader;
    reader->SetFileName((folder + "/" + values["image"].get<std::string>()).c_str());
    reader->Update();
    light->SetImage(reader->GetOutput());
    renderer->AddLight(light);
  }
}

void SetUpMapper(vtkShadowedSliceMapper* mapper, const json& picture)
{
  mapper->SetScalarModeToUsePointFieldData();
  mapper->SelectScalarArray(picture["array"].get<std::string>().c_str());
  mapper->SetShadows(picture["shadows"] == 1);
  mapper->SetMaximumNumberOfShadows(picture["number_of_shadows"]);
  mapper->SetSliceSpacing(picture["spacing"]);
  mapper->AutoAdjustSampleDistancesOff();
}

void Draw(const json& picture, const std::string& folder)
{
  WriteScreen(folder);
  const vtkSmartPointer<vtkAlgorithm> source = MakeTemporalSource(picture);
  source->Update();
  vtkNew<vtkShadowedSliceMapper> mapper;
  mapper->SetInputConnection(source->GetOutputPort());
  SetUpMapper(mapper, picture);
  mapper->TwoSidedLightingOn();
  vtkNew<vtkVolume> volume;
  volume->SetMapper(mapper);
  vtkVolumeProperty* property = volume->GetProperty();
  SetUpProperty(property, picture);
  property->SetInterpolationTypeToLinear();
  property->SetShade(picture["shade"]);
  property->SetAmbient(picture["ambient"]);
  property->SetDiffuse(1.0);
  property->SetSpecular(0.0);
  if (picture["colored"] == 1)
  {
    mapper->SetTransmissionColor(property->GetRGBTransferFunction());
  }
  if (!picture["crop"].empty())
  {
    const std::array<double, 3> scale = Triple(picture["crop"]);
    const double* bounds = mapper->GetBounds();
    mapper->CroppingOn();
    mapper->SetCroppingRegionFlagsToSubVolume();
    mapper->SetCroppingRegionPlanes(bounds[0] * scale[0], bounds[1] * scale[0],
      bounds[2] * scale[1], bounds[3] * scale[1], bounds[4] * scale[2], bounds[5] * scale[2]);
  }
  vtkNew<vtkRenderer> renderer;
  AddLights(renderer, picture, folder);
  renderer->AddVolume(volume);
  SavePicture(picture, renderer, folder);
}
}

int main(int argc, char* argv[])
{
  return WritePictures(argc, argv, "shadowed_slices.json", AllCases(), Draw);
}
