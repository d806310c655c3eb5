// SPDX-License-Identifier: BSD-3-Clause
// Every operation compared with its definition at random points: soft and hard operands, evaluation
// order, remote operands, bounds, and rejected operands.
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Checks/ReferenceMessages.h"
#include "Support/Checks/ReferenceProgress.h"
#include "Support/Meshes/ReferenceImageSource.h"

#include "vtkMath.h"
#include "vtkMinimalStandardRandomSequence.h"
#include "vtkNew.h"
#include "vtkSpatialOperation.h"
#include "vtkSpatialPrimitive.h"
#include "vtkSpatialTurbulence.h"
#include "vtkTransform.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace
{

using namespace reference;
using Sample = vtkSpatialObject::Sample;

vtkSmartPointer<vtkSpatialPrimitive> MakeOperand(int i)
{
  auto primitive = vtkSmartPointer<vtkSpatialPrimitive>::New();
  primitive->SetShape(i % 2 == 0 ? vtkSpatialPrimitive::FUZZY_SPHERE : vtkSpatialPrimitive::BOX);
  primitive->SetCenter(0.2 * i, -0.1 * i, 0.15);
  primitive->SetRadius(0.9);
  primitive->SetInnerRadius(0.2);
  primitive->SetEdgeWidth(i == 3 ? 0.0 : 0.6);
  primitive->SetDensity(1.0 - 0.15 * i);
  primitive->SetColor(0.1 + 0.2 * i, 0.9 - 0.2 * i, 0.5);
  if (i == 1)
  {
    vtkNew<vtkTransform> transform;
    transform->RotateWXYZ(35.0, 1.0, 2.0, 3.0);
    transform->Scale(1.2, 0.8, 1.0);
    primitive->SetTransform(transform);
  }
  return primitive;
}

// Implements the definitions of the scalar functions by Chen and Tucker.
Sample Combine(int operation, const Sample& a, const Sample& b)
{
  Sample c = a;
  const bool isFirst = a.Density >= b.Density;
  switch (operation)
  {
    case vtkSpatialOperation::UNION:
    case vtkSpatialOperation::INTERSECTION:
      std::copy_n(isFirst ? a.Color : b.Color, 3, c.Color);
      c.Density = (operation == vtkSpatialOperation::UNION) == isFirst ? a.Density : b.Density;
      break;
    case vtkSpatialOperation::DIFFERENCE:
      c.Density = a.Density > b.Density ? a.Density - b.Density : 0.0;
      break;
    case vtkSpatialOperation::BLEND:
      c.Density = std::min(1.0, a.Density + b.Density);
      for (int i = 0; i < 3 && c.Density > 0.0; ++i)
      {
        c.Color[i] = (a.Density * a.Color[i] + b.Density * b.Color[i]) / (a.Density + b.Density);
      }
      break;
    default:
      c.Density =
        (b.Density < a.Density) == (operation == vtkSpatialOperation::CAP) ? a.Density : 0.0;
      break;
  }
  return c;
}

void Compare(const Sample& found, const Sample& expected, Check& check)
{
  check.Near(found.Density, expected.Density, 1e-15, "density", 1.0);
  for (int i = 0; i < 3; ++i)
  {
    check.Near(
      found.Color[i], expected.Density > 0.0 ? expected.Color[i] : 0.0, 1e-15, "color", 1.0);
  }
}

void CheckDefinitions(Check& check)
{
  for (int operation = 0; operation < vtkSpatialOperation::NUMBER_OF_OPERATIONS; ++operation)
  {
    vtkNew<vtkSpatialOperation> object;
    object->SetOperation(operation);
    std::vector<vtkSmartPointer<vtkSpatialPrimitive>> operands;
    vtkNew<vtkMinimalStandardRandomSequence> random;
    int dense = 0;
    for (int number = 1; number <= 4; ++number)
    {
      operands.push_back(MakeOperand(number - 1));
      object->AddOperand(operands.back());
      check.SetContext(std::string(vtkSpatialOperation::GetOperationName(operation)) + " of " +
        std::to_string(number));
      double bounds[6];
      object->GetBounds(bounds);
      for (int i = 0; i < 2000; ++i)
      {
        double x[3];
        for (double& coordinate : x)
        {
          coordinate = random->GetNextRangeValue(-1.2, 1.4);
        }
        Sample expected;
        operands[0]->Evaluate(x, expected);
        for (int j = 1; j < number; ++j)
        {
          Sample other;
          operands[j]->Evaluate(x, other);
          expected = Combine(operation, expected, other);
        }
        Sample found;
        object->Evaluate(x, found);
        Compare(found, expected, check);
        dense += expected.Density > 0.0;
        const bool isInside = x[0] >= bounds[0] && x[0] <= bounds[1] && x[1] >= bounds[2] &&
          x[1] <= bounds[3] && x[2] >= bounds[4] && x[2] <= bounds[5];
        check.That(isInside || found.Density == 0.0, "no density outside the bounds");
      }
    }
    check.That(dense > 200, "there is density");
  }
}

// A difference that removes more density than there is has the density 0, not a negative density,
// which would affect an enclosing operation.
void CheckNestedDifference(Check& check)
{
  check.SetContext("difference within a blend");
  const auto makeBox = [](double density)
  {
    auto box = vtkSmartPointer<vtkSpatialPrimitive>::New();
    box->SetShapeToBox();
    box->SetDensity(density);
    return box;
  };
  vtkNew<vtkSpatialOperation> difference;
  difference->SetOperation(vtkSpatialOperation::DIFFERENCE);
  difference->AddOperand(makeBox(0.3));
  difference->AddOperand(makeBox(0.8));
  vtkNew<vtkSpatialOperation> blend;
  blend->SetOperation(vtkSpatialOperation::BLEND);
  blend->AddOperand(difference);
  blend->AddOperand(makeBox(0.6));
  const double x[3] = { 0.1, 0.1, 0.1 };
  Sample found;
  blend->Evaluate(x, found);
  check.Near(found.Density, 0.6, 1e-15, "density", 1.0);
}

// Tests two overlapping boxes at points in only the first box, in both, and in only the second.
void CheckSolids(Check& check)
{
  const double expected[vtkSpatialOperation::NUMBER_OF_OPERATIONS][3] = { { 1.0, 1.0, 1.0 },
    { 0.0, 1.0, 0.0 }, { 1.0, 0.0, 0.0 }, { 1.0, 1.0, 1.0 }, { 1.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0 } };
  const double reds[vtkSpatialOperation::NUMBER_OF_OPERATIONS] = { 1.0, 1.0, 0.0, 0.5, 0.0, 1.0 };
  for (int operation = 0; operation < vtkSpatialOperation::NUMBER_OF_OPERATIONS; ++operation)
  {
    check.SetContext(std::string("solids, ") + vtkSpatialOperation::GetOperationName(operation));
    vtkNew<vtkSpatialOperation> object;
    object->SetOperation(operation);
    for (double side : { -1.0, 1.0 })
    {
      vtkNew<vtkSpatialPrimitive> box;
      box->SetShapeToBox();
      box->SetLengths(2.0, 1.0, 1.0);
      box->SetCenter(0.5 * side, 0.0, 0.0);
      box->SetColor(side < 0.0 ? 1.0 : 0.0, 0.0, 0.0);
      object->AddOperand(box);
    }
    for (int position = 0; position < 3; ++position)
    {
      const double x[3] = { position - 1.0, 0.1, 0.2 };
      Sample sample;
      object->Evaluate(x, sample);
      check.Near(sample.Density, expected[operation][position], 0.0,
        "density at position " + std::to_string(position));
      if (position == 1)
      {
        check.Near(sample.Color[0], reds[operation], 0.0, "red in the intersection");
      }
    }
  }
}

// EvaluateSpan matches Evaluate for spans in which an operand covers none, some or all of the
// points.
void CheckSpans(Check& check)
{
  for (int operation = 0; operation < vtkSpatialOperation::NUMBER_OF_OPERATIONS; ++operation)
  {
    check.SetContext(std::string("span, ") + vtkSpatialOperation::GetOperationName(operation));
    vtkNew<vtkSpatialOperation> object;
    object->SetOperation(operation);
    for (int i = 0; i < 4; ++i)
    {
      object->AddOperand(MakeOperand(i));
    }
    check.That(object->Update().empty(), "the operation is valid");
    vtkNew<vtkMinimalStandardRandomSequence> random;
    for (int row = 0; row < 300; ++row)
    {
      const double y = random->GetNextRangeValue(-1.2, 1.2);
      const double z = random->GetNextRangeValue(-1.2, 1.2);
      const double start = random->GetNextRangeValue(-3.0, 2.0);
      double points[vtkSpatialObject::SpanLength][3];
      for (int i = 0; i < vtkSpatialObject::SpanLength; ++i)
      {
        points[i][0] = start + 0.03 * i;
        points[i][1] = y;
        points[i][2] = z;
      }
      Sample samples[vtkSpatialObject::SpanLength];
      const bool isAny = object->EvaluateSpan(points, vtkSpatialObject::SpanLength, samples);
      for (int i = 0; i < vtkSpatialObject::SpanLength; ++i)
      {
        Sample expected;
        object->Evaluate(points[i], expected);
        Sample found = isAny && samples[i].Density > 0.0 ? samples[i] : Sample();
        Compare(found, expected, check);
      }
    }
  }
}

void CheckBounds(Check& check)
{
  check.SetContext("bounds");
  vtkNew<vtkSpatialPrimitive> half;
  half->SetShapeToHalfSpace();
  half->SetCenter(7.0, 8.0, 0.5);
  vtkNew<vtkTransform> turn;
  turn->RotateY(90.0);
  turn->Scale(2.0, 1.0, 1.0);
  half->SetTransform(turn);
  vtkNew<vtkSpatialOperation> object;
  object->SetOperationToIntersection();
  object->AddOperand(MakeOperand(3));
  object->AddOperand(half);
  double bounds[6];
  object->GetBounds(bounds);
  const double expected[6] = { 0.1, 0.5, -0.8, 0.2, -0.35, 0.65 };
  for (int side = 0; side < 6; ++side)
  {
    check.Near(bounds[side], expected[side], 1e-12, "a bound", 1.0);
  }
  object->SetOperationToUnion();
  object->GetBounds(bounds);
  check.That(bounds[0] == vtkMath::NegInf(), "a union with a half-space is unbounded");
  vtkNew<vtkSpatialOperation> nothing;
  nothing->SetOperationToIntersection();
  for (double x : { 0.0, 10.0 })
  {
    vtkNew<vtkSpatialPrimitive> sphere;
    sphere->SetCenter(x, 0.0, 0.0);
    nothing->AddOperand(sphere);
  }
  nothing->SetTransform(turn);
  nothing->GetBounds(bounds);
  check.That(bounds[0] > bounds[1], "bounds without operands");
}

void CheckRejections(Check& check)
{
  check.SetContext("refusals");
  vtkNew<vtkSpatialOperation> outer;
  vtkNew<vtkSpatialOperation> inner;
  vtkNew<vtkSpatialTurbulence> center;
  Sample sample;
  const double x[3] = { 0.0, 0.0, 0.0 };
  check.Contains(CaptureErrors(outer, [&] { outer->Evaluate(x, sample); }), "no operand");
  center->SetOperand(inner);
  outer->AddOperand(center);
  check.Contains(CaptureErrors(inner, [&] { inner->AddOperand(outer); }), "contains this");
  check.Contains(CaptureErrors(inner, [&] { inner->AddOperand(inner); }), "contains this");
  check.Contains(CaptureErrors(center, [&] { center->SetOperand(outer); }), "contains this");
  check.Contains(CaptureErrors(outer, [&] { outer->AddOperand(nullptr); }), "null");
  check.Equal(inner->GetNumberOfOperands(), 0, "number of operands after rejections");
  check.Contains(CaptureErrors(outer, [&] { outer->Evaluate(x, sample); }), "no operand");
  // An object may be used in several operations.
  vtkNew<vtkSpatialPrimitive> shared;
  inner->AddOperand(shared);
  inner->AddOperand(shared);
  inner->SetOperationToBlend();
  outer->Evaluate(x, sample);
  check.Near(sample.Density, 1.0, 0.0, "an operand twice");
  shared->SetDensity(0.25);
  center->SetAmplitude(0.0);
  outer->Evaluate(x, sample);
  check.Near(sample.Density, 0.5, 0.0, "modifying an operand modifies the operation");
  check.That(outer->GetOperand(0) == center && outer->GetOperand(1) == nullptr &&
      outer->GetOperand(-1) == nullptr,
    "operands by index");
  outer->RemoveAllOperands();
  check.Equal(outer->GetNumberOfOperands(), 0, "number of operands after removal");
  outer->AddOperand(inner);
  outer->SetOperation(99);
  CheckPrinted(Print(outer), { "Operation: trim", "Operation: blend", "Shape: sphere" }, check);
}

}

int TestSpatialOperation(int, char*[])
{
  return RunChecks({ CheckDefinitions, CheckSolids, CheckNestedDifference, CheckSpans, CheckBounds,
    CheckRejections });
}
