// SPDX-License-Identifier: BSD-3-Clause
#ifndef DataFiles_h
#define DataFiles_h

#include "vtkSmartPointer.h"

#include <string>

class vtkDataObject;
class vtkDataSet;

/**
 * Finds and reads the files in Data/.
 */
namespace interlume
{
/**
 * Returns the data directory without a trailing slash: the value of the environment variable
 * INTERLUME_DATA if it is set, otherwise Data/ in the source tree.
 */
std::string DataFolder();

/**
 * Returns the path of a file in DataFolder().
 */
std::string DataFile(const std::string& name);

/**
 * Reads a VTK XML file (.vti, .vtr, .vts, .vtu, .vtm ...) or a legacy file (.vtk).
 * @throw std::runtime_error with the path if the file cannot be read.
 */
vtkSmartPointer<vtkDataObject> ReadDataObject(const std::string& path);

/**
 * Reads the file \a name in DataFolder().
 * @throw std::runtime_error with the file's name if it cannot be read or is not a vtkDataSet.
 */
vtkSmartPointer<vtkDataSet> ReadData(const std::string& name);
}

#endif
