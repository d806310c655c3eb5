// SPDX-License-Identifier: BSD-3-Clause
#ifndef DataFiles_h
#define DataFiles_h

#include "vtkSmartPointer.h"

#include <string>

class vtkDataObject;
class vtkDataSet;

/**
 * Where the real data of the project lies, and how it is read.
 */
namespace interlume
{
/**
 * The folder Data/: the environment variable INTERLUME_DATA where set, else that of the source tree
 * the program was built from. Without a slash at the end.
 */
std::string DataFolder();

/**
 * The path of a file in DataFolder().
 */
std::string DataFile(const std::string& name);

/**
 * Reads a VTK file of the XML kinds (.vti, .vtr, .vts, .vtu, .vtm ...) or the legacy kind (.vtk).
 * @throw std::runtime_error that names the file when it can't be read.
 */
vtkSmartPointer<vtkDataObject> ReadDataObject(const std::string& path);

/**
 * Reads \a name from DataFolder().
 * @throw std::runtime_error that names the file when it can't be read or is no vtkDataSet.
 */
vtkSmartPointer<vtkDataSet> ReadData(const std::string& name);
}

#endif
