// The defaults in the plugin's server-manager XML are those of the C++ classes, for every property;
// the properties whose default comes from the data have a domain that gives it.
#include "vtkIntervalVolume.h"
#include "vtkIsotableContour.h"
#include "vtkNew.h"
#include "vtkSmartPointer.h"
#ifdef INTERLUME_ENABLE_TETGEN
#include "vtkTetrahedralMesher.h"
#endif
#include "vtkTimeWeightedTetrahedraMapper.h"
#include "vtkXMLDataElement.h"
#include "vtkXMLUtilities.h"

#include <cstdlib>
#include <iostream>
#include <map>
#include <sstream>
#include <string>

namespace
{
int Failures = 0;

void Check(bool condition, const std::string& what)
{
  if (!condition)
  {
    ++Failures;
    std::cerr << "failed: " << what << "\n";
  }
}

template <typename Value>
std::string Text(Value value)
{
  std::ostringstream text;
  text << value;
  return text.str();
}

// A property's name in the XML and the value a fresh object has.
using Defaults = std::map<std::string, std::string>;

bool TakesValueFromData(vtkXMLDataElement* property)
{
  return property->FindNestedElementWithName("ArrayRangeDomain") ||
    property->FindNestedElementWithName("DataTypeDomain") ||
    property->FindNestedElementWithName("ArrayListDomain") ||
    property->FindNestedElementWithName("BoundsDomain") ||
    property->FindNestedElementWithName("InputArrayDomain");
}

// Compares the properties whose names start with the prefix.
void CompareWithXML(const std::string& file, const std::string& proxyKind,
  const std::string& className, const std::string& prefix, const Defaults& defaults)
{
  vtkSmartPointer<vtkXMLDataElement> root;
  root.TakeReference(vtkXMLUtilities::ReadElementFromFile(file.c_str()));
  vtkXMLDataElement* proxy = root ? root->LookupElementWithName(proxyKind.c_str()) : nullptr;
  Check(proxy != nullptr, file + " has a " + proxyKind);
  if (!proxy)
  {
    return;
  }
  Check(proxy->GetAttribute("class") == className, file + " is for " + className);

  std::size_t compared = 0;
  for (int i = 0; i < proxy->GetNumberOfNestedElements(); ++i)
  {
    vtkXMLDataElement* property = proxy->GetNestedElement(i);
    const std::string kind = property->GetName();
    if (kind.find("Property") == std::string::npos || kind == "PropertyGroup")
    {
      continue;
    }
    const std::string name = property->GetAttribute("name");
    if (name.compare(0, prefix.size(), prefix) != 0)
    {
      continue;
    }
    const auto expected = defaults.find(name);
    if (expected == defaults.end())
    {
      Check(TakesValueFromData(property), className + "." + name + " is compared or has a domain");
      continue;
    }
    const char* given = property->GetAttribute("default_values");
    Check((given ? given : "") == expected->second,
      className + "." + name + ": XML '" + (given ? given : "") + "', C++ '" + expected->second +
        "'");
    ++compared;
  }
  Check(compared == defaults.size(), className + ": the XML has every compared property");
}
}

int main(int argc, char* argv[])
{
  if (argc != 2)
  {
    std::cerr << "usage: " << argv[0] << " PLUGIN_FOLDER\n";
    return EXIT_FAILURE;
  }
  const std::string folder = argv[1];

  vtkNew<vtkIntervalVolume> interval;
  Check(interval->GetNumberOfIntervals() == 0, "vtkIntervalVolume starts without an interval");
  Check(interval->GetNumberOfCriteria() == 0, "vtkIntervalVolume starts without a criterion");
  CompareWithXML(folder + "/IntervalVolume.xml", "SourceProxy", "vtkIntervalVolume", "",
    { { "Criteria", "" }, { "GenerateBoundaries", Text(interval->GetGenerateBoundaries()) },
      { "OutputPointsPrecision", Text(interval->GetOutputPointsPrecision()) },
      { "UseValueIndex", Text(interval->GetUseValueIndex()) } });

  vtkNew<vtkIsotableContour> contour;
  Check(contour->GetNumberOfContours() == 0, "vtkIsotableContour starts without a value");
  CompareWithXML(folder + "/IsotableContour.xml", "SourceProxy", "vtkIsotableContour", "",
    { { "OutputPointsPrecision", Text(contour->GetOutputPointsPrecision()) },
      { "UseValueIndex", Text(contour->GetUseValueIndex()) } });

#ifdef INTERLUME_ENABLE_TETGEN
  vtkNew<vtkTetrahedralMesher> mesher;
  CompareWithXML(folder + "/TetrahedralMesher.xml", "SourceProxy", "vtkTetrahedralMesher", "",
    { { "QualityBound", Text(mesher->GetQualityBound()) },
      { "MinimumDihedralAngle", Text(mesher->GetMinimumDihedralAngle()) },
      { "MaximumVolume", Text(mesher->GetMaximumVolume()) },
      { "MaximumNumberOfAddedPoints", Text(mesher->GetMaximumNumberOfAddedPoints()) },
      { "PreserveBoundary", Text(mesher->GetPreserveBoundary()) },
      { "FillNestedShells", Text(mesher->GetFillNestedShells()) },
      { "TimeLimit", Text(mesher->GetTimeLimit()) } });
#endif

  // The representation's own properties; the others are those of ParaView's volumes.
  vtkNew<vtkTimeWeightedTetrahedraMapper> mapper;
  Check(mapper->GetDeltaTArrayName() == nullptr, "the mapper takes DeltaT where there is one");
  Check(mapper->GetLayerPriority(3) == 3.0, "the mapper's priorities are the layers' numbers");
  CompareWithXML(folder + "/IntervalVolumeRepresentation.xml", "RepresentationProxy",
    "vtkIntervalVolumeRepresentation", "Interval",
    { { "IntervalBlendMode", Text(mapper->GetBlendMode()) },
      { "IntervalSortMode", Text(mapper->GetSortMode()) },
      { "IntervalIntegrationMode", Text(mapper->GetIntegrationMode()) },
      { "IntervalRenderPath", Text(mapper->GetRenderPath()) },
      { "IntervalAutoAdjustLevelOfDetail", Text(mapper->GetAutoAdjustLevelOfDetail()) },
      { "IntervalDeltaTArrayName", "DeltaT" },
      { "IntervalLayerArrayName", mapper->GetLayerArrayName() },
      { "IntervalLayerPriorities", "" } });
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
