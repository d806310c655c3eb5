#include "ReferenceMessages.h"

#include "vtkAlgorithm.h"
#include "vtkCommand.h"
#include "vtkExecutive.h"
#include "vtkNew.h"
#include "vtkTestErrorObserver.h"

std::string reference::MessagesOf(vtkAlgorithm* filter)
{
  vtkNew<vtkTest::ErrorObserver> observer;
  filter->AddObserver(vtkCommand::ErrorEvent, observer);
  filter->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, observer);
  filter->Update();
  filter->RemoveObserver(observer);
  filter->GetExecutive()->RemoveObserver(observer);
  return observer->GetErrorMessage();
}
