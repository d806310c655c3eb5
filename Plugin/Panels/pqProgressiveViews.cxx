// SPDX-License-Identifier: BSD-3-Clause
#include "pqProgressiveViews.h"

#include "PendingInput.h"
#include "vtkProgressiveVolumes.h"

#include "pqAnimationManager.h"
#include "pqApplicationCore.h"
#include "pqCoreUtilities.h"
#include "pqPVApplicationCore.h"
#include "pqServer.h"
#include "pqServerManagerModel.h"
#include "pqView.h"
#include "vtkCommand.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMRenderViewProxy.h"
#include "vtkSMSession.h"
#include "vtkSMSessionProxyManager.h"

#include <QApplication>

#include <algorithm>

namespace
{
/// Times, in milliseconds, without other images or input before a refinement.
constexpr int PAUSE_AFTER_IMAGE = 100;
constexpr int PAUSE_AFTER_INPUT = 300;
/// Number of refinements after which the image is rendered completely. Usually, three suffice.
constexpr int MAXIMUM_PASSES = 4;
constexpr double UNLIMITED_SECONDS = 1e6;

vtkSMRenderViewProxy* GetProxy(const pqView* view)
{
  return view ? vtkSMRenderViewProxy::SafeDownCast(view->getViewProxy()) : nullptr;
}

bool IsAnimationPlaying()
{
  auto* application = pqPVApplicationCore::instance();
  return application && application->animationManager() &&
    application->animationManager()->animationPlaying();
}

bool IsTurnedOn(vtkSMProxy* view)
{
  vtkSMProxy* settings = view->GetSessionProxyManager()->GetProxy("settings", "InterlumeSettings");
  return !settings || vtkSMPropertyHelper(settings, "ProgressiveImages").GetAsInt() != 0;
}

/// ParaView turns off SwapBuffers while it captures or selects.
bool IsShown(vtkRenderWindow* window)
{
  return window->GetSwapBuffers() != 0;
}

/// Returns true if a refinement must wait for the user or for a filter.
bool IsBusy(const pqView* view)
{
  return QApplication::mouseButtons() != Qt::NoButton || IsAnimationPlaying() ||
    view->getViewProxy()->GetSession()->GetPendingProgress() ||
    view->getServer()->isProcessingPending();
}
}

pqProgressiveViews::pqProgressiveViews(QObject* parent)
  : Superclass(parent)
{
  this->Timer.setSingleShot(true);
  QObject::connect(&this->Timer, &QTimer::timeout, this, &pqProgressiveViews::refine);
}

pqProgressiveViews::~pqProgressiveViews() = default;

void pqProgressiveViews::startup()
{
  pqServerManagerModel* model = pqApplicationCore::instance()->getServerManagerModel();
  QObject::connect(model, &pqServerManagerModel::viewAdded, this, &pqProgressiveViews::addView);
  for (pqView* view : model->findItems<pqView*>())
  {
    this->addView(view);
  }
}

void pqProgressiveViews::shutdown()
{
  this->Timer.stop();
}

void pqProgressiveViews::addView(pqView* view)
{
  vtkSMRenderViewProxy* proxy = GetProxy(view);
  if (!proxy || view->getServer()->isRemote())
  {
    return;
  }
  const auto isDeleted = [](const View& other) { return !other.Widget; };
  this->Views.erase(
    std::remove_if(this->Views.begin(), this->Views.end(), isDeleted), this->Views.end());
  this->Views.push_back({ view });
  pqCoreUtilities::connect(
    proxy, vtkCommand::StartEvent, this, SLOT(beginRender(vtkObject*, unsigned long, void*)));
  pqCoreUtilities::connect(proxy, vtkCommand::EndEvent, this, SLOT(endRender(vtkObject*)));
  pqCoreUtilities::connect(
    proxy->GetRenderer(), vtkCommand::StartEvent, this, SLOT(beginImage(vtkObject*)));
  pqCoreUtilities::connect(
    proxy->GetRenderWindow(), vtkCommand::AbortCheckEvent, this, SLOT(checkAbort(vtkObject*)));
}

pqProgressiveViews::View* pqProgressiveViews::findView(vtkObject* proxy)
{
  const auto found = std::find_if(this->Views.begin(), this->Views.end(),
    [proxy](const View& view) { return GetProxy(view.Widget) == proxy; });
  return found == this->Views.end() ? nullptr : &*found;
}

void pqProgressiveViews::beginRender(vtkObject* object, unsigned long, void* isInteractive)
{
  auto* proxy = vtkSMRenderViewProxy::SafeDownCast(object);
  this->IsStill = !*static_cast<int*>(isInteractive);
  this->IsProgressive = this->IsStill && IsShown(proxy->GetRenderWindow()) && IsTurnedOn(proxy) &&
    !IsAnimationPlaying() && !(this->Refined && this->Refined->Passes == MAXIMUM_PASSES);
  if (this->IsProgressive && !this->Refined)
  {
    // Only refinements may take long, because only they can be aborted.
    vtkProgressiveVolumes::Restart(proxy->GetRenderer());
  }
}

void pqProgressiveViews::beginImage(vtkObject* object)
{
  auto* renderer = vtkRenderer::SafeDownCast(object);
  if (!renderer->GetSelector())
  {
    vtkProgressiveVolumes::Set(renderer, this->IsProgressive);
  }
  if (this->IsStill)
  {
    // ParaView limits the time of a still image, too. Times that are expected from coarse images
    // can exceed the limit.
    renderer->SetAllocatedRenderTime(UNLIMITED_SECONDS);
  }
}

void pqProgressiveViews::checkAbort(vtkObject* object)
{
  if (this->Refined && this->Input.Exists())
  {
    auto* window = vtkRenderWindow::SafeDownCast(object);
    window->SetAbortRender(1);
    // The last image remains.
    window->SwapBuffersOff();
    this->IsAborted = true;
  }
}

void pqProgressiveViews::endRender(vtkObject* object)
{
  auto* proxy = vtkSMRenderViewProxy::SafeDownCast(object);
  View* view = this->findView(proxy);
  if (view && IsShown(proxy->GetRenderWindow()))
  {
    view->IsCoarse = this->IsProgressive && vtkProgressiveVolumes::IsPending(proxy->GetRenderer());
    view->Passes = view == this->Refined ? view->Passes : 0;
    if (view->IsCoarse)
    {
      this->Timer.start(PAUSE_AFTER_IMAGE);
    }
  }
  this->IsProgressive = false;
  this->IsStill = false;
}

void pqProgressiveViews::refine()
{
  for (View& view : this->Views)
  {
    vtkSMRenderViewProxy* proxy = GetProxy(view.Widget);
    if (!proxy || !view.IsCoarse)
    {
      continue;
    }
    this->IsAborted = IsBusy(view.Widget);
    if (!this->IsAborted)
    {
      this->refineView(view, proxy);
    }
    // Returns to the event loop after each pass.
    this->Timer.start(this->IsAborted ? PAUSE_AFTER_INPUT : 0);
    return;
  }
}

void pqProgressiveViews::refineView(View& view, vtkSMRenderViewProxy* proxy)
{
  vtkRenderWindow* window = proxy->GetRenderWindow();
  this->Refined = &view;
  this->Input = PendingInput();
  view.Widget->forceRender();
  this->Refined = nullptr;
  if (this->IsAborted)
  {
    window->SwapBuffersOn();
    return;
  }
  // A view that cannot be rendered remains as it is.
  view.IsCoarse = view.IsCoarse && view.Passes < MAXIMUM_PASSES;
  ++view.Passes;
}
