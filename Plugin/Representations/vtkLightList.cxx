// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLightList.h"

#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkRenderer.h"

std::vector<vtkSmartPointer<vtkLight>> vtkLightList::Get(vtkRenderer* renderer)
{
  std::vector<vtkSmartPointer<vtkLight>> lights;
  vtkCollectionSimpleIterator iterator;
  renderer->GetLights()->InitTraversal(iterator);
  while (vtkLight* light = renderer->GetLights()->GetNextLight(iterator))
  {
    lights.emplace_back(light);
  }
  return lights;
}

void vtkLightList::Set(vtkRenderer* renderer, const std::vector<vtkSmartPointer<vtkLight>>& lights)
{
  renderer->GetLights()->RemoveAllItems();
  for (const auto& light : lights)
  {
    renderer->GetLights()->AddItem(light);
  }
}
