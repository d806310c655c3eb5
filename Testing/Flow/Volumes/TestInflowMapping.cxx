// SPDX-License-Identifier: BSD-3-Clause
// vtkInflowMapping evaluates a scalar of the termination surfaces at every sample: formulas, rings
// and images compared with their definitions, formulas with time and arrays, far-side values, NaN
// at samples without a value, periodicity, invalid settings, and threads.
#include "Support/AnalyticFlows/ReferenceFlowResults.h"
#include "Support/Arrays/ReferenceIndices.h"
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Checks/ReferenceExecution.h"
#include "Support/Checks/ReferenceMessages.h"
#include "Support/Checks/ReferenceProgress.h"
#include "Support/Checks/ReferenceThreads.h"
#include "Support/Flow/ReferenceFlowGrid.h"
#include "Support/Meshes/ReferenceLattice.h"

#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkImplicitFlowField.h"
#include "vtkInflowMapping.h"
#include "vtkIntArray.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkSMPTools.h"
#include "vtkTerminationPlane.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <cmath>
#include <limits>

namespace
{

using namespace reference;

const double TwoPi = 2.0 * vtkMath::Pi();

// Samples with z >= 0 reach a surface. The surface id changes from 0 to 7 and back along x.
vtkSmartPointer<vtkImageData> MakeSamples()
{
  auto image = MakeFlowImage({ { 13, 9, 5 } }, { { -0.2, 1.2, -0.1, 1.3, -1.0, 2.0 } });
  AddFlow(image,
    [](const double* x) -> FlowResult {
      return { x[2] < 0.0 ? 3 : 0, x[0] < 0.4 || x[0] > 1.1 ? 0 : 7, x[0], x[1], 1.0 };
    },
    { { { 0, 1, 0 } }, { { 7, 0, 0 } } });
  return image;
}

// Compares Inflow at each sample that reached a surface with expected(id, u, v). At other samples,
// Inflow must be NaN.
template <typename Function>
void CheckValues(
  vtkInflowMapping* mapping, const std::string& name, Check& check, const Function& expected)
{
  check.SetContext(name);
  auto samples = MakeSamples();
  mapping->SetInputData(samples);
  mapping->Update();
  vtkPointData* data = mapping->GetOutput()->GetPointData();
  vtkDataArray* inflow = data->GetArray("Inflow");
  if (!check.That(
        inflow != nullptr && inflow->GetNumberOfTuples() == 13 * 9 * 5, "the array Inflow exists"))
  {
    return;
  }
  for (vtkIdType p = 0; p < inflow->GetNumberOfTuples(); ++p)
  {
    const double* uv = data->GetArray("TerminationUV")->GetTuple2(p);
    const int id = static_cast<int>(data->GetArray("TerminationId")->GetComponent(p, 0));
    const double u = uv[0];
    const double v = uv[1];
    const double value = id < 0 ? std::numeric_limits<double>::quiet_NaN() : expected(id, u, v);
    const double found = inflow->GetComponent(p, 0);
    if (std::isnan(value))
    {
      check.That(std::isnan(found), "NaN for samples without a value");
    }
    else
    {
      check.Near(found, value, 1e-13, "Inflow", 1.0);
      check.Near(mapping->Evaluate(id, u, v, id == 0, false), value, 1e-13, "Evaluate", 1.0);
    }
  }
}

double Around(double u)
{
  return u >= 0.0 && u <= 1.0 ? u : u - std::floor(u);
}

void CheckFormulas(Check& check)
{
  vtkNew<vtkInflowMapping> mapping;
  AllowWarnings(mapping);
  CheckValues(
    mapping, "default", check, [](int id, double u, double) { return id ? u : Around(u); });
  mapping->SetFormula(vtkInflowMapping::ALL, "u + 2*v + 10*f");
  CheckValues(mapping, "all", check,
    [](int id, double u, double v) { return (id ? u : Around(u)) + 2.0 * v + 10.0 * id; });
  mapping->SetFormula(7, "ln(v)");
  CheckValues(mapping, "a specific mapping for one id", check,
    [](int id, double u, double v) {
      return id == 0 ? Around(u) + 2.0 * v : v > 0 ? std::log(v) : std::nan("");
    });
  mapping->RemoveMapping(vtkInflowMapping::ALL);
  CheckValues(mapping, "a mapping for only one id", check,
    [](int id, double, double v) { return id == 0 || v <= 0 ? std::nan("") : std::log(v); });
  mapping->RemoveAllMappings();
  CheckValues(mapping, "none", check, [](int, double, double) { return std::nan(""); });
  check.That(std::isnan(mapping->Evaluate(0, 0.5, 0.5)), "NaN without a mapping");
}

void CheckRings(Check& check)
{
  vtkNew<vtkInflowMapping> mapping;
  AllowWarnings(mapping);
  mapping->AddRing(vtkInflowMapping::ALL, 0.9, 0.4, 0.25, 0.1, 2.0);
  mapping->AddRing(vtkInflowMapping::ALL, 0.1, 0.6, 0.0, 0.3);
  check.Equal(mapping->GetNumberOfRings(vtkInflowMapping::ALL), 2, "rings");
  CheckValues(mapping, "rings", check,
    [](int id, double u, double v)
    {
      double sum = 0.0;
      const double rings[2][5] = { { 0.9, 0.4, 0.25, 0.1, 2.0 }, { 0.1, 0.6, 0.0, 0.3, 1.0 } };
      for (const auto& ring : rings)
      {
        double du = std::abs(u - ring[0]);
        for (int turn = -2; turn <= 2 && id == 0; ++turn)
        {
          du = std::min(du, std::abs(u - ring[0] + turn));
        }
        const double r = std::sqrt(du * du + (v - ring[1]) * (v - ring[1]));
        sum += ring[4] * std::exp(-std::pow((r - ring[2]) / ring[3], 2));
      }
      return sum;
    });
}

vtkSmartPointer<vtkImageData> MakeTexture(const std::array<int, 3>& size, int components)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(size[0], size[1], size[2]);
  image->AllocateScalars(components == 1 ? VTK_DOUBLE : VTK_UNSIGNED_CHAR, components);
  vtkDataArray* values = image->GetPointData()->GetScalars();
  for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
  {
    for (int c = 0; c < components; ++c)
    {
      values->SetComponent(i, c, static_cast<double>((37 * i + 101 * c) % 251));
    }
  }
  return image;
}

// Bilinear interpolation of the value or the luminance at (u, v).
double Bilinear(vtkImageData* image, int nu, int nv, double u, double v)
{
  const double x = std::max(0.0, std::min(u, 1.0)) * (nu - 1);
  const double y = std::max(0.0, std::min(v, 1.0)) * (nv - 1);
  vtkDataArray* values = image->GetPointData()->GetScalars();
  double sum = 0.0;
  for (const auto& [j, i] : AllIndices(nv, nu))
  {
    const double weight =
      std::max(0.0, 1.0 - std::abs(x - i)) * std::max(0.0, 1.0 - std::abs(y - j));
    const vtkIdType p = static_cast<vtkIdType>(j) * nu + i;
    const double value = values->GetNumberOfComponents() == 1 ? values->GetComponent(p, 0)
                                                              : 0.30 * values->GetComponent(p, 0) +
        0.59 * values->GetComponent(p, 1) + 0.11 * values->GetComponent(p, 2);
    sum += weight * value;
  }
  return sum;
}

void CheckImages(Check& check)
{
  struct
  {
    std::array<int, 3> Size;
    int NumberOfU;
    int NumberOfV;
  } const cases[] = { { { { 6, 4, 1 } }, 6, 4 }, { { { 5, 1, 3 } }, 5, 3 },
    { { { 1, 4, 5 } }, 4, 5 }, { { { 1, 4, 1 } }, 1, 4 }, { { { 4, 1, 1 } }, 4, 1 },
    { { { 1, 1, 1 } }, 1, 1 } };
  for (const auto& one : cases)
  {
    for (int components : { 1, 3, 4 })
    {
      auto image = MakeTexture(one.Size, components);
      vtkNew<vtkInflowMapping> mapping;
      AllowWarnings(mapping);
      mapping->SetImage(vtkInflowMapping::ALL, image);
      CheckValues(mapping, "image " + std::to_string(components), check,
        [&](int id, double u, double v)
        { return Bilinear(image, one.NumberOfU, one.NumberOfV, id ? u : Around(u), v); });
    }
  }
  check.SetContext("a modified image");
  auto image = MakeTexture({ { 2, 1, 1 } }, 1);
  vtkNew<vtkInflowMapping> mapping;
  AllowWarnings(mapping);
  mapping->SetImage(3, image);
  check.That(mapping->GetImage(3) == image, "GetImage");
  check.Near(mapping->Evaluate(3, 1.0, 0.0), 37.0, 1e-15, "before");
  image->GetPointData()->GetScalars()->SetComponent(1, 0, 5.0);
  image->GetPointData()->GetScalars()->Modified();
  check.Near(mapping->Evaluate(3, 1.0, 0.0), 5.0, 1e-15, "after");
}

// Returns InflowPeriodic of the surface with id 0. \a isPeriodic specifies whether u and v of the
// input are periodic.
std::array<int, 2> GetPeriodic(vtkInflowMapping* mapping, std::array<int, 2> isPeriodic)
{
  auto image = MakeFlowImage({ { 2, 2, 2 } }, { { 0, 1, 0, 1, 0, 1 } });
  AddFlow(image, UniformFlow(1.0), { { { 5, 0, 0 } }, { { 0, isPeriodic[0], isPeriodic[1] } } });
  mapping->SetInputData(image);
  mapping->Update();
  vtkDataArray* array = mapping->GetOutput()->GetFieldData()->GetArray("InflowPeriodic");
  for (vtkIdType i = 0; array && i < array->GetNumberOfTuples(); ++i)
  {
    if (array->GetComponent(i, 0) == 0.0)
    {
      return { { static_cast<int>(array->GetComponent(i, 1)),
        static_cast<int>(array->GetComponent(i, 2)) } };
    }
  }
  return { { -1, -1 } };
}

void CheckPeriodic(Check& check)
{
  vtkNew<vtkInflowMapping> mapping;
  const std::array<int, 2> both{ { 1, 1 } };
  const auto expect = [&](const char* formula, std::array<int, 2> isPeriodic, int u, int v)
  {
    check.SetContext(formula);
    mapping->SetFormula(vtkInflowMapping::ALL, formula);
    const auto found = GetPeriodic(mapping, isPeriodic);
    check.Equal(found[0], u, "across the seam of u");
    check.Equal(found[1], v, "across the seam of v");
  };
  expect("u", both, 0, 1);
  expect("v", both, 1, 0);
  expect("v", { { 0, 1 } }, 0, 0);
  expect("v", { { 1, 0 } }, 1, 0);
  expect("sin(6.283185307179586*u)*v", both, 1, 0);
  expect("sin(6.283185307179586*u)+1e-7*u", both, 1, 1);
  expect("sin(6.283185307179586*u)+1e-5*u", both, 0, 1);
  expect("3", both, 1, 1);
  expect("1/u", both, 0, 1);
  // Times are 0 and 1, and the mapping is 0 at time 0.
  expect("u*t", both, 0, 1);
  expect("sin(6.283185307179586*u)*t", both, 1, 1);
  expect("v*(1 - FlowStatus)", both, 1, 0);
  check.SetContext("rings");
  mapping->AddRing(vtkInflowMapping::ALL, 0.9, 0.5, 0.2, 0.1);
  check.That(GetPeriodic(mapping, both) == both, "rings are periodic");
  mapping->SetImage(vtkInflowMapping::ALL, MakeTexture({ { 3, 3, 1 } }, 1));
  check.That(GetPeriodic(mapping, both) == std::array<int, 2>{ { 0, 0 } }, "an image");
}

vtkSmartPointer<vtkIntArray> MakeIds(const char* name, vtkIdType number)
{
  auto ids = vtkSmartPointer<vtkIntArray>::New();
  ids->SetName(name);
  for (vtkIdType p = 0; p < number; ++p)
  {
    ids->InsertNextValue(static_cast<int>(3 * p % 17));
  }
  return ids;
}

// Formulas with time and with arrays whose names are no words of the formula language, or are equal
// to its parameters apart from case or quotes.
void CheckArrays(Check& check)
{
  check.SetContext("arrays");
  const auto addArrays = [](vtkImageData* samples)
  {
    const vtkIdType number = samples->GetNumberOfPoints();
    AddFlow(samples,
      [](const double* x) -> FlowResult {
        return { x[2] < 0.0 ? 3 : 0, 7, x[0], x[1], 1.0 + x[0] * x[2] };
      },
      { { { 7, 0, 0 } } });
    for (const char* name : { "Mean density (kg/m3)", "T", "u", "sin", "e3" })
    {
      samples->GetPointData()->AddArray(MakeIds(name, number));
    }
  };
  auto samples = MakeSamples();
  addArrays(samples);
  vtkNew<vtkInflowMapping> mapping;
  AllowWarnings(mapping);
  mapping->SetInputData(samples);
  mapping->SetFormula(vtkInflowMapping::ALL, "u + t");
  check.Near(mapping->Evaluate(0, 0.25, 0.0, false, false, 2.0), 2.25, 1e-15, "Evaluate at a time");
  const auto compare = [&](const char* formula, auto&& expected)
  {
    mapping->SetFormula(vtkInflowMapping::ALL, formula);
    check.That(UpdateAndGetErrors(mapping).empty(), std::string("no error for ") + formula);
    vtkPointData* data = mapping->GetOutput()->GetPointData();
    for (vtkIdType p = 0; p < samples->GetNumberOfPoints(); ++p)
    {
      double x[3];
      samples->GetPoint(p, x);
      const double found = data->GetArray("Inflow")->GetComponent(p, 0);
      const double ids = static_cast<double>(3 * p % 17);
      check.That(x[2] < 0.0 ? std::isnan(found)
                            : std::abs(found - expected(x, ids)) < 1e-12 * (1.0 + std::abs(found)),
        formula);
    }
  };
  compare("t", [](const double* x, double) { return 1.0 + x[0] * x[2]; });
  compare("2*\"Mean density (kg/m3)\" + T*u + t + 10*\"u\"",
    [](const double* x, double ids) { return 12.0 * ids + ids * x[0] + 1.0 + x[0] * x[2]; });
  compare("1e3 + e3 + \"e3\"", [](const double*, double ids) { return 1000.0 + 2.0 * ids; });
  compare(
    "min(TerminationId, \"sin\")", [](const double*, double ids) { return std::min(7.0, ids); });
  check.That(std::isnan(mapping->Evaluate(0, 0.5, 0.5)), "Evaluate without arrays");

  // A function's name in quotes is the array, otherwise the function.
  compare("sin(0*t) + \"sin\"", [](const double*, double ids) { return ids; });
  compare("1 + \"T\" * 2 - T", [](const double*, double ids) { return 1.0 + ids; });
  const std::string longText(200000, 'x');
  mapping->SetFormula(vtkInflowMapping::ALL, longText.c_str());
  check.That(!UpdateAndGetErrors(mapping).empty(), "a long word");
  mapping->SetFormula(vtkInflowMapping::ALL, "T 3");
  CheckError(mapping, "\"T\"3", check);
  mapping->SetFormula(vtkInflowMapping::ALL, " \t ");
  CheckError(mapping, "empty", check);
  mapping->SetFormula(vtkInflowMapping::ALL, "u + \"T");
  CheckError(mapping, "cannot be read", check);

  check.SetContext("invalid arrays");
  vtkNew<vtkIntArray> few;
  few->SetName("few");
  few->InsertNextValue(3);
  samples->GetPointData()->AddArray(few);
  mapping->SetFormula(vtkInflowMapping::ALL, "few");
  CheckError(mapping, "\"few\" has 1 tuple", check);
  samples->GetPointData()->RemoveArray("few");
  vtkNew<vtkDoubleArray> vectors;
  vectors->SetNumberOfComponents(3);
  vectors->SetNumberOfTuples(samples->GetNumberOfPoints());
  vectors->Fill(1000.0);
  vtkNew<vtkImageData> doubled;
  doubled->DeepCopy(samples);
  doubled->GetPointData()->RemoveArray("T");
  vectors->SetName("other");
  doubled->GetPointData()->AddArray(vectors);
  doubled->GetPointData()->AddArray(MakeIds("T", samples->GetNumberOfPoints()));
  vectors->SetName("T");
  mapping->SetInputData(doubled);
  compare("T", [](const double*, double ids) { return ids; });
  mapping->SetFormula(4, "u");
  mapping->SetFormula(vtkInflowMapping::ALL, "\"unknown\"");
  check.Near(mapping->Evaluate(4, 0.5, 0.0), 0.5, 1e-15, "Evaluate beside a mapping with an error");
  mapping->RemoveMapping(4);

  check.SetContext("missing arrays");
  mapping->SetFormula(vtkInflowMapping::ALL, "T");
  mapping->SetInputData(MakeSamples());
  CheckError(mapping, "'T'", check);
  mapping->SetFormula(vtkInflowMapping::ALL, "1 + \"T\"");
  CheckError(mapping, "\"T\"", check);
  mapping->SetInputData(samples);
  check.That(UpdateAndGetErrors(mapping).empty(), "no error with the array");
  mapping->SetFormula(vtkInflowMapping::ALL, "TerminationUV");
  CheckError(mapping, "TerminationUV", check);
  samples->GetPointData()->RemoveArray("AdvectionTime");
  check.That(!UpdateAndGetErrors(mapping).empty(), "still an error");
  mapping->SetFormula(vtkInflowMapping::ALL, "u - t");
  CheckError(mapping, "\"AdvectionTime\"", check);
  mapping->SetFormula(vtkInflowMapping::ALL, "u");
  check.That(UpdateAndGetErrors(mapping).empty(), "no error without t");
}

// Dye that enters through the plane x = 0 with a strength that changes over time, carried by the
// shear flow (1, z / 4, 0): at time 3, the dye at x was released at time 3 - x.
void CheckUnsteadyInflow(Check& check)
{
  check.SetContext("unsteady inflow");
  vtkNew<vtkImplicitFlowField> field;
  field->SetInputDataObject(MakeFlowImage(9,
    [](const Vector& x) -> Vector {
      return { { 1.0, 0.25 * x[2], 0.0 } };
    }));
  field->AddTerminationSurface(MakeFlowPlane(0.0));
  vtkNew<vtkInflowMapping> mapping;
  mapping->SetInputConnection(field->GetOutputPort());
  mapping->SetFormula(vtkInflowMapping::ALL, "cos(5*(3 - t))*(u + v^2)");
  mapping->Update();
  vtkDataSet* output = vtkDataSet::SafeDownCast(mapping->GetOutputDataObject(0));
  int reached = 0;
  for (vtkIdType p = 0; p < output->GetNumberOfPoints(); ++p)
  {
    double x[3];
    output->GetPoint(p, x);
    const double y = x[1] - 0.25 * x[2] * x[0];
    if (y > 1e-9)
    {
      const double released = std::cos(5.0 * (3.0 - x[0]));
      check.Near(output->GetPointData()->GetArray("Inflow")->GetComponent(p, 0),
        released * (y / 4.0 + x[2] * x[2] / 16.0), 1e-9, "dye", 1.0);
      ++reached;
    }
  }
  check.That(reached > 300, "many samples contain dye");
}

// Far-side values of a mapping with time and arrays: the far-side time and arc length, and the
// sample's own local speed.
void CheckFarSide(Check& check)
{
  check.SetContext("far side");
  vtkNew<vtkImplicitFlowField> field;
  field->SetInputDataObject(MakeFlowImage(9,
    [](const Vector& x) -> Vector {
      return { { 2.0 - x[1], x[0] - 2.0, 0.0 } };
    }));
  auto plane = MakeFlowPlane(2.25);
  field->AddTerminationSurface(plane);
  field->ComputeArcLengthOn();
  field->ComputeLocalAttributesOn();
  vtkNew<vtkInflowMapping> mapping;
  mapping->SetInputConnection(field->GetOutputPort());
  mapping->SetFormula(vtkInflowMapping::ALL, "u + 3*t + 5*ArcLength + 7*LocalSpeed");
  mapping->Update();
  vtkDataSet* output = vtkDataSet::SafeDownCast(mapping->GetOutputDataObject(0));
  const auto get = [output](const char* name, vtkIdType row)
  { return output->GetFieldData()->GetArray(name)->GetComponent(row, 0); };
  int known = 0;
  for (vtkIdType row = 0;
       row < output->GetFieldData()->GetArray("BeyondInflow")->GetNumberOfTuples(); ++row)
  {
    if (get("BeyondTerminationId", row) >= 0.0)
    {
      const auto sample = static_cast<vtkIdType>(get("BeyondSampleId", row));
      const double speed = output->GetPointData()->GetArray("LocalSpeed")->GetComponent(sample, 0);
      check.Near(get("BeyondInflow", row),
        get("BeyondTerminationUV", row) + 3.0 * get("BeyondAdvectionTime", row) +
          5.0 * get("BeyondArcLength", row) + 7.0 * speed,
        1e-12, "far-side value", 1.0);
      ++known;
    }
  }
  check.That(known > 20, "there are far-side values");
}

void CheckErrors(Check& check)
{
  check.SetContext("errors");
  for (const char* name : { "FlowStatus", "TerminationId", "TerminationUV" })
  {
    auto samples = MakeSamples();
    samples->GetPointData()->RemoveArray(name);
    vtkNew<vtkInflowMapping> mapping;
    mapping->SetInputData(samples);
    CheckError(mapping, name, check);
  }
  vtkNew<vtkInflowMapping> mapping;
  auto samples = MakeSamples();
  samples->GetFieldData()->RemoveArray("TerminationSurfaces");
  mapping->SetInputData(samples);
  CheckError(mapping, "TerminationSurfaces", check);
  samples = MakeSamples();
  samples->GetPointData()->GetArray("TerminationId")->SetNumberOfTuples(3);
  mapping->SetInputData(samples);
  CheckError(mapping, "3 tuples", check);
  mapping->SetInputData(MakeSamples());
  mapping->SetFormula(4, "u + w");
  CheckError(mapping, "'w'", check);
  check.That(std::isnan(mapping->Evaluate(4, 0.5, 0.5)), "NaN for an invalid formula");
  mapping->SetFormula(4, "u +");
  CheckError(mapping, "formula", check);
  mapping->SetFormula(4, "u*iHat");
  CheckError(mapping, "vector", check);
  mapping->SetFormula(4, "");
  CheckError(mapping, "empty", check);
  mapping->SetImage(4, MakeTexture({ { 2, 3, 4 } }, 1));
  CheckError(mapping, "2 x 3 x 4", check);
  vtkNew<vtkImageData> empty;
  mapping->SetImage(4, empty);
  CheckError(mapping, "no points", check);
  empty->SetDimensions(2, 2, 1);
  CheckError(mapping, "The image has no active point scalars.", check);
  mapping->RemoveMapping(4);
  check.That(UpdateAndGetErrors(mapping).empty(), "no error after the correction");

  const vtkMTimeType before = mapping->GetMTime();
  vtkNew<vtkInflowMapping> fresh;
  fresh->SetFormula(0, "u*t");
  check.That(!fresh->IsContinued(0, 0, true, false), "a seam before an execution");
  check.Contains(
    CaptureErrors(mapping, [&]() { mapping->AddRing(0, 0.5, 0.5, 0.1, 0.0); }), "width 0");
  const double rings[4][4] = { { 0.5, NAN, 0.1, 1.0 }, { NAN, 0.5, 0.1, 1.0 },
    { 0.5, 0.5, INFINITY, 1.0 }, { 0.5, 0.5, 0.1, -1.0 } };
  for (const double* ring : rings)
  {
    check.Contains(
      CaptureErrors(mapping, [&]() { mapping->AddRing(0, ring[0], ring[1], ring[2], ring[3]); }),
      "The ring for id");
  }
  check.Contains(CaptureErrors(mapping, [&]() { mapping->SetFormula(-2, "u"); }), "-2");
  check.Equal(mapping->GetKind(0), vtkInflowMapping::NONE, "the invalid setting is ignored");
  mapping->SetFormula(vtkInflowMapping::ALL, "u");
  check.Equal(static_cast<long long>(mapping->GetMTime() - before), 0,
    "setting the same values does not modify the mapping");
  check.That(mapping->GetFormula(vtkInflowMapping::ALL) == std::string("u"), "GetFormula");
  mapping->AddRing(2, 0.5, 0.5, 0.1, 1.0);
  mapping->SetFormula(3, "v");
  CheckPrinted(Print(mapping), { "all: formula u", "2: rings 1", "3: formula v" }, check);
  mapping->SetFormula(3, nullptr);
  check.Equal(mapping->GetKind(3), vtkInflowMapping::NONE, "null removes the mapping");
}

void CheckRuns(Check& check)
{
  const auto run = []()
  {
    std::vector<vtkSmartPointer<vtkUnstructuredGrid>> outputs;
    for (const DataSetVariant& form : FormsOf(MakeSamples()))
    {
      if (!form.Data->IsA("vtkUnstructuredGrid"))
      {
        continue;
      }
      AddFlow(form.Data, CylinderFlow(0.3), { { { 0, 1, 0 } } });
      vtkNew<vtkInflowMapping> mapping;
      mapping->SetFormula(vtkInflowMapping::ALL, "sin(20*u)*v");
      mapping->SetInputData(form.Data);
      mapping->Update();
      outputs.emplace_back(vtkUnstructuredGrid::SafeDownCast(mapping->GetOutput()));
    }
    return outputs;
  };
  CheckThreads("mapping", run, check);
  check.SetContext("progress");
  vtkNew<vtkInflowMapping> mapping;
  mapping->SetInputData(MakeSamples());
  ProgressWatch watch;
  ObserveProgress(mapping, watch);
  mapping->Update();
  CheckMonotonicProgress(watch, 3, check);
  watch = ProgressWatch();
  watch.AbortAt = 0.3;
  mapping->Modified();
  mapping->Update();
  check.That(mapping->GetOutput()->GetPointData()->GetArray("Inflow") == nullptr, "aborted");
}

}

int TestInflowMapping(int, char*[])
{
  Check check;
  // With the sequential backend, a single SMP range contains samples of several surfaces.
  vtkSMPTools::SetBackend("Sequential");
  CheckFormulas(check);
  CheckRings(check);
  CheckImages(check);
  CheckPeriodic(check);
  CheckArrays(check);
  CheckUnsteadyInflow(check);
  CheckFarSide(check);
  CheckErrors(check);
  CheckRuns(check);
  check.SetContext("seam");
  vtkNew<vtkInflowMapping> mapping;
  mapping->SetFormula(0, "cos(6.283185307179586*u)");
  check.Near(mapping->Evaluate(0, 1.25, 0.0, true), std::cos(TwoPi * 0.25), 1e-12, "around", 1.0);
  return check.Result();
}
