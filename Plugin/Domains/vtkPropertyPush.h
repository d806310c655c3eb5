#ifndef vtkPropertyPush_h
#define vtkPropertyPush_h

class vtkSMProperty;

/**
 * @class   vtkPropertyPush
 * @brief   what a domain needs to change the property it is on
 */
class vtkPropertyPush
{
public:
  /// Whether a property has values that wait for Apply.
  static bool IsPending(vtkSMProperty* property);

  /// Sends a property's values to the server where its proxy is there already: a script that sets
  /// one property sends only that.
  static void Push(vtkSMProperty* property);
};

#endif
