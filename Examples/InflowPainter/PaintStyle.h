// SPDX-License-Identifier: BSD-3-Clause
#ifndef PaintStyle_h
#define PaintStyle_h

#include <vtkInteractorStyleTrackballCamera.h>

class PainterWindow;

/**
 * Paints where the left button is pressed on the page; elsewhere a trackball for the camera. Keys
 * are the painter's, but for q.
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
