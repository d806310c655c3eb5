#ifndef vtkColorArrayChoice_h
#define vtkColorArrayChoice_h

#include <string>

class vtkSMPVRepresentationProxy;

/**
 * @class   vtkColorArrayChoice
 * @brief   chooses the array that a display colours by where none is given
 *
 * One of those that its list of arrays offers: numbers, of points or cells.
 */
class vtkColorArrayChoice
{
public:
  explicit vtkColorArrayChoice(vtkSMPVRepresentationProxy* display);

  /// Whether there is one.
  bool IsFound() const { return !this->Name.empty(); }

  std::string Name;
  /// vtkDataObject::POINT or CELL.
  int Association = 0;
};

#endif
