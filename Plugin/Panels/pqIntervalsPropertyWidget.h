// SPDX-License-Identifier: BSD-3-Clause
#ifndef pqIntervalsPropertyWidget_h
#define pqIntervalsPropertyWidget_h

#include "pqPropertyWidget.h"

class QToolButton;
class pqDoubleRangeSliderPropertyWidget;
class pqScalarValueListPropertyWidget;

/**
 * @class   pqIntervalsPropertyWidget
 * @brief   sliders for a single interval, a table for several
 *
 * The widget is for a property with rows of two values. While that has one row, the widget shows
 * the two sliders that ParaView's own IsoVolume has; the button "Several intervals" shows the table
 * below them. With any other number of rows it shows the table alone, and a button that goes back
 * to one.
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
  /// Shows what fits the number of rows.
  void arrange();
  /// Takes what the domain proposes from the data.
  void resetToData();

private:
  Q_DISABLE_COPY(pqIntervalsPropertyWidget)

  void labelTable();

  pqDoubleRangeSliderPropertyWidget* Sliders;
  QToolButton* Several;
  QToolButton* Reset;
  pqScalarValueListPropertyWidget* Table;
};

#endif
