// SPDX-License-Identifier: BSD-3-Clause
#include "Fields/MeshLinks.h"

#include "Common/GridCells.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>

namespace interlume
{

namespace
{
struct Entry
{
  MeshLinks::Key Key;
  std::weak_ptr<const MeshLinks> Links;
};

struct Registry
{
  std::mutex Mutex;
  std::vector<Entry> Entries;
};

Registry& GetRegistry()
{
  static Registry registry;
  return registry;
}
}

MeshLinks::Key MeshLinks::GetKey(vtkUnstructuredGrid* grid)
{
  // The grid's virtual GetMTime() would also change if an unrelated array changed.
  Key key = { { grid, grid->vtkObject::GetMTime() } };
  vtkCellArray* cells = grid->GetCells();
  for (vtkObject* part : std::initializer_list<vtkObject*>{ cells, cells->GetOffsetsArray(),
         cells->GetConnectivityArray(), GridCells::GetStoredTypes(grid), grid->GetPoints(),
         grid->GetPoints()->GetData(),
         grid->GetCellData()->GetArray(vtkDataSetAttributes::GhostArrayName()),
         grid->GetPointData()->GetArray(vtkDataSetAttributes::GhostArrayName()) })
  {
    key.emplace_back(part, part ? part->GetMTime() : 0);
  }
  return key;
}

std::shared_ptr<const MeshLinks> MeshLinks::Find(const Key& key)
{
  Registry& registry = GetRegistry();
  const std::lock_guard<std::mutex> lock(registry.Mutex);
  for (const Entry& entry : registry.Entries)
  {
    if (entry.Key == key)
    {
      return entry.Links.lock();
    }
  }
  return nullptr;
}

void MeshLinks::Add(const Key& key, const std::shared_ptr<const MeshLinks>& links)
{
  Registry& registry = GetRegistry();
  const std::lock_guard<std::mutex> lock(registry.Mutex);
  std::vector<Entry>& entries = registry.Entries;
  entries.erase(std::remove_if(entries.begin(), entries.end(),
                  [&key](const Entry& entry) { return entry.Links.expired() || entry.Key == key; }),
    entries.end());
  entries.push_back({ key, links });
}

}
