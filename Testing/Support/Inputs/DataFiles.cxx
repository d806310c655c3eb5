// SPDX-License-Identifier: BSD-3-Clause
#include "Support/Inputs/DataFiles.h"

#include "vtkDataSet.h"
#include "vtkDataSetReader.h"
#include "vtkNew.h"
#include "vtkXMLGenericDataObjectReader.h"

#include <cstdlib>
#include <fstream>
#include <stdexcept>

namespace interlume
{
std::string DataFolder()
{
  const char* chosen = std::getenv("INTERLUME_DATA");
  return chosen && *chosen ? chosen : INTERLUME_SOURCE_DATA;
}

std::string DataFile(const std::string& name)
{
  return DataFolder() + "/" + name;
}

vtkSmartPointer<vtkDataObject> ReadDataObject(const std::string& path)
{
  if (!std::ifstream(path))
  {
    throw std::runtime_error("Cannot open the file " + path);
  }
  vtkSmartPointer<vtkDataObject> data;
  const std::string::size_type dot = path.rfind('.');
  if (dot != std::string::npos && path.substr(dot) == ".vtk")
  {
    vtkNew<vtkDataSetReader> reader;
    reader->SetFileName(path.c_str());
    reader->Update();
    data = reader->GetOutput();
  }
  else
  {
    vtkNew<vtkXMLGenericDataObjectReader> reader;
    reader->SetFileName(path.c_str());
    reader->Update();
    data = reader->GetOutput();
  }
  if (!data)
  {
    throw std::runtime_error("The file contains no dataset: " + path);
  }
  return data;
}

vtkSmartPointer<vtkDataSet> ReadData(const std::string& name)
{
  vtkSmartPointer<vtkDataSet> dataSet = vtkDataSet::SafeDownCast(ReadDataObject(DataFile(name)));
  if (!dataSet)
  {
    throw std::runtime_error(name + " is not a vtkDataSet.");
  }
  return dataSet;
}
}
