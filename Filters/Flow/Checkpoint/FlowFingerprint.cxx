// SPDX-License-Identifier: BSD-3-Clause
#include "Checkpoint/FlowFingerprint.h"

#include "Advection/AdvectionOptions.h"
#include "Common/DataDigest.h"
#include "Common/NamedValue.h"

#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkPointData.h"
#include "vtkTerminationMesh.h"
#include "vtkTerminationTube.h"

#include <sstream>
#include <string>

namespace interlume
{

namespace
{
template <typename... Parts>
std::string GetDigest(Parts*... parts)
{
  DataDigest digest;
  (digest.Add(parts), ...);
  return digest.Take();
}

std::string GetGridDigest(vtkDataSet* grid)
{
  DataDigest digest;
  digest.AddGrid(grid);
  return digest.Take();
}

/// Returns the settings that PrintSelf prints for a surface. The output of vtkObject and pointers
/// are excluded because they differ between processes.
std::string GetSettings(vtkTerminationSurface* surface)
{
  std::ostringstream ofObject;
  surface->vtkObject::PrintSelf(ofObject, vtkIndent());
  std::ostringstream all = Fingerprint::MakeExactStream();
  surface->PrintSelf(all, vtkIndent());
  std::istringstream lines(all.str().substr(ofObject.str().size()));
  std::string settings = surface->GetClassName();
  for (std::string line; std::getline(lines, line);)
  {
    settings += line.find(": 0x") == std::string::npos ? "; " + line : std::string();
  }
  return settings;
}

std::string Describe(const AdvectionOptions::Surface& surface)
{
  // The getters and PrintSelf of VTK objects are not const.
  auto* shape = const_cast<vtkTerminationSurface*>(surface.Shape);
  std::string text = GetSettings(shape) + "; id " + std::to_string(surface.Id);
  if (auto* mesh = vtkTerminationMesh::SafeDownCast(shape))
  {
    text += "; mesh " + GetDigest(mesh->GetMesh());
  }
  if (auto* tube = vtkTerminationTube::SafeDownCast(shape))
  {
    DataDigest digest;
    digest.Add(tube->GetLine());
    for (int i = 0; i < tube->GetNumberOfPoints(); ++i)
    {
      double x[3];
      tube->GetPoint(i, x);
      digest.Add(x, sizeof(x));
    }
    text += "; line " + digest.Take();
  }
  return text;
}
}

FlowFingerprint::FlowFingerprint(
  const AdvectionOptions& options, vtkDataSet* field, vtkDataArray* vectors, vtkDataSet* samples)
  : Fingerprint(INTERLUME_VERSION)
{
  this->Add("field's points, cells or ghost marks", GetGridDigest(field));
  this->Add("vectors", GetDigest(vectors));
  for (const std::string& name : options.MeanArrays)
  {
    this->Add("array " + name, GetDigest(field->GetPointData()->GetArray(name.c_str())));
  }
  this->Add("samples", GetGridDigest(samples));
  this->Add("number of surfaces", std::to_string(options.Surfaces.size()));
  for (std::size_t i = 0; i < options.Surfaces.size(); ++i)
  {
    this->Add("surface " + std::to_string(i), Describe(options.Surfaces[i]));
  }
  std::ostringstream settings = Fingerprint::MakeExactStream();
  NamedValue::Print(settings, vtkIndent(),
    { { "DomainFaces", options.DomainFaces }, { "DomainFaceId", options.DomainFaceId },
      { "Direction", options.Direction }, { "Integrator", options.Integrator },
      { "MaximumError", options.MaximumError }, { "MaximumTime", options.MaximumTime },
      { "MaximumNumberOfSteps", options.MaximumNumberOfSteps },
      { "MinimumSpeed", options.MinimumSpeed }, { "ArrivalTolerance", options.ArrivalTolerance },
      { "ComputeMaximumSpeed", options.ComputeMaximumSpeed },
      { "ComputeArcLength", options.ComputeArcLength },
      { "ComputeMeanVorticity", options.ComputeMeanVorticity },
      { "MeanArrays", options.MeanArrays },
      { "InterpolateStreamlines", options.InterpolateStreamlines },
      { "RefinementLevels", options.RefinementLevels },
      { "SamplingChecks", options.SamplingChecks } });
  this->AddLines(settings.str());
}

}
