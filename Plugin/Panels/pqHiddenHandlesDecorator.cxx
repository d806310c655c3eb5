// SPDX-License-Identifier: BSD-3-Clause
#include "pqHiddenHandlesDecorator.h"

#include "pqInteractivePropertyWidget.h"

pqHiddenHandlesDecorator::pqHiddenHandlesDecorator(vtkPVXMLElement* xml, pqPropertyWidget* parent)
  : Superclass(xml, parent)
{
  if (auto* widget = qobject_cast<pqInteractivePropertyWidget*>(parent))
  {
    // The widget shows its handles when it is shown.
    widget->setWidgetVisible(false);
  }
}

pqHiddenHandlesDecorator::~pqHiddenHandlesDecorator() = default;
