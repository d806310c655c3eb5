// SPDX-License-Identifier: BSD-3-Clause
// Input that cannot be drawn, in whole or in part: what is said, what is left out, what is seen.
#include "Support/Pages/StabilityCase.h"
#include "Support/Drawing/PictureCases.h"
#include "Support/Pictures/VolumeStage.h"
#include "Support/Checks/ReferenceReport.h"
#include "Support/Meshes/ReferenceMesh.h"
#include "Tetrahedra/MapperPicture.h"

#include "vtkCallbackCommand.h"
#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkExecutive.h"
#include "vtkNew.h"
#include "Loader/OpenGLFunctions.h"
#include "vtkOutputWindow.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkTimeWeightedTetrahedraMapper.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <sstream>
#include <vector>

namespace
{

using namespace reference;
using Mapper = vtkTimeWeightedTetrahedraMapper;

constexpr Point3 Slanted = { { 0.3, -0.4, 1.0 } };
constexpr double Bound = 1e-3;
constexpr double NaN = std::numeric_limits<double>::quiet_NaN();
constexpr double Infinity = std::numeric_limits<double>::infinity();

/// Keeps the messages of an object's events.
class Listener
{
public:
  explicit Listener(vtkObject* object)
  {
    this->Command->SetClientData(&this->Messages);
    this->Command->SetCallback(
      [](vtkObject*, unsigned long, void* messages, void* text)
      {
        static_cast<std::vector<std::string>*>(messages)->push_back(
          text ? static_cast<const char*>(text) : "");
      });
    object->AddObserver(vtkCommand::ErrorEvent, this->Command);
    object->AddObserver(vtkCommand::WarningEvent, this->Command);
    this->Object = object;
  }
  ~Listener() { this->Object->RemoveObserver(this->Command); }
  Listener(const Listener&) = delete;
  Listener& operator=(const Listener&) = delete;

  std::vector<std::string> Messages;

private:
  vtkNew<vtkCallbackCommand> Command;
  vtkSmartPointer<vtkObject> Object;
};

PictureCase MakeCase()
{
  return reference::MakeCase(MakeCube(4), MakeRamp(0.1, 1.0, 0.25), Slanted, false, { { 64, 48 } });
}

/// What one picture came to.
struct Outcome
{
  RgbaPicture Picture;
  ReportCopy Report;
  /// Of the mapper, and of all others: VTK's output window and OpenGL.
  std::vector<std::string> Errors;
  std::vector<std::string> Others;
};

/// One mapper in one window, drawn again and again.
class Attempt
{
public:
  Attempt(int path, const PictureCase& what)
    : Stage(what.Settings.Size)
    , Errors(Drawer)
    , Others(vtkOutputWindow::GetInstance())
  {
    this->Drawer->SetRenderPath(path);
    Configure(this->Drawer, what);
    this->Stage.SetVolume(this->Drawer, what.Property);
    this->Stage.SetCamera(what.Camera);
  }

  /// Draws, twice as VolumeStage does it.
  Outcome Draw()
  {
    this->Errors.Messages.clear();
    this->Others.Messages.clear();
    Outcome outcome;
    outcome.Picture = this->Stage.Capture();
    for (unsigned int code = glGetError(); code != GL_NO_ERROR; code = glGetError())
    {
      this->Others.Messages.push_back("OpenGL error " + std::to_string(code));
    }
    outcome.Report = CopyReport(this->Drawer->GetReport());
    outcome.Errors = this->Errors.Messages;
    outcome.Others = this->Others.Messages;
    return outcome;
  }

  vtkNew<Mapper> Drawer;
  VolumeStage Stage;

private:
  Listener Errors;
  Listener Others;
};

bool IsSilent(const Outcome& outcome)
{
  return outcome.Errors.empty() && outcome.Others.empty();
}

std::string Describe(const Outcome& outcome)
{
  std::ostringstream text;
  for (const auto* messages : { &outcome.Errors, &outcome.Others })
  {
    for (const std::string& message : *messages)
    {
      text << message << "; ";
    }
  }
  text << "alpha to " << LargestAlpha(outcome.Picture) << ", "
       << outcome.Report->GetNumber("NonFiniteTetrahedra") << " not finite, "
       << outcome.Report->GetNumber("FlatTetrahedra") << " flat";
  std::string line = text.str();
  std::replace(line.begin(), line.end(), '\n', ' ');
  return line;
}

using Change = std::function<void(PictureCase&)>;

class Table
{
public:
  Table(int argc, char* argv[])
    : Catalogue("TestTetrahedraMapperInput", argc, argv)
  {
    this->Catalogue.SetClass("vtkTimeWeightedTetrahedraMapper");
  }

  /// Expects one error with each of the words, nothing drawn, and no error in the next pictures.
  void Refused(const std::string& name, const std::string& extreme,
    const std::vector<std::string>& words, const Change& change)
  {
    for (int path : AllRenderPaths())
    {
      PictureCase what = MakeCase();
      change(what);
      Attempt attempt(path, what);
      const Outcome first = attempt.Draw();
      const Outcome again = attempt.Draw();
      bool isNamed = first.Errors.size() == 1;
      std::string wanted = "one error, nothing drawn; it names";
      for (const std::string& word : words)
      {
        isNamed = isNamed && first.Errors[0].find(word) != std::string::npos;
        wanted.append(" ").append(word);
      }
      const bool isEmpty = LargestAlpha(first.Picture) == 0.0 && LargestAlpha(again.Picture) == 0.0;
      this->Catalogue.Check(name + "-" + GetPathName(path), extreme, wanted, Describe(first),
        isNamed && isEmpty && first.Others.empty());
      this->Catalogue.Check(name + "-again-" + GetPathName(path), extreme + ", the next picture",
        "no error again", Describe(again), IsSilent(again));
    }
  }

  /// Expects the picture of the reference, silence, and so many tetrahedra left out.
  void LeftOut(const std::string& name, const std::string& extreme, vtkIdType nonFinite,
    vtkIdType flat, const Change& change)
  {
    for (int path : AllRenderPaths())
    {
      PictureCase what = MakeCase();
      change(what);
      Attempt attempt(path, what);
      const Outcome outcome = attempt.Draw();
      const RgbaPicture expected = DrawByReference(what);
      const std::string row = name + "-" + GetPathName(path);
      this->Catalogue.Check(row, extreme,
        std::to_string(nonFinite) + " not finite, " + std::to_string(flat) + " flat, no error",
        Describe(outcome),
        IsSilent(outcome) && outcome.Report->GetNumber("NonFiniteTetrahedra") == nonFinite &&
          outcome.Report->GetNumber("FlatTetrahedra") == flat &&
          outcome.Report->GetNumber("Tetrahedra") == what.Grid->GetNumberOfCells());
      const bool isSeen = LargestAlpha(expected) > 0.2;
      this->Catalogue.Measure(row + "-picture", extreme, "the others as in the reference",
        isSeen ? ComparePictures(outcome.Picture, expected).Max : NaN, Bound);
    }
  }

  /// Expects silence and what else there is to be expected of an attempt.
  void Quiet(const std::string& name, const std::string& extreme, const std::string& expected,
    const std::function<bool(Attempt&, Outcome&)>& isRight, const Change& change)
  {
    for (int path : AllRenderPaths())
    {
      PictureCase what = MakeCase();
      change(what);
      Attempt attempt(path, what);
      Outcome outcome;
      const bool passed = isRight(attempt, outcome);
      this->Catalogue.Check(name + "-" + GetPathName(path), extreme, expected + ", no error",
        Describe(outcome), passed && IsSilent(outcome));
    }
  }

  int GetExitCode() { return this->Catalogue.GetExitCode(); }

private:
  StabilityCatalogue Catalogue;
};

/// How many cells have a point.
vtkIdType CountCellsAt(vtkIdType point)
{
  auto grid = MakeCase().Grid;
  vtkIdType cells = 0;
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    vtkIdType size = 0;
    const vtkIdType* corners = nullptr;
    grid->GetCellPoints(cell, size, corners);
    cells += std::find(corners, corners + size, point) != corners + size ? 1 : 0;
  }
  return cells;
}

void TestErrors(Table& table)
{
  const std::string remedy = "vtkDataSetTriangleFilter";
  const struct
  {
    MeshKind Kind;
    const char* Type;
  } kinds[] = { { MeshKind::Hexahedra, "vtkHexahedron" }, { MeshKind::Wedges, "vtkWedge" },
    { MeshKind::Pyramids, "vtkPyramid" }, { MeshKind::Voxels, "vtkVoxel" },
    { MeshKind::Boxes, "vtkPolyhedron" } };
  for (const auto& kind : kinds)
  {
    table.Refused("cells-" + GetName(kind.Kind), std::string("cells of type ") + kind.Type,
      { kind.Type, remedy },
      [&kind](PictureCase& what)
      {
        what.Grid = MakeMesh(kind.Kind, { { 2, 2, 2 } });
        AddLinear(what.Grid, "f", 0.1, { { 0.5, 0.3, 0.1 } });
        what.Grid->GetPointData()->SetActiveScalars("f");
      });
  }
  table.Refused("cells-one", "the last cell is a triangle", { "vtkTriangle", remedy },
    [](PictureCase& what)
    {
      const vtkIdType corners[3] = { 0, 1, 2 };
      what.Grid->InsertNextCell(VTK_TRIANGLE, 3, corners);
    });
  table.Refused("scalars-missing", "no array of the scalars' name", { "absent" },
    [](PictureCase& what) { what.Settings.Arrays.Scalars = "absent"; });
  table.Refused("scalars-none", "no scalars", { "scalars" },
    [](PictureCase& what) { what.Grid->GetPointData()->Initialize(); });
  table.Refused("scalars-short-unnamed", "scalars without name, one value short",
    { "without a name", "124 tuples", "125 are needed" },
    [](PictureCase& what)
    {
      vtkNew<vtkDoubleArray> array;
      array->SetNumberOfTuples(what.Grid->GetNumberOfPoints() - 1);
      array->Fill(0.5);
      what.Grid->GetPointData()->Initialize();
      what.Grid->GetPointData()->SetScalars(array);
    });
  table.Refused("delta-t-missing", "no array of the name of the extent in time", { "absent" },
    [](PictureCase& what) { what.Settings.Arrays.DeltaT = "absent"; });
  table.Refused("delta-t-vector", "an extent in time of three components", { "vector" },
    [](PictureCase& what)
    {
      vtkNew<vtkDoubleArray> array;
      array->SetName("vector");
      array->SetNumberOfComponents(3);
      array->SetNumberOfTuples(what.Grid->GetNumberOfPoints());
      array->Fill(1.0);
      what.Grid->GetPointData()->AddArray(array);
      what.Settings.Arrays.DeltaT = "vector";
    });
  table.Refused("delta-t-short", "an extent in time, one value short",
    { "\"brief\"", "124 tuples", "125 are needed" },
    [](PictureCase& what)
    {
      vtkNew<vtkDoubleArray> array;
      array->SetName("brief");
      array->SetNumberOfTuples(what.Grid->GetNumberOfPoints() - 1);
      array->Fill(1.0);
      what.Grid->GetPointData()->AddArray(array);
      what.Settings.Arrays.DeltaT = "brief";
    });
  table.Refused("layers-short", "layers, one value short", { "\"few\"", "one for each cell" },
    [](PictureCase& what)
    {
      vtkNew<vtkDoubleArray> array;
      array->SetName("few");
      array->SetNumberOfTuples(what.Grid->GetNumberOfCells() - 1);
      array->Fill(1.0);
      what.Grid->GetCellData()->AddArray(array);
      what.Settings.How = Blend::Priority;
      what.Settings.Layers = "few";
    });
  table.Refused("layers-missing", "no array of the layers' name", { "absent" },
    [](PictureCase& what)
    {
      what.Settings.How = Blend::Priority;
      what.Settings.Layers = "absent";
    });
}

void TestNonFinite(Table& table)
{
  // In the middle of the cube.
  constexpr vtkIdType point = 62;
  const vtkIdType cells = CountCellsAt(point);
  const struct
  {
    double Value;
    const char* Name;
  } values[] = { { NaN, "nan" }, { Infinity, "infinity" }, { -Infinity, "minus-infinity" } };
  for (const auto& value : values)
  {
    const std::string of = std::string(value.Name) + " at one point, in ";
    const double x = value.Value;
    table.LeftOut(std::string("scalars-") + value.Name, of + "the scalars", cells, 0,
      [x](PictureCase& what)
      { what.Grid->GetPointData()->GetScalars()->SetComponent(point, 0, x); });
    for (int axis : { 0, 2 })
    {
      const std::string name = std::to_string(axis) + "-" + value.Name;
      const auto change = [x, axis](PictureCase& what)
      {
        what.Grid->GetPoints()->GetData()->SetComponent(point, axis, x);
        what.Grid->GetPoints()->Modified();
        what.Grid->Modified();
      };
      table.LeftOut("coordinates-" + name, of + "a coordinate", cells, 0, change);
      table.Quiet(
        "bounds-" + name, of + "a coordinate", "the bounds of the other points",
        [](Attempt& attempt, Outcome& outcome)
        {
          outcome = attempt.Draw();
          double expected[6];
          MakeCase().Grid->GetBounds(expected);
          return std::equal(expected, expected + 6, attempt.Drawer->GetBounds());
        },
        change);
    }
    table.LeftOut(std::string("delta-t-") + value.Name, of + "the extent in time", cells, 0,
      [x](PictureCase& what)
      {
        AddLinear(what.Grid, "DeltaT", 1.0, { { -0.8, 0.5, 0.3 } });
        what.Grid->GetPointData()->GetArray("DeltaT")->SetComponent(point, 0, x);
        what.Settings.Arrays.DeltaT = "DeltaT";
        what.Settings.How = Blend::OpticalDepth;
      });
    table.LeftOut(std::string("cells-") + value.Name, std::string(value.Name) + " of one cell", 1,
      0,
      [x](PictureCase& what)
      {
        vtkNew<vtkDoubleArray> array;
        array->SetName("c");
        for (vtkIdType cell = 0; cell < what.Grid->GetNumberOfCells(); ++cell)
        {
          array->InsertNextValue(cell == 100 ? x : 0.5);
        }
        what.Grid->GetCellData()->AddArray(array);
        what.Settings.Arrays.Scalars = "c";
        what.Settings.Arrays.OfCells = true;
      });
    table.Quiet(
      std::string("all-") + value.Name, std::string(value.Name) + " at every point",
      "all are counted, nothing drawn",
      [](Attempt& attempt, Outcome& outcome)
      {
        outcome = attempt.Draw();
        return outcome.Report->GetNumber("NonFiniteTetrahedra") ==
          outcome.Report->GetNumber("Tetrahedra") &&
          outcome.Report->GetNumber("Tetrahedra") > 0 && LargestAlpha(outcome.Picture) == 0.0;
      },
      [x](PictureCase& what) { what.Grid->GetPointData()->GetScalars()->FillComponent(0, x); });
  }
}

void TestShapes(Table& table)
{
  table.LeftOut("flat", "three more tetrahedra with no volume", 0, 3,
    [](PictureCase& what)
    {
      // In a side of the cube, along an edge, and in a point.
      for (const auto& corners :
        { std::array<vtkIdType, 4>{ { 0, 1, 5, 6 } }, { { 0, 1, 2, 3 } }, { { 7, 7, 7, 7 } } })
      {
        what.Grid->InsertNextCell(VTK_TETRA, 4, corners.data());
      }
    });
  table.LeftOut("constant", "one value of the scalar", 0, 0,
    [](PictureCase& what) { what.Grid->GetPointData()->GetScalars()->FillComponent(0, 0.6); });
  table.LeftOut("inverted", "every other tetrahedron turned inside out", 0, 0,
    [](PictureCase& what)
    {
      vtkNew<vtkCellArray> cells;
      for (vtkIdType cell = 0; cell < what.Grid->GetNumberOfCells(); ++cell)
      {
        vtkIdType size = 0;
        const vtkIdType* corners = nullptr;
        what.Grid->GetCellPoints(cell, size, corners);
        std::array<vtkIdType, 4> turned = { { corners[0], corners[1], corners[2], corners[3] } };
        if (cell % 2 == 1)
        {
          std::swap(turned[0], turned[2]);
        }
        cells->InsertNextCell(4, turned.data());
      }
      what.Grid->SetCells(VTK_TETRA, cells);
    });
}

/// Ghost cells as if they were not there; duplicate points alone take nothing away.
void TestGhosts(Table& table)
{
  table.Quiet(
    "ghosts", "half of the cells are ghosts", "the picture without them",
    [](Attempt& attempt, Outcome& outcome)
    {
      outcome = attempt.Draw();
      PictureCase half = MakeCase();
      vtkNew<vtkCellArray> cells;
      for (vtkIdType cell = 0; cell < half.Grid->GetNumberOfCells(); cell += 2)
      {
        vtkIdType size = 0;
        const vtkIdType* corners = nullptr;
        half.Grid->GetCellPoints(cell, size, corners);
        cells->InsertNextCell(4, corners);
      }
      half.Grid->SetCells(VTK_TETRA, cells);
      const RgbaPicture expected = DrawByReference(half);
      return LargestAlpha(expected) > 0.2 &&
        outcome.Report->GetNumber("NonFiniteTetrahedra") == 0 &&
        outcome.Report->GetNumber("FlatTetrahedra") == 0 &&
        ComparePictures(outcome.Picture, expected).Max < Bound;
    },
    [](PictureCase& what)
    {
      vtkNew<vtkUnsignedCharArray> ghosts;
      ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
      for (vtkIdType cell = 0; cell < what.Grid->GetNumberOfCells(); ++cell)
      {
        const int mark = cell % 4 == 1 ? vtkDataSetAttributes::DUPLICATECELL
          : cell % 4 == 3              ? vtkDataSetAttributes::HIDDENCELL
                                       : 0;
        ghosts->InsertNextValue(static_cast<unsigned char>(mark));
      }
      what.Grid->GetCellData()->AddArray(ghosts);
    });
}

void TestEmpty(Table& table)
{
  const auto isNothing = [](Attempt& attempt, Outcome& outcome)
  {
    outcome = attempt.Draw();
    return LargestAlpha(outcome.Picture) == 0.0 && outcome.Report->GetNumber("Tetrahedra") == 0;
  };
  table.Quiet("empty", "a grid without cells and points", "nothing drawn", isNothing,
    [](PictureCase& what) { what.Grid->Initialize(); });
  table.Quiet("no-cells", "a grid of points alone", "nothing drawn", isNothing,
    [](PictureCase& what) { what.Grid->SetCells(VTK_TETRA, vtkNew<vtkCellArray>()); });
  table.Quiet(
    "emptied", "cells that go and come back", "nothing, then the same picture",
    [](Attempt& attempt, Outcome& outcome)
    {
      const RgbaPicture before = attempt.Draw().Picture;
      auto* grid = vtkUnstructuredGrid::SafeDownCast(attempt.Drawer->GetInput());
      vtkNew<vtkUnstructuredGrid> copy;
      copy->DeepCopy(grid);
      grid->Initialize();
      outcome = attempt.Draw();
      const bool isEmpty = LargestAlpha(outcome.Picture) == 0.0;
      grid->DeepCopy(copy);
      const RgbaPicture after = attempt.Draw().Picture;
      return isEmpty && LargestAlpha(before) > 0.2 && ComparePictures(after, before).Max == 0.0;
    },
    [](PictureCase&) {});
}

/// An error is forgotten with its cause, and said again when it comes back.
void TestRecovery(Table& table)
{
  table.Quiet(
    "recovery", "a missing array of the extent in time, named by turns",
    "one error each time, and the picture in between",
    [](Attempt& attempt, Outcome& outcome)
    {
      const RgbaPicture before = attempt.Draw().Picture;
      bool isRight = LargestAlpha(before) > 0.2;
      for (int turn = 0; turn < 3; ++turn)
      {
        attempt.Drawer->SetDeltaTArrayName("absent");
        outcome = attempt.Draw();
        isRight = isRight && outcome.Errors.size() == 1 && outcome.Others.empty() &&
          LargestAlpha(outcome.Picture) == 0.0;
        attempt.Drawer->SetDeltaTArrayName("");
        outcome = attempt.Draw();
        isRight = isRight && ComparePictures(outcome.Picture, before).Max == 0.0;
      }
      return isRight;
    },
    [](PictureCase&) {});
}

/// VTK's pipeline says by itself, to its own observers, that an input is missing.
void TestNoInput(Table& table)
{
  table.Quiet(
    "no-input", "no input after one was drawn, and the input again",
    "nothing drawn, then the same picture",
    [](Attempt& attempt, Outcome& outcome)
    {
      const RgbaPicture before = attempt.Draw().Picture;
      vtkSmartPointer<vtkDataSet> grid = attempt.Drawer->GetInput();
      const Listener pipeline(attempt.Drawer->GetExecutive());
      attempt.Drawer->SetInputConnection(nullptr);
      outcome = attempt.Draw();
      const bool isEmpty = LargestAlpha(outcome.Picture) == 0.0;
      attempt.Drawer->SetInputData(grid);
      const RgbaPicture after = attempt.Draw().Picture;
      return isEmpty && LargestAlpha(before) > 0.2 && ComparePictures(after, before).Max == 0.0;
    },
    [](PictureCase&) {});
}

void TestSizes(Table& table)
{
  for (const std::array<int, 2>& size :
    { std::array<int, 2>{ { 1, 1 } }, { { 1, 41 } }, { { 41, 1 } }, { { 2, 3 } }, { { 5, 4 } } })
  {
    const std::string text = std::to_string(size[0]) + "x" + std::to_string(size[1]);
    table.LeftOut("window-" + text, "a window of " + text + " pixels", 0, 0,
      [&size](PictureCase& what) { what.Settings.Size = size; });
  }
  table.Quiet(
    "viewport-zero", "a renderer of no size, and then of the whole window",
    "nothing, then the picture",
    [](Attempt& attempt, Outcome& outcome)
    {
      vtkRenderer* renderer = attempt.Stage.GetRenderer();
      renderer->SetViewport(0.5, 0.5, 0.5, 0.5);
      attempt.Stage.Render();
      renderer->SetViewport(0.0, 0.0, 1.0, 1.0);
      outcome = attempt.Draw();
      return ComparePictures(outcome.Picture, DrawByReference(MakeCase())).Max < Bound;
    },
    [](PictureCase&) {});
}

}

int TestTetrahedraMapperInput(int argc, char* argv[])
{
  Table table(argc, argv);
  TestErrors(table);
  TestNonFinite(table);
  TestShapes(table);
  TestGhosts(table);
  TestEmpty(table);
  TestRecovery(table);
  TestNoInput(table);
  TestSizes(table);
  return table.GetExitCode();
}
