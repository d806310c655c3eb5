// SPDX-License-Identifier: BSD-3-Clause
#include "pqAreaLightPropertyWidget.h"

#include "pqComboBoxDomain.h"
#include "pqDoubleLineEdit.h"
#include "pqSignalAdaptors.h"
#include "vtkSMEnumerationDomain.h"
#include "vtkSMPropertyGroup.h"
#include "vtkSMVectorProperty.h"

#include <QCheckBox>
#include <QComboBox>
#include <QGridLayout>
#include <QLabel>

namespace
{
constexpr int Columns = 4;
}

pqAreaLightPropertyWidget::pqAreaLightPropertyWidget(
  vtkSMProxy* proxy, vtkSMPropertyGroup* group, QWidget* parent)
  : Superclass("representations", "InterlumeAreaLightWidget", proxy, group, parent)
{
  auto* layout = new QGridLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  auto* show = new QCheckBox(tr("Show handles"), this);
  show->setObjectName("show3DWidget");
  show->setToolTip(
    tr("Show handles in the view to drag the light's center, focal point, width and height"));
  layout->addWidget(show, 0, 0, 1, Columns);
  this->addChoice(layout, "Shape");
  for (const char* function : { "WorldPosition", "FocalPoint", "ViewUp", "Width", "Height" })
  {
    this->addNumbers(layout, function);
  }
  this->connect(show, SIGNAL(toggled(bool)), SLOT(setWidgetVisible(bool)));
  show->connect(this, SIGNAL(widgetVisibilityToggled(bool)), SLOT(setChecked(bool)));
}

pqAreaLightPropertyWidget::~pqAreaLightPropertyWidget() = default;

void pqAreaLightPropertyWidget::addLabel(QGridLayout* layout, vtkSMProperty* property)
{
  auto* label = new QLabel(property->GetXMLLabel(), this);
  label->setToolTip(pqPropertyWidget::getTooltip(property));
  layout->addWidget(label, layout->rowCount(), 0);
}

void pqAreaLightPropertyWidget::addNumbers(QGridLayout* layout, const char* function)
{
  auto* property = vtkSMVectorProperty::SafeDownCast(this->propertyGroup()->GetProperty(function));
  if (!property)
  {
    return;
  }
  this->addLabel(layout, property);
  const int row = layout->rowCount() - 1;
  const int count = static_cast<int>(property->GetNumberOfElements());
  for (int i = 0; i < count; ++i)
  {
    auto* field = new pqDoubleLineEdit(this);
    field->setObjectName(QString("%1%2").arg(function).arg(i));
    layout->addWidget(field, row, 1 + i, 1, count == 1 ? Columns - 1 : 1);
    this->addPropertyLink(field, "text2", SIGNAL(textChangedAndEditingFinished()), property, i);
  }
}

void pqAreaLightPropertyWidget::addChoice(QGridLayout* layout, const char* function)
{
  vtkSMProperty* property = this->propertyGroup()->GetProperty(function);
  auto* choices = property ? property->FindDomain<vtkSMEnumerationDomain>() : nullptr;
  if (!choices)
  {
    return;
  }
  this->addLabel(layout, property);
  auto* box = new QComboBox(this);
  box->setObjectName(function);
  new pqComboBoxDomain(box, property, choices);
  auto* adaptor = new pqSignalAdaptorComboBox(box);
  layout->addWidget(box, layout->rowCount() - 1, 1, 1, Columns - 1);
  this->addPropertyLink(adaptor, "currentData", SIGNAL(currentTextChanged(QString)), property);
}
