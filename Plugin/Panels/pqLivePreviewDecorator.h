// SPDX-License-Identifier: BSD-3-Clause
#ifndef pqLivePreviewDecorator_h
#define pqLivePreviewDecorator_h

#include "pqPropertyWidgetDecorator.h"

#include <QTimer> // for a member

#include <vector> // for values

class pqProxy;

/**
 * @class   pqLivePreviewDecorator
 * @brief   applies a property of numbers while the user drags its sliders
 *
 * XML, in the hints of the property:
 *
 *     <PropertyWidgetDecorator type="interlume_live" cells="1000000"/>
 *
 * During the drag, the values are sent to the filter, its property PreviewCellLimit is set to
 * *cells*, and the render views that show it render interactively. One update runs at a time, with
 * the last values. When the user releases the slider, the values are applied as by the button
 * Apply: one step to undo, one line of Python trace, and a render without preview. Reset then keeps
 * them.
 *
 * If the filter has changes that are not applied, or was never applied, the sliders do not update
 * it.
 */
class pqLivePreviewDecorator : public pqPropertyWidgetDecorator
{
  Q_OBJECT
  typedef pqPropertyWidgetDecorator Superclass;

public:
  pqLivePreviewDecorator(vtkPVXMLElement* xml, pqPropertyWidget* parent);
  ~pqLivePreviewDecorator() override;

  bool eventFilter(QObject* slider, QEvent* event) override;

private Q_SLOTS:
  void begin();
  void schedule();
  void update();
  void end();

private:
  Q_DISABLE_COPY(pqLivePreviewDecorator)

  /// Returns null if the filter was deleted.
  pqProxy* findProxy() const;
  /// Sends values to the filter. A preview is exact up to \a cells cells; 0 for no preview.
  void push(const std::vector<double>& values, int cells);

  int Cells = 0;
  bool IsLive = false;
  /// The values before the drag, and the last values sent.
  std::vector<double> Before;
  std::vector<double> Sent;
  QTimer Timer;
};

#endif
