// SPDX-License-Identifier: BSD-3-Clause
#include "pqLiveDisplaySliders.h"

#include "pqPropertyWidget.h"
#include "pqView.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"
#include "vtkSMUncheckedPropertyHelper.h"

#include <QCoreApplication>
#include <QEvent>
#include <QSlider>

namespace
{
pqPropertyWidget* FindPropertyWidget(QObject* object)
{
  while (object && !qobject_cast<pqPropertyWidget*>(object))
  {
    object = object->parent();
  }
  return qobject_cast<pqPropertyWidget*>(object);
}

/// Returns true if a proxy is a representation that is shown as one of Interlume's volumes.
bool IsVolume(vtkSMProxy* proxy)
{
  const QString type = vtkSMPropertyHelper(proxy, "Representation", true).GetAsString();
  return type == "Interval Volume" || type == "Shadowed Slices" || type == "Inflow Textures";
}
}

pqLiveDisplaySliders::pqLiveDisplaySliders(QObject* parent)
  : Superclass(parent)
{
  // Runs after all mouse events that have arrived during an image.
  this->Timer.setSingleShot(true);
  QObject::connect(&this->Timer, &QTimer::timeout, this, &pqLiveDisplaySliders::update);
}

pqLiveDisplaySliders::~pqLiveDisplaySliders() = default;

void pqLiveDisplaySliders::startup()
{
  QCoreApplication::instance()->installEventFilter(this);
}

void pqLiveDisplaySliders::shutdown()
{
  QCoreApplication::instance()->removeEventFilter(this);
}

bool pqLiveDisplaySliders::eventFilter(QObject* object, QEvent* event)
{
  if (event->type() == QEvent::MouseButtonPress)
  {
    this->begin(qobject_cast<QSlider*>(object));
  }
  else if (event->type() == QEvent::MouseButtonRelease && object == this->Slider)
  {
    this->end();
  }
  return Superclass::eventFilter(object, event);
}

void pqLiveDisplaySliders::begin(QSlider* slider)
{
  pqPropertyWidget* widget = FindPropertyWidget(slider);
  if (!widget || !widget->property() || !widget->view() || !IsVolume(widget->proxy()))
  {
    return;
  }
  this->Slider = slider;
  this->Widget = widget;
  this->Before = vtkSMPropertyHelper(widget->property()).GetDoubleArray();
  this->Sent = this->Before;
  QObject::connect(
    slider, &QSlider::valueChanged, this, &pqLiveDisplaySliders::schedule, Qt::UniqueConnection);
}

void pqLiveDisplaySliders::schedule()
{
  if (this->Widget && !this->Timer.isActive())
  {
    this->Timer.start(0);
  }
}

void pqLiveDisplaySliders::push(const std::vector<double>& values)
{
  vtkSMPropertyHelper(this->Widget->property())
    .Set(values.data(), static_cast<unsigned int>(values.size()));
  this->Widget->proxy()->UpdateVTKObjects();
}

void pqLiveDisplaySliders::update()
{
  if (!this->Widget)
  {
    return;
  }
  const std::vector<double> values =
    vtkSMUncheckedPropertyHelper(this->Widget->property()).GetDoubleArray();
  if (values != this->Sent)
  {
    this->Sent = values;
    this->push(values);
    this->Widget->view()->render();
  }
}

void pqLiveDisplaySliders::end()
{
  if (this->Widget && this->Sent != this->Before)
  {
    const std::vector<double> values =
      vtkSMUncheckedPropertyHelper(this->Widget->property()).GetDoubleArray();
    this->push(this->Before);
    vtkSMUncheckedPropertyHelper(this->Widget->property())
      .Set(values.data(), static_cast<unsigned int>(values.size()));
  }
  this->Widget = nullptr;
}
