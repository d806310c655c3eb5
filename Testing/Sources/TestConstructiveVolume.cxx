// SPDX-License-Identifier: BSD-3-Clause
// Arrays of every output mode compared with samples of the root, equation 2.7 of C. Zhang's
// dissertation, subsamples, and colors next to objects. Also tests pieces, threads, progress,
// abort, the bounds of a root, and errors.
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Checks/ReferenceMessages.h"
#include "Support/Checks/ReferenceProgress.h"
#include "Support/Meshes/ReferenceImageSource.h"

#include "vtkConstructiveModelSource.h"
#include "vtkConstructiveVolume.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkSpatialOperation.h"
#include "vtkSpatialPrimitive.h"
#include "vtkStructuredData.h"
#include "vtkTransform.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace
{

using namespace reference;

vtkSmartPointer<vtkSpatialOperation> MakeRoot()
{
  auto root = vtkSmartPointer<vtkSpatialOperation>::New();
  root->SetOperationToBlend();
  for (int i = 0; i < 2; ++i)
  {
    vtkNew<vtkSpatialPrimitive> part;
    part->SetShape(i == 0 ? vtkSpatialPrimitive::FUZZY_SPHERE : vtkSpatialPrimitive::BOX);
    part->SetCenter(0.3 * i, 0.2 * i, -0.1);
    part->SetDensity(0.7);
    part->SetEdgeWidth(0.2);
    part->SetColor(0.9 - 0.7 * i, 0.3, 0.1 + 0.8 * i);
    root->AddOperand(part);
  }
  return root;
}

// A point without density has the mean color of its neighbors with density.
void CheckDilation(vtkImageData* image, const int ijk[3], double tolerance, Check& check)
{
  const int* extent = image->GetExtent();
  double sums[3] = { 0.0, 0.0, 0.0 };
  int number = 0;
  for (int n = 0; n < 27; ++n)
  {
    const int i = ijk[0] + n % 3 - 1;
    const int j = ijk[1] + n / 3 % 3 - 1;
    const int k = ijk[2] + n / 9 - 1;
    const bool isIn = i >= extent[0] && i <= extent[1] && j >= extent[2] && j <= extent[3] &&
      k >= extent[4] && k <= extent[5];
    if (isIn && image->GetScalarComponentAsDouble(i, j, k, 3) > 0.0)
    {
      ++number;
      for (int c = 0; c < 3; ++c)
      {
        sums[c] += image->GetScalarComponentAsDouble(i, j, k, c);
      }
    }
  }
  for (int c = 0; c < 3; ++c)
  {
    const double expected = number > 0 ? sums[c] / number : 0.0;
    const double found = image->GetScalarComponentAsDouble(ijk[0], ijk[1], ijk[2], c);
    check.That(std::fabs(found - expected) <= tolerance, "color of a point without density");
  }
}

void CheckValues(Check& check)
{
  const auto root = MakeRoot();
  vtkNew<vtkConstructiveVolume> source;
  source->SetRoot(root);
  source->SetWholeExtent(-3, 40, 2, 25, 0, 20);
  for (int mode = 0; mode < vtkConstructiveVolume::NUMBER_OF_OUTPUT_MODES; ++mode)
  {
    check.SetContext(vtkConstructiveVolume::GetOutputModeName(mode));
    source->SetOutputMode(mode);
    source->Update();
    vtkImageData* image = source->GetOutput();
    const bool isColored = mode != vtkConstructiveVolume::DENSITY;
    const bool isBytes = mode == vtkConstructiveVolume::COLOR_BYTES;
    vtkDataArray* values = image->GetPointData()->GetArray(isColored ? "Color" : "Density");
    if (!check.That(values && values == image->GetPointData()->GetScalars(), "the array"))
    {
      return;
    }
    check.Equal(values->GetNumberOfComponents(), isColored ? 4 : 1, "components");
    check.Equal(values->GetDataType(), isBytes ? VTK_UNSIGNED_CHAR : VTK_FLOAT, "type");
    int dense = 0;
    for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
    {
      double x[3];
      double color[3];
      image->GetPoint(i, x);
      const double density = source->Evaluate(x, color);
      const double scale = isBytes ? 255.0 : 1.0;
      const double tolerance = isBytes ? 0.5000001 : 1e-6;
      check.Near(values->GetComponent(i, isColored ? 3 : 0), scale * density, tolerance, "density",
        1.0 / std::max(1.0, scale * density));
      for (int c = 0; c < 3 && isColored && values->GetComponent(i, 3) > 0.0; ++c)
      {
        ++dense;
        check.That(std::fabs(values->GetComponent(i, c) - scale * color[c]) <= tolerance,
          "color " + std::to_string(c));
      }
    }
    check.That(!isColored || dense > 1000, "there is density");
    for (vtkIdType i = 0; i < image->GetNumberOfPoints() && isColored; ++i)
    {
      int ijk[3];
      vtkStructuredData::ComputePointStructuredCoordsForExtent(i, image->GetExtent(), ijk);
      if (values->GetComponent(i, 3) == 0.0)
      {
        CheckDilation(image, ijk, isBytes ? 1.0 : 1e-6, check);
      }
    }
  }
}

// Image values equal the profile of the source's fuzzy sphere.
void CheckFuzzySphere(Check& check)
{
  check.SetContext("equation 2.7");
  vtkNew<vtkConstructiveVolume> source;
  source->SetRoot(vtkConstructiveModelSource::MakeModel(vtkConstructiveModelSource::FUZZY_SPHERE));
  source->SetDimensions(41, 41, 41);
  source->Update();
  vtkImageData* image = source->GetOutput();
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    double x[3];
    image->GetPoint(i, x);
    const double r2 = x[0] * x[0] + x[1] * x[1] + x[2] * x[2];
    double expected = 0.0;
    if (r2 <= 0.2 * 0.2)
    {
      expected = 1.0;
    }
    else if (r2 < 0.5 * 0.5)
    {
      expected = (0.5 * 0.5 - r2) / (0.5 * 0.5 - 0.2 * 0.2);
    }
    check.Near(image->GetPointData()->GetScalars()->GetTuple1(i), expected, 1e-7, "density", 1.0);
  }
}

// A box that covers known fractions of its boundary cells: densities are means over subsamples, and
// the color is constant.
void CheckSubsamples(Check& check)
{
  check.SetContext("subsamples");
  vtkNew<vtkSpatialPrimitive> box;
  box->SetShapeToBox();
  // The box covers three quarters of the unit cells centered at -2 and 2 along x.
  box->SetLengths(4.5, 3.0, 4.0);
  box->SetColor(0.25, 0.5, 0.75);
  vtkNew<vtkConstructiveVolume> source;
  source->SetRoot(box);
  source->SetWholeExtent(-4, 4, -4, 4, -4, 4);
  source->SetBounds(-4.0, 4.0, -4.0, 4.0, -4.0, 4.0);
  source->SetOutputModeToColorFloats();
  source->SetNumberOfSubsamples(4);
  source->Update();
  vtkDataArray* values = source->GetOutput()->GetPointData()->GetScalars();
  const double fractions[3][5] = { { 1.0, 1.0, 0.75, 0.0, 0.0 }, { 1.0, 1.0, 0.0, 0.0, 0.0 },
    { 1.0, 1.0, 0.5, 0.0, 0.0 } };
  for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
  {
    double x[3];
    source->GetOutput()->GetPoint(i, x);
    double expected = 1.0;
    for (int axis = 0; axis < 3; ++axis)
    {
      expected *= fractions[axis][static_cast<int>(std::lround(std::fabs(x[axis])))];
    }
    check.Near(values->GetComponent(i, 3), expected, 1e-6, "density", 1.0);
    if (expected > 0.0)
    {
      check.Near(values->GetComponent(i, 1), 0.5, 1e-6, "green");
    }
  }
}

// Points next to an object have the object's color, and points farther away have no color, even at
// the boundary of the image.
void CheckNeighbors(Check& check)
{
  check.SetContext("neighbors");
  vtkNew<vtkSpatialPrimitive> left;
  vtkNew<vtkSpatialPrimitive> right;
  left->SetShapeToBox();
  left->SetCenter(-1.0, 0.0, 0.0);
  left->SetColor(1.0, 0.0, 0.0);
  right->SetShapeToBox();
  right->SetCenter(1.0, 0.0, 0.0);
  right->SetColor(0.0, 0.0, 1.0);
  vtkNew<vtkSpatialOperation> root;
  root->AddOperand(left);
  root->AddOperand(right);
  vtkNew<vtkConstructiveVolume> source;
  source->SetRoot(root);
  source->SetWholeExtent(-3, 3, -3, 3, 0, 0);
  source->SetBounds(-3.0, 3.0, -3.0, 3.0, 0.0, 1.0);
  source->SetOutputModeToColorBytes();
  source->Update();
  const auto compare = [&](int x, int y, double red, double blue, double density)
  {
    check.SetContext("neighbors of " + std::to_string(x) + " " + std::to_string(y));
    vtkImageData* image = source->GetOutput();
    const double expected[4] = { red, 0.0, blue, density };
    for (int c = 0; c < 4; ++c)
    {
      check.Near(image->GetScalarComponentAsDouble(x, y, 0, c), expected[c], 0.0, "component");
    }
  };
  compare(-1, 0, 255, 0, 255);
  compare(-2, 1, 255, 0, 0);
  compare(2, -1, 0, 255, 0);
  compare(0, 0, 127, 127, 0);
  compare(0, 1, 127, 127, 0);
  compare(1, 2, 0, 0, 0);
  compare(3, 0, 0, 0, 0);
}

void CheckExecution(Check& check)
{
  for (int mode = 0; mode < vtkConstructiveVolume::NUMBER_OF_OUTPUT_MODES; ++mode)
  {
    vtkNew<vtkConstructiveVolume> source;
    source->SetRoot(MakeRoot());
    source->SetWholeExtent(-5, 45, 0, 34, 3, 40);
    source->SetOutputMode(mode);
    source->SetNumberOfSubsamples(mode + 1);
    check.SetContext(std::string("execution, ") + vtkConstructiveVolume::GetOutputModeName(mode));
    CheckImageSource(source, check);
  }
}

void CheckFit(Check& check)
{
  check.SetContext("fit");
  vtkNew<vtkConstructiveVolume> source;
  vtkNew<vtkSpatialPrimitive> box;
  box->SetShapeToBox();
  box->SetLengths(2.0, 1.0, 0.5);
  box->SetCenter(1.0, 0.0, 0.0);
  check.That(!CaptureErrors(source, [&] { source->FitRoot(20); }).empty(),
    "an error reports the missing root");
  for (double scale : { 1e-6, 1.0, 1e6 })
  {
    vtkNew<vtkTransform> transform;
    transform->Scale(scale, scale, scale);
    box->SetTransform(transform);
    source->SetRoot(box);
    source->FitRoot(23, 0.05);
    const double expected[6] = { -0.1, 2.1, -0.6, 0.6, -0.35, 0.35 };
    for (int side = 0; side < 6; ++side)
    {
      check.Near(source->GetBounds()[side], scale * expected[side], 1e-9, "a bound", scale);
    }
    const int* extent = source->GetWholeExtent();
    check.That(extent[1] == 22 && extent[3] == 12 && extent[5] == 7, "points are equally spaced");
    source->Update();
    double sum = 0.0;
    vtkDataArray* values = source->GetOutput()->GetPointData()->GetScalars();
    for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
    {
      sum += values->GetTuple1(i);
    }
    // Rounding decides whether points on the faces of the box are inside.
    check.That(sum >= 19 * 9 * 6 && sum <= 21 * 11 * 6, "points inside the box");
  }
  box->SetShapeToHalfSpace();
  check.That(
    !CaptureErrors(source, [&] { source->FitRoot(20); }).empty(), "infinite bounds are an error");
  check.That(
    !CaptureErrors(source, [&] { source->FitRoot(20, std::nan("")); }).empty(), "a margin");
}

void CheckRejections(Check& check)
{
  check.SetContext("refusals");
  vtkNew<vtkConstructiveVolume> source;
  check.Contains(UpdateAndGetErrors(source), "no root");
  check.Equal(source->GetOutput()->GetNumberOfPoints(), 0, "no points without a root");
  double color[3] = { 1.0, 1.0, 1.0 };
  const double x[3] = { 0.0, 0.0, 0.0 };
  check.That(!CaptureErrors(source, [&] { source->Evaluate(x, color); }).empty() && color[0] == 0.0,
    "no root to evaluate");
  vtkNew<vtkSpatialOperation> root;
  source->SetRoot(root);
  check.Contains(UpdateAndGetErrors(source), "no operand");
  check.Equal(source->GetOutput()->GetNumberOfPoints(), 0, "no points if an operand has an error");
  vtkNew<vtkSpatialPrimitive> sphere;
  root->AddOperand(sphere);
  check.That(UpdateAndGetErrors(source).empty(), "no error once the operand is valid again");
  check.Equal(source->GetOutput()->GetNumberOfPoints(), 64 * 64 * 64, "points");
  const std::string before = GetBytes(source->GetOutput());
  sphere->SetRadius(0.7);
  source->Update();
  check.That(GetBytes(source->GetOutput()) != before, "a modified operand changes the output");
  source->SetOutputMode(99);
  source->SetNumberOfSubsamples(99);
  CheckPrinted(Print(source),
    { "OutputMode: color floats", "NumberOfSubsamples: 8", "Root:", "WholeExtent: 0 63",
      "Bounds: -1 1", "Radius: 0.7" },
    check);
}

}

int TestConstructiveVolume(int, char*[])
{
  return RunChecks({ CheckValues, CheckFuzzySphere, CheckSubsamples, CheckNeighbors, CheckExecution,
    CheckFit, CheckRejections });
}
