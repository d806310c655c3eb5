// SPDX-License-Identifier: BSD-3-Clause
#include "pqIntervalsPropertyWidget.h"

#include "pqCoreUtilities.h"
#include "pqDoubleRangeSliderPropertyWidget.h"
#include "pqScalarValueListPropertyWidget.h"
#include "vtkCommand.h"
#include "vtkPVXMLElement.h"
#include "vtkSMDoubleRangeDomain.h"
#include "vtkSMProperty.h"
#include "vtkSMUncheckedPropertyHelper.h"

#include <QToolButton>
#include <QVBoxLayout>

#include <type_traits>
#include <vector>

namespace
{
// The setter takes std::vector<const char*> in ParaView 5.11 and std::vector<std::string> in 5.13.
template <typename Labels>
void SetLabels(pqScalarValueListPropertyWidget* table,
  void (pqScalarValueListPropertyWidget::*setter)(Labels), const std::vector<const char*>& texts)
{
  std::decay_t<Labels> labels(texts.begin(), texts.end());
  (table->*setter)(labels);
}
}

pqIntervalsPropertyWidget::pqIntervalsPropertyWidget(
  vtkSMProxy* proxy, vtkSMProperty* property, QWidget* parent)
  : Superclass(proxy, parent)
  , Sliders(new pqDoubleRangeSliderPropertyWidget(proxy, property, this))
  , Several(new QToolButton(this))
  , Reset(new QToolButton(this))
  , Table(new pqScalarValueListPropertyWidget(property, proxy, this))
{
  this->setProperty(property);
  this->setShowLabel(false);

  this->Sliders->setObjectName("Sliders");
  this->Table->setObjectName("Table");
  this->Table->setRangeDomain(property->FindDomain<vtkSMDoubleRangeDomain>());
  this->Several->setObjectName("Several");
  this->Several->setText(tr("Several intervals"));
  this->Several->setToolTip(tr("Show a table in which you can add intervals"));
  this->Several->setCheckable(true);
  this->Several->setToolButtonStyle(Qt::ToolButtonTextOnly);

  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(this->Sliders);
  layout->addWidget(this->Several);
  layout->addWidget(this->Table);

  this->Reset->setObjectName("Reset");
  this->Reset->setText(tr("Reset to one interval"));
  this->Reset->setToolTip(tr("Replace all intervals by one interval from the range of the data"));
  layout->addWidget(this->Reset);

  this->labelTable();
  this->addPropertyLink(this->Table, "scalars", SIGNAL(scalarsChanged()), property);
  QObject::connect(this->Sliders, SIGNAL(changeAvailable()), this, SIGNAL(changeAvailable()));
  QObject::connect(this->Reset, SIGNAL(clicked()), this, SLOT(resetToData()));
  QObject::connect(this->Several, SIGNAL(toggled(bool)), this, SLOT(arrange()));
  pqCoreUtilities::connect(
    property, vtkCommand::UncheckedPropertyModifiedEvent, this, SLOT(arrange()));
  pqCoreUtilities::connect(property, vtkCommand::ModifiedEvent, this, SLOT(arrange()));
  this->arrange();
}

pqIntervalsPropertyWidget::~pqIntervalsPropertyWidget() = default;

void pqIntervalsPropertyWidget::labelTable()
{
  std::vector<const char*> labels;
  vtkPVXMLElement* hints = this->property()->GetHints();
  vtkPVXMLElement* named = hints ? hints->FindNestedElementByName("ShowComponentLabels") : nullptr;
  for (unsigned int i = 0; named && i < named->GetNumberOfNestedElements(); ++i)
  {
    labels.push_back(named->GetNestedElement(i)->GetAttributeOrEmpty("label"));
  }
  if (labels.size() == 2)
  {
    this->Table->setShowLabels(true);
    SetLabels(this->Table, &pqScalarValueListPropertyWidget::setLabels, labels);
  }
}

void pqIntervalsPropertyWidget::reset()
{
  this->Superclass::reset();
  this->Sliders->reset();
}

void pqIntervalsPropertyWidget::resetToData()
{
  this->property()->ResetToDomainDefaults(/*use_unchecked_values=*/true);
  Q_EMIT this->changeAvailable();
}

void pqIntervalsPropertyWidget::arrange()
{
  const bool isSingle = vtkSMUncheckedPropertyHelper(this->property()).GetNumberOfElements() == 2;
  this->Sliders->setVisible(isSingle);
  this->Several->setVisible(isSingle);
  this->Reset->setVisible(!isSingle);
  this->Table->setVisible(!isSingle || this->Several->isChecked());
}
