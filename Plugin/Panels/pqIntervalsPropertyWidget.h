// SPDX-License-Identifier: BSD-3-Clause
#ifndef pqIntervalsPropertyWidget_h
#define pqIntervalsPropertyWidget_h

#include "pqPropertyWidget.h"

#include <QVariantList> // for a member

class QLabel;
class QToolButton;
class pqDoubleRangeSliderPropertyWidget;
class pqScalarValueListPropertyWidget;

/**
 * @class   pqIntervalsPropertyWidget
 * @brief   edits a single interval with sliders, and several intervals in a table
 *
 * Use it for a repeatable property with two values per row. The widget shows two sliders, as for
 * ParaView's IsoVolume, or a table and a button that resets it to one row. The button "Several
 * intervals" switches between them; with several rows, the table remains. The table does not move
 * when rows are added or removed. A row that is added starts at the upper value of the row above.
 *
 * If the proxy has the property SkippedCells, the widget shows the number, unless it is 0.
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
  /// Sets the values of a row that was added to the table as a copy of the row above.
  void placeNewRow();
  /// Shows the number of skipped cells.
  void updateSkipped();

private:
  Q_DISABLE_COPY(pqIntervalsPropertyWidget)

  /// Sets the column labels of the table from the XML hints.
  void labelTable();

  pqDoubleRangeSliderPropertyWidget* Sliders;
  QToolButton* Several;
  QToolButton* Reset;
  pqScalarValueListPropertyWidget* Table;
  QLabel* Skipped;
  QVariantList LastRows; ///< the values of the table before the last change
};

#endif
