// SPDX-License-Identifier: BSD-3-Clause
#ifndef pqIntervalsPropertyWidget_h
#define pqIntervalsPropertyWidget_h

#include "pqPropertyWidget.h"

#include <QVariantList> // for a member

#include <vector> // for the sliders

class QLabel;
class QModelIndex;
class QToolButton;
class pqDoubleRangeWidget;
class pqHighlightableToolButton;
class pqScalarValueListPropertyWidget;

/**
 * @class   pqIntervalsPropertyWidget
 * @brief   edits a single row of numbers with sliders, and several rows in a table
 *
 * Use it for a repeatable property with one value per row (isovalues) or two (intervals). The
 * sliders edit the single row, or the row that is selected in the table. The button "Several"
 * shows the table; with several rows, the table remains. The table does not move when rows are
 * added or removed. An interval that is added starts at the upper value of the row above. While a
 * slider is dragged past the other bound, it takes that bound along.
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

  void apply() override;
  void reset() override;

private Q_SLOTS:
  /// Shows the widgets for the current number of rows.
  void arrange();
  /// Sets the values that the domain proposes from the range of the data.
  void resetToData();
  /// Sets the values of a row that was added to the table as a copy of the row above.
  void placeNewRow();
  /// Lets the sliders edit a row of the table.
  void selectRow(const QModelIndex& index);
  /// Shows the number of skipped cells.
  void updateSkipped();

private:
  Q_DISABLE_COPY(pqIntervalsPropertyWidget)

  /// Returns the labels of the columns from the XML hints.
  std::vector<const char*> getLabels() const;
  void createSliders();
  void createTable();
  /// Sets a value of the selected row. If \a isOrdered is true, keeps lower values below upper
  /// ones.
  void setValue(int column, double value, bool isOrdered);

  const int Columns;
  int Row = 0; ///< the row that the sliders edit
  QWidget* Sliders;
  std::vector<pqDoubleRangeWidget*> Bounds; ///< the sliders of a row
  QToolButton* Several;
  pqHighlightableToolButton* Reset;
  pqScalarValueListPropertyWidget* Table;
  QLabel* Skipped;
  QVariantList LastRows; ///< the values of the table before the last change
};

#endif
