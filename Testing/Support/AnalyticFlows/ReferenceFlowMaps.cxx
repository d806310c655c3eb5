// SPDX-License-Identifier: BSD-3-Clause
#include "Support/AnalyticFlows/ReferenceFlowMaps.h"

#include "Support/Arrays/ReferenceIndices.h"
#include "Support/Arrays/ReferenceVector.h"

#include "vtkCellArray.h"
#include "vtkDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>

namespace reference
{

namespace
{

FlowVector UnitVector(const FlowVector& a)
{
  return (1.0 / std::sqrt(Dot(a, a))) * a;
}

FlowMatrix Product(const FlowMatrix& a, const FlowMatrix& b)
{
  FlowMatrix product{};
  for (const auto& [i, j, k] : AllIndices(3, 3, 3))
  {
    product[3 * i + j] += a[3 * i + k] * b[3 * k + j];
  }
  return product;
}

}

FlowVector Multiply(const FlowMatrix& matrix, const FlowVector& x)
{
  FlowVector product;
  for (int i = 0; i < 3; ++i)
  {
    product[i] = matrix[3 * i] * x[0] + matrix[3 * i + 1] * x[1] + matrix[3 * i + 2] * x[2];
  }
  return product;
}

FlowMatrix CrossMatrix(const FlowVector& a)
{
  return { { 0.0, -a[2], a[1], a[2], 0.0, -a[0], -a[1], a[0], 0.0 } };
}

// Halves the matrix until its Taylor series converges quickly, then squares the sum as many times.
FlowMatrix Exponential(const FlowMatrix& matrix)
{
  double size = 0.0;
  for (double entry : matrix)
  {
    size += std::abs(entry);
  }
  const int halvings = size > 0.5 ? 1 + std::ilogb(2.0 * size) : 0;
  FlowMatrix part = matrix;
  for (double& entry : part)
  {
    entry = std::ldexp(entry, -halvings);
  }
  FlowMatrix sum = { { 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0 } };
  FlowMatrix power = sum;
  for (int n = 1; n < 20; ++n)
  {
    power = Product(power, part);
    power *= 1.0 / n;
    sum += power;
  }
  for (int i = 0; i < halvings; ++i)
  {
    sum = Product(sum, sum);
  }
  return sum;
}

FlowVector MapLinear(
  const FlowVector& x, const FlowVector& center, const FlowMatrix& matrix, double t)
{
  FlowMatrix scaled = matrix;
  scaled *= t;
  return center + Multiply(Exponential(scaled), x - center);
}

FlowVector MapUniform(const FlowVector& x, const FlowVector& velocity, double t)
{
  return x + t * velocity;
}

FlowVector MapRotation(const FlowVector& x, const FlowVector& center, const FlowVector& axis,
  double angularVelocity, double t)
{
  const FlowVector a = UnitVector(axis);
  const FlowVector offset = x - center;
  const double angle = angularVelocity * t;
  return center + std::cos(angle) * offset + std::sin(angle) * Cross(a, offset) +
    (Dot(a, offset) * (1.0 - std::cos(angle))) * a;
}

FlowVector MapSaddle(
  const FlowVector& x, const FlowVector& center, const FlowVector& rates, double t)
{
  FlowVector result;
  for (int i = 0; i < 3; ++i)
  {
    result[i] = center[i] + std::exp(rates[i] * t) * (x[i] - center[i]);
  }
  return result;
}

FlowVector MapNode(const FlowVector& x, const FlowVector& center, const FlowVector& rates,
  const FlowVector& axis, double swirl, double t)
{
  FlowMatrix matrix = CrossMatrix(swirl * UnitVector(axis));
  for (int i = 0; i < 3; ++i)
  {
    matrix[4 * i] = rates[i];
  }
  return MapLinear(x, center, matrix, t);
}

FlowVector MapShear(const FlowVector& x, const FlowVector& center, const FlowVector& normal,
  const FlowVector& velocity, double thickness, double t)
{
  const FlowVector n = UnitVector(normal);
  const FlowVector across = velocity - Dot(velocity, n) * n;
  return x + (t * std::tanh(Dot(n, x - center) / thickness)) * across;
}

void SetVelocity(vtkDataSet* data, const FlowFunction& function)
{
  vtkNew<vtkDoubleArray> velocity;
  velocity->SetName("Velocity");
  velocity->SetNumberOfComponents(3);
  velocity->SetNumberOfTuples(data->GetNumberOfPoints());
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    FlowVector x;
    data->GetPoint(i, x.data());
    velocity->SetTuple(i, function(x).data());
  }
  data->GetPointData()->SetVectors(velocity);
}

std::string GetBytes(vtkPolyData* data)
{
  std::string bytes;
  const auto add = [&bytes](vtkDataArray* array)
  {
    if (array)
    {
      bytes += array->GetName() ? array->GetName() : "";
      bytes.append(static_cast<const char*>(array->GetVoidPointer(0)),
        array->GetNumberOfValues() * array->GetDataTypeSize());
    }
  };
  add(data->GetPoints() ? data->GetPoints()->GetData() : nullptr);
  for (vtkCellArray* cells : { data->GetVerts(), data->GetLines() })
  {
    add(cells->GetOffsetsArray());
    add(cells->GetConnectivityArray());
  }
  for (int i = 0; i < data->GetPointData()->GetNumberOfArrays(); ++i)
  {
    add(data->GetPointData()->GetArray(i));
  }
  return bytes;
}

}
