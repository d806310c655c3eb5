// SPDX-License-Identifier: BSD-3-Clause
#include "Support/Checks/ReferenceMessages.h"

#include "vtkAlgorithm.h"
#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkDataSet.h"
#include "vtkExecutive.h"
#include "vtkNew.h"
#include "vtkTestErrorObserver.h"

#include <algorithm>
#include <iostream>

std::string reference::UpdateAndGetErrors(vtkAlgorithm* filter)
{
  vtkNew<vtkTest::ErrorObserver> observer;
  filter->AddObserver(vtkCommand::ErrorEvent, observer);
  filter->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, observer);
  filter->Update();
  filter->RemoveObserver(observer);
  filter->GetExecutive()->RemoveObserver(observer);
  return observer->GetErrorMessage();
}

std::string reference::CaptureErrors(vtkObject* object, const std::function<void()>& act)
{
  vtkNew<vtkTest::ErrorObserver> observer;
  object->AddObserver(vtkCommand::ErrorEvent, observer);
  act();
  object->RemoveObserver(observer);
  return ToSingleLine(observer->GetErrorMessage());
}

std::string reference::ToSingleLine(const std::string& message)
{
  const std::size_t words = message.find("): ");
  std::string line = words == std::string::npos ? message : message.substr(words + 3);
  std::replace(line.begin(), line.end(), '\n', ' ');
  line.erase(line.find_last_not_of(' ') + 1);
  return line;
}

std::string reference::WarningsOf(vtkAlgorithm* filter)
{
  vtkNew<vtkTest::ErrorObserver> observer;
  filter->AddObserver(vtkCommand::WarningEvent, observer);
  filter->Update();
  filter->RemoveObserver(observer);
  return observer->GetWarningMessage();
}

void reference::UpdateAndCheckWarnings(vtkAlgorithm* filter)
{
  const std::string warnings = WarningsOf(filter);
  const bool isReported = warnings.find("The output is empty: ") != std::string::npos;
  const bool isOnlyReported = isReported && warnings.find("Warning:", 1) == std::string::npos;
  auto* output = vtkDataSet::SafeDownCast(filter->GetOutputDataObject(0));
  const bool isEmpty = output && output->GetNumberOfCells() == 0;
  if (isEmpty != isReported || (!warnings.empty() && !isOnlyReported))
  {
    std::cerr << " WARN| an output " << (isEmpty ? "without cells" : "with cells")
              << " and the warnings: " << warnings << "\n";
  }
}

void reference::AllowWarnings(vtkAlgorithm* filter)
{
  vtkNew<vtkCallbackCommand> nothing;
  filter->AddObserver(vtkCommand::WarningEvent, nothing);
}
