// SPDX-License-Identifier: BSD-3-Clause
#include "pqReportPropertyWidget.h"

#include "pqCoreUtilities.h"
#include "vtkCommand.h"
#include "vtkOutputWindow.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"

#include <QLabel>
#include <QVBoxLayout>

#include <set>

namespace
{
/// Writes the text to the output window if it is the first one of the proxy.
void WriteOnce(vtkSMProxy* proxy, const QString& text)
{
  static std::set<vtkTypeUInt32> written;
  if (!text.isEmpty() && written.insert(proxy->GetGlobalID()).second)
  {
    const QString line = QString("%1: %2\n").arg(proxy->GetXMLLabel(), text);
    vtkOutputWindowDisplayText(line.toUtf8().constData());
  }
}
}

pqReportPropertyWidget::pqReportPropertyWidget(
  vtkSMProxy* proxy, vtkSMProperty* property, QWidget* parent)
  : Superclass(proxy, parent)
  , Text(new QLabel(this))
{
  this->setProperty(property);
  this->setShowLabel(false);
  this->Text->setObjectName("Text");
  this->Text->setWordWrap(true);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(this->Text);
  pqCoreUtilities::connect(proxy, vtkCommand::UpdateDataEvent, this, SLOT(updateText()));
  this->updateText();
}

pqReportPropertyWidget::~pqReportPropertyWidget() = default;

void pqReportPropertyWidget::updateText()
{
  const bool hasCommand = this->property()->GetCommand() != nullptr;
  if (hasCommand)
  {
    this->proxy()->UpdatePropertyInformation(this->property());
  }
  const QString text = vtkSMPropertyHelper(this->property()).GetAsString();
  this->Text->setText(text);
  this->Text->setVisible(!text.isEmpty());
  if (hasCommand)
  {
    WriteOnce(this->proxy(), text);
  }
}
