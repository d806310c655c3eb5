// SPDX-License-Identifier: BSD-3-Clause
#include "pqIntervalsPropertyWidget.h"

#include "pqCoreUtilities.h"
#include "pqDoubleRangeWidget.h"
#include "pqHighlightableToolButton.h"
#include "pqScalarValueListPropertyWidget.h"
#include "pqWidgetRangeDomain.h"
#include "vtkCommand.h"
#include "vtkPVXMLElement.h"
#include "vtkSMDoubleRangeDomain.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"
#include "vtkSMUncheckedPropertyHelper.h"
#include "vtkSMVectorProperty.h"

#include <QGridLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QSlider>
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
  , Columns(vtkSMVectorProperty::SafeDownCast(property)->GetNumberOfElementsPerCommand())
  , Sliders(new QWidget(this))
  , Several(new QToolButton(this))
  , Reset(new pqHighlightableToolButton(this))
  , Table(new pqScalarValueListPropertyWidget(property, proxy, this))
  , Skipped(new QLabel(this))
{
  this->setProperty(property);
  this->setShowLabel(false);

  const bool isOfIntervals = this->Columns == 2;
  this->Several->setObjectName("Several");
  this->Several->setText(isOfIntervals ? tr("Several intervals") : tr("Several values"));
  this->Several->setToolTip(tr("Show a table in which you can add rows"));
  this->Several->setCheckable(true);
  this->Several->setToolButtonStyle(Qt::ToolButtonTextOnly);
  this->Reset->setObjectName("Reset");
  this->Reset->setText(tr("Reset"));
  this->Reset->setToolTip(tr("Replace all rows by the default for the range of the data"));
  this->Skipped->setObjectName("Skipped");
  this->Skipped->setWordWrap(true);
  this->createSliders();
  this->createTable();

  auto* layout = new QGridLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(this->Several, 0, 0, Qt::AlignLeft);
  layout->addWidget(this->Reset, 0, 1, Qt::AlignRight);
  layout->addWidget(this->Sliders, 1, 0, 1, 2);
  layout->addWidget(this->Table, 2, 0, 1, 2);
  layout->addWidget(this->Skipped, 3, 0, 1, 2);

  QObject::connect(this->Reset, SIGNAL(clicked()), this, SLOT(resetToData()));
  QObject::connect(this->Several, SIGNAL(toggled(bool)), this, SLOT(arrange()));
  pqCoreUtilities::connect(
    property, vtkCommand::UncheckedPropertyModifiedEvent, this, SLOT(arrange()));
  pqCoreUtilities::connect(property, vtkCommand::ModifiedEvent, this, SLOT(arrange()));
  pqCoreUtilities::connect(
    property, vtkCommand::DomainModifiedEvent, this->Reset, SLOT(highlight()));
  pqCoreUtilities::connect(proxy, vtkCommand::UpdateDataEvent, this, SLOT(updateSkipped()));
  this->arrange();
  this->updateSkipped();
}

pqIntervalsPropertyWidget::~pqIntervalsPropertyWidget() = default;

std::vector<const char*> pqIntervalsPropertyWidget::getLabels() const
{
  std::vector<const char*> labels;
  vtkPVXMLElement* hints = this->property()->GetHints();
  vtkPVXMLElement* named = hints ? hints->FindNestedElementByName("ShowComponentLabels") : nullptr;
  for (unsigned int i = 0; named && i < named->GetNumberOfNestedElements(); ++i)
  {
    labels.push_back(named->GetNestedElement(i)->GetAttributeOrEmpty("label"));
  }
  labels.resize(static_cast<std::size_t>(this->Columns), "");
  return labels;
}

void pqIntervalsPropertyWidget::createSliders()
{
  this->Sliders->setObjectName("Sliders");
  auto* layout = new QGridLayout(this->Sliders);
  layout->setContentsMargins(0, 0, 0, 0);
  const std::vector<const char*> labels = this->getLabels();
  for (int column = 0; column < this->Columns; ++column)
  {
    auto* bound = new pqDoubleRangeWidget(this->Sliders);
    bound->setObjectName(QString("ThresholdBetween_%1").arg(column));
    layout->addWidget(new QLabel(labels[column], this->Sliders), column, 0);
    layout->addWidget(bound, column, 1);
    new pqWidgetRangeDomain(bound, "minimum", "maximum", this->property(), 0);
    auto* slider = bound->findChild<QSlider*>();
    // A value that is being typed is not complete, and must not move the other bound.
    QObject::connect(bound, &pqDoubleRangeWidget::valueChanged, this,
      [=](double value) { this->setValue(column, value, slider && slider->isSliderDown()); });
    QObject::connect(bound, &pqDoubleRangeWidget::valueEdited, this,
      [=](double value) { this->setValue(column, value, true); });
    this->Bounds.push_back(bound);
  }
}

void pqIntervalsPropertyWidget::createTable()
{
  this->Table->setObjectName("Table");
  this->Table->setRangeDomain(this->property()->FindDomain<vtkSMDoubleRangeDomain>());
  this->Table->setShowLabels(true);
  SetLabels(this->Table, &pqScalarValueListPropertyWidget::setLabels, this->getLabels());
  this->addPropertyLink(this->Table, "scalars", SIGNAL(scalarsChanged()), this->property());
  this->LastRows = this->Table->scalars();
  QObject::connect(this->Table, SIGNAL(scalarsChanged()), this, SLOT(placeNewRow()));
  if (auto* view = this->Table->findChild<QTableView*>())
  {
    QObject::connect(view->selectionModel(), SIGNAL(currentChanged(QModelIndex, QModelIndex)), this,
      SLOT(selectRow(QModelIndex)));
  }
}

void pqIntervalsPropertyWidget::apply()
{
  this->Superclass::apply();
  this->Reset->clear();
}

void pqIntervalsPropertyWidget::reset()
{
  this->Superclass::reset();
  this->Reset->clear();
}

void pqIntervalsPropertyWidget::resetToData()
{
  this->property()->ResetToDomainDefaults(/*use_unchecked_values=*/true);
  this->Several->setChecked(false);
  Q_EMIT this->changeAvailable();
}

void pqIntervalsPropertyWidget::arrange()
{
  const std::vector<double> values =
    vtkSMUncheckedPropertyHelper(this->property()).GetDoubleArray();
  const int rows = static_cast<int>(values.size()) / this->Columns;
  if (rows != 1)
  {
    this->Several->setChecked(true);
  }
  this->Several->setEnabled(rows == 1);
  this->Table->setVisible(this->Several->isChecked());
  this->Row = std::max(0, std::min(this->Row, rows - 1));
  this->Sliders->setEnabled(rows > 0);
  for (int column = 0; rows > 0 && column < this->Columns; ++column)
  {
    const QSignalBlocker blocker(this->Bounds[column]);
    this->Bounds[column]->setValue(values[this->Row * this->Columns + column]);
  }
}

void pqIntervalsPropertyWidget::selectRow(const QModelIndex& index)
{
  if (index.isValid())
  {
    this->Row = index.row();
    this->arrange();
  }
}

void pqIntervalsPropertyWidget::setValue(int column, double value, bool isOrdered)
{
  std::vector<double> values = vtkSMUncheckedPropertyHelper(this->property()).GetDoubleArray();
  const std::size_t first = static_cast<std::size_t>(this->Row * this->Columns);
  if (first + this->Columns > values.size())
  {
    return;
  }
  const std::vector<double> before = values;
  values[first + column] = value;
  for (int other = 0; isOrdered && other < this->Columns; ++other)
  {
    double& bound = values[first + other];
    bound = other < column ? std::min(bound, value) : std::max(bound, value);
  }
  if (values != before)
  {
    vtkSMUncheckedPropertyHelper(this->property())
      .Set(values.data(), static_cast<unsigned int>(values.size()));
    Q_EMIT this->changeAvailable();
  }
}

void pqIntervalsPropertyWidget::placeNewRow()
{
  const QVariantList rows = this->Table->scalars();
  const int row = FindCopiedRow(this->LastRows, rows);
  this->LastRows = rows;
  auto* view = this->Table->findChild<QTableView*>();
  if (this->Columns != 2 || row < 0 || !view || view->model()->columnCount() != 2)
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
