// SPDX-License-Identifier: BSD-3-Clause
#include "pqIntervalsPropertyWidget.h"

#include "pqCoreUtilities.h"
#include "pqDoubleRangeSliderPropertyWidget.h"
#include "pqScalarValueListPropertyWidget.h"
#include "vtkCommand.h"
#include "vtkPVXMLElement.h"
#include "vtkSMDoubleRangeDomain.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"
#include "vtkSMUncheckedPropertyHelper.h"

#include <QLabel>
#include <QTableView>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
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

/// Returns the row that was added to \a before as a copy of the row above, or -1. Rows have two
/// values.
int FindCopiedRow(const QVariantList& before, const QVariantList& after)
{
  const int rows = after.size() / 2;
  if (rows < 2 || after.size() != before.size() + 2)
  {
    return -1;
  }
  const auto isEqual = [&](int row, const QVariantList& values, int other)
  { return after.mid(2 * row, 2) == values.mid(2 * other, 2); };
  int row = 0;
  while (row + 1 < rows && isEqual(row, before, row))
  {
    ++row;
  }
  return row > 0 && isEqual(row, after, row - 1) && after.mid(2 * row + 2) == before.mid(2 * row)
    ? row
    : -1;
}
}

pqIntervalsPropertyWidget::pqIntervalsPropertyWidget(
  vtkSMProxy* proxy, vtkSMProperty* property, QWidget* parent)
  : Superclass(proxy, parent)
  , Sliders(new pqDoubleRangeSliderPropertyWidget(proxy, property, this))
  , Several(new QToolButton(this))
  , Reset(new QToolButton(this))
  , Table(new pqScalarValueListPropertyWidget(property, proxy, this))
  , Skipped(new QLabel(this))
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
  layout->addWidget(this->Several);
  layout->addWidget(this->Sliders);
  layout->addWidget(this->Table);

  this->Reset->setObjectName("Reset");
  this->Reset->setText(tr("Reset to one interval"));
  this->Reset->setToolTip(tr("Replace all intervals by one interval from the range of the data"));
  layout->addWidget(this->Reset);
  this->Skipped->setObjectName("Skipped");
  this->Skipped->setWordWrap(true);
  layout->addWidget(this->Skipped);

  this->labelTable();
  this->addPropertyLink(this->Table, "scalars", SIGNAL(scalarsChanged()), property);
  this->LastRows = this->Table->scalars();
  QObject::connect(this->Table, SIGNAL(scalarsChanged()), this, SLOT(placeNewRow()));
  QObject::connect(this->Sliders, SIGNAL(changeAvailable()), this, SIGNAL(changeAvailable()));
  QObject::connect(this->Reset, SIGNAL(clicked()), this, SLOT(resetToData()));
  QObject::connect(this->Several, SIGNAL(toggled(bool)), this, SLOT(arrange()));
  pqCoreUtilities::connect(
    property, vtkCommand::UncheckedPropertyModifiedEvent, this, SLOT(arrange()));
  pqCoreUtilities::connect(property, vtkCommand::ModifiedEvent, this, SLOT(arrange()));
  pqCoreUtilities::connect(proxy, vtkCommand::UpdateDataEvent, this, SLOT(updateSkipped()));
  this->arrange();
  this->updateSkipped();
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
  this->Several->setChecked(false);
  Q_EMIT this->changeAvailable();
}

void pqIntervalsPropertyWidget::arrange()
{
  const bool isSingle = vtkSMUncheckedPropertyHelper(this->property()).GetNumberOfElements() == 2;
  if (!isSingle)
  {
    this->Several->setChecked(true);
  }
  this->Several->setEnabled(isSingle);
  const bool isTable = this->Several->isChecked();
  this->Sliders->setVisible(!isTable);
  this->Table->setVisible(isTable);
  this->Reset->setVisible(isTable);
}

void pqIntervalsPropertyWidget::placeNewRow()
{
  const QVariantList rows = this->Table->scalars();
  const int row = FindCopiedRow(this->LastRows, rows);
  this->LastRows = rows;
  auto* view = this->Table->findChild<QTableView*>();
  if (row < 0 || !view || view->model()->columnCount() != 2)
  {
    return;
  }
  const double lower = rows[2 * row - 2].toDouble();
  const double upper = rows[2 * row - 1].toDouble();
  double end = upper + (upper - lower);
  auto* range = this->property()->FindDomain<vtkSMDoubleRangeDomain>();
  if (row + 1 < rows.size() / 2 && rows[2 * row + 2].toDouble() > upper)
  {
    end = rows[2 * row + 2].toDouble();
  }
  else if (range && range->GetMaximumExists(0) && range->GetMaximum(0) > upper)
  {
    end = std::min(end, range->GetMaximum(0));
  }
  // Each change calls this function again.
  view->model()->setData(view->model()->index(row, 1), end);
  view->model()->setData(view->model()->index(row, 0), upper);
}

void pqIntervalsPropertyWidget::updateSkipped()
{
  vtkSMProperty* skipped = this->proxy()->GetProperty("SkippedCells");
  if (skipped)
  {
    this->proxy()->UpdatePropertyInformation(skipped);
  }
  const long long number = skipped ? vtkSMPropertyHelper(skipped).GetAsIdType() : 0;
  this->Skipped->setText(tr("%1 cells with NaN or infinite values are skipped.").arg(number));
  this->Skipped->setVisible(number > 0);
}
