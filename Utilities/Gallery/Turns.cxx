// SPDX-License-Identifier: BSD-3-Clause
#include "Gallery/Turns.h"

#include "Gallery/Picture.h"
#include "Gallery/Scene.h"
#include "Gallery/Stage.h"
#include "Support/Pictures/PictureTurn.h"

#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkNew.h"
#include "vtkShadowedSliceMapper.h"
#include "vtkTransform.h"
#include "vtkVolume.h"
#include "vtkVolumeCollection.h"

#include <array>
#include <cstdio>

namespace gallery
{
namespace
{
using Point = std::array<double, 3>;

/// A light that stands in the scene, and where it was.
struct PlacedLight
{
  vtkLight* Light;
  Point Position;
  Point FocalPoint;
};

std::vector<PlacedLight> FindLights(vtkRenderer* renderer)
{
  std::vector<PlacedLight> lights;
  vtkLightCollection* all = renderer->GetLights();
  vtkCollectionSimpleIterator iterator;
  all->InitTraversal(iterator);
  while (vtkLight* light = all->GetNextLight(iterator))
  {
    if (light->LightTypeIsSceneLight())
    {
      PlacedLight placed{ light, {}, {} };
      light->GetPosition(placed.Position.data());
      light->GetFocalPoint(placed.FocalPoint.data());
      lights.push_back(placed);
    }
  }
  return lights;
}

void TurnLights(const std::vector<PlacedLight>& lights, const Point& middle, int degrees)
{
  vtkNew<vtkTransform> turn;
  turn->Translate(middle.data());
  turn->RotateZ(degrees);
  turn->Translate(-middle[0], -middle[1], -middle[2]);
  for (const PlacedLight& placed : lights)
  {
    placed.Light->SetPosition(turn->TransformPoint(placed.Position.data()));
    placed.Light->SetFocalPoint(turn->TransformPoint(placed.FocalPoint.data()));
  }
}

reference::RgbaPicture ToPicture(vtkImageData* image)
{
  reference::RgbaPicture picture(image->GetDimensions()[0], image->GetDimensions()[1]);
  const auto* pixels = static_cast<const unsigned char*>(image->GetScalarPointer());
  for (std::size_t i = 0; i < picture.Values.size() / 4; ++i)
  {
    for (std::size_t channel = 0; channel < 3; ++channel)
    {
      picture.Values[4 * i + channel] = pixels[3 * i + channel] / 255.0;
    }
  }
  return picture;
}

/// Has the volumes drawn last drawn more coarsely.
void Coarsen(vtkRenderer* renderer, double factor)
{
  vtkVolumeCollection* volumes = renderer->GetVolumes();
  vtkCollectionSimpleIterator iterator;
  volumes->InitTraversal(iterator);
  while (vtkVolume* volume = volumes->GetNextVolume(iterator))
  {
    auto* mapper = vtkShadowedSliceMapper::SafeDownCast(volume->GetMapper());
    if (mapper && factor != 1.0)
    {
      const vtkShadowedSliceReport& report = mapper->GetReport();
      mapper->SetLightBufferSize(static_cast<int>(report.LightBufferSize / factor));
      mapper->SetSliceSpacing(factor * report.SliceSpacing);
    }
  }
}

Turn TurnPanel(Panel& panel, vtkRenderWindow* window, bool isOfLights, int degrees)
{
  vtkCamera* camera = panel.GetCamera();
  vtkNew<vtkCamera> first;
  first->DeepCopy(camera);
  const std::vector<PlacedLight> lights = FindLights(panel.GetRenderer());
  Point middle;
  camera->GetFocalPoint(middle.data());
  reference::PictureTurn pictures;
  // Once around, the second frame comes again, so that each has both of its neighbours.
  Turn turn;
  turn.Frames = degrees == 360 ? degrees + 2 : degrees;
  for (int i = 0; i < turn.Frames; ++i)
  {
    if (isOfLights)
    {
      TurnLights(lights, middle, i);
    }
    else
    {
      camera->DeepCopy(first);
      camera->Azimuth(i);
    }
    pictures.Add(ToPicture(panel.DrawIn(window)));
  }
  camera->DeepCopy(first);
  TurnLights(lights, middle, 0);
  const double mean = pictures.GetMean();
  const reference::PictureTurn::Bend means = pictures.GetMeanBend();
  const reference::PictureTurn::Bend changes = pictures.GetChangeBend();
  turn.IsOfLights = isOfLights;
  turn.Mean = mean > 0.0 ? means.Largest / mean : 0.0;
  turn.MeanAt = means.At;
  turn.MeanP95 = mean > 0.0 ? means.P95 / mean : 0.0;
  turn.MeanOutliers = means.Outliers;
  turn.Change = changes.Largest;
  turn.ChangeAt = changes.At;
  turn.ChangeP95 = changes.P95;
  turn.ChangeOutliers = changes.Outliers;
  return turn;
}
}

void TurnScene(
  const Scene& scene, const TurnSettings& settings, const std::function<void(const Turn&)>& visit)
{
  Stage stage(settings.Width, settings.Height);
  scene.Build(stage);
  int number = 0;
  for (const std::unique_ptr<Panel>& panel : stage.FitPanels())
  {
    ++number;
    // The first drawing prepares what the panel is drawn by.
    panel->Draw(settings.Width, settings.Height);
    Coarsen(panel->GetRenderer(), settings.Coarseness);
    vtkSmartPointer<vtkRenderWindow> window = MakeWindow(settings.Width, settings.Height);
    window->AddRenderer(panel->GetRenderer());
    for (const bool isOfLights : { false, true })
    {
      Turn turn = TurnPanel(*panel, window, isOfLights, settings.Degrees);
      turn.Scene = scene.Id;
      turn.Panel = number;
      visit(turn);
    }
  }
}

std::string GetTurnsHeading()
{
  return "| scene, panel | turned | frames | mean, largest | in frame | 95 % below | outliers "
         "| change, largest | in frame | 95 % below | outliers |\n"
         "| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |\n";
}

std::string ToText(const Turn& turn)
{
  std::array<char, 256> line{};
  std::snprintf(line.data(), line.size(),
    "| %s, %d | %s | %d | %.2f %% | %d | %.2f %% | %d | %.3f | %d | %.3f | %d |\n",
    turn.Scene.c_str(), turn.Panel, turn.IsOfLights ? "lights" : "view", turn.Frames,
    100.0 * turn.Mean, turn.MeanAt, 100.0 * turn.MeanP95, turn.MeanOutliers, turn.Change,
    turn.ChangeAt, turn.ChangeP95, turn.ChangeOutliers);
  return line.data();
}
}
