// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkColorArrayChoice_h
#define vtkColorArrayChoice_h

#include <string>

class vtkSMPVRepresentationProxy;

/**
 * @class   vtkColorArrayChoice
 * @brief   chooses the array that a display colours by where none is given
 *
 * It is one of those that the display's list of arrays offers: numbers, of points or cells.
 */
class vtkColorArrayChoice
{
public:
  explicit vtkColorArrayChoice(vtkSMPVRepresentationProxy* display);

  /// Returns whether there is an array to colour by.
  bool IsFound() const { return !this->Name.empty(); }

  std::string Name;
  /// The association of the array, vtkDataObject::POINT or CELL.
  int Association = 0;
};

#endif
