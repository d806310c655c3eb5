// SPDX-License-Identifier: BSD-3-Clause
#include "Support/Pictures/ReferenceMixedPicture.h"

#include "Support/Pictures/MixedScene.h"
#include "Support/Pictures/ReferenceLightSource.h"
#include "Support/Pictures/ReferenceMedium.h"
#include "Support/Pictures/ReferenceRay.h"
#include "Support/Pictures/ReferenceShadow.h"
#include "Support/Pictures/ReferenceSurface.h"

#include "vtkMath.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <tuple>

namespace reference
{

namespace
{

constexpr double LargestStepDepth = 0.1;
constexpr double Opaque = 18.0; // exp(-18) is below any bound
/// Where rays from surfaces begin, of the size of all of them.
constexpr double SurfaceOffset = 1e-9;

Double3 Along(const Double3& origin, const Double3& direction, double distance)
{
  return { { origin[0] + distance * direction[0], origin[1] + distance * direction[1],
    origin[2] + distance * direction[2] } };
}

class Picture
{
public:
  Picture(const MixedScene& scene, int refinement)
    : Scene(scene)
    , Media(scene.Volumes.begin(), scene.Volumes.end())
    , Surfaces(scene.Surfaces.begin(), scene.Surfaces.end())
    , Refinement(refinement)
    , Rays(scene.Camera, scene.Size)
    , Result(scene.Size[0], scene.Size[1])
  {
    if (!scene.OpaqueDistance.empty() &&
      scene.OpaqueDistance.size() != this->Result.Values.size() / 4)
    {
      throw std::invalid_argument("opaque distances for another number of pixels");
    }
    for (const ReferenceSurface& surface : this->Surfaces)
    {
      this->Offset = std::max(this->Offset, SurfaceOffset * surface.GetSize());
    }
    for (const SceneLight& light : scene.Lights)
    {
      if (light.Light->GetSwitch() != 0)
      {
        this->Lights.emplace_back(light.Light, light.Points);
      }
    }
    for (const ReferenceLightSource& light : this->Lights)
    {
      vtkMath::Add(this->Ambient.data(), light.GetAmbient().data(), this->Ambient.data());
      this->HasShadows = this->HasShadows || (scene.Shadows && light.GetShadowStrength() > 0.0);
    }
    if (this->Ambient == Double3{})
    {
      this->Ambient.fill(1.0);
    }
    vtkSMPTools::For(0, scene.Size[1],
      [&](vtkIdType begin, vtkIdType end)
      {
        for (int j = static_cast<int>(begin); j < static_cast<int>(end); ++j)
        {
          for (int i = 0; i < scene.Size[0]; ++i)
          {
            this->DrawPixel(i, j);
          }
        }
      });
  }

  const RgbaPicture& Get() const { return this->Result; }

private:
  using Part = ReferenceMedium::Part;
  using Arrival = ReferenceLightSource::Arrival;

  /// What a line of sight has gathered.
  struct Gathered
  {
    Double3 Seen{};
    double Depth = 0.0;
  };

  struct Sight
  {
    Double3 Origin;
    Double3 Direction;
  };

  /// A medium where a line of sight is in it.
  struct Stay
  {
    const ReferenceMedium* Medium = nullptr;
    IndexLine Line{};
    double Begin = 0.0;
    double End = 0.0;
  };

  /// A surface that a line of sight meets.
  struct Encounter
  {
    const ReferenceSurface* Surface = nullptr;
    ReferenceSurface::Hit Hit{};
  };

  /// The share of a light's colour that comes to a place along a ray.
  Double3 GetTransmittance(const Double3& world, const ReferenceLightSource::ShadowRay& ray) const
  {
    double through = 1.0;
    for (const ReferenceSurface& surface : this->Surfaces)
    {
      through *= surface.GetTransmittance(world, ray.ToLight, this->Offset, ray.Distance);
      if (through == 0.0)
      {
        return {};
      }
    }
    Double3 depth{};
    for (const ReferenceMedium& medium : this->Media)
    {
      const Double3 more =
        GetOpticalDepth(medium, world, ray.ToLight, ray.Distance, this->Refinement);
      vtkMath::Add(depth.data(), more.data(), depth.data());
    }
    Double3 transmittance = ToTransmittance(depth);
    for (int k = 0; k < 3; ++k)
    {
      transmittance[k] *= through * ray.Share[k];
    }
    return transmittance;
  }

  /// The lights at a place, with the shadows they are in.
  std::vector<Arrival> GetArrivals(const Double3& world) const
  {
    std::vector<Arrival> arrivals;
    for (const ReferenceLightSource& light : this->Lights)
    {
      Arrival arrival = light.At(world);
      const double strength = this->Scene.Shadows ? light.GetShadowStrength() : 0.0;
      if (strength > 0.0 && (arrival.Diffuse != Double3{} || arrival.Specular != Double3{}))
      {
        Double3 through{};
        for (const auto& ray : light.GetShadowRays(world, arrival))
        {
          const Double3 more = this->GetTransmittance(world, ray);
          vtkMath::Add(through.data(), more.data(), through.data());
        }
        for (int k = 0; k < 3; ++k)
        {
          const double share = 1.0 - strength * (1.0 - through[k]);
          arrival.Diffuse[k] *= share;
          arrival.Specular[k] *= share;
        }
      }
      arrivals.push_back(arrival);
    }
    return arrivals;
  }

  /// Equations 2.6 and 2.9 of the source.
  Double3 Shade(const Part& part, const ReferenceMedium::Reflection& reflect,
    const std::vector<Arrival>& arrivals, const Double3& direction) const
  {
    if (!reflect.Shade && !this->HasShadows)
    {
      return part.Color;
    }
    const bool isSurface = reflect.Shade && part.Normal != Double3{};
    Double3 diffuse = reflect.Shade ? this->Ambient : Double3{ { 1.0, 1.0, 1.0 } };
    vtkMath::MultiplyScalar(diffuse.data(), reflect.Ambient);
    Double3 specular{};
    for (const Arrival& light : arrivals)
    {
      const double cosine =
        isSurface ? vtkMath::Dot(part.Normal.data(), light.ToLight.data()) : 1.0;
      double glint = 0.0;
      if (isSurface && cosine > 0.0)
      {
        Double3 reflected;
        for (int k = 0; k < 3; ++k)
        {
          reflected[k] = 2.0 * cosine * part.Normal[k] - light.ToLight[k];
        }
        const double towardsEye = -vtkMath::Dot(reflected.data(), direction.data());
        glint = std::pow(std::max(towardsEye, 0.0), reflect.SpecularPower);
      }
      for (int k = 0; k < 3; ++k)
      {
        diffuse[k] += reflect.Diffuse * light.Diffuse[k] * std::max(cosine, 0.0);
        specular[k] += reflect.Specular * light.Specular[k] * glint;
      }
    }
    Double3 color;
    for (int k = 0; k < 3; ++k)
    {
      color[k] = part.Color[k] * diffuse[k] + specular[k];
    }
    return color;
  }

  /// Extinction and extinction times colour at a place.
  struct Emission
  {
    double Extinction = 0.0;
    Double3 Light{};
  };

  Emission GetEmission(const std::vector<Stay>& stays, double at, const Sight& sight) const
  {
    const Double3 world = Along(sight.Origin, sight.Direction, at);
    Emission emission;
    std::vector<Arrival> arrivals;
    for (const Stay& stay : stays)
    {
      std::array<Part, 4> parts;
      const int count = stay.Medium->GetParts(stay.Line.At(at), true, parts);
      if (count > 0 && arrivals.empty())
      {
        arrivals = this->GetArrivals(world);
      }
      for (int p = 0; p < count; ++p)
      {
        const Double3 color = this->Shade(
          parts[p], stay.Medium->GetReflection(parts[p].Row), arrivals, sight.Direction);
        emission.Extinction += parts[p].Extinction;
        for (int k = 0; k < 3; ++k)
        {
          emission.Light[k] += parts[p].Extinction * color[k];
        }
      }
    }
    return emission;
  }

  static double GetExtinction(const std::vector<Stay>& stays, double at)
  {
    double sum = 0.0;
    for (const Stay& stay : stays)
    {
      std::array<Part, 4> parts;
      const int count = stay.Medium->GetParts(stay.Line.At(at), false, parts);
      for (int p = 0; p < count; ++p)
      {
        sum += parts[p].Extinction;
      }
    }
    return sum;
  }

  std::vector<Encounter> GetEncounters(const Sight& sight, double begin, double end) const
  {
    std::vector<Encounter> encounters;
    std::vector<ReferenceSurface::Hit> hits;
    for (const ReferenceSurface& surface : this->Surfaces)
    {
      hits.clear();
      surface.AppendHits(sight.Origin, sight.Direction, begin, end, hits);
      for (const auto& hit : hits)
      {
        encounters.push_back({ &surface, hit });
      }
    }
    std::sort(encounters.begin(), encounters.end(),
      [](const Encounter& a, const Encounter& b)
      {
        return std::tie(a.Hit.Distance, a.Surface, a.Hit.Triangle) <
          std::tie(b.Hit.Distance, b.Surface, b.Hit.Triangle);
      });
    return encounters;
  }

  void DrawPixel(int i, int j)
  {
    const Ray ray = this->Rays.Get(i, j);
    Sight sight;
    for (int k = 0; k < 3; ++k)
    {
      sight.Origin[k] = static_cast<double>(ray.Origin[k]);
      sight.Direction[k] = static_cast<double>(ray.Direction[k]);
    }
    double begin = static_cast<double>(this->Rays.GetNear() * ray.DistancePerDepth);
    double end = static_cast<double>(this->Rays.GetFar() * ray.DistancePerDepth);
    if (!this->Scene.OpaqueDistance.empty())
    {
      end = std::min(
        end, this->Scene.OpaqueDistance[static_cast<std::size_t>(j) * this->Scene.Size[0] + i]);
    }
    Gathered gathered;
    for (const Encounter& encounter : this->GetEncounters(sight, begin, end))
    {
      this->Cross(sight, begin, encounter.Hit.Distance, gathered);
      begin = encounter.Hit.Distance;
      if (gathered.Depth < Opaque)
      {
        this->Meet(sight, encounter, gathered);
      }
    }
    this->Cross(sight, begin, end, gathered);
    double* pixel = this->Result.At(i, j);
    std::copy(gathered.Seen.begin(), gathered.Seen.end(), pixel);
    pixel[3] = -std::expm1(-gathered.Depth);
  }

  /// Adds what a surface reflects.
  void Meet(const Sight& sight, const Encounter& encounter, Gathered& gathered) const
  {
    const Double3 world = Along(sight.Origin, sight.Direction, encounter.Hit.Distance);
    const double opacity = encounter.Surface->GetOpacity();
    const Double3 color =
      encounter.Surface->Shade(encounter.Hit, world, sight.Direction, this->GetArrivals(world));
    const double through = std::exp(-gathered.Depth);
    for (int k = 0; k < 3; ++k)
    {
      gathered.Seen[k] += through * opacity * color[k];
    }
    gathered.Depth -= std::log1p(-opacity);
  }

  /// Adds what the media between two surfaces scatter.
  void Cross(const Sight& sight, double begin, double end, Gathered& gathered) const
  {
    std::vector<Stay> stays;
    std::vector<double> bounds;
    for (const ReferenceMedium& medium : this->Media)
    {
      Stay stay = { &medium, medium.GetImage().ToIndex(sight.Origin, sight.Direction), begin, end };
      if (gathered.Depth < Opaque && medium.GetImage().Cut(stay.Line, stay.Begin, stay.End) &&
        medium.Clip(sight.Origin, sight.Direction, stay.Begin, stay.End))
      {
        stays.push_back(stay);
        ReferenceImage::Walk(stay.Line, stay.Begin, stay.End, medium.GetCuts(stay.Line),
          [&](double a, double b)
          {
            bounds.push_back(a);
            bounds.push_back(b);
            return true;
          });
      }
    }
    std::sort(bounds.begin(), bounds.end());
    // Bounds of neighbouring voxels differ by rounding; no step leads from one to the other.
    constexpr double rounding = 1e-13;
    std::vector<Stay> here;
    for (std::size_t i = 0; i + 1 < bounds.size() && gathered.Depth < Opaque; ++i)
    {
      const double middle = 0.5 * (bounds[i] + bounds[i + 1]);
      here.clear();
      std::copy_if(stays.begin(), stays.end(), std::back_inserter(here),
        [middle](const Stay& stay) { return middle > stay.Begin && middle < stay.End; });
      if (bounds[i + 1] - bounds[i] > rounding * bounds[i + 1] && !here.empty())
      {
        this->March(here, sight, { bounds[i], bounds[i + 1] }, gathered);
      }
    }
  }

  /// Through a part of the line within one voxel of each medium.
  void March(const std::vector<Stay>& stays, const Sight& sight, const std::array<double, 2>& part,
    Gathered& gathered) const
  {
    constexpr double node = 0.28867513459481287; // half of 1 / sqrt(3)
    const double longest = 0.5 * (part[1] - part[0]) / this->Refinement;
    const double depth = LargestStepDepth / this->Refinement;
    for (double a = part[0]; part[1] - a > 1e-9 * longest && gathered.Depth < Opaque;)
    {
      double h = std::min(longest, part[1] - a);
      while (h > 1e-6 * longest &&
        h * std::max(GetExtinction(stays, a + 0.1 * h), GetExtinction(stays, a + 0.9 * h)) > depth)
      {
        h *= 0.5;
      }
      std::array<Emission, 2> emission;
      for (int side = 0; side < 2; ++side)
      {
        const double at = a + h * (0.5 + (side == 0 ? -node : node));
        emission[side] = this->GetEmission(stays, at, sight);
      }
      // The depth in front of each point, of an extinction that is linear in the step.
      const double mean = 0.5 * (emission[0].Extinction + emission[1].Extinction);
      const double slope = (emission[1].Extinction - emission[0].Extinction) / (2.0 * node);
      for (int side = 0; side < 2; ++side)
      {
        const double at = 0.5 + (side == 0 ? -node : node);
        const double before = h * at * (mean + 0.5 * slope * (at - 1.0));
        const double through = std::exp(-gathered.Depth - before);
        for (int k = 0; k < 3; ++k)
        {
          gathered.Seen[k] += 0.5 * h * through * emission[side].Light[k];
        }
      }
      gathered.Depth += h * mean;
      a += h;
    }
  }

  const MixedScene& Scene;
  std::vector<ReferenceMedium> Media;
  std::vector<ReferenceSurface> Surfaces;
  int Refinement;
  PixelRays Rays;
  std::vector<ReferenceLightSource> Lights;
  Double3 Ambient{};
  bool HasShadows = false;
  double Offset = 0.0;
  RgbaPicture Result;
};

}

RgbaPicture MakeMixedPicture(const MixedScene& scene, int refinement)
{
  return Picture(scene, refinement).Get();
}

}
