// SPDX-License-Identifier: BSD-3-Clause
#ifndef pqAreaLightPropertyWidget_h
#define pqAreaLightPropertyWidget_h

#include "pqInteractivePropertyWidget.h"

class QGridLayout;

/**
 * @class   pqAreaLightPropertyWidget
 * @brief   places an area light, by handles in the view and by numbers
 *
 * The widget is for a group of properties with the functions WorldPosition, FocalPoint and ViewUp,
 * of three elements, Width and Height, of one, and Shape, an enumeration. It shows fields for all
 * of them and a box that switches the handles of vtkAreaLightRepresentation on and off.
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

  /// Add a row for a property of the group, with its label and its text as a tool tip.
  void addNumbers(QGridLayout* layout, const char* function);
  void addChoice(QGridLayout* layout, const char* function);
  void addLabel(QGridLayout* layout, vtkSMProperty* property);
};

#endif
