// SPDX-License-Identifier: BSD-3-Clause
#include "Draw/TetrahedraSelection.h"

#include "Frame/PlaneClip.h"
#include "Offscreen/PropSelection.h"
#include "Software/SoftwareRasterizer.h"

#include "vtkCallbackCommand.h"
#include "vtkDataObject.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkHardwareSelector.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSMPTools.h"
#include "vtkTimeWeightedTetrahedraMapper.h"

#include <algorithm>
#include <map>

namespace interlume
{

namespace
{
/// Depths of the scenes in which something is being selected.
std::map<vtkObject*, OpaqueSceneDepth>& GetSceneDepths()
{
  static std::map<vtkObject*, OpaqueSceneDepth> depths;
  return depths;
}

void EndSelection(vtkObject* selector, unsigned long, void* command, void*)
{
  GetSceneDepths().erase(selector);
  selector->RemoveObserver(static_cast<vtkCommand*>(command));
}

bool SelectsPoints(vtkHardwareSelector* selector)
{
  return selector->GetFieldAssociation() == vtkDataObject::FIELD_ASSOCIATION_POINTS;
}
}

void TetrahedraSelection::ReadDepth(vtkRenderer* renderer, OpaqueSceneDepth& depth)
{
  vtkHardwareSelector* selector = renderer->GetSelector();
  const auto found = GetSceneDepths().find(selector);
  if (found != GetSceneDepths().end())
  {
    depth = found->second;
    return;
  }
  depth.Read(renderer);
  GetSceneDepths()[selector] = depth;
  vtkNew<vtkCallbackCommand> command;
  command->SetCallback(EndSelection);
  command->SetClientData(command);
  selector->AddObserver(vtkCommand::EndEvent, command);
}

bool TetrahedraSelection::IsFound(vtkRenderer* renderer, vtkProp* prop) const
{
  return this->Renderer == renderer && this->Prop == prop &&
    renderer->GetSelector()->GetCurrentPass() != vtkHardwareSelector::MIN_KNOWN_PASS;
}

void TetrahedraSelection::Find(vtkRenderer* renderer, vtkProp* prop, const TetrahedraFrame& frame,
  const PlaneClip& clip, const Source& source, SoftwareRasterizer& rasterizer)
{
  this->Renderer = renderer;
  this->Prop = prop;
  const vtkIdType points = source.Grid->GetNumberOfPoints();
  if (source.Ids &&
    (source.Ids->GetNumberOfCells() != source.Grid->GetNumberOfCells() ||
      source.Ids->GetNumberOfPoints() != points))
  {
    return;
  }
  const TetrahedraView& view = frame.View;
  this->Width = view.GetWidth();
  this->Height = view.GetHeight();
  rasterizer.Draw(frame);
  const std::vector<SeenTetrahedra::Seen> seen = rasterizer.ReleaseSeen();
  this->Pixels.assign(seen.size(), Pixel());
  const bool isPoints = SelectsPoints(renderer->GetSelector());
  vtkSMPTools::For(0, static_cast<vtkIdType>(seen.size()),
    [&](vtkIdType first, vtkIdType last)
    {
      for (vtkIdType i = first; i < last; ++i)
      {
        if (seen[i].Tetrahedron == 0)
        {
          continue;
        }
        Pixel& pixel = this->Pixels[i];
        const double x = static_cast<double>(i % this->Width) + 0.5;
        const double y = static_cast<double>(i / this->Width) + 0.5;
        const std::uint32_t tetrahedron = seen[i].Tetrahedron - 1;
        const std::uint32_t original = clip.GetOriginal(tetrahedron);
        pixel.Cell = frame.Mesh->Cells.empty() ? original : frame.Mesh->Cells[original];
        pixel.Point = isPoints ? FindPoint(frame, tetrahedron, points, x, y) : -1;
        const double depth = view.GetBufferFromDepth(x, y, seen[i].Depth);
        pixel.Depth = isPoints && pixel.Point < 0
          ? -1.0f
          : static_cast<float>(std::max(0.0, std::min(depth, 1.0)));
      }
    });
  this->ReplaceIds(source.Ids);
}

void TetrahedraSelection::ReplaceIds(vtkDataSet* ids)
{
  const auto find = [ids](int association, const char* name)
  {
    return ids ? vtkIdTypeArray::SafeDownCast(ids->GetAttributes(association)->GetArray(name))
               : nullptr;
  };
  using Mapper = vtkTimeWeightedTetrahedraMapper;
  vtkIdTypeArray* cells = find(vtkDataObject::CELL, Mapper::SelectionCellIds());
  vtkIdTypeArray* blocks = find(vtkDataObject::CELL, Mapper::SelectionBlockIds());
  vtkIdTypeArray* points = find(vtkDataObject::POINT, Mapper::SelectionPointIds());
  for (Pixel& pixel : this->Pixels)
  {
    pixel.Block = blocks ? blocks->GetValue(pixel.Cell) : pixel.Block;
    pixel.Cell = cells ? cells->GetValue(pixel.Cell) : pixel.Cell;
    pixel.Point = points && pixel.Point >= 0 ? points->GetValue(pixel.Point) : pixel.Point;
    this->MaximumCell = std::max(this->MaximumCell, pixel.Cell);
    this->MaximumPoint = std::max(this->MaximumPoint, pixel.Point);
  }
}

vtkIdType TetrahedraSelection::FindPoint(
  const TetrahedraFrame& frame, std::uint32_t tetrahedron, vtkIdType points, double x, double y)
{
  vtkIdType closest = -1;
  double smallest = POINT_RADIUS * POINT_RADIUS;
  const std::uint32_t* corners = frame.Mesh->GetCorners(tetrahedron);
  for (int k = 0; k < 4; ++k)
  {
    // Points that clipping appended are not in the input.
    if (corners[k] < points)
    {
      const TetrahedraView::Projected p =
        frame.View.Project(frame.View.GetEyeCoordinates(frame.Mesh->GetPoint(corners[k])));
      const double square = (p.X - x) * (p.X - x) + (p.Y - y) * (p.Y - y);
      if (square <= smallest)
      {
        smallest = square;
        closest = corners[k];
      }
    }
  }
  return closest;
}

std::array<float, 3> TetrahedraSelection::GetColor(vtkIdType id, bool isHigh)
{
  std::array<float, 3> color;
  vtkHardwareSelector::Convert((id >> (isHigh ? 24 : 0)) & 0xffffff, color.data());
  return color;
}

std::array<float, 3> TetrahedraSelection::GetColor(
  const Pixel& pixel, vtkHardwareSelector* selector) const
{
  switch (selector->GetCurrentPass())
  {
    case vtkHardwareSelector::CELL_ID_LOW24:
      return GetColor(pixel.Cell, false);
    case vtkHardwareSelector::CELL_ID_HIGH24:
      return GetColor(pixel.Cell, true);
    case vtkHardwareSelector::POINT_ID_LOW24:
      return GetColor(pixel.Point, false);
    case vtkHardwareSelector::POINT_ID_HIGH24:
      return GetColor(pixel.Point, true);
    case vtkHardwareSelector::COMPOSITE_INDEX_PASS:
      return GetColor(pixel.Block, false);
    default:
    {
      std::array<float, 3> color{};
      PropSelection::FindColor(selector, color.data());
      return color;
    }
  }
}

void TetrahedraSelection::Draw(vtkRenderer* renderer)
{
  vtkHardwareSelector* selector = renderer->GetSelector();
  selector->BeginRenderProp();
  selector->UpdateMaximumCellId(this->MaximumCell);
  selector->UpdateMaximumPointId(this->MaximumPoint);
  const int pass = selector->GetCurrentPass();
  const bool isPointPass =
    pass == vtkHardwareSelector::POINT_ID_LOW24 || pass == vtkHardwareSelector::POINT_ID_HIGH24;
  if (!this->Pixels.empty() && (SelectsPoints(selector) || !isPointPass))
  {
    std::vector<float> image;
    image.reserve(4 * this->Pixels.size());
    for (const Pixel& pixel : this->Pixels)
    {
      const std::array<float, 3> color = this->GetColor(pixel, selector);
      image.insert(image.end(), color.begin(), color.end());
      image.push_back(pixel.Depth);
    }
    auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
    this->Quad.Upload(window, this->Width, this->Height, image, false);
    this->Quad.Draw(window, "SELECTION");
  }
  selector->EndRenderProp();
}

}
