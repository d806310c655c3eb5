// SPDX-License-Identifier: BSD-3-Clause
#include "Pictures/ReferenceShadowPicture.h"

#include "Pictures/ReferenceLightSource.h"
#include "Pictures/ReferenceMedium.h"
#include "Pictures/ReferenceRay.h"
#include "Pictures/ReferenceShadow.h"
#include "Pictures/ShadowScene.h"

#include "vtkCamera.h"
#include "vtkColorTransferFunction.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkPlane.h"
#include "vtkSMPTools.h"
#include "vtkVolumeProperty.h"

#include <stdexcept>

namespace reference
{

namespace
{

constexpr double LargestStepDepth = 0.1;
constexpr double Opaque = 18.0; // exp(-18) is below any bound

class Picture
{
public:
  Picture(const ShadowScene& scene, int refinement)
    : Scene(scene)
    , Medium(scene)
    , Refinement(refinement)
    , Rays(scene.Camera, scene.Size)
    , Result(scene.Size[0], scene.Size[1])
  {
    if (!scene.OpaqueDistance.empty() &&
      scene.OpaqueDistance.size() != this->Result.Values.size() / 4)
    {
      throw std::invalid_argument("opaque distances for another number of pixels");
    }
    for (vtkLight* light : scene.Lights)
    {
      if (light->GetSwitch() != 0)
      {
        this->Lights.emplace_back(light);
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
        const Double3 through = ToTransmittance(GetOpticalDepth(
          this->Medium, world, arrival.ToLight, arrival.Distance, this->Refinement));
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
  Double3 Shade(
    const Part& part, const std::vector<Arrival>& arrivals, const Double3& direction) const
  {
    const ReferenceMedium::Reflection& reflect = this->Medium.GetReflection(part.Row);
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

  Emission GetEmission(const Double3& index, const Double3& world, const Double3& direction) const
  {
    std::array<Part, 4> parts;
    const int count = this->Medium.GetParts(index, true, parts);
    Emission emission;
    if (count == 0)
    {
      return emission;
    }
    const std::vector<Arrival> arrivals = this->GetArrivals(world);
    for (int p = 0; p < count; ++p)
    {
      const Double3 color = this->Shade(parts[p], arrivals, direction);
      emission.Extinction += parts[p].Extinction;
      for (int k = 0; k < 3; ++k)
      {
        emission.Light[k] += parts[p].Extinction * color[k];
      }
    }
    return emission;
  }

  double GetExtinction(const Double3& index) const
  {
    std::array<Part, 4> parts;
    const int count = this->Medium.GetParts(index, false, parts);
    double sum = 0.0;
    for (int p = 0; p < count; ++p)
    {
      sum += parts[p].Extinction;
    }
    return sum;
  }

  void DrawPixel(int i, int j)
  {
    const Ray ray = this->Rays.Get(i, j);
    Double3 origin;
    Double3 direction;
    for (int k = 0; k < 3; ++k)
    {
      origin[k] = static_cast<double>(ray.Origin[k]);
      direction[k] = static_cast<double>(ray.Direction[k]);
    }
    double begin = static_cast<double>(this->Rays.GetNear() * ray.DistancePerDepth);
    double end = this->Scene.OpaqueDistance.empty()
      ? std::numeric_limits<double>::infinity()
      : this->Scene.OpaqueDistance[static_cast<std::size_t>(j) * this->Scene.Size[0] + i];
    const IndexLine line = this->Medium.GetImage().ToIndex(origin, direction);
    Gathered gathered;
    if (this->Medium.GetImage().Cut(line, begin, end) &&
      this->Medium.Clip(origin, direction, begin, end))
    {
      ReferenceImage::Walk(line, begin, end, this->Medium.GetCuts(line),
        [&](double a, double b)
        {
          this->March(line, origin, direction, { a, b }, gathered);
          return gathered.Depth < Opaque;
        });
    }
    double* pixel = this->Result.At(i, j);
    std::copy(gathered.Seen.begin(), gathered.Seen.end(), pixel);
    pixel[3] = -std::expm1(-gathered.Depth);
  }

  /// Through a part of the line within one voxel.
  void March(const IndexLine& line, const Double3& origin, const Double3& direction,
    const std::array<double, 2>& part, Gathered& gathered) const
  {
    constexpr double node = 0.28867513459481287; // half of 1 / sqrt(3)
    const double longest = 0.5 * (part[1] - part[0]) / this->Refinement;
    const double depth = LargestStepDepth / this->Refinement;
    for (double a = part[0]; part[1] - a > 1e-9 * longest && gathered.Depth < Opaque;)
    {
      double h = std::min(longest, part[1] - a);
      while (h > 1e-6 * longest &&
        h *
            std::max(this->GetExtinction(line.At(a + 0.1 * h)),
              this->GetExtinction(line.At(a + 0.9 * h))) >
          depth)
      {
        h *= 0.5;
      }
      std::array<Emission, 2> emission;
      for (int side = 0; side < 2; ++side)
      {
        const double at = a + h * (0.5 + (side == 0 ? -node : node));
        Double3 world;
        for (int k = 0; k < 3; ++k)
        {
          world[k] = origin[k] + at * direction[k];
        }
        emission[side] = this->GetEmission(line.At(at), world, direction);
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

  const ShadowScene& Scene;
  ReferenceMedium Medium;
  int Refinement;
  PixelRays Rays;
  std::vector<ReferenceLightSource> Lights;
  Double3 Ambient{};
  bool HasShadows = false;
  RgbaPicture Result;
};

}

RgbaPicture MakeShadowPicture(const ShadowScene& scene, int refinement)
{
  return Picture(scene, refinement).Get();
}

}
