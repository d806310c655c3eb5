// SPDX-License-Identifier: BSD-3-Clause
#include "ShadowMaps/PropSurfaces.h"

#include "ShadowMaps/GlyphInstances.h"
#include "Common/Vectors.h"
#include "Space/UnitVector.h"

#include "vtkActor.h"
#include "vtkAssemblyNode.h"
#include "vtkAssemblyPath.h"
#include "vtkCellArray.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataSetMapper.h"
#include "vtkGlyph3DMapper.h"
#include "vtkIdList.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkPolygon.h"
#include "vtkProperty.h"
#include "vtkSmartPointer.h"

namespace interlume
{

namespace
{
// Appends the point ids of the triangles of a polygon or a strip.
void AddPoints(vtkPolyData* data, const std::vector<vtkIdType>& cell, bool isStrip,
  std::vector<vtkIdType>& points)
{
  if (isStrip || cell.size() == 3)
  {
    for (std::size_t i = 2; i < cell.size(); ++i)
    {
      points.insert(points.end(), { cell[i - 2], cell[i - 1], cell[i] });
    }
    return;
  }
  vtkNew<vtkPolygon> polygon;
  polygon->Initialize(static_cast<int>(cell.size()), cell.data(), data->GetPoints());
  vtkNew<vtkIdList> corners;
  vtkNew<vtkPoints> coordinates;
  if (cell.size() > 3 && polygon->Triangulate(0, corners, coordinates) != 0)
  {
    points.insert(points.end(), corners->begin(), corners->end());
  }
}

void AddTriangles(vtkPolyData* data, const glm::dmat4& worldFromData, std::vector<glm::dvec3>& to)
{
  std::vector<vtkIdType> points;
  for (const bool isStrip : { false, true })
  {
    vtkCellArray* cells = !data ? nullptr : isStrip ? data->GetStrips() : data->GetPolys();
    for (vtkIdType i = 0; cells && i < cells->GetNumberOfCells(); ++i)
    {
      vtkIdType number = 0;
      const vtkIdType* ids = nullptr;
      cells->GetCellAtId(i, number, ids);
      AddPoints(data, { ids, ids + number }, isStrip, points);
    }
  }
  for (const vtkIdType point : points)
  {
    glm::dvec4 position(1.0);
    data->GetPoint(point, glm::value_ptr(position));
    position = worldFromData * position;
    to.push_back(glm::dvec3(position) / position.w);
  }
}

void AddGlyphs(vtkGlyph3DMapper* mapper, vtkDataSet* points, const glm::dmat4& worldFromPoints,
  std::vector<glm::dvec3>& to)
{
  if (!points || mapper->GetUseSourceTableTree())
  {
    return;
  }
  for (const GlyphInstances::Instance& instance : GlyphInstances::Get(mapper, points))
  {
    AddTriangles(mapper->GetSource(instance.Source), worldFromPoints * instance.Matrix, to);
  }
}

PropSurfaces::Surface GetSurface(vtkActor* actor, vtkMatrix4x4* matrix)
{
  PropSurfaces::Surface surface;
  vtkMapper* any = actor->GetMapper();
  auto* ofData = vtkDataSetMapper::SafeDownCast(any);
  auto* glyphs = vtkGlyph3DMapper::SafeDownCast(any);
  vtkMapper* mapper =
    glyphs ? any : vtkPolyDataMapper::SafeDownCast(ofData ? ofData->GetPolyDataMapper() : any);
  if (!mapper || mapper->GetNumberOfInputConnections(0) == 0 || !actor->HasOpaqueGeometry() ||
    actor->GetProperty()->GetRepresentation() != VTK_SURFACE)
  {
    return surface;
  }
  any->Update();
  const glm::dmat4 worldFromData =
    matrix ? UnitVector::FromRows(matrix->GetData()) : glm::dmat4(1.0);
  const auto add = [&](vtkDataObject* data)
  {
    if (glyphs)
    {
      AddGlyphs(glyphs, vtkDataSet::SafeDownCast(data), worldFromData, surface.Corners);
    }
    else
    {
      AddTriangles(vtkPolyData::SafeDownCast(data), worldFromData, surface.Corners);
    }
  };
  vtkDataObject* input = mapper->GetInputDataObject(0, 0);
  add(input);
  if (auto* composite = vtkCompositeDataSet::SafeDownCast(input))
  {
    const vtkSmartPointer<vtkCompositeDataIterator> parts =
      vtkSmartPointer<vtkCompositeDataIterator>::Take(composite->NewIterator());
    for (parts->InitTraversal(); !parts->IsDoneWithTraversal(); parts->GoToNextItem())
    {
      add(parts->GetCurrentDataObject());
    }
  }
  vtkPlaneCollection* planes = any->GetClippingPlanes();
  for (int i = 0; planes && i < planes->GetNumberOfItems(); ++i)
  {
    vtkPlane* plane = planes->GetItem(i);
    const glm::dvec3 normal = glm::make_vec3(plane->GetNormal());
    surface.Planes.emplace_back(normal, -glm::dot(normal, glm::make_vec3(plane->GetOrigin())));
  }
  return surface;
}
}

std::vector<PropSurfaces::Surface> PropSurfaces::Get(const std::vector<vtkProp*>& props)
{
  std::vector<Surface> surfaces;
  for (vtkProp* prop : props)
  {
    prop->InitPathTraversal();
    while (vtkAssemblyPath* path = prop->GetNextPath())
    {
      vtkAssemblyNode* node = path->GetLastNode();
      auto* actor = vtkActor::SafeDownCast(node->GetViewProp());
      if (actor && actor->GetVisibility() && actor->GetMapper())
      {
        surfaces.push_back(GetSurface(actor, node->GetMatrix()));
        if (surfaces.back().Corners.empty())
        {
          surfaces.pop_back();
        }
      }
    }
  }
  return surfaces;
}

}
