// SPDX-License-Identifier: BSD-3-Clause
#include "vtkInterlumeReport.h"

#include "vtkDataArray.h"
#include "vtkIdTypeArray.h"
#include "vtkObjectFactory.h"
#include "vtkStringArray.h"

#include <cmath>
#include <limits>
#include <sstream>

vtkStandardNewMacro(vtkInterlumeReport);

vtkInterlumeReport::vtkInterlumeReport() = default;
vtkInterlumeReport::~vtkInterlumeReport() = default;

vtkIdType vtkInterlumeReport::GetSize(const std::string& name)
{
  vtkAbstractArray* values = this->GetAbstractArray(name.c_str());
  return values ? values->GetNumberOfValues() : 0;
}

double vtkInterlumeReport::GetNumber(const std::string& name, vtkIdType entry)
{
  vtkDataArray* values = this->GetArray(name.c_str());
  if (!values || entry < 0 || entry >= values->GetNumberOfValues())
  {
    vtkErrorMacro("The report has no numeric value \"" << name << "\", or the value has no entry "
                                                       << entry << ".");
    return std::numeric_limits<double>::quiet_NaN();
  }
  const int components = values->GetNumberOfComponents();
  return values->GetComponent(entry / components, static_cast<int>(entry % components));
}

vtkIdType vtkInterlumeReport::GetCount(const std::string& name, vtkIdType entry)
{
  const double number = this->GetNumber(name, entry);
  return std::isfinite(number) ? static_cast<vtkIdType>(number) : -1;
}

std::string vtkInterlumeReport::GetText(const std::string& name, vtkIdType entry)
{
  auto* values = vtkStringArray::SafeDownCast(this->GetAbstractArray(name.c_str()));
  if (!values || entry < 0 || entry >= values->GetNumberOfValues())
  {
    vtkErrorMacro("The report has no text value \"" << name << "\", or the value has no entry "
                                                    << entry << ".");
    return {};
  }
  return values->GetValue(entry);
}

bool vtkInterlumeReport::IsEqual(vtkInterlumeReport* other)
{
  const auto print = [](vtkInterlumeReport* report)
  {
    std::ostringstream text;
    text.precision(std::numeric_limits<double>::max_digits10);
    report->PrintSelf(text, vtkIndent());
    return text.str();
  };
  return other && print(this) == print(other);
}

void vtkInterlumeReport::PrintSelf(ostream& os, vtkIndent indent)
{
  for (int i = 0; i < this->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* values = this->GetAbstractArray(i);
    os << indent << values->GetName() << ":";
    for (vtkIdType entry = 0; entry < values->GetNumberOfValues(); ++entry)
    {
      if (auto* texts = vtkStringArray::SafeDownCast(values))
      {
        os << " " << texts->GetValue(entry);
      }
      else if (auto* counts = vtkIdTypeArray::SafeDownCast(values))
      {
        os << " " << counts->GetValue(entry);
      }
      else
      {
        os << " " << this->GetNumber(values->GetName(), entry);
      }
    }
    os << "\n";
  }
}
