// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Scattering/ScatteringModes.h"

#include "vtkMath.h"

#include <cmath>
#include <memory>

namespace scattering
{
const char* const Single = "single";
const char* const Forward = "forward";
const char* const Full = "full";
const char* const MonteCarlo = "monte-carlo";

std::vector<std::string> GetModes()
{
  return { Single, Forward, Full };
}

Change MakeModeSetter(const std::string& mode, double g, const Change& more)
{
  return [=](vtkShadowedSliceMapper* mapper)
  {
    using Mapper = vtkShadowedSliceMapper;
    mapper->SetScatteringMode(mode == Single ? Mapper::SINGLE_SCATTERING
        : mode == Forward                    ? Mapper::FORWARD_SCATTERING
                                             : Mapper::FULL_SCATTERING);
    mapper->SetPhaseFunctionToHenyeyGreenstein();
    mapper->SetAnisotropy(g);
    if (more)
    {
      more(mapper);
    }
  };
}

BenchWork MakeRelightingWork(shadows::Method& method, vtkLight* light, int threads)
{
  const BenchWork frame = method.GetFrame(threads);
  double start[3];
  light->GetPosition(start);
  const double x = start[0];
  const double y = start[1];
  const double z = start[2];
  const auto frames = std::make_shared<int>(0);
  return [=]()
  {
    const double angle = vtkMath::RadiansFromDegrees(0.5 * (++*frames % 40));
    light->SetPosition(
      x * std::cos(angle) - y * std::sin(angle), x * std::sin(angle) + y * std::cos(angle), z);
    vtkSmartPointer<vtkObjectBase> drawn = frame();
    light->SetPosition(x, y, z);
    return drawn;
  };
}
}
