// SPDX-License-Identifier: BSD-3-Clause
#include "Support/Images/ReferenceVolumeImage.h"

#include "Support/Images/PixelBuckets.h"
#include "Support/Images/ReferenceRay.h"

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

class ImageRenderer
{
public:
  /// If \a segments is not null, it gets the segments of each pixel, and no image is rendered.
  ImageRenderer(vtkUnstructuredGrid* grid, vtkVolumeProperty* property, vtkCamera* camera,
    const CameraSettings& settings, std::vector<std::vector<RaySegment>>* segments = nullptr)
    : Settings(settings)
    , Material(grid, property, settings.Arrays)
    , Rays(camera, settings.Size)
    , Result(settings.Size[0], settings.Size[1])
  {
    const std::size_t pixels = this->Result.Values.size() / 4;
    if (!settings.OpaqueDistance.empty() && settings.OpaqueDistance.size() != pixels)
    {
      throw std::invalid_argument(
        "the number of opaque distances differs from the number of pixels");
    }
    if (!settings.Wanted.empty() && settings.Wanted.size() != pixels)
    {
      throw std::invalid_argument("CameraSettings::Wanted must have one value per pixel");
    }
    this->ReadTetrahedra(grid);
    if (segments)
    {
      segments->resize(pixels);
    }
    const PixelBuckets buckets(this->Tetrahedra, this->Rays, settings.Size);
    vtkSMPTools::For(0, settings.Size[1],
      [&](vtkIdType begin, vtkIdType end)
      {
        for (int j = static_cast<int>(begin); j < static_cast<int>(end); ++j)
        {
          for (int i = 0; i < settings.Size[0]; ++i)
          {
            const std::size_t pixel = static_cast<std::size_t>(j) * settings.Size[0] + i;
            if (segments)
            {
              (*segments)[pixel] = this->GetSegments(this->Cross(i, j, buckets));
            }
            else if (settings.Wanted.empty() || settings.Wanted[pixel])
            {
              this->DrawPixel(i, j, buckets);
            }
          }
        }
      });
  }

  const RgbaImage& Get() const { return this->Result; }

private:
  /// Interval of a view ray inside a tetrahedron, with the samples at both ends.
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
        throw std::invalid_argument("the grid does not have the cell array CameraSettings::Layers");
      }
    }
    vtkNew<vtkIdList> ids;
    for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
    {
      if (grid->GetCellType(cell) != VTK_TETRA)
      {
        throw std::invalid_argument("the reference renders tetrahedra only");
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
    std::vector<LinearPart> parts;
    if (this->Settings.Mode == Integration::AverageColor)
    {
      parts.push_back(this->Material.GetMeanPart(crossing.AtEntry, crossing.AtExit, length));
    }
    else
    {
      this->Material.AppendParts(crossing.AtEntry, crossing.AtExit, length, parts);
    }
    Light light;
    for (const LinearPart& part : parts)
    {
      light.AddBehind(Integrate(part));
    }
    return light;
  }

  std::vector<RaySegment> GetSegments(std::vector<Crossing> crossings) const
  {
    if (this->Settings.How == Blend::Priority)
    {
      std::stable_sort(crossings.begin(), crossings.end(),
        [this](const Crossing& a, const Crossing& b)
        { return this->GetLayerKey(a) > this->GetLayerKey(b); });
    }
    std::vector<RaySegment> segments;
    for (const Crossing& crossing : crossings)
    {
      const ReferenceMaterial::Sample& largest =
        crossing.AtEntry.OpacityArgument > crossing.AtExit.OpacityArgument ? crossing.AtEntry
                                                                           : crossing.AtExit;
      segments.push_back({ this->Cells[crossing.Id], static_cast<double>(crossing.Entry),
        this->IntegrateCrossing(crossing).Depth, largest.OpacityArgument,
        this->Material.GetOpacity(largest) });
    }
    return segments;
  }

  /// Returns the priority and the number of a crossing's layer.
  std::pair<double, int> GetLayerKey(const Crossing& crossing) const
  {
    const int layer = this->Layers[crossing.Id];
    const auto found = this->Settings.Priorities.find(layer);
    return { found != this->Settings.Priorities.end() ? found->second : layer, layer };
  }

  void DrawPixel(int i, int j, const PixelBuckets& buckets)
  {
    const std::vector<Crossing> crossings = this->Cross(i, j, buckets);
    double* pixel = this->Result.At(i, j);
    switch (this->Settings.How)
    {
      case Blend::MaximumIntensity:
        this->Material.HasDirectColors() ? this->DrawMaximumColors(crossings, pixel)
                                         : this->DrawMaximum(crossings, pixel);
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

  void DrawMaximum(const std::vector<Crossing>& crossings, double* pixel) const
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
      this->UpdateMaximum(*largest, pixel);
    }
  }

  /// For direct colors, renders the maximum of each premultiplied channel.
  void DrawMaximumColors(const std::vector<Crossing>& crossings, double* pixel) const
  {
    for (const Crossing& crossing : crossings)
    {
      this->UpdateMaximum(crossing.AtEntry, pixel);
      this->UpdateMaximum(crossing.AtExit, pixel);
    }
  }

  void UpdateMaximum(const ReferenceMaterial::Sample& sample, double* pixel) const
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
    // Front to back: by decreasing priority, then by decreasing layer number.
    std::map<std::pair<double, int>, Light, std::greater<>> layers;
    for (const Crossing& crossing : crossings)
    {
      layers[this->GetLayerKey(crossing)].AddBehind(this->IntegrateCrossing(crossing));
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

  const CameraSettings& Settings;
  ReferenceMaterial Material;
  PixelRays Rays;
  RgbaImage Result;
  std::vector<RayTetrahedron> Tetrahedra;
  std::vector<vtkIdType> Cells;
  std::vector<std::array<vtkIdType, 4>> Points;
  std::vector<int> Layers;
};

}

RgbaImage MakeReferenceImage(vtkUnstructuredGrid* grid, vtkVolumeProperty* property,
  vtkCamera* camera, const CameraSettings& settings)
{
  return ImageRenderer(grid, property, camera, settings).Get();
}

std::vector<std::vector<RaySegment>> MakeReferenceSegments(vtkUnstructuredGrid* grid,
  vtkVolumeProperty* property, vtkCamera* camera, const CameraSettings& settings)
{
  std::vector<std::vector<RaySegment>> segments;
  ImageRenderer(grid, property, camera, settings, &segments);
  return segments;
}

}
