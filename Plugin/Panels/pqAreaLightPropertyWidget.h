// SPDX-License-Identifier: BSD-3-Clause
#ifndef pqAreaLightPropertyWidget_h
#define pqAreaLightPropertyWidget_h

#include "pqInteractivePropertyWidget.h"

class QGridLayout;

/**
 * @class   pqAreaLightPropertyWidget
 * @brief   edits an area light with handles in the view and with input fields
 *
 * Use it for a group of properties with the functions WorldPosition, FocalPoint and ViewUp (three
 * elements), Width and Height (one element), and Shape (an enumeration). The widget has an input
 * field for each property and a check box that shows the handles of vtkAreaLightRepresentation.
 */
class pqAreaLightPropertyWidget : public pqInteractivePropertyWidget
{
  Q_OBJECT
  typedef pqInteractivePropertyWidget Superclass;

public:
  pqAreaLightPropertyWidget(
    vtkSMProxy* proxy, vtkSMPropertyGroup* group, QWidget* parent = nullptr);
  ~pqAreaLightPropertyWidget() override;

protected Q_SLOTS:
  void placeWidget() override {}

private:
  Q_DISABLE_COPY(pqAreaLightPropertyWidget)

  /// Adds a row of number fields for a property of the group. Its documentation is the tooltip of
  /// its label.
  void addNumbers(QGridLayout* layout, const char* function);
  void addChoice(QGridLayout* layout, const char* function);
  void addLabel(QGridLayout* layout, vtkSMProperty* property);
};

#endif
