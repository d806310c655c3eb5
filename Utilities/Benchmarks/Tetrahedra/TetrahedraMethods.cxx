// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Tetrahedra/TetrahedraMethods.h"

namespace tetrahedra
{
namespace
{
using Mapper = vtkTimeWeightedTetrahedraMapper;
}

const char* const Baseline = "projectedtetrahedra";

const std::vector<RenderPath>& AllRenderPaths()
{
  static const std::vector<RenderPath> paths = { { "opengl", Mapper::OPENGL_PATH },
    { "software", Mapper::SOFTWARE_PATH } };
  return paths;
}

const char* const Unsorted = "composite, unsorted";
const char* const OpticalDepth = "optical depth";

const std::vector<RenderMode>& AllRenderModes()
{
  static const std::vector<RenderMode> modes = {
    { "composite", Mapper::COMPOSITE_BLEND, Mapper::AUTOMATIC_SORT, Mapper::LINEAR_SEGMENT },
    { Unsorted, Mapper::COMPOSITE_BLEND, Mapper::NO_SORT, Mapper::LINEAR_SEGMENT },
    { OpticalDepth, Mapper::OPTICAL_DEPTH_BLEND, Mapper::AUTOMATIC_SORT, Mapper::LINEAR_SEGMENT },
  };
  return modes;
}

const RenderMode& GetDefaultMode()
{
  return AllRenderModes()[0];
}

vtkSmartPointer<Mapper> NewMapper(
  vtkUnstructuredGrid* grid, const RenderPath& path, const RenderMode& mode)
{
  auto mapper = vtkSmartPointer<Mapper>::New();
  mapper->SetInputData(static_cast<vtkDataSet*>(grid));
  mapper->SetRenderPath(path.Path);
  mapper->SetBlendMode(mode.Blend);
  mapper->SetSortMode(mode.Sort);
  mapper->SetIntegrationMode(mode.Integration);
  mapper->AutoAdjustLevelOfDetailOff();
  return mapper;
}

void AddReport(vtkInterlumeReport* report, BenchRow& row)
{
  using Name = std::pair<const char*, const char*>;
  for (const auto& [count, value] : { Name("tetrahedra", "Tetrahedra"),
         Name("drawn", "TetrahedraDrawn"), Name("render_path", "RenderPath"),
         Name("passes", "Passes"), Name("sort_mode", "SortMode"), Name("cycles", "Cycles"),
         Name("gaps", "Gaps"), Name("buffers", "Buffers"), Name("buffer_bytes", "BufferBytes"),
         Name("memory_bytes", "MemoryBytes"), Name("uploaded_order_bytes", "UploadedOrderBytes"),
         Name("uploaded_image_bytes", "UploadedImageBytes") })
  {
    row.Counts[count] = report->GetCount(value);
  }
}
}
