// SPDX-License-Identifier: BSD-3-Clause
// Writes a folder for the test of the plugin's Inflow Textures: inflow_textures.json, a list of
// pictures (which flow and surfaces, which settings of the mapper, from where), each picture as
// `<name>.png`, and the images that are painted. ParaView is asked the same and must draw the same.
#include "ParaView/Extractions/FlowExtraction.h"
#include "ParaView/Extractions/PictureStage.h"

#include "vtkAnalyticFlowSource.h"
#include "vtkImageData.h"
#include "vtkImplicitFlowField.h"
#include "vtkImplicitFlowVolumeMapper.h"
#include "vtkLight.h"
#include "vtkNew.h"
#include "vtkPNGReader.h"
#include "vtkPNGWriter.h"
#include "vtkPiecewiseFunction.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <array>
#include <string>
#include <vector>

using nlohmann::json;

namespace
{
// The flow around a sphere from a rectangle of the id 3 upstream. `pulse` is the share of a period
// in which paint is put in.
const json COMMON = { { "source_properties",
                        { { "Field", vtkAnalyticFlowSource::SPHERE },
                          { "WholeExtent", { 0, 19, 0, 19, 0, 19 } },
                          { "Bounds", { -1.0, 1.0, -1.0, 1.0, -1.0, 1.0 } } } },
  { "surfaces",
    { { { "kind", "Rectangle" },
      { "properties",
        { { "Center", { -0.875, 0.0, 0.0 } }, { "Normal", { 1.0, 0.0, 0.0 } },
          { "Lengths", { 1.5, 1.5 } }, { "Id", 3 } } } } } },
  { "meshes", json::array() }, { "field", { { "SampleMode", 0 } } }, { "size", { 200, 160 } },
  { "background", { 0.925, 0.929, 0.933 } },
  { "camera",
    { { "position", { 1.6, -3.6, 1.8 } }, { "focus", { 0.0, 0.0, 0.0 } },
      { "up", { 0.0, 0.0, 1.0 } }, { "angle", 40.0 } } },
  { "unit", 0.1 }, { "inflow", "" }, { "surface", "" }, { "detail", "" }, { "pulse", 1.0 },
  { "phase", 0.0 }, { "opacity_range", json::array() }, { "shading", "" }, { "shadows", 0 },
  { "crop", { 1.0, 1.0, 1.0 } }, { "ambient", 0.1 }, { "diffuse", 0.9 },
  { "light",
    { { "position", { 1.0, -1.0, 3.0 } }, { "focus", { 0.0, 0.0, 0.0 } },
      { "color", { 1.0, 0.95, 0.85 } }, { "intensity", 0.9 } } } };

json MakeCase(const std::string& name, const json& changes)
{
  json result = COMMON;
  result.update(changes);
  result["name"] = name;
  return result;
}

std::vector<json> AllCases()
{
  const char* wide = "inflow-wide.png";
  const char* fine = "inflow-fine.png";
  return { MakeCase("inflow-plain", json::object()), MakeCase("inflow-all", { { "inflow", wide } }),
    MakeCase("inflow-one-surface", { { "inflow", wide }, { "surface", fine } }),
    MakeCase("inflow-detail", { { "inflow", wide }, { "detail", fine } }),
    MakeCase("inflow-pulse", { { "inflow", wide }, { "pulse", 0.5 } }),
    MakeCase("inflow-phase", { { "inflow", wide }, { "pulse", 0.5 }, { "phase", 0.3 } }),
    MakeCase("inflow-opacity", { { "inflow", wide }, { "opacity_range", { 1.0, 0.2 } } }),
    MakeCase("inflow-cropped", { { "inflow", wide }, { "crop", { 0.9, 0.4, 1.0 } } }),
    MakeCase("inflow-shaded", { { "inflow", wide }, { "shading", "AdvectionTime" } }),
    MakeCase("inflow-shadows", { { "inflow", wide }, { "shadows", 1 } }) };
}

// Squares of two colours, of which one is thin.
void WriteSquares(const std::string& path, int width)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(64, 64, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 4);
  for (int y = 0; y < 64; ++y)
  {
    for (int x = 0; x < 64; ++x)
    {
      const bool isDense = (x / width + y / width) % 2 != 0;
      auto* pixel = static_cast<unsigned char*>(image->GetScalarPointer(x, y, 0));
      pixel[0] = isDense ? 200 : 40;
      pixel[1] = static_cast<unsigned char>(60 + 2 * y);
      pixel[2] = static_cast<unsigned char>(40 + 3 * x);
      pixel[3] = isDense ? 120 : 20;
    }
  }
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputData(image);
  writer->SetFileName(path.c_str());
  writer->Write();
}

vtkSmartPointer<vtkImageData> ReadImage(const std::string& folder, const std::string& name)
{
  if (name.empty())
  {
    return nullptr;
  }
  vtkNew<vtkPNGReader> reader;
  reader->SetFileName((folder + "/" + name).c_str());
  reader->Update();
  return reader->GetOutput();
}

void Draw(const json& picture, const std::string& folder)
{
  WriteSquares(folder + "/inflow-wide.png", 16);
  WriteSquares(folder + "/inflow-fine.png", 4);
  const vtkSmartPointer<vtkImplicitFlowField> field = MakeFlowField(picture);
  vtkNew<vtkImplicitFlowVolumeMapper> mapper;
  mapper->SetInputConnection(field->GetOutputPort());
  mapper->SetInflowTexture(vtkImplicitFlowVolumeMapper::ALL, ReadImage(folder, picture["inflow"]));
  mapper->SetInflowTexture(3, ReadImage(folder, picture["surface"]));
  mapper->SetDetailTexture(ReadImage(folder, picture["detail"]));
  const double pulse = picture["pulse"];
  if (pulse < 1.0)
  {
    vtkNew<vtkPiecewiseFunction> gate;
    gate->AddPoint(0.0, 1.0);
    gate->AddPoint(pulse, 1.0, 0.0, 1.0);
    gate->AddPoint(1.0, 0.0);
    mapper->SetTimeGate(gate);
  }
  mapper->SetTimePhase(picture["phase"]);
  vtkNew<vtkVolume> volume;
  vtkVolumeProperty* property = volume->GetProperty();
  const json& range = picture["opacity_range"];
  if (!range.empty())
  {
    mapper->SetOpacityArray("AdvectionTime");
    vtkNew<vtkPiecewiseFunction> opacity;
    opacity->AddPoint(range[0], 0.0);
    opacity->AddPoint(range[1], 1.0);
    property->SetScalarOpacity(opacity);
  }
  const std::string shading = picture["shading"];
  mapper->SetShadingArray(shading.c_str());
  property->SetShade(!shading.empty());
  property->SetAmbient(picture["ambient"]);
  property->SetDiffuse(picture["diffuse"]);
  property->SetSpecular(0.0);
  mapper->SetShadows(picture["shadows"] == 1);
  // A share of the bounds, scaled from the origin.
  field->Update();
  const double* bounds = vtkImageData::SafeDownCast(field->GetOutputDataObject(0))->GetBounds();
  const std::array<double, 3> share = Triple(picture["crop"]);
  mapper->SetCropping(share != std::array<double, 3>{ { 1.0, 1.0, 1.0 } });
  mapper->SetCroppingRegionPlanes(share[0] * bounds[0], share[0] * bounds[1], share[1] * bounds[2],
    share[1] * bounds[3], share[2] * bounds[4], share[2] * bounds[5]);
  volume->SetMapper(mapper);
  property->SetScalarOpacityUnitDistance(picture["unit"]);
  vtkNew<vtkRenderer> renderer;
  renderer->AutomaticLightCreationOff();
  vtkNew<vtkLight> light;
  SetUpLight(light, picture["light"]);
  renderer->AddLight(light);
  renderer->AddVolume(volume);
  SavePicture(picture, renderer, folder);
}
}

int main(int argc, char* argv[])
{
  return WritePictures(argc, argv, "inflow_textures.json", AllCases(), Draw);
}
