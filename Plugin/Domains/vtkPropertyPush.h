// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkPropertyPush_h
#define vtkPropertyPush_h

class vtkSMProperty;

/**
 * @class   vtkPropertyPush
 * @brief   sends changes of a property that a domain makes
 */
class vtkPropertyPush
{
public:
  /// Returns whether a property has values that wait for Apply.
  static bool IsPending(vtkSMProperty* property);

  /// Sends a property's values to the server where its proxy is there already: a script that sets
  /// one property sends only that.
  static void Push(vtkSMProperty* property);
};

#endif
