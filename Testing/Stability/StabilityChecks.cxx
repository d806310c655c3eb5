// SPDX-License-Identifier: BSD-3-Clause
#include "StabilityChecks.h"

#include "Support/Checks/ReferenceMessages.h"

#include "vtkAlgorithm.h"
#include "vtkCommand.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkExecutive.h"
#include "vtkNew.h"
#include "vtkTestErrorObserver.h"

#include <sstream>

namespace stability
{

int RunCases(const std::string& test, const std::string& className, int argc, char* argv[],
  std::initializer_list<void (*)(StabilityCatalogue&)> tests)
{
  StabilityCatalogue catalogue(test, argc, argv);
  catalogue.SetClass(className);
  for (const auto run : tests)
  {
    run(catalogue);
  }
  return catalogue.GetExitCode();
}

Messages UpdateFilter(vtkAlgorithm* filter)
{
  vtkNew<vtkTest::ErrorObserver> observer;
  vtkObject* const objects[] = { filter, filter->GetExecutive() };
  for (vtkObject* object : objects)
  {
    object->AddObserver(vtkCommand::ErrorEvent, observer);
    object->AddObserver(vtkCommand::WarningEvent, observer);
  }
  filter->Update();
  for (vtkObject* object : objects)
  {
    object->RemoveObserver(observer);
  }
  return { reference::ToSingleLine(observer->GetErrorMessage()),
    reference::ToSingleLine(observer->GetWarningMessage()) };
}

bool IsEmpty(vtkAlgorithm* filter)
{
  for (int port = 0; port < filter->GetNumberOfOutputPorts(); ++port)
  {
    auto* output = vtkDataSet::SafeDownCast(filter->GetOutputDataObject(port));
    if (!output || output->GetNumberOfPoints() > 0)
    {
      return false;
    }
  }
  return true;
}

void ReportRejection(StabilityCatalogue& catalogue, vtkAlgorithm* filter, const std::string& name,
  const std::string& extreme, const std::vector<std::string>& words,
  const std::function<void()>& mend)
{
  const std::string errors = UpdateFilter(filter).Errors;
  bool isRefused = IsEmpty(filter);
  std::string expected = "an empty output and an error with";
  for (const std::string& part : words)
  {
    isRefused = isRefused && errors.find(part) != std::string::npos;
    expected += " \"" + part + '"';
  }
  mend();
  const bool isMended = UpdateFilter(filter).Errors.empty() && !IsEmpty(filter);
  catalogue.Check(name, extreme, expected + "; corrected, it works",
    (errors.empty() ? "no error" : errors) + (isMended ? "" : "; corrected, it does not work"),
    isRefused && isMended);
}

void ReportEmpty(StabilityCatalogue& catalogue, vtkAlgorithm* filter, const std::string& name,
  const std::string& extreme, const std::string& words)
{
  const Messages messages = UpdateFilter(filter);
  const bool isEmpty = IsEmpty(filter);
  catalogue.Check(name, extreme, "an empty output and a warning with \"" + words + "\"",
    (isEmpty ? "empty, " : "not empty, ") +
      (messages.Warnings.empty() ? "no warning" : messages.Warnings) + messages.Errors,
    isEmpty && messages.Errors.empty() && messages.Warnings.find(words) != std::string::npos);
}

double CountOutside(vtkDataArray* array, double lower, double upper)
{
  if (!array || array->GetNumberOfValues() == 0)
  {
    return NaN;
  }
  vtkIdType number = 0;
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    for (int c = 0; c < array->GetNumberOfComponents(); ++c)
    {
      const double value = array->GetComponent(i, c);
      number += value >= lower && value <= upper ? 0 : 1;
    }
  }
  return static_cast<double>(number);
}

std::string FormatShort(double value)
{
  std::ostringstream text;
  text << value;
  return text.str();
}

}
