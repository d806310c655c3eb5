// SPDX-License-Identifier: BSD-3-Clause
#include "FuzzRun.h"

#include "Support/Checks/ReferenceCheck.h"
#include "Support/Checks/ReferenceThreads.h"

#include "vtkAlgorithm.h"
#include "vtkCell.h"
#include "vtkCellData.h"
#include "vtkDataSet.h"
#include "vtkGenericDataObjectWriter.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOutputWindow.h"
#include "vtkPointData.h"
#include "vtkSMPTools.h"

namespace fuzz
{

class Messages::Window : public vtkOutputWindow
{
public:
  static Window* New();
  vtkTypeMacro(Window, vtkOutputWindow);

  void DisplayText(const char* text) override { this->Text += text; }
  void DisplayErrorText(const char* text) override { this->Text += text; }
  void DisplayWarningText(const char* text) override { this->Text += text; }
  void DisplayGenericWarningText(const char* text) override { this->Text += text; }

  std::string Text;
  vtkSmartPointer<vtkOutputWindow> Former;
};

vtkStandardNewMacro(Messages::Window);

Messages::Messages()
  : Collected(vtkSmartPointer<Window>::New())
{
  this->Collected->Former = vtkOutputWindow::GetInstance();
  vtkOutputWindow::SetInstance(this->Collected);
}

Messages::~Messages()
{
  vtkOutputWindow::SetInstance(this->Collected->Former);
}

const std::string& Messages::GetText() const
{
  return this->Collected->Text;
}

std::string BytesOf(vtkDataObject* data)
{
  if (!data)
  {
    return "none";
  }
  vtkNew<vtkGenericDataObjectWriter> writer;
  writer->SetInputData(data);
  writer->SetFileTypeToBinary();
  writer->WriteToOutputStringOn();
  writer->Write();
  return { writer->GetOutputString(), static_cast<std::size_t>(writer->GetOutputStringLength()) };
}

std::string BytesOf(vtkAlgorithm* filter)
{
  std::string bytes;
  for (int port = 0; port < filter->GetNumberOfOutputPorts(); ++port)
  {
    bytes += BytesOf(filter->GetOutputDataObject(port));
  }
  return bytes;
}

namespace
{

void CheckArrays(vtkFieldData* arrays, vtkIdType count, reference::Check& check)
{
  for (int i = 0; i < arrays->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* array = arrays->GetAbstractArray(i);
    check.Equal(array->GetNumberOfTuples(), count,
      std::string("values of ") + (array->GetName() ? array->GetName() : "an unnamed array"));
  }
}

void CheckDataSet(vtkDataSet* data, reference::Check& check)
{
  CheckArrays(data->GetPointData(), data->GetNumberOfPoints(), check);
  CheckArrays(data->GetCellData(), data->GetNumberOfCells(), check);
  vtkNew<vtkIdList> ids;
  bool areValid = true;
  for (vtkIdType cell = 0; cell < data->GetNumberOfCells(); ++cell)
  {
    data->GetCellPoints(cell, ids);
    for (vtkIdType i = 0; i < ids->GetNumberOfIds(); ++i)
    {
      areValid = areValid && ids->GetId(i) >= 0 && ids->GetId(i) < data->GetNumberOfPoints();
    }
  }
  check.That(areValid, "all point ids of cells are valid");
}

}

std::string CheckRun(const std::function<vtkSmartPointer<vtkAlgorithm>()>& make, bool isExplained,
  reference::Check& check)
{
  std::string expected;
  std::string text;
  for (const int threads : { 1, 3 })
  {
    vtkSMPTools::SetBackend(threads == 1 ? "Sequential" : "STDThread");
    reference::SetThreads(threads);
    Messages messages;
    const vtkSmartPointer<vtkAlgorithm> filter = make();
    filter->Update();
    text = messages.GetText();
    const std::string bytes = BytesOf(filter);
    if (threads == 1)
    {
      expected = bytes;
      for (int port = 0; port < filter->GetNumberOfOutputPorts(); ++port)
      {
        if (auto* output = vtkDataSet::SafeDownCast(filter->GetOutputDataObject(port)))
        {
          CheckDataSet(output, check);
        }
      }
      auto* output = vtkDataSet::SafeDownCast(filter->GetOutputDataObject(0));
      if (isExplained && (!output || output->GetNumberOfCells() == 0))
      {
        check.That(!text.empty(), "an empty output comes with a message");
      }
    }
    else
    {
      check.That(bytes == expected, "the output with three threads equals the output with one");
    }
  }
  vtkSMPTools::SetBackend("Sequential");
  return text;
}

}
