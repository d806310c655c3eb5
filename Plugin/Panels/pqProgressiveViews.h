// SPDX-License-Identifier: BSD-3-Clause
#ifndef pqProgressiveViews_h
#define pqProgressiveViews_h

#include <QList>
#include <QObject>
#include <QPoint>
#include <QPointer>
#include <QTimer>

class pqView;
class vtkObject;

/**
 * @class   pqProgressiveViews
 * @brief   refines Interlume's volumes in the render views of the client
 *
 * A view first shows a coarse image of a volume, and is rendered again until the image is final. A
 * movement of the mouse aborts the rendering, which restarts when the mouse rests. The abort button
 * in the status bar, which is enabled until then, leaves the coarse image. Screenshots and
 * animations are always final, as are views that a server renders.
 */
class pqProgressiveViews : public QObject
{
  Q_OBJECT
  typedef QObject Superclass;

public:
  explicit pqProgressiveViews(QObject* parent = nullptr);
  ~pqProgressiveViews() override;

  void startup();
  void shutdown();

private Q_SLOTS:
  void addView(pqView* view);
  void beginImage(vtkObject* renderer);
  void checkAbort(vtkObject* window);
  void scheduleRefinement();
  void refine();
  /// Leaves the images as they are until the next rendering.
  void stop();

private:
  Q_DISABLE_COPY(pqProgressiveViews)

  QList<QPointer<pqView>> Views;
  QTimer Timer;
  /// If true, the current rendering is a refinement.
  bool IsRefining = false;
  /// Number of refinements since the last other rendering.
  int Refinements = 0;
  /// Position of the mouse when the current image or pause began.
  QPoint MousePosition;
};

#endif
