// SPDX-License-Identifier: BSD-3-Clause
#include "pqLivePreviewDecorator.h"

#include "pqApplicationCore.h"
#include "pqPropertiesPanel.h"
#include "pqPropertyWidget.h"
#include "pqRenderView.h"
#include "pqServerManagerModel.h"
#include "pqUndoStack.h"
#include "vtkPVXMLElement.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"
#include "vtkSMTrace.h"
#include "vtkSMUncheckedPropertyHelper.h"
#include "vtkSMViewProxy.h"

#include <QSlider>

namespace
{
pqServerManagerModel* GetModel()
{
  return pqApplicationCore::instance()->getServerManagerModel();
}

/// Updates and renders the views as after Apply.
void RenderApplied(QObject* widget)
{
  for (QObject* at = widget; at; at = at->parent())
  {
    if (auto* panel = qobject_cast<pqPropertiesPanel*>(at))
    {
      Q_EMIT panel->applied();
      return;
    }
  }
  pqApplicationCore::instance()->render();
}
}

pqLivePreviewDecorator::pqLivePreviewDecorator(vtkPVXMLElement* xml, pqPropertyWidget* parent)
  : Superclass(xml, parent)
{
  xml->GetScalarAttribute("cells", &this->Cells);
  // Runs after all mouse events that have arrived during an update.
  this->Timer.setSingleShot(true);
  this->connect(&this->Timer, SIGNAL(timeout()), SLOT(update()));
  for (QSlider* slider : parent->findChildren<QSlider*>())
  {
    this->connect(slider, SIGNAL(sliderPressed()), SLOT(begin()));
    this->connect(slider, SIGNAL(valueChanged(int)), SLOT(schedule()));
    this->connect(slider, SIGNAL(sliderReleased()), SLOT(end()));
  }
}

pqLivePreviewDecorator::~pqLivePreviewDecorator() = default;

pqProxy* pqLivePreviewDecorator::findProxy() const
{
  return GetModel()->findItem<pqProxy*>(this->parentWidget()->proxy());
}

void pqLivePreviewDecorator::begin()
{
  const pqProxy* proxy = this->findProxy();
  this->IsLive = proxy && proxy->modifiedState() == pqProxy::UNMODIFIED;
  this->Before = vtkSMPropertyHelper(this->parentWidget()->property()).GetDoubleArray();
  this->Sent = this->Before;
}

void pqLivePreviewDecorator::schedule()
{
  if (this->IsLive && !this->Timer.isActive())
  {
    this->Timer.start(0);
  }
}

void pqLivePreviewDecorator::push(const std::vector<double>& values, int cells)
{
  vtkSMProxy* proxy = this->parentWidget()->proxy();
  vtkSMPropertyHelper(proxy, "PreviewCellLimit").Set(cells);
  vtkSMPropertyHelper(this->parentWidget()->property())
    .Set(values.data(), static_cast<unsigned int>(values.size()));
  proxy->UpdateVTKObjects();
}

void pqLivePreviewDecorator::update()
{
  const std::vector<double> values =
    vtkSMUncheckedPropertyHelper(this->parentWidget()->property()).GetDoubleArray();
  if (!this->IsLive || values == this->Sent)
  {
    return;
  }
  this->Sent = values;
  this->push(values, this->Cells);
  this->findProxy()->setModifiedState(pqProxy::UNMODIFIED);
  for (pqRenderView* view : GetModel()->findItems<pqRenderView*>())
  {
    if (view->getViewProxy()->GetNeedsUpdate())
    {
      view->getViewProxy()->InteractiveRender();
    }
  }
}

void pqLivePreviewDecorator::end()
{
  const std::vector<double> values =
    vtkSMUncheckedPropertyHelper(this->parentWidget()->property()).GetDoubleArray();
  const bool isChanged = this->IsLive && (values != this->Before || this->Sent != this->Before);
  this->IsLive = false;
  if (!isChanged)
  {
    return;
  }
  // Undo and trace record the change from the values before the drag.
  this->push(this->Before, 0);
  BEGIN_UNDO_SET("Drag");
  {
    SM_SCOPED_TRACE(PropertiesModified).arg("proxy", this->parentWidget()->proxy());
    this->push(values, 0);
  }
  this->findProxy()->setModifiedState(pqProxy::UNMODIFIED);
  RenderApplied(this->parentWidget());
  END_UNDO_SET();
}
