// SPDX-License-Identifier: BSD-3-Clause
#include "Support/Meshes/ReferenceMeshBuilder.h"

#include <set>

namespace reference
{

MeshBuilder::MeshBuilder()
{
  this->Points->SetDataTypeToDouble();
}

vtkIdType MeshBuilder::AddPoint(double x, double y, double z)
{
  return this->Points->InsertNextPoint(x, y, z);
}

vtkIdType MeshBuilder::FindOrAddPoint(
  const std::array<int, 3>& key, const std::array<double, 3>& scale)
{
  const auto found = this->Keys.find(key);
  if (found != this->Keys.end())
  {
    return found->second;
  }
  const vtkIdType id = this->AddPoint(key[0] * scale[0], key[1] * scale[1], key[2] * scale[2]);
  this->Keys[key] = id;
  return id;
}

void MeshBuilder::AddCell(int type, const std::vector<vtkIdType>& ids)
{
  this->Mesh->InsertNextCell(type, static_cast<vtkIdType>(ids.size()), ids.data());
}

void MeshBuilder::AddPolyhedron(const std::vector<std::vector<vtkIdType>>& faces)
{
  std::vector<vtkIdType> stream;
  std::set<vtkIdType> distinct;
  for (const auto& face : faces)
  {
    stream.push_back(static_cast<vtkIdType>(face.size()));
    stream.insert(stream.end(), face.begin(), face.end());
    distinct.insert(face.begin(), face.end());
  }
  const std::vector<vtkIdType> ids(distinct.begin(), distinct.end());
  this->Mesh->InsertNextCell(VTK_POLYHEDRON, static_cast<vtkIdType>(ids.size()), ids.data(),
    static_cast<vtkIdType>(faces.size()), stream.data());
}

vtkSmartPointer<vtkUnstructuredGrid> MeshBuilder::GetMesh()
{
  this->Mesh->SetPoints(this->Points);
  return vtkSmartPointer<vtkUnstructuredGrid>(this->Mesh);
}

}
