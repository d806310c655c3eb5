// SPDX-License-Identifier: BSD-3-Clause
// Writes a folder for the tests of the ParaView plugin: numbers.json, a list of extractions (what
// was asked of which filter on which data, and what came out), that data in the legacy format, and
// time_varying.json and flow.json, extractions from temporal sources and of flows.
// The plugin is asked the same and must give the same. The legacy format, since ParaView 5.11 of
// Debian cannot read appended XML data with an expat that defers parsing (2.6, and 2.5 with that
// fix).
#include "Support/Inputs/DataFiles.h"
#include "ParaView/Extractions/ExtractionMeasures.h"
#include "ParaView/Extractions/FlowNumbers.h"
#include "ParaView/Extractions/PieceWriter.h"
#include "ParaView/Extractions/TimeVaryingNumbers.h"
#include "vtkDataSet.h"
#include "vtkDataSetWriter.h"
#include "vtkIdTypeArray.h"
#include "vtkIntervalVolume.h"
#include "vtkIsotableContour.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkRTAnalyticSource.h"
#include "vtkUnstructuredGrid.h"

#include <cstdlib>
#include <exception>
#include <fstream>
#include <iostream>
#include <map>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace
{
constexpr int NUMBER_OF_PIECES = 4;

using Range = std::pair<double, double>;

struct Criterion
{
  std::string Array;
  double Lower;
  double Upper;
};

// Point ids that outlast a distribution to other processes: cells are cut in their order.
void AddGlobalIds(vtkDataSet* data)
{
  vtkNew<vtkIdTypeArray> ids;
  ids->SetName("GlobalPointIds");
  ids->SetNumberOfValues(data->GetNumberOfPoints());
  std::iota(ids->Begin(), ids->End(), vtkIdType{ 0 });
  data->GetPointData()->SetGlobalIds(ids);
}

// Gives the inputs and leaves a copy of each file for ParaView.
class Inputs
{
public:
  explicit Inputs(std::string folder)
    : Folder(std::move(folder))
  {
  }

  // The wavelet source with its defaults, or a file of Data/, by its name without extension.
  vtkSmartPointer<vtkDataSet> Get(const std::string& name) const
  {
    const auto file = this->Files.find(name);
    if (file == this->Files.end())
    {
      vtkNew<vtkRTAnalyticSource> wavelet;
      wavelet->Update();
      return vtkDataSet::SafeDownCast(wavelet->GetOutputDataObject(0));
    }
    vtkSmartPointer<vtkDataSet> data = interlume::ReadData(file->second);
    AddGlobalIds(data);
    vtkNew<vtkDataSetWriter> writer;
    writer->SetInputData(data);
    writer->SetFileTypeToBinary();
    writer->SetFileName((this->Folder + "/" + name + ".vtk").c_str());
    if (writer->Write() != 1)
    {
      throw std::runtime_error("cannot write to " + this->Folder);
    }
    return data;
  }

private:
  std::string Folder;
  std::map<std::string, std::string> Files{ { "disk_out_ref", "disk_out_ref.vtu" },
    { "bluntfin", "bluntfin.vts" }, { "post_tets", "post_tets.vtk" } };
};

nlohmann::json ExtractIntervals(const Inputs& inputs, const std::string& data,
  const std::string& array, const std::vector<Range>& intervals,
  const std::vector<Criterion>& criteria = {})
{
  nlohmann::json result = { { "filter", "IntervalVolume" }, { "data", data }, { "array", array },
    { "intervals", intervals }, { "criteria", nlohmann::json::array() } };
  vtkNew<vtkIntervalVolume> filter;
  filter->SetInputData(inputs.Get(data));
  filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, array.c_str());
  filter->GenerateBoundariesOn();
  filter->SetNumberOfIntervals(static_cast<int>(intervals.size()));
  for (std::size_t i = 0; i < intervals.size(); ++i)
  {
    filter->SetInterval(static_cast<int>(i), intervals[i].first, intervals[i].second);
  }
  for (const Criterion& criterion : criteria)
  {
    filter->AddCriterion(criterion.Array.c_str(), criterion.Lower, criterion.Upper);
    result["criteria"].push_back({ criterion.Array, criterion.Lower, criterion.Upper });
  }
  filter->Update();
  result["output"] = MeasureExtraction(filter->GetOutput(0), "IntervalId");
  result["boundary"] = MeasureExtraction(filter->GetOutput(1), "IntervalId");
  return result;
}

nlohmann::json ExtractContours(const Inputs& inputs, const std::string& data,
  const std::string& array, const std::vector<double>& values)
{
  vtkNew<vtkIsotableContour> filter;
  filter->SetInputData(inputs.Get(data));
  filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, array.c_str());
  filter->SetNumberOfContours(static_cast<int>(values.size()));
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    filter->SetValue(static_cast<int>(i), values[i]);
  }
  filter->Update();
  return { { "filter", "IsotableContour" }, { "data", data }, { "array", array },
    { "values", values }, { "output", MeasureExtraction(filter->GetOutput(0), "ContourId") } };
}

nlohmann::json AllExtractions(const Inputs& inputs)
{
  const std::string disk = "disk_out_ref";
  return { ExtractIntervals(inputs, "wavelet", "RTData", { { 140.0, 180.0 } }),
    ExtractIntervals(
      inputs, "wavelet", "RTData", { { 60.0, 100.0 }, { 100.0, 130.0 }, { 200.0, 250.0 } }),
    ExtractIntervals(inputs, "bluntfin", "Density", { { 1.2, 2.5 } }),
    ExtractIntervals(inputs, disk, "Temp", { { 400.0, 500.0 }, { 500.0, 700.0 } }),
    ExtractIntervals(inputs, disk, "Temp", { { 350.0, 600.0 } }, { { "Pres", 0.01, 0.02 } }),
    ExtractIntervals(inputs, "post_tets", "Pressure", { { 0.8, 1.1 } }),
    ExtractContours(inputs, "wavelet", "RTData", { 100.0, 157.0 }),
    ExtractContours(inputs, disk, "Temp", { 400.0 }) };
}

// The unstructured grids for the run with several processes.
void WriteDistributed(const Inputs& inputs, const std::string& folder)
{
  const std::pair<const char*, const char*> grids[] = { { "disk_out_ref", "Temp" },
    { "post_tets", "Pressure" } };
  for (const auto& grid : grids)
  {
    WritePieces(vtkUnstructuredGrid::SafeDownCast(inputs.Get(grid.first)), grid.second,
      NUMBER_OF_PIECES, folder + "/" + grid.first + "_pieces");
  }
}

void WriteJson(const nlohmann::json& content, const std::string& path)
{
  std::ofstream file(path);
  file << content.dump(1) << "\n";
  if (!file.flush())
  {
    throw std::runtime_error("cannot write " + path);
  }
}
}

int main(int argc, char* argv[])
{
  if (argc != 2)
  {
    std::cerr << "usage: " << argv[0] << " FOLDER\n";
    return EXIT_FAILURE;
  }
  try
  {
    const std::string folder = argv[1];
    const Inputs inputs(folder);
    WriteDistributed(inputs, folder);
    const nlohmann::json extractions = AllExtractions(inputs);
    for (const nlohmann::json& extraction : extractions)
    {
      const auto cells = extraction["output"]["cells"].get<vtkIdType>();
      std::cout << extraction["filter"] << " of " << extraction["data"] << ": " << cells
                << " cells, size " << extraction["output"]["size"] << "\n";
      if (cells == 0)
      {
        throw std::runtime_error("an extraction is empty");
      }
    }
    WriteJson(extractions, folder + "/numbers.json");
    WriteJson(MeasureTimeVaryingVolumes(), folder + "/time_varying.json");
    WriteJson(MeasureFlowVolumes(), folder + "/flow.json");
  }
  catch (const std::exception& error)
  {
    std::cerr << "ERROR: " << error.what() << "\n";
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
