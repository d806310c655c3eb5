// SPDX-License-Identifier: BSD-3-Clause
#include "Support/Images/ReferenceMixedImage.h"

#include "Support/Images/MixedScene.h"
#include "Support/Images/ReferenceLightSource.h"
#include "Support/Images/ReferenceMedium.h"
#include "Support/Images/ReferenceRay.h"
#include "Support/Images/ReferenceShadow.h"
#include "Support/Images/ReferenceSurface.h"

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
constexpr double Opaque = 18.0; // exp(-18) is below all tolerances
/// Shadow rays ignore surfaces closer than this, relative to the size of the largest surface.
constexpr double SurfaceOffset = 1e-9;

Double3 Along(const Double3& origin, const Double3& direction, double distance)
{
  return { { origin[0] + distance * direction[0], origin[1] + distance * direction[1],
    origin[2] + distance * direction[2] } };
}

class ImageRenderer
{
public:
  ImageRenderer(const MixedScene& scene, int refinement)
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
      throw std::invalid_argument(
        "the number of opaque distances differs from the number of pixels");
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

  const RgbaImage& Get() const { return this->Result; }

private:
  using Part = ReferenceMedium::Part;
  using Arrival = ReferenceLightSource::Arrival;

  /// Light and optical depth accumulated along a view ray.
  struct RayState
  {
    Double3 Seen{};
    double Depth = 0.0;
  };

  struct ViewRay
  {
    Double3 Origin;
    Double3 Direction;
  };

  /// The interval of a view ray inside a medium.
  struct MediumInterval
  {
    const ReferenceMedium* Medium = nullptr;
    IndexLine Line{};
    double Begin = 0.0;
    double End = 0.0;
  };

  /// An intersection of a view ray with a surface.
  struct SurfaceHit
  {
    const ReferenceSurface* Surface = nullptr;
    ReferenceSurface::Hit Hit{};
  };

  /// Returns the fraction of the light, per color channel, that reaches a point along a shadow ray.
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
      transmittance[k] *= through * ray.Fraction[k];
    }
    return transmittance;
  }

  /// Returns the light that arrives at a point from each light source, reduced by shadows.
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
          const double factor = 1.0 - strength * (1.0 - through[k]);
          arrival.Diffuse[k] *= factor;
          arrival.Specular[k] *= factor;
        }
      }
      arrivals.push_back(arrival);
    }
    return arrivals;
  }

  /// Shades by equations 2.6 and 2.9 of C. Zhang's dissertation.
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
        const double towardCamera = -vtkMath::Dot(reflected.data(), direction.data());
        glint = std::pow(std::max(towardCamera, 0.0), reflect.SpecularPower);
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

  /// Extinction and emitted light (extinction times color) at a point.
  struct Emission
  {
    double Extinction = 0.0;
    Double3 Light{};
  };

  Emission GetEmission(
    const std::vector<MediumInterval>& intervals, double at, const ViewRay& viewRay) const
  {
    const Double3 world = Along(viewRay.Origin, viewRay.Direction, at);
    Emission emission;
    std::vector<Arrival> arrivals;
    for (const MediumInterval& interval : intervals)
    {
      std::array<Part, 4> parts;
      const int count = interval.Medium->GetParts(interval.Line.At(at), true, parts);
      if (count > 0 && arrivals.empty())
      {
        arrivals = this->GetArrivals(world);
      }
      for (int p = 0; p < count; ++p)
      {
        const Double3 color = this->Shade(
          parts[p], interval.Medium->GetReflection(parts[p].Row), arrivals, viewRay.Direction);
        emission.Extinction += parts[p].Extinction;
        for (int k = 0; k < 3; ++k)
        {
          emission.Light[k] += parts[p].Extinction * color[k];
        }
      }
    }
    return emission;
  }

  static double GetExtinction(const std::vector<MediumInterval>& intervals, double at)
  {
    double sum = 0.0;
    for (const MediumInterval& interval : intervals)
    {
      std::array<Part, 4> parts;
      const int count = interval.Medium->GetParts(interval.Line.At(at), false, parts);
      for (int p = 0; p < count; ++p)
      {
        sum += parts[p].Extinction;
      }
    }
    return sum;
  }

  std::vector<SurfaceHit> GetSurfaceHits(const ViewRay& viewRay, double begin, double end) const
  {
    std::vector<SurfaceHit> surfaceHits;
    std::vector<ReferenceSurface::Hit> hits;
    for (const ReferenceSurface& surface : this->Surfaces)
    {
      hits.clear();
      surface.AppendHits(viewRay.Origin, viewRay.Direction, begin, end, hits);
      for (const auto& hit : hits)
      {
        surfaceHits.push_back({ &surface, hit });
      }
    }
    std::sort(surfaceHits.begin(), surfaceHits.end(),
      [](const SurfaceHit& a, const SurfaceHit& b)
      {
        return std::tie(a.Hit.Distance, a.Surface, a.Hit.Triangle) <
          std::tie(b.Hit.Distance, b.Surface, b.Hit.Triangle);
      });
    return surfaceHits;
  }

  void DrawPixel(int i, int j)
  {
    const Ray ray = this->Rays.Get(i, j);
    ViewRay viewRay;
    for (int k = 0; k < 3; ++k)
    {
      viewRay.Origin[k] = static_cast<double>(ray.Origin[k]);
      viewRay.Direction[k] = static_cast<double>(ray.Direction[k]);
    }
    double begin = static_cast<double>(this->Rays.GetNear() * ray.DistancePerDepth);
    double end = static_cast<double>(this->Rays.GetFar() * ray.DistancePerDepth);
    if (!this->Scene.OpaqueDistance.empty())
    {
      end = std::min(
        end, this->Scene.OpaqueDistance[static_cast<std::size_t>(j) * this->Scene.Size[0] + i]);
    }
    RayState state;
    for (const SurfaceHit& surfaceHit : this->GetSurfaceHits(viewRay, begin, end))
    {
      this->AddMedia(viewRay, begin, surfaceHit.Hit.Distance, state);
      begin = surfaceHit.Hit.Distance;
      if (state.Depth < Opaque)
      {
        this->AddSurface(viewRay, surfaceHit, state);
      }
    }
    this->AddMedia(viewRay, begin, end, state);
    double* pixel = this->Result.At(i, j);
    std::copy(state.Seen.begin(), state.Seen.end(), pixel);
    pixel[3] = -std::expm1(-state.Depth);
  }

  /// Adds the light reflected by a surface.
  void AddSurface(const ViewRay& viewRay, const SurfaceHit& surfaceHit, RayState& state) const
  {
    const Double3 world = Along(viewRay.Origin, viewRay.Direction, surfaceHit.Hit.Distance);
    const double opacity = surfaceHit.Surface->GetOpacity();
    const Double3 color =
      surfaceHit.Surface->Shade(surfaceHit.Hit, world, viewRay.Direction, this->GetArrivals(world));
    const double through = std::exp(-state.Depth);
    for (int k = 0; k < 3; ++k)
    {
      state.Seen[k] += through * opacity * color[k];
    }
    state.Depth -= std::log1p(-opacity);
  }

  /// Adds the light scattered by the media in the interval [begin, end] of the ray.
  void AddMedia(const ViewRay& viewRay, double begin, double end, RayState& state) const
  {
    std::vector<MediumInterval> intervals;
    std::vector<double> bounds;
    for (const ReferenceMedium& medium : this->Media)
    {
      MediumInterval interval = { &medium,
        medium.GetImage().ToIndex(viewRay.Origin, viewRay.Direction), begin, end };
      if (state.Depth < Opaque &&
        medium.GetImage().Cut(interval.Line, interval.Begin, interval.End) &&
        medium.Clip(viewRay.Origin, viewRay.Direction, interval.Begin, interval.End))
      {
        intervals.push_back(interval);
        ImageInterpolator::Walk(interval.Line, interval.Begin, interval.End,
          medium.GetCuts(interval.Line),
          [&](double a, double b)
          {
            bounds.push_back(a);
            bounds.push_back(b);
            return true;
          });
      }
    }
    std::sort(bounds.begin(), bounds.end());
    // Bounds that should be equal can differ by rounding errors. The tiny intervals between them
    // are skipped.
    constexpr double rounding = 1e-13;
    std::vector<MediumInterval> here;
    for (std::size_t i = 0; i + 1 < bounds.size() && state.Depth < Opaque; ++i)
    {
      const double midpoint = 0.5 * (bounds[i] + bounds[i + 1]);
      here.clear();
      std::copy_if(intervals.begin(), intervals.end(), std::back_inserter(here),
        [midpoint](const MediumInterval& interval)
        { return midpoint > interval.Begin && midpoint < interval.End; });
      if (bounds[i + 1] - bounds[i] > rounding * bounds[i + 1] && !here.empty())
      {
        this->March(here, viewRay, { bounds[i], bounds[i + 1] }, state);
      }
    }
  }

  /// Integrates a part of the ray that lies within one voxel of each medium.
  void March(const std::vector<MediumInterval>& intervals, const ViewRay& viewRay,
    const std::array<double, 2>& part, RayState& state) const
  {
    constexpr double node = 0.28867513459481287; // half of 1 / sqrt(3)
    const double longest = 0.5 * (part[1] - part[0]) / this->Refinement;
    const double depth = LargestStepDepth / this->Refinement;
    for (double a = part[0]; part[1] - a > 1e-9 * longest && state.Depth < Opaque;)
    {
      double h = std::min(longest, part[1] - a);
      while (h > 1e-6 * longest &&
        h * std::max(GetExtinction(intervals, a + 0.1 * h), GetExtinction(intervals, a + 0.9 * h)) >
          depth)
      {
        h *= 0.5;
      }
      std::array<Emission, 2> emission;
      for (int side = 0; side < 2; ++side)
      {
        const double at = a + h * (0.5 + (side == 0 ? -node : node));
        emission[side] = this->GetEmission(intervals, at, viewRay);
      }
      // Optical depth from the start of the step to each Gauss node, for linear extinction.
      const double mean = 0.5 * (emission[0].Extinction + emission[1].Extinction);
      const double slope = (emission[1].Extinction - emission[0].Extinction) / (2.0 * node);
      for (int side = 0; side < 2; ++side)
      {
        const double at = 0.5 + (side == 0 ? -node : node);
        const double before = h * at * (mean + 0.5 * slope * (at - 1.0));
        const double through = std::exp(-state.Depth - before);
        for (int k = 0; k < 3; ++k)
        {
          state.Seen[k] += 0.5 * h * through * emission[side].Light[k];
        }
      }
      state.Depth += h * mean;
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
  RgbaImage Result;
};

}

RgbaImage MakeMixedImage(const MixedScene& scene, int refinement)
{
  return ImageRenderer(scene, refinement).Get();
}

}
