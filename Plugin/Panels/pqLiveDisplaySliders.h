// SPDX-License-Identifier: BSD-3-Clause
#ifndef pqLiveDisplaySliders_h
#define pqLiveDisplaySliders_h

#include <QObject>
#include <QPointer>
#include <QTimer>

#include <vector>

class QSlider;
class pqPropertyWidget;

/**
 * @class   pqLiveDisplaySliders
 * @brief   shows Interlume's volumes while the user drags a slider of a display property
 *
 * ParaView applies a slider when it is released. Here, its values are also sent to the
 * representation during the drag, and the view is rendered, which is fast because of
 * pqProgressiveViews. One image is rendered at a time, with the last value. ParaView's own change
 * when the slider is released remains the only one that can be undone and that is recorded in
 * Python.
 */
class pqLiveDisplaySliders : public QObject
{
  Q_OBJECT
  typedef QObject Superclass;

public:
  explicit pqLiveDisplaySliders(QObject* parent = nullptr);
  ~pqLiveDisplaySliders() override;

  void startup();
  void shutdown();

  bool eventFilter(QObject* object, QEvent* event) override;

private Q_SLOTS:
  void schedule();
  void update();

private:
  Q_DISABLE_COPY(pqLiveDisplaySliders)

  void begin(QSlider* slider);
  /// Restores the values before the drag, so that ParaView changes them to those of the widget.
  void end();
  void push(const std::vector<double>& values);

  QPointer<QSlider> Slider;
  QPointer<pqPropertyWidget> Widget;
  /// The values before the drag, and the last values sent.
  std::vector<double> Before;
  std::vector<double> Sent;
  QTimer Timer;
};

#endif
