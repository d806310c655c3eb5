// SPDX-License-Identifier: BSD-3-Clause
#ifndef PaintStyle_h
#define PaintStyle_h

#include <vtkInteractorStyleTrackballCamera.h>

class PainterWindow;

/**
 * Interactor style that paints while the left button is held down on the page, and otherwise works
 * like a trackball camera style. All keys except q are passed to the painter.
 */
class PaintStyle : public vtkInteractorStyleTrackballCamera
{
public:
  static PaintStyle* New();
  vtkTypeMacro(PaintStyle, vtkInteractorStyleTrackballCamera);

  void SetPainter(PainterWindow* painter) { this->Painter = painter; }

  void OnLeftButtonDown() override;
  void OnMouseMove() override;
  void OnLeftButtonUp() override;
  void OnChar() override;

protected:
  PaintStyle() = default;
  ~PaintStyle() override = default;

private:
  PaintStyle(const PaintStyle&) = delete;
  void operator=(const PaintStyle&) = delete;

  PainterWindow* Painter = nullptr;
};

#endif
