// SPDX-License-Identifier: BSD-3-Clause
// Tests that vtkHardwareSelector returns the input's cell ids, for separate tetrahedra, some of
// which are skipped, transparent, hidden, cut by the near plane or visible by boundary triangles
// only, with and without multisampling.
#include "Support/Images/CameraSettings.h"
#include "Support/Checks/ReferenceCheck.h"
#include "Tetrahedra/MapperImage.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDataObject.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkHardwareSelector.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSelection.h"
#include "vtkSelectionNode.h"
#include "vtkSphereSource.h"
#include "vtkTimeWeightedTetrahedraMapper.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <array>
#include <cmath>
#include <limits>
#include <set>
#include <sstream>

namespace
{

using namespace reference;
using Mapper = vtkTimeWeightedTetrahedraMapper;
using Ids = std::set<vtkIdType>;

constexpr int Side = 4;
constexpr vtkIdType Cells = Side * Side;
/// The process id that selections must contain.
constexpr int Process = 7;
constexpr Point3 Red = { { 1.0, 0.1, 0.0 } };

/// Returns Side x Side separate tetrahedra, one per unit square of the plane z = 0, with the cell
/// id as scalar.
vtkSmartPointer<vtkUnstructuredGrid> MakeSeparated()
{
  const double corners[4][3] = { { 0.0, 0.0, -0.25 }, { 0.5, 0.0, -0.1 }, { 0.2, 0.5, 0.0 },
    { 0.25, 0.2, 0.25 } };
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> tetrahedra;
  vtkNew<vtkDoubleArray> scalars;
  scalars->SetName("f");
  for (vtkIdType cell = 0; cell < Cells; ++cell)
  {
    const double column = static_cast<double>(cell % Side);
    const vtkIdType row = cell / Side;
    vtkIdType ids[4];
    for (int i = 0; i < 4; ++i)
    {
      ids[i] = points->InsertNextPoint(
        corners[i][0] + column, corners[i][1] + static_cast<double>(row), corners[i][2]);
      scalars->InsertNextValue(static_cast<double>(cell));
    }
    tetrahedra->InsertNextCell(4, ids);
  }
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  grid->SetPoints(points);
  grid->SetCells(VTK_TETRA, tetrahedra);
  grid->GetPointData()->SetScalars(scalars);
  return grid;
}

class Picker
{
public:
  Picker(int path, bool parallel, int samples)
    : Name(GetPathName(path) + (parallel ? ", parallel, " : ", perspective, ") +
        std::to_string(samples) + " samples")
    , Grid(MakeSeparated())
  {
    this->Volume->SetMapper(this->Drawer);
    this->Volume->SetProperty(MakeProperty({ { 0.0, Red, 1.0 } }, 0.25));
    this->Drawer->SetInputData(static_cast<vtkDataSet*>(this->Grid));
    this->Drawer->SetRenderPath(path);
    this->Renderer->AddVolume(this->Volume);
    this->Renderer->SetActiveCamera(LookAt(this->Grid, { { 0.0, 0.0, -1.0 } }, parallel));
    this->Window->SetOffScreenRendering(1);
    this->Window->SetMultiSamples(samples);
    this->Window->SetSize(160, 160);
    this->Window->AddRenderer(this->Renderer);
  }

  /// Selects the cells of the volume in a rectangle of the window.
  Ids Select(int left, int bottom, int right, int top)
  {
    this->Window->Render();
    vtkNew<vtkHardwareSelector> selector;
    selector->SetRenderer(this->Renderer);
    selector->SetProcessID(Process);
    selector->SetFieldAssociation(vtkDataObject::FIELD_ASSOCIATION_CELLS);
    selector->SetArea(static_cast<unsigned int>(left), static_cast<unsigned int>(bottom),
      static_cast<unsigned int>(right), static_cast<unsigned int>(top));
    const auto selection = vtkSmartPointer<vtkSelection>::Take(selector->Select());
    Ids found;
    for (unsigned int n = 0; selection && n < selection->GetNumberOfNodes(); ++n)
    {
      vtkSelectionNode* node = selection->GetNode(n);
      auto* list = vtkIdTypeArray::SafeDownCast(node->GetSelectionList());
      const bool isVolume = node->GetProperties()->Get(vtkSelectionNode::PROP()) == this->Volume;
      this->HasOtherProcess = this->HasOtherProcess ||
        (isVolume && node->GetProperties()->Get(vtkSelectionNode::PROCESS_ID()) != Process);
      for (vtkIdType i = 0; isVolume && list && i < list->GetNumberOfTuples(); ++i)
      {
        found.insert(list->GetValue(i));
      }
    }
    return found;
  }

  Ids SelectAll() { return this->Select(0, 0, 159, 159); }

  /// Selects the cells at the pixel that shows the center of a tetrahedron.
  Ids SelectAt(vtkIdType cell)
  {
    double center[3] = { 0.0, 0.0, 0.0 };
    for (vtkIdType i = 0; i < 4; ++i)
    {
      double x[3];
      MakeSeparated()->GetPoint(4 * cell + i, x);
      for (int k = 0; k < 3; ++k)
      {
        center[k] += 0.25 * x[k];
      }
    }
    this->Window->Render();
    this->Renderer->SetWorldPoint(center[0], center[1], center[2], 1.0);
    this->Renderer->WorldToDisplay();
    const double* pixel = this->Renderer->GetDisplayPoint();
    const int i = static_cast<int>(pixel[0]);
    const int j = static_cast<int>(pixel[1]);
    return this->Select(i, j, i, j);
  }

  std::string Name;
  bool HasOtherProcess = false;
  vtkSmartPointer<vtkUnstructuredGrid> Grid;
  vtkNew<Mapper> Drawer;
  vtkNew<vtkVolume> Volume;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkRenderWindow> Window;
};

std::string Print(const Ids& ids)
{
  std::ostringstream text;
  for (vtkIdType id : ids)
  {
    text << ' ' << id;
  }
  return text.str();
}

/// Expects that all cells except \a missing can be selected, together in the full window and each
/// at the pixel of its center.
void Expect(Check& check, Picker& picker, const Ids& missing, const std::string& what)
{
  const std::string name = picker.Name + ", " + what;
  Ids expected;
  for (vtkIdType cell = 0; cell < Cells; ++cell)
  {
    if (missing.count(cell) == 0)
    {
      expected.insert(cell);
    }
  }
  const Ids all = picker.SelectAll();
  check.That(all == expected, name + ": found" + Print(all) + " instead of" + Print(expected));
  check.That(!picker.HasOtherProcess, name + ": the process id is correct");
  for (vtkIdType cell = 0; cell < Cells; ++cell)
  {
    const Ids one = picker.SelectAt(cell);
    const Ids expectedId = missing.count(cell) == 0 ? Ids{ cell } : Ids{};
    check.That(
      one == expectedId, name + ": found" + Print(one) + " at cell " + std::to_string(cell));
  }
}

void TestPlain(Check& check, int path, bool parallel, int samples)
{
  Picker picker(path, parallel, samples);
  Expect(check, picker, {}, "all");
}

void TestSkipped(Check& check, int path, bool parallel, int samples)
{
  Picker picker(path, parallel, samples);
  for (vtkIdType cell : { 2, 3, 9 })
  {
    picker.Grid->GetPointData()->GetScalars()->SetComponent(
      4 * cell + 1, 0, std::numeric_limits<double>::quiet_NaN());
  }
  picker.Grid->Modified();
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
  ghosts->SetNumberOfTuples(Cells);
  ghosts->Fill(0);
  ghosts->SetValue(5, vtkDataSetAttributes::DUPLICATECELL);
  ghosts->SetValue(6, vtkDataSetAttributes::HIDDENCELL);
  picker.Grid->GetCellData()->AddArray(ghosts);
  picker.Grid->Modified();
  Expect(check, picker, { 2, 3, 5, 6, 9 }, "some skipped");
}

void TestTransparent(Check& check, int path, bool parallel, int samples)
{
  Picker picker(path, parallel, samples);
  picker.Volume->SetProperty(
    MakeProperty({ { 0.0, Red, 1.0 }, { 4.4, Red, 1.0 }, { 4.6, Red, 0.0 }, { 6.4, Red, 0.0 },
                   { 6.6, Red, 1.0 }, { 15.0, Red, 1.0 } },
      0.25));
  Expect(check, picker, { 5, 6 }, "some transparent");
}

/// Tests that cells are seen if only their boundary triangles are visible.
void TestBoundary(Check& check, int path, bool parallel, int samples)
{
  Picker picker(path, parallel, samples);
  picker.Volume->SetProperty(MakeProperty({ { 0.0, Red, 0.0 }, { 15.0, Red, 0.0 } }, 0.25));
  Ids missing;
  vtkNew<vtkCellArray> triangles;
  for (vtkIdType cell = 0; cell < Cells; ++cell)
  {
    if (cell != 3 && cell != 12)
    {
      missing.insert(cell);
      continue;
    }
    for (vtkIdType face = 0; face < 4; ++face)
    {
      vtkIdType ids[3];
      for (vtkIdType k = 0; k < 3; ++k)
      {
        ids[k] = 4 * cell + (face + k) % 4;
      }
      triangles->InsertNextCell(3, ids);
    }
  }
  vtkNew<vtkPolyData> boundary;
  boundary->SetPoints(picker.Grid->GetPoints());
  boundary->SetPolys(triangles);
  picker.Drawer->SetBoundaryData(boundary);
  Expect(check, picker, missing, "boundary triangles");
}

void TestHidden(Check& check, int path, bool parallel, int samples)
{
  Picker picker(path, parallel, samples);
  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(0.45);
  sphere->SetThetaResolution(32);
  sphere->SetPhiResolution(32);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(sphere->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  picker.Renderer->AddActor(actor);
  // The camera looks along -z. The sphere is first in front of cell 10, then behind it.
  sphere->SetCenter(2.23, 2.2, 0.75);
  Expect(check, picker, { 10 }, "a sphere in front");
  sphere->SetCenter(2.23, 2.2, -0.85);
  Expect(check, picker, {}, "a sphere behind");
}

void TestNearPlane(Check& check, int path, bool parallel, int samples)
{
  Picker picker(path, parallel, samples);
  double position[3];
  picker.Renderer->GetActiveCamera()->GetPosition(position);
  // The plane z = 0.05 removes the apex of each tetrahedron but not its center.
  picker.Renderer->GetActiveCamera()->SetClippingRange(position[2] - 0.05, position[2] + 10.0);
  Expect(check, picker, {}, "cut by the near plane");
  picker.Window->Render();
  check.Equal(picker.Drawer->GetReport()->GetCount("TetrahedraClipped"), Cells,
    picker.Name + ": all are clipped");
}

}

int TestTetrahedraMapperSelection(int, char*[])
{
  Check check;
  for (int path : AllRenderPaths())
  {
    for (bool parallel : { true, false })
    {
      for (int samples : { 0, 4 })
      {
        TestPlain(check, path, parallel, samples);
        TestSkipped(check, path, parallel, samples);
        TestTransparent(check, path, parallel, samples);
        TestBoundary(check, path, parallel, samples);
        TestHidden(check, path, parallel, samples);
        TestNearPlane(check, path, parallel, samples);
      }
    }
  }
  return check.Result();
}
