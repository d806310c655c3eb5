// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSMInputInitializationHelper.h"

#include "vtkCallbackCommand.h"
#include "vtkDataObject.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPVArrayInformation.h"
#include "vtkPVDataInformation.h"
#include "vtkPVXMLElement.h"
#include "vtkSMInputProperty.h"
#include "vtkSMParaViewPipelineController.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxyIterator.h"
#include "vtkSMSourceProxy.h"

#include <algorithm>

vtkStandardNewMacro(vtkSMInputInitializationHelper);

vtkSMInputInitializationHelper::vtkSMInputInitializationHelper() = default;
vtkSMInputInitializationHelper::~vtkSMInputInitializationHelper() = default;

namespace
{
/// An output port of a source.
struct Output
{
  vtkSMSourceProxy* Source = nullptr;
  unsigned int Port = 0;

  explicit Output(vtkSMProxy* proxy)
  {
    const vtkSMPropertyHelper input(proxy, "Input", /*quiet=*/true);
    if (input.GetNumberOfElements() > 0)
    {
      this->Source = vtkSMSourceProxy::SafeDownCast(input.GetAsProxy());
      this->Port = input.GetOutputPort();
    }
  }

  vtkPVDataInformation* GetInformation() const
  {
    return this->Source->GetDataInformation(this->Port);
  }
};

/// Hides all displays of the first output of \a source.
void HideFirstOutput(vtkSMSourceProxy* source)
{
  vtkNew<vtkSMProxyIterator> iterator;
  iterator->SetSession(source->GetSession());
  for (iterator->Begin("representations"); !iterator->IsAtEnd(); iterator->Next())
  {
    vtkSMProxy* display = iterator->GetProxy();
    const Output shown(display);
    if (shown.Source == source && shown.Port == 0 && display->GetProperty("Visibility"))
    {
      vtkSMPropertyHelper(display, "Visibility").Set(0);
      display->UpdateVTKObjects();
    }
  }
}

/// Called when the new filter was updated.
void FilterUpdated(vtkObject* caller, unsigned long, void* command, void*)
{
  auto* filter = vtkSMSourceProxy::SafeDownCast(caller);
  const Output input(filter);
  if (input.Source && filter->GetDataInformation(0)->GetNumberOfPoints() > 0)
  {
    filter->RemoveObserver(static_cast<vtkCommand*>(command));
    if (input.Port != 0)
    {
      HideFirstOutput(input.Source);
    }
  }
}

void SelectOutput(vtkSMProxy* filter, const char* name)
{
  const Output input(filter);
  if (!input.Source || input.Port != 0)
  {
    return;
  }
  input.Source->CreateOutputPorts();
  const unsigned int port = input.Source->GetOutputPortIndex(name);
  if (port > 0 && port < input.Source->GetNumberOfOutputPorts())
  {
    vtkSMPropertyHelper(filter, "Input").Set(input.Source, port);
    filter->UpdateVTKObjects();
    vtkNew<vtkCallbackCommand> command;
    command->SetCallback(FilterUpdated);
    command->SetClientData(command);
    filter->AddObserver(vtkCommand::UpdateDataEvent, command);
  }
}

void SelectField(vtkSMProxy* filter, vtkPVXMLElement* xml)
{
  auto* field = vtkSMInputProperty::SafeDownCast(filter->GetProperty(xml->GetAttribute("field")));
  if (!field || field->GetNumberOfProxies() > 0)
  {
    return;
  }
  Output found(filter);
  for (; found.Source; found = Output(found.Source))
  {
    field->SetUncheckedInputConnection(0, found.Source, found.Port);
    const bool isSuitable = field->IsInDomains() != 0;
    field->RemoveAllUncheckedProxies();
    if (isSuitable)
    {
      break;
    }
  }
  if (!found.Source)
  {
    return;
  }
  field->SetInputConnection(0, found.Source, found.Port);
  vtkSMProperty* array = filter->GetProperty(xml->GetAttributeOrEmpty("array"));
  const char* selected = array ? vtkSMPropertyHelper(array).GetInputArrayNameToProcess() : "";
  if (array && (!selected || !*selected))
  {
    array->ResetToDomainDefaults();
  }
  filter->UpdateVTKObjects();
}

void SelectTime(vtkSMProxy* filter, vtkPVXMLElement* xml, vtkMTimeType start)
{
  vtkSMProperty* property = filter->GetProperty(xml->GetAttribute("time"));
  vtkNew<vtkSMParaViewPipelineController> controller;
  vtkSMProxy* keeper = controller->FindTimeKeeper(filter->GetSession());
  if (!property || !keeper || property->GetMTime() > start)
  {
    return;
  }
  double time = vtkSMPropertyHelper(keeper, "Time").GetAsDouble();
  for (Output output(filter); output.Source; output = Output(output.Source))
  {
    vtkPVDataInformation* information = output.GetInformation();
    vtkPVArrayInformation* times =
      information->GetArrayInformation(xml->GetAttribute("time"), vtkDataObject::POINT);
    const double* range = times ? times->GetComponentFiniteRange(0) : information->GetTimeRange();
    if (range[0] <= range[1] && range[0] > -VTK_DOUBLE_MAX && range[1] < VTK_DOUBLE_MAX)
    {
      time = std::clamp(time, range[0], range[1]);
      break;
    }
  }
  // Setting the time turns the toggle off.
  vtkSMPropertyHelper toggle(filter, xml->GetAttributeOrEmpty("toggle"), /*quiet=*/true);
  const int isOn = toggle.GetNumberOfElements() > 0 ? toggle.GetAsInt() : 0;
  vtkSMPropertyHelper(property).Set(time);
  if (isOn)
  {
    toggle.Set(isOn);
  }
  filter->UpdateVTKObjects();
}
}

void vtkSMInputInitializationHelper::PostInitializeProxy(
  vtkSMProxy* proxy, vtkPVXMLElement* xml, vtkMTimeType initializationTimeStamp)
{
  if (const char* output = xml->GetAttribute("output"))
  {
    SelectOutput(proxy, output);
  }
  if (xml->GetAttribute("field"))
  {
    SelectField(proxy, xml);
  }
  if (xml->GetAttribute("time"))
  {
    SelectTime(proxy, xml, initializationTimeStamp);
  }
}
