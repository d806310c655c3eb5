// SPDX-License-Identifier: BSD-3-Clause
// Tests that PrintSelf prints every value of a public class that has a setter and a getter. The
// values are read from the headers, so that the test covers new setters and classes.
#include "vtkAnalyticFieldSource.h"
#include "vtkAnalyticFlowSource.h"
#include "vtkAreaLight.h"
#include "vtkConstructiveModelSource.h"
#include "vtkConstructiveVolume.h"
#include "vtkDeltaWingSource.h"
#include "vtkFlowBoundary.h"
#include "vtkFlowCriticalPoints.h"
#include "vtkFlowLIC.h"
#include "vtkFlowVolume.h"
#include "vtkFlowVolumeFromVectors.h"
#include "vtkImplicitFlowField.h"
#include "vtkInflowMapping.h"
#include "vtkInterlumeReport.h"
#include "vtkIntervalVolume.h"
#include "vtkIsotableContour.h"
#include "vtkProjectiveLight.h"
#include "vtkShadowedScenePass.h"
#include "vtkShadowedSliceMapper.h"
#include "vtkSimplexTimeSlice.h"
#include "vtkSpatialImage.h"
#include "vtkSpatialOperation.h"
#include "vtkSpatialPrimitive.h"
#include "vtkSpatialTurbulence.h"
#include "vtkStreamSurfaceParameters.h"
#include "vtkImplicitFlowVolumeMapper.h"
#include "vtkStreamSurfaceMapper.h"
#include "vtkStreamlineTexture.h"
#include "vtkTaperedCylinderSource.h"
#include "vtkTemporalColorTransferFunction.h"
#include "vtkTerminationBox.h"
#include "vtkTerminationCylinder.h"
#include "vtkTerminationInflow.h"
#include "vtkTerminationMesh.h"
#include "vtkTerminationPlane.h"
#include "vtkTerminationSphere.h"
#include "vtkTerminationSurfaceSource.h"
#include "vtkTerminationTube.h"
#include "vtkTimeSlabWriter.h"
#include "vtkTimeVaryingIntervalVolume.h"
#include "vtkTimeWeightedTetrahedraMapper.h"
#include "vtkTurbulenceSource.h"
#include "vtkVortexAxis.h"
#ifdef INTERLUME_HAS_MESHING
#include "vtkTetrahedralMesher.h"
#endif

#include "vtkIndent.h"
#include "vtkObject.h"
#include "vtkSmartPointer.h"

#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace
{

namespace fs = std::filesystem;

template <typename Class>
vtkSmartPointer<vtkObject> Make()
{
  return vtkSmartPointer<Class>::New();
}

/// Returns an instance of each public class.
std::vector<vtkSmartPointer<vtkObject>> MakeAll()
{
  std::vector<vtkSmartPointer<vtkObject>> all = {
    Make<vtkAnalyticFieldSource>(),
    Make<vtkAnalyticFlowSource>(),
    Make<vtkAreaLight>(),
    Make<vtkConstructiveModelSource>(),
    Make<vtkConstructiveVolume>(),
    Make<vtkDeltaWingSource>(),
    Make<vtkFlowBoundary>(),
    Make<vtkFlowCriticalPoints>(),
    Make<vtkFlowLIC>(),
    Make<vtkFlowVolume>(),
    Make<vtkFlowVolumeFromVectors>(),
    Make<vtkImplicitFlowField>(),
    Make<vtkInflowMapping>(),
    Make<vtkIntervalVolume>(),
    Make<vtkInterlumeReport>(),
    Make<vtkIsotableContour>(),
    Make<vtkProjectiveLight>(),
    Make<vtkShadowedScenePass>(),
    Make<vtkShadowedSliceMapper>(),
    Make<vtkSimplexTimeSlice>(),
    Make<vtkSpatialImage>(),
    Make<vtkSpatialOperation>(),
    Make<vtkSpatialPrimitive>(),
    Make<vtkSpatialTurbulence>(),
    Make<vtkStreamSurfaceParameters>(),
    Make<vtkStreamSurfaceMapper>(),
    Make<vtkStreamlineTexture>(),
    Make<vtkImplicitFlowVolumeMapper>(),
    Make<vtkTaperedCylinderSource>(),
    Make<vtkTemporalColorTransferFunction>(),
    Make<vtkTerminationBox>(),
    Make<vtkTerminationCylinder>(),
    Make<vtkTerminationInflow>(),
    Make<vtkTerminationMesh>(),
    Make<vtkTerminationPlane>(),
    Make<vtkTerminationSphere>(),
    Make<vtkTerminationSurfaceSource>(),
    Make<vtkTerminationTube>(),
    Make<vtkTimeSlabWriter>(),
    Make<vtkTimeVaryingIntervalVolume>(),
    Make<vtkTimeWeightedTetrahedraMapper>(),
    Make<vtkTurbulenceSource>(),
    Make<vtkVortexAxis>(),
  };
#ifdef INTERLUME_HAS_MESHING
  all.push_back(Make<vtkTetrahedralMesher>());
#endif
  return all;
}

std::string Print(vtkObject* object)
{
  std::ostringstream text;
  object->PrintSelf(text, vtkIndent());
  return text.str();
}

/// Values that PrintSelf need not print. Values per surface id are printed only if they are set.
/// The values of vtkShadowedScenePass are information keys of props.
const std::set<std::string> NotPrinted = { "vtkInflowMapping::Formula", "vtkInflowMapping::Image",
  "vtkShadowedScenePass::CastsShadows", "vtkShadowedScenePass::CastsShadowsWhenInvisible",
  "vtkShadowedScenePass::ReceivesShadows" };

/// Returns the text of each module header without comments, by class name.
std::map<std::string, std::string> ReadHeaders(const fs::path& source)
{
  const std::regex comment(R"(/\*[\s\S]*?\*/|//[^\n]*)");
  std::map<std::string, std::string> headers;
  for (const char* part : { "Filters", "Rendering" })
  {
    for (const auto& module : fs::directory_iterator(source / part))
    {
      for (const auto& entry : fs::directory_iterator(module.path()))
      {
        if (entry.path().extension() == ".h")
        {
          std::ifstream file(entry.path());
          std::stringstream text;
          text << file.rdbuf();
          headers[entry.path().stem().string()] = std::regex_replace(text.str(), comment, "");
        }
      }
    }
  }
  return headers;
}

std::set<std::string> FindAll(const std::string& text, const std::string& pattern)
{
  const std::regex expression(pattern);
  std::set<std::string> found;
  for (std::sregex_iterator i(text.begin(), text.end(), expression), end; i != end; ++i)
  {
    found.insert((*i)[1]);
  }
  return found;
}

/// Returns the values that a class or its base classes in the project can set and get.
std::set<std::string> FindValues(
  const std::map<std::string, std::string>& headers, const std::string& name)
{
  const auto header = headers.find(name);
  if (header == headers.end())
  {
    return {};
  }
  const std::string& text = header->second;
  std::set<std::string> values = FindAll(text, R"(vtkSet\w*Macro\((\w+),)");
  std::set<std::string> getters = FindAll(text, R"(\bGet(\w+)\()");
  getters.merge(FindAll(text, R"(vtkGet\w*Macro\((\w+),)"));
  for (const std::string& value : FindAll(text, R"(void Set(\w+)\()"))
  {
    if (getters.count(value) > 0)
    {
      values.insert(value);
    }
  }
  for (const std::string& base : FindAll(text, R"(public (vtk\w+))"))
  {
    values.merge(FindValues(headers, base));
  }
  return values;
}

/// Returns true if a line begins with the value's name in singular or plural. A value
/// NumberOfThings may be printed as `Things: 3`.
bool IsPrinted(const std::string& text, const std::string& value)
{
  const std::string prefix = "NumberOf";
  const std::string name =
    value.compare(0, prefix.size(), prefix) == 0 ? value.substr(prefix.size()) : value;
  const std::string stem = name.back() == 'y' ? name.substr(0, name.size() - 1) + "ie" : name;
  return std::regex_search(
    text, std::regex("(^|\n) *(" + prefix + ")?(" + name + "|" + stem + "s):"));
}

}

int main(int, char* argv[])
{
  const auto headers = ReadHeaders(argv[1]);
  int failed = 0;
  int checked = 0;
  const auto expect = [&](bool isValid, const std::string& what)
  {
    ++checked;
    failed += isValid ? 0 : 1;
    if (!isValid)
    {
      std::cerr << what << "\n";
    }
  };
  std::set<std::string> created;
#ifndef INTERLUME_HAS_MESHING
  created.insert("vtkTetrahedralMesher");
#endif
  for (const auto& object : MakeAll())
  {
    const std::string name = object->GetClassName();
    created.insert(name);
    const std::string text = Print(object);
    for (const std::string& value : FindValues(headers, name))
    {
      expect(IsPrinted(text, value) || NotPrinted.count(name + "::" + value) > 0,
        name + " does not print " + value);
    }
  }
  for (const auto& header : headers)
  {
    const std::string& name = header.first;
    const bool isPublic = header.second.find("_EXPORT " + name) != std::string::npos;
    const bool hasNew = header.second.find("static " + name + "* New();") != std::string::npos;
    expect(!isPublic || !hasNew || created.count(name) > 0, name + " is missing from this test");
  }
  std::cout << checked << " checks, " << failed << " failed\n";
  return failed == 0 && checked > 200 ? 0 : 1;
}
