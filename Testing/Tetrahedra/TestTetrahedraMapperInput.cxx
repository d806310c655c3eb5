// SPDX-License-Identifier: BSD-3-Clause
// Tests input that is invalid or partly invalid: messages, skipped tetrahedra, and the image.
#include "Support/Pages/StabilityCase.h"
#include "Support/Drawing/ImageCases.h"
#include "Support/Images/VolumeStage.h"
#include "Support/Checks/ReferenceReport.h"
#include "Support/Meshes/ReferenceMesh.h"
#include "Tetrahedra/MapperImage.h"

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

/// Collects error and warning messages of an object.
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

ImageCase MakeCase()
{
  return reference::MakeCase(MakeCube(4), MakeRamp(0.1, 1.0, 0.25), Slanted, false, { { 64, 48 } });
}

/// Image, report and messages of one Draw().
struct Outcome
{
  RgbaImage Image;
  ReportCopy Report;
  /// Messages of the mapper (Errors), and of VTK's output window and OpenGL (Others).
  std::vector<std::string> Errors;
  std::vector<std::string> Others;
};

/// A mapper in a window, rendered repeatedly.
class Attempt
{
public:
  Attempt(int path, const ImageCase& what)
    : Stage(what.Settings.Size)
    , Errors(Drawer)
    , Others(vtkOutputWindow::GetInstance())
  {
    this->Drawer->SetRenderPath(path);
    Configure(this->Drawer, what);
    this->Stage.SetVolume(this->Drawer, what.Property);
    this->Stage.SetCamera(what.Camera);
  }

  /// Captures the second of two frames.
  Outcome Draw()
  {
    this->Errors.Messages.clear();
    this->Others.Messages.clear();
    Outcome outcome;
    outcome.Image = this->Stage.Capture(2);
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
  text << "largest alpha " << LargestAlpha(outcome.Image) << ", "
       << outcome.Report->GetNumber("NonFiniteTetrahedra") << " not finite, "
       << outcome.Report->GetNumber("FlatTetrahedra") << " flat";
  std::string line = text.str();
  std::replace(line.begin(), line.end(), '\n', ' ');
  return line;
}

using Change = std::function<void(ImageCase&)>;

class Table
{
public:
  Table(int argc, char* argv[])
    : Catalogue("TestTetrahedraMapperInput", argc, argv)
  {
    this->Catalogue.SetClass("vtkTimeWeightedTetrahedraMapper");
  }

  /// Expects one error that contains all words, an empty image, and no error in the next frame.
  void Rejected(const std::string& name, const std::string& extreme,
    const std::vector<std::string>& words, const Change& change)
  {
    for (int path : AllRenderPaths())
    {
      ImageCase what = MakeCase();
      change(what);
      Attempt attempt(path, what);
      const Outcome first = attempt.Draw();
      const Outcome again = attempt.Draw();
      bool isNamed = first.Errors.size() == 1;
      std::string expected = "an empty image and one error that contains";
      for (const std::string& word : words)
      {
        isNamed = isNamed && first.Errors[0].find(word) != std::string::npos;
        expected.append(" ").append(word);
      }
      const bool isEmpty = LargestAlpha(first.Image) == 0.0 && LargestAlpha(again.Image) == 0.0;
      this->Catalogue.Check(name + "-" + GetPathName(path), extreme, expected, Describe(first),
        isNamed && isEmpty && first.Others.empty());
      this->Catalogue.Check(name + "-again-" + GetPathName(path), extreme + ", the next frame",
        "no repeated error", Describe(again), IsSilent(again));
    }
  }

  /// Expects the reference image without messages, and the given numbers of skipped tetrahedra.
  void Skipped(const std::string& name, const std::string& extreme, vtkIdType nonFinite,
    vtkIdType flat, const Change& change)
  {
    for (int path : AllRenderPaths())
    {
      ImageCase what = MakeCase();
      change(what);
      Attempt attempt(path, what);
      const Outcome outcome = attempt.Draw();
      const RgbaImage expected = DrawReference(what);
      const std::string row = name + "-" + GetPathName(path);
      this->Catalogue.Check(row, extreme,
        std::to_string(nonFinite) + " not finite, " + std::to_string(flat) + " flat, no error",
        Describe(outcome),
        IsSilent(outcome) && outcome.Report->GetNumber("NonFiniteTetrahedra") == nonFinite &&
          outcome.Report->GetNumber("FlatTetrahedra") == flat &&
          outcome.Report->GetNumber("Tetrahedra") == what.Grid->GetNumberOfCells());
      const bool isSeen = LargestAlpha(expected) > 0.2;
      this->Catalogue.Measure(row + "-picture", extreme, "largest difference from the reference",
        isSeen ? CompareImages(outcome.Image, expected).Max : NaN, Bound);
    }
  }

  /// Expects no messages, and that \a isExpected returns true.
  void Silent(const std::string& name, const std::string& extreme, const std::string& expected,
    const std::function<bool(Attempt&, Outcome&)>& isExpected, const Change& change)
  {
    for (int path : AllRenderPaths())
    {
      ImageCase what = MakeCase();
      change(what);
      Attempt attempt(path, what);
      Outcome outcome;
      const bool passed = isExpected(attempt, outcome);
      this->Catalogue.Check(name + "-" + GetPathName(path), extreme, expected + ", no error",
        Describe(outcome), passed && IsSilent(outcome));
    }
  }

  int GetExitCode() { return this->Catalogue.GetExitCode(); }

private:
  StabilityCatalogue Catalogue;
};

/// Returns the number of cells that use a point.
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
    table.Rejected("cells-" + GetName(kind.Kind), std::string("cells of type ") + kind.Type,
      { kind.Type, remedy },
      [&kind](ImageCase& what)
      {
        what.Grid = MakeMesh(kind.Kind, { { 2, 2, 2 } });
        AddLinearArray(what.Grid, "f", 0.1, { { 0.5, 0.3, 0.1 } });
        what.Grid->GetPointData()->SetActiveScalars("f");
      });
  }
  table.Rejected("cells-one", "the last cell is a triangle", { "vtkTriangle", remedy },
    [](ImageCase& what)
    {
      const vtkIdType corners[3] = { 0, 1, 2 };
      what.Grid->InsertNextCell(VTK_TRIANGLE, 3, corners);
    });
  table.Rejected("scalars-missing", "a scalar array that does not exist", { "absent" },
    [](ImageCase& what) { what.Settings.Arrays.Scalars = "absent"; });
  table.Rejected("scalars-none", "no scalars", { "scalars" },
    [](ImageCase& what) { what.Grid->GetPointData()->Initialize(); });
  table.Rejected("scalars-short-unnamed", "unnamed scalars with a missing value",
    { "without a name", "124 tuples", "125 are needed" },
    [](ImageCase& what)
    {
      vtkNew<vtkDoubleArray> array;
      array->SetNumberOfTuples(what.Grid->GetNumberOfPoints() - 1);
      array->Fill(0.5);
      what.Grid->GetPointData()->Initialize();
      what.Grid->GetPointData()->SetScalars(array);
    });
  table.Rejected("delta-t-missing", "an extent array that does not exist", { "absent" },
    [](ImageCase& what) { what.Settings.Arrays.DeltaT = "absent"; });
  table.Rejected("delta-t-vector", "a three-component extent array", { "vector" },
    [](ImageCase& what)
    {
      vtkNew<vtkDoubleArray> array;
      array->SetName("vector");
      array->SetNumberOfComponents(3);
      array->SetNumberOfTuples(what.Grid->GetNumberOfPoints());
      array->Fill(1.0);
      what.Grid->GetPointData()->AddArray(array);
      what.Settings.Arrays.DeltaT = "vector";
    });
  table.Rejected("delta-t-short", "an extent array with a missing value",
    { "\"brief\"", "124 tuples", "125 are needed" },
    [](ImageCase& what)
    {
      vtkNew<vtkDoubleArray> array;
      array->SetName("brief");
      array->SetNumberOfTuples(what.Grid->GetNumberOfPoints() - 1);
      array->Fill(1.0);
      what.Grid->GetPointData()->AddArray(array);
      what.Settings.Arrays.DeltaT = "brief";
    });
  table.Rejected("layers-short", "a layer array with a missing value",
    { "\"few\"", "one for each cell" },
    [](ImageCase& what)
    {
      vtkNew<vtkDoubleArray> array;
      array->SetName("few");
      array->SetNumberOfTuples(what.Grid->GetNumberOfCells() - 1);
      array->Fill(1.0);
      what.Grid->GetCellData()->AddArray(array);
      what.Settings.How = Blend::Priority;
      what.Settings.Layers = "few";
    });
  table.Rejected("layers-missing", "a layer array that does not exist", { "absent" },
    [](ImageCase& what)
    {
      what.Settings.How = Blend::Priority;
      what.Settings.Layers = "absent";
    });
}

void TestNonFinite(Table& table)
{
  // The center of the cube.
  constexpr vtkIdType point = 62;
  const vtkIdType cells = CountCellsAt(point);
  const struct
  {
    double Value;
    const char* Name;
  } values[] = { { NaN, "nan" }, { Infinity, "infinity" }, { -Infinity, "minus-infinity" } };
  for (const auto& value : values)
  {
    const std::string prefix = std::string(value.Name) + " at one point, in ";
    const double x = value.Value;
    table.Skipped(std::string("scalars-") + value.Name, prefix + "the scalars", cells, 0,
      [x](ImageCase& what) { what.Grid->GetPointData()->GetScalars()->SetComponent(point, 0, x); });
    for (int axis : { 0, 2 })
    {
      const std::string name = std::to_string(axis) + "-" + value.Name;
      const auto change = [x, axis](ImageCase& what)
      {
        what.Grid->GetPoints()->GetData()->SetComponent(point, axis, x);
        what.Grid->GetPoints()->Modified();
        what.Grid->Modified();
      };
      table.Skipped("coordinates-" + name, prefix + "a coordinate", cells, 0, change);
      table.Silent(
        "bounds-" + name, prefix + "a coordinate", "the bounds of the other points",
        [](Attempt& attempt, Outcome& outcome)
        {
          outcome = attempt.Draw();
          double expected[6];
          MakeCase().Grid->GetBounds(expected);
          return std::equal(expected, expected + 6, attempt.Drawer->GetBounds());
        },
        change);
    }
    table.Skipped(std::string("delta-t-") + value.Name, prefix + "the extent in time", cells, 0,
      [x](ImageCase& what)
      {
        AddLinearArray(what.Grid, "DeltaT", 1.0, { { -0.8, 0.5, 0.3 } });
        what.Grid->GetPointData()->GetArray("DeltaT")->SetComponent(point, 0, x);
        what.Settings.Arrays.DeltaT = "DeltaT";
        what.Settings.How = Blend::OpticalDepth;
      });
    table.Skipped(std::string("cells-") + value.Name, std::string(value.Name) + " at one cell", 1,
      0,
      [x](ImageCase& what)
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
    table.Silent(
      std::string("all-") + value.Name, std::string(value.Name) + " at every point",
      "an empty image, all tetrahedra reported",
      [](Attempt& attempt, Outcome& outcome)
      {
        outcome = attempt.Draw();
        return outcome.Report->GetNumber("NonFiniteTetrahedra") ==
          outcome.Report->GetNumber("Tetrahedra") &&
          outcome.Report->GetNumber("Tetrahedra") > 0 && LargestAlpha(outcome.Image) == 0.0;
      },
      [x](ImageCase& what) { what.Grid->GetPointData()->GetScalars()->FillComponent(0, x); });
  }
}

void TestShapes(Table& table)
{
  table.Skipped("flat", "three additional degenerate tetrahedra", 0, 3,
    [](ImageCase& what)
    {
      // Flat tetrahedra: in a face of the cube, along an edge, and collapsed to a point.
      for (const auto& corners :
        { std::array<vtkIdType, 4>{ { 0, 1, 5, 6 } }, { { 0, 1, 2, 3 } }, { { 7, 7, 7, 7 } } })
      {
        what.Grid->InsertNextCell(VTK_TETRA, 4, corners.data());
      }
    });
  table.Skipped("constant", "a constant scalar", 0, 0,
    [](ImageCase& what) { what.Grid->GetPointData()->GetScalars()->FillComponent(0, 0.6); });
  table.Skipped("inverted", "every other tetrahedron inverted", 0, 0,
    [](ImageCase& what)
    {
      vtkNew<vtkCellArray> cells;
      for (vtkIdType cell = 0; cell < what.Grid->GetNumberOfCells(); ++cell)
      {
        vtkIdType size = 0;
        const vtkIdType* corners = nullptr;
        what.Grid->GetCellPoints(cell, size, corners);
        std::array<vtkIdType, 4> inverted = { { corners[0], corners[1], corners[2], corners[3] } };
        if (cell % 2 == 1)
        {
          std::swap(inverted[0], inverted[2]);
        }
        cells->InsertNextCell(4, inverted.data());
      }
      what.Grid->SetCells(VTK_TETRA, cells);
    });
}

/// Tests that ghost and hidden cells are skipped.
void TestGhosts(Table& table)
{
  table.Silent(
    "ghosts", "half of the cells are ghosts", "the image without them",
    [](Attempt& attempt, Outcome& outcome)
    {
      outcome = attempt.Draw();
      ImageCase half = MakeCase();
      vtkNew<vtkCellArray> cells;
      for (vtkIdType cell = 0; cell < half.Grid->GetNumberOfCells(); cell += 2)
      {
        vtkIdType size = 0;
        const vtkIdType* corners = nullptr;
        half.Grid->GetCellPoints(cell, size, corners);
        cells->InsertNextCell(4, corners);
      }
      half.Grid->SetCells(VTK_TETRA, cells);
      const RgbaImage expected = DrawReference(half);
      return LargestAlpha(expected) > 0.2 &&
        outcome.Report->GetNumber("NonFiniteTetrahedra") == 0 &&
        outcome.Report->GetNumber("FlatTetrahedra") == 0 &&
        CompareImages(outcome.Image, expected).Max < Bound;
    },
    [](ImageCase& what)
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
  const auto isEmpty = [](Attempt& attempt, Outcome& outcome)
  {
    outcome = attempt.Draw();
    return LargestAlpha(outcome.Image) == 0.0 && outcome.Report->GetNumber("Tetrahedra") == 0;
  };
  table.Silent("empty", "a grid without cells and points", "an empty image", isEmpty,
    [](ImageCase& what) { what.Grid->Initialize(); });
  table.Silent("no-cells", "a grid without cells", "an empty image", isEmpty,
    [](ImageCase& what) { what.Grid->SetCells(VTK_TETRA, vtkNew<vtkCellArray>()); });
  table.Silent(
    "emptied", "cells that are removed and restored", "an empty image, then the first image",
    [](Attempt& attempt, Outcome& outcome)
    {
      const RgbaImage before = attempt.Draw().Image;
      auto* grid = vtkUnstructuredGrid::SafeDownCast(attempt.Drawer->GetInput());
      vtkNew<vtkUnstructuredGrid> copy;
      copy->DeepCopy(grid);
      grid->Initialize();
      outcome = attempt.Draw();
      const bool isEmpty = LargestAlpha(outcome.Image) == 0.0;
      grid->DeepCopy(copy);
      const RgbaImage after = attempt.Draw().Image;
      return isEmpty && LargestAlpha(before) > 0.2 && CompareImages(after, before).Max == 0.0;
    },
    [](ImageCase&) {});
}

/// Tests that an error is cleared when its cause is removed, and reported again when the cause
/// recurs.
void TestRecovery(Table& table)
{
  table.Silent(
    "recovery", "a missing extent array that is set and unset",
    "one error per change, and the image in between",
    [](Attempt& attempt, Outcome& outcome)
    {
      const RgbaImage before = attempt.Draw().Image;
      bool isExpected = LargestAlpha(before) > 0.2;
      for (int repetition = 0; repetition < 3; ++repetition)
      {
        attempt.Drawer->SetDeltaTArrayName("absent");
        outcome = attempt.Draw();
        isExpected = isExpected && outcome.Errors.size() == 1 && outcome.Others.empty() &&
          LargestAlpha(outcome.Image) == 0.0;
        attempt.Drawer->SetDeltaTArrayName("");
        outcome = attempt.Draw();
        isExpected = isExpected && CompareImages(outcome.Image, before).Max == 0.0;
      }
      return isExpected;
    },
    [](ImageCase&) {});
}

/// Tests an input that is removed and restored. VTK's executive may report the missing input.
void TestNoInput(Table& table)
{
  table.Silent(
    "no-input", "an input that is removed and restored", "an empty image, then the first image",
    [](Attempt& attempt, Outcome& outcome)
    {
      const RgbaImage before = attempt.Draw().Image;
      vtkSmartPointer<vtkDataSet> grid = attempt.Drawer->GetInput();
      const Listener pipeline(attempt.Drawer->GetExecutive());
      attempt.Drawer->SetInputConnection(nullptr);
      outcome = attempt.Draw();
      const bool isEmpty = LargestAlpha(outcome.Image) == 0.0;
      attempt.Drawer->SetInputData(grid);
      const RgbaImage after = attempt.Draw().Image;
      return isEmpty && LargestAlpha(before) > 0.2 && CompareImages(after, before).Max == 0.0;
    },
    [](ImageCase&) {});
}

void TestSizes(Table& table)
{
  for (const std::array<int, 2>& size :
    { std::array<int, 2>{ { 1, 1 } }, { { 1, 41 } }, { { 41, 1 } }, { { 2, 3 } }, { { 5, 4 } } })
  {
    const std::string text = std::to_string(size[0]) + "x" + std::to_string(size[1]);
    table.Skipped("window-" + text, "a window of " + text + " pixels", 0, 0,
      [&size](ImageCase& what) { what.Settings.Size = size; });
  }
  table.Silent(
    "viewport-zero", "an empty viewport, then the full window", "the image",
    [](Attempt& attempt, Outcome& outcome)
    {
      vtkRenderer* renderer = attempt.Stage.GetRenderer();
      renderer->SetViewport(0.5, 0.5, 0.5, 0.5);
      attempt.Stage.Render();
      renderer->SetViewport(0.0, 0.0, 1.0, 1.0);
      outcome = attempt.Draw();
      return CompareImages(outcome.Image, DrawReference(MakeCase())).Max < Bound;
    },
    [](ImageCase&) {});
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
