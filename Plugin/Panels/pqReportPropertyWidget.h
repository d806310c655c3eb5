// SPDX-License-Identifier: BSD-3-Clause
#ifndef pqReportPropertyWidget_h
#define pqReportPropertyWidget_h

#include "pqPropertyWidget.h"

class QLabel;

/**
 * @class   pqReportPropertyWidget
 * @brief   shows the text of an information-only property in the properties panel
 *
 * The text is read again after each update of the proxy. If the property has a command, its first
 * text for each proxy also appears in the output window.
 */
class pqReportPropertyWidget : public pqPropertyWidget
{
  Q_OBJECT
  typedef pqPropertyWidget Superclass;

public:
  pqReportPropertyWidget(vtkSMProxy* proxy, vtkSMProperty* property, QWidget* parent = nullptr);
  ~pqReportPropertyWidget() override;

private Q_SLOTS:
  void updateText();

private:
  Q_DISABLE_COPY(pqReportPropertyWidget)

  QLabel* Text;
};

#endif
