// SPDX-License-Identifier: BSD-3-Clause
#ifndef MakeReader_h
#define MakeReader_h

#include <vtkAlgorithm.h>
#include <vtkDataSetReader.h>
#include <vtkSmartPointer.h>
#include <vtkXMLGenericDataObjectReader.h>

#include <string>

/**
 * Returns a reader that matches the extension of a file: a legacy reader for .vtk, otherwise a
 * reader for VTK's XML formats (.vti, .vtr, .vts, .vtu, .vtm, ...). If the file cannot be read, the
 * pipeline reports an error when it runs.
 */
inline vtkSmartPointer<vtkAlgorithm> MakeReader(const std::string& path)
{
  if (path.size() > 4 && path.compare(path.size() - 4, 4, ".vtk") == 0)
  {
    auto reader = vtkSmartPointer<vtkDataSetReader>::New();
    reader->SetFileName(path.c_str());
    return reader;
  }
  auto reader = vtkSmartPointer<vtkXMLGenericDataObjectReader>::New();
  reader->SetFileName(path.c_str());
  return reader;
}

#endif
