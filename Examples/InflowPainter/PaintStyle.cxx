// SPDX-License-Identifier: BSD-3-Clause
#include "PaintStyle.h"

#include "PainterWindow.h"

#include <vtkObjectFactory.h>
#include <vtkRenderWindowInteractor.h>

vtkStandardNewMacro(PaintStyle);

void PaintStyle::OnLeftButtonDown()
{
  const int* position = this->Interactor->GetEventPosition();
  this->Painter->SetReducedResolution(true);
  if (this->Painter->IsOverPage(position[0]))
  {
    this->Painter->BeginStroke(position[0], position[1]);
  }
  else
  {
    this->Superclass::OnLeftButtonDown();
  }
}

void PaintStyle::OnMouseMove()
{
  if (this->Painter->IsPainting())
  {
    const int* position = this->Interactor->GetEventPosition();
    this->Painter->ContinueStroke(position[0], position[1]);
  }
  else
  {
    this->Superclass::OnMouseMove();
  }
}

void PaintStyle::OnLeftButtonUp()
{
  this->Painter->EndStroke();
  this->Superclass::OnLeftButtonUp();
  this->Painter->SetReducedResolution(false);
  this->Interactor->Render();
}

void PaintStyle::OnChar()
{
  const char key = this->Interactor->GetKeyCode();
  if (key == 'q')
  {
    this->Superclass::OnChar();
  }
  else if (this->Painter->HandleKey(key))
  {
    this->Interactor->Render();
  }
}
