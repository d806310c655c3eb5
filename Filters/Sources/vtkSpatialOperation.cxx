// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSpatialOperation.h"

#include "vtkObjectFactory.h"

#include <algorithm>

vtkStandardNewMacro(vtkSpatialOperation);

const char* vtkSpatialOperation::GetOperationName(int operation)
{
  static const char* const names[NUMBER_OF_OPERATIONS] = { "union", "intersection", "difference",
    "blend", "cap", "trim" };
  return operation >= 0 && operation < NUMBER_OF_OPERATIONS ? names[operation] : nullptr;
}

void vtkSpatialOperation::AddOperand(vtkSpatialObject* operand)
{
  if (!operand)
  {
    vtkErrorMacro("AddOperand: the operand is null and was ignored. Pass a vtkSpatialObject.");
    return;
  }
  if (operand->Contains(this))
  {
    vtkErrorMacro("AddOperand: the operand contains this vtkSpatialOperation and was ignored. Pass "
                  "an object that does not contain it.");
    return;
  }
  this->Operands.emplace_back(operand);
  this->Modified();
}

void vtkSpatialOperation::RemoveAllOperands()
{
  if (!this->Operands.empty())
  {
    this->Operands.clear();
    this->Modified();
  }
}

vtkSpatialObject* vtkSpatialOperation::GetOperand(int index) const
{
  return index >= 0 && index < this->GetNumberOfOperands() ? this->Operands[index] : nullptr;
}

bool vtkSpatialOperation::Contains(const vtkSpatialObject* object) const
{
  return object == this ||
    std::any_of(this->Operands.begin(), this->Operands.end(),
      [object](const auto& operand) { return operand->Contains(object); });
}

vtkMTimeType vtkSpatialOperation::GetMTime()
{
  vtkMTimeType time = this->Superclass::GetMTime();
  for (const auto& operand : this->Operands)
  {
    time = std::max(time, operand->GetMTime());
  }
  return time;
}

std::string vtkSpatialOperation::Prepare(double bounds[6])
{
  if (this->Operands.empty())
  {
    return std::string("A vtkSpatialOperation (") + GetOperationName(this->Operation) +
      ") has no operand. Call AddOperand.";
  }
  for (std::size_t i = 0; i < this->Operands.size(); ++i)
  {
    std::string error = this->Operands[i]->Update();
    if (!error.empty())
    {
      return error;
    }
    double box[6];
    this->Operands[i]->GetBounds(box);
    for (int side = 0; side < 6; ++side)
    {
      const bool isLower = side % 2 == 0;
      if (i == 0)
      {
        bounds[side] = box[side];
      }
      else if (this->Operation == UNION || this->Operation == BLEND)
      {
        bounds[side] =
          isLower ? std::min(bounds[side], box[side]) : std::max(bounds[side], box[side]);
      }
      else if (this->Operation == INTERSECTION || this->Operation == TRIM)
      {
        bounds[side] =
          isLower ? std::max(bounds[side], box[side]) : std::min(bounds[side], box[side]);
      }
    }
  }
  return "";
}

void vtkSpatialOperation::Combine(Sample& a, const Sample& b) const
{
  switch (this->Operation)
  {
    case UNION:
      if (b.Density > a.Density)
      {
        a = b;
      }
      break;
    case INTERSECTION:
    {
      const double density = std::min(a.Density, b.Density);
      if (b.Density > a.Density)
      {
        a = b;
      }
      a.Density = density;
      break;
    }
    case DIFFERENCE:
      a.Density = std::max(0.0, a.Density - b.Density);
      break;
    case BLEND:
      if (b.Density > 0.0)
      {
        const double sum = a.Density + b.Density;
        for (int i = 0; i < 3; ++i)
        {
          a.Color[i] = (a.Density * a.Color[i] + b.Density * b.Color[i]) / sum;
        }
        a.Density = std::min(1.0, sum);
      }
      break;
    case CAP:
      a.Density = b.Density < a.Density ? a.Density : 0.0;
      break;
    default:
      a.Density = b.Density >= a.Density ? a.Density : 0.0;
      break;
  }
}

bool vtkSpatialOperation::EvaluateLocally(
  const double (*points)[3], int number, Sample* samples) const
{
  bool isAny = this->Operands.front()->EvaluateSpan(points, number, samples);
  const bool adds = this->Operation == UNION || this->Operation == BLEND;
  const bool keeps = this->Operation != INTERSECTION && this->Operation != TRIM;
  for (std::size_t i = 1; i < this->Operands.size() && (isAny || adds); ++i)
  {
    const vtkSpatialObject* operand = this->Operands[i];
    if (!isAny)
    {
      isAny = operand->EvaluateSpan(points, number, samples);
      continue;
    }
    Sample others[SpanLength];
    if (operand->EvaluateSpan(points, number, others))
    {
      for (int j = 0; j < number; ++j)
      {
        this->Combine(samples[j], others[j]);
      }
    }
    else if (!keeps)
    {
      return false;
    }
  }
  return isAny;
}

void vtkSpatialOperation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Operation: " << GetOperationName(this->Operation) << "\n";
  os << indent << "Number of operands: " << this->Operands.size() << "\n";
  for (const auto& operand : this->Operands)
  {
    operand->PrintSelf(os, indent.GetNextIndent());
  }
}
