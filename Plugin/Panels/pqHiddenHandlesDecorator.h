// SPDX-License-Identifier: BSD-3-Clause
#ifndef pqHiddenHandlesDecorator_h
#define pqHiddenHandlesDecorator_h

#include "pqPropertyWidgetDecorator.h"

/**
 * @class   pqHiddenHandlesDecorator
 * @brief   hides the handles of a property widget until the widget itself is shown
 *
 * ParaView's widgets with handles in the view show them when they are created, even if another
 * decorator hides the widget, for example because the feature is off.
 */
class pqHiddenHandlesDecorator : public pqPropertyWidgetDecorator
{
  Q_OBJECT
  typedef pqPropertyWidgetDecorator Superclass;

public:
  pqHiddenHandlesDecorator(vtkPVXMLElement* xml, pqPropertyWidget* parent);
  ~pqHiddenHandlesDecorator() override;

private:
  Q_DISABLE_COPY(pqHiddenHandlesDecorator)
};

#endif
