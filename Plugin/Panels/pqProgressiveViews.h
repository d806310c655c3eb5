// SPDX-License-Identifier: BSD-3-Clause
#ifndef pqProgressiveViews_h
#define pqProgressiveViews_h

#include "PendingInput.h" // for a member

#include <QObject>
#include <QPointer>
#include <QTimer>

#include <vector>

class pqView;
class vtkObject;
class vtkSMRenderViewProxy;

/**
 * @class   pqProgressiveViews
 * @brief   refines Interlume's volumes in the render views of the client
 *
 * A still image of a view is coarse first, unless it is already final. A timer then renders the
 * view again until it is final. An input event aborts this, so that it is processed; the last image
 * remains, and is refined when the user pauses. Images during interaction, which ParaView reduces,
 * are not changed.
 *
 * Always complete: screenshots, animations that are playing, comparative views, views that a server
 * renders, images that a script renders without the view's proxy, and everything if *Progressive
 * Images* is off in ParaView's settings. If an image is not final after MAXIMUM_PASSES, such as if
 * something changes in each rendering, it is rendered completely.
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
  /// Called when the view's proxy, and then its renderer, begins an image.
  void beginRender(vtkObject* proxy, unsigned long event, void* isInteractive);
  void beginImage(vtkObject* renderer);
  /// Called by long images.
  void checkAbort(vtkObject* window);
  /// Called when the proxy has rendered.
  void endRender(vtkObject* proxy);
  /// Renders one pass of a coarse view. Called by the timer.
  void refine();

private:
  Q_DISABLE_COPY(pqProgressiveViews)

  struct View
  {
    QPointer<pqView> Widget;
    /// If true, the image that the view shows is not final.
    bool IsCoarse = false;
    /// Number of refinements since the last other image.
    int Passes = 0;
  };

  void refineView(View& view, vtkSMRenderViewProxy* proxy);
  View* findView(vtkObject* proxy);

  std::vector<View> Views;
  QTimer Timer;
  /// View that is refined by the current rendering, or null.
  View* Refined = nullptr;
  PendingInput Input;
  bool IsAborted = false;
  /// If true, a proxy is rendering an image that is not interactive, and this may be coarse.
  bool IsStill = false;
  bool IsProgressive = false;
};

#endif
