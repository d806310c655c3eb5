// SPDX-License-Identifier: BSD-3-Clause
#include "Support/Pictures/ReferenceVolumePicture.h"

#include "Support/Pictures/PixelBuckets.h"
#include "Support/Pictures/ReferenceRay.h"

#include "vtkCell.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDataArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkSMPTools.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <limits>
#include <stdexcept>

namespace reference
{

namespace
{

class Picture
{
public:
  Picture(vtkUnstructuredGrid* grid, vtkVolumeProperty* property, vtkCamera* camera,
    const PictureSettings& settings)
    : Settings(settings)
    , Material(grid, property, settings.Arrays)
    , Rays(camera, settings.Size)
    , Result(settings.Size[0], settings.Size[1])
  {
    const std::size_t pixels = this->Result.Values.size() / 4;
    if (!settings.OpaqueDistance.empty() && settings.OpaqueDistance.size() != pixels)
    {
      throw std::invalid_argument("opaque distances for another number of pixels");
    }
    if (!settings.Wanted.empty() && settings.Wanted.size() != pixels)
    {
      throw std::invalid_argument("wanted pixels of another number of pixels");
    }
    this->ReadTetrahedra(grid);
    const PixelBuckets buckets(this->Tetrahedra, this->Rays, settings.Size);
    vtkSMPTools::For(0, settings.Size[1],
      [&](vtkIdType begin, vtkIdType end)
      {
        for (int j = static_cast<int>(begin); j < static_cast<int>(end); ++j)
        {
          for (int i = 0; i < settings.Size[0]; ++i)
          {
            if (settings.Wanted.empty() || settings.Wanted[j * settings.Size[0] + i])
            {
              this->DrawPixel(i, j, buckets);
            }
          }
        }
      });
  }

  const RgbaPicture& Get() const { return this->Result; }

private:
  /// A segment with its tetrahedron, and what it looks like at both ends.
  struct Crossing
  {
    std::uint32_t Id;
    Real Entry;
    Real Exit;
    ReferenceMaterial::Sample AtEntry;
    ReferenceMaterial::Sample AtExit;
  };

  void ReadTetrahedra(vtkUnstructuredGrid* grid)
  {
    vtkDataArray* layers = nullptr;
    if (this->Settings.How == Blend::Priority)
    {
      layers = grid->GetCellData()->GetArray(this->Settings.Layers.c_str());
      if (!layers)
      {
        throw std::invalid_argument("the reference lacks the array of the layers");
      }
    }
    vtkNew<vtkIdList> ids;
    for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
    {
      if (grid->GetCellType(cell) != VTK_TETRA)
      {
        throw std::invalid_argument("the reference draws tetrahedra only");
      }
      grid->GetCellPoints(cell, ids);
      std::array<vtkIdType, 4> points;
      std::array<Vector, 4> corners;
      for (int i = 0; i < 4; ++i)
      {
        points[i] = ids->GetId(i);
        const double* x = grid->GetPoint(points[i]);
        corners[i] = { x[0], x[1], x[2] };
      }
      if (this->Material.IsFinite(cell, points))
      {
        this->Tetrahedra.emplace_back(corners);
        this->Cells.push_back(cell);
        this->Points.push_back(points);
        this->Layers.push_back(layers ? static_cast<int>(layers->GetTuple1(cell)) : 0);
      }
    }
  }

  std::vector<Crossing> Cross(int i, int j, const PixelBuckets& buckets) const
  {
    const Ray ray = this->Rays.Get(i, j);
    const int pixel = j * this->Settings.Size[0] + i;
    const Real from = this->Rays.GetNear() * ray.DistancePerDepth;
    const Real to = this->Settings.OpaqueDistance.empty() ? std::numeric_limits<Real>::infinity()
                                                          : this->Settings.OpaqueDistance[pixel];
    std::vector<Crossing> crossings;
    for (const std::uint32_t* id = buckets.Begin(pixel); id != buckets.End(pixel); ++id)
    {
      if (const auto segment = this->Tetrahedra[*id].Meet(ray, from, to))
      {
        crossings.push_back({ *id, segment->Entry, segment->Exit,
          this->Material.At(this->Cells[*id], this->Points[*id], segment->AtEntry),
          this->Material.At(this->Cells[*id], this->Points[*id], segment->AtExit) });
      }
    }
    std::sort(crossings.begin(), crossings.end(),
      [](const Crossing& a, const Crossing& b)
      { return a.Entry != b.Entry ? a.Entry < b.Entry : a.Exit < b.Exit; });
    return crossings;
  }

  Light IntegrateCrossing(const Crossing& crossing) const
  {
    const auto length = static_cast<double>(crossing.Exit - crossing.Entry);
    std::vector<StraightPart> parts;
    if (this->Settings.Mode == Integration::AverageColor)
    {
      parts.push_back(this->Material.GetMeanPart(crossing.AtEntry, crossing.AtExit, length));
    }
    else
    {
      this->Material.AppendParts(crossing.AtEntry, crossing.AtExit, length, parts);
    }
    Light light;
    for (const StraightPart& part : parts)
    {
      light.AddBehind(Integrate(part));
    }
    return light;
  }

  void DrawPixel(int i, int j, const PixelBuckets& buckets)
  {
    const std::vector<Crossing> crossings = this->Cross(i, j, buckets);
    double* pixel = this->Result.At(i, j);
    switch (this->Settings.How)
    {
      case Blend::MaximumIntensity:
        this->Material.HasDirectColors() ? this->DrawLargestColors(crossings, pixel)
                                         : this->DrawLargest(crossings, pixel);
        break;
      case Blend::Additive:
        this->DrawSum(crossings, pixel);
        break;
      case Blend::Priority:
        this->DrawLayers(crossings, pixel);
        break;
      case Blend::Composite:
      {
        const Light light = this->Total(crossings);
        std::copy(light.Seen.begin(), light.Seen.end(), pixel);
        pixel[3] = light.GetAlpha();
        break;
      }
      case Blend::OpticalDepth:
        DrawMean(this->Total(crossings), pixel);
    }
  }

  Light Total(const std::vector<Crossing>& crossings) const
  {
    Light light;
    for (const Crossing& crossing : crossings)
    {
      light.AddBehind(this->IntegrateCrossing(crossing));
    }
    return light;
  }

  static void DrawMean(const Light& light, double* pixel)
  {
    pixel[3] = light.GetAlpha();
    for (int k = 0; k < 3 && light.Depth > 0.0; ++k)
    {
      pixel[k] = pixel[3] * (light.Emitted[k] / light.Depth);
    }
  }

  void DrawSum(const std::vector<Crossing>& crossings, double* pixel) const
  {
    for (const Crossing& crossing : crossings)
    {
      const Light light = this->IntegrateCrossing(crossing);
      for (int k = 0; k < 3; ++k)
      {
        pixel[k] += light.Seen[k];
      }
      pixel[3] += light.GetAlpha();
    }
    for (int k = 0; k < 4; ++k)
    {
      pixel[k] = std::min(pixel[k], 1.0);
    }
  }

  void DrawLargest(const std::vector<Crossing>& crossings, double* pixel) const
  {
    const ReferenceMaterial::Sample* largest = nullptr;
    for (const Crossing& crossing : crossings)
    {
      for (const ReferenceMaterial::Sample* sample : { &crossing.AtEntry, &crossing.AtExit })
      {
        if (!largest || sample->OpacityArgument > largest->OpacityArgument)
        {
          largest = sample;
        }
      }
    }
    if (largest)
    {
      this->TakeLargest(*largest, pixel);
    }
  }

  /// Colors of the array itself: the maximum of each premultiplied component.
  void DrawLargestColors(const std::vector<Crossing>& crossings, double* pixel) const
  {
    for (const Crossing& crossing : crossings)
    {
      this->TakeLargest(crossing.AtEntry, pixel);
      this->TakeLargest(crossing.AtExit, pixel);
    }
  }

  void TakeLargest(const ReferenceMaterial::Sample& sample, double* pixel) const
  {
    const std::array<double, 3> color = this->Material.GetColor(sample);
    const double opacity = std::min(this->Material.GetOpacity(sample), 1.0);
    for (int k = 0; k < 3; ++k)
    {
      pixel[k] = std::max(pixel[k], opacity * color[k]);
    }
    pixel[3] = std::max(pixel[3], opacity);
  }

  void DrawLayers(const std::vector<Crossing>& crossings, double* pixel) const
  {
    // Front to back: by falling priority, then falling number.
    std::map<std::pair<double, int>, Light, std::greater<>> layers;
    for (const Crossing& crossing : crossings)
    {
      const int layer = this->Layers[crossing.Id];
      const auto found = this->Settings.Priorities.find(layer);
      const double priority = found != this->Settings.Priorities.end() ? found->second : layer;
      layers[{ priority, layer }].AddBehind(this->IntegrateCrossing(crossing));
    }
    for (const auto& layer : layers)
    {
      double over[4] = { 0.0, 0.0, 0.0, 0.0 };
      DrawMean(layer.second, over);
      const double through = 1.0 - pixel[3];
      for (int k = 0; k < 4; ++k)
      {
        pixel[k] += through * over[k];
      }
    }
  }

  const PictureSettings& Settings;
  ReferenceMaterial Material;
  PixelRays Rays;
  RgbaPicture Result;
  std::vector<RayTetrahedron> Tetrahedra;
  std::vector<vtkIdType> Cells;
  std::vector<std::array<vtkIdType, 4>> Points;
  std::vector<int> Layers;
};

}

RgbaPicture MakeReferencePicture(vtkUnstructuredGrid* grid, vtkVolumeProperty* property,
  vtkCamera* camera, const PictureSettings& settings)
{
  return Picture(grid, property, camera, settings).Get();
}

}
