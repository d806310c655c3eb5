// SPDX-License-Identifier: BSD-3-Clause
#ifndef pqIntervalsPropertyWidget_h
#define pqIntervalsPropertyWidget_h

#include "pqPropertyWidget.h"

class QToolButton;
class pqDoubleRangeSliderPropertyWidget;
class pqScalarValueListPropertyWidget;

/**
 * @class   pqIntervalsPropertyWidget
 * @brief   edits a single interval with sliders, and several intervals in a table
 *
 * Use it for a repeatable property with two values per row. If the property has one row, the widget
 * shows two sliders, as for ParaView's IsoVolume, and the button "Several intervals", which shows
 * the table. Otherwise, the widget shows only the table and a button that resets it to one row.
 */
class pqIntervalsPropertyWidget : public pqPropertyWidget
{
  Q_OBJECT
  typedef pqPropertyWidget Superclass;

public:
  pqIntervalsPropertyWidget(vtkSMProxy* proxy, vtkSMProperty* property, QWidget* parent = nullptr);
  ~pqIntervalsPropertyWidget() override;

  void reset() override;

private Q_SLOTS:
  /// Shows the widgets for the current number of rows.
  void arrange();
  /// Sets the values that the domain proposes from the range of the data.
  void resetToData();

private:
  Q_DISABLE_COPY(pqIntervalsPropertyWidget)

  /// Sets the column labels of the table from the XML hints.
  void labelTable();

  pqDoubleRangeSliderPropertyWidget* Sliders;
  QToolButton* Several;
  QToolButton* Reset;
  pqScalarValueListPropertyWidget* Table;
};

#endif
