// SPDX-License-Identifier: BSD-3-Clause
#ifndef PainterWindow_h
#define PainterWindow_h

#include "PaintCanvas.h"

#include <vtkNew.h>

#include <string>

class vtkActor;
class vtkImageData;
class vtkImplicitFlowVolumeMapper;
class vtkRenderWindow;
class vtkRenderWindowInteractor;
class vtkRenderer;
class vtkSliderWidget;
class vtkTerminationSurface;
class vtkTexture;
class vtkVolume;

/**
 * A window with a page to paint on at its left, and at its right the flow that carries the paint.
 *
 * Left button on the page: paint. Sliders: size of the brush, opacity and hue. Keys: 1 to 6
 * colours, k black, x eraser, [ and ] smaller and larger, z undo, c clear, s save to the file, l
 * load it, q quit. On the right the left button turns, the wheel zooms.
 */
class PainterWindow
{
public:
  /**
   * \a flow is an image with the arrays of vtkImplicitFlowField; \a surface, which is up to date,
   * is painted on. The page has \a columns and \a rows.
   */
  PainterWindow(vtkImageData* flow, vtkTerminationSurface* surface, int columns, int rows);
  ~PainterWindow();

  /// Sets the file that the keys s and l write and read. Default paint.png.
  void SetFile(const std::string& file) { this->File = file; }

  vtkRenderWindow* GetWindow() const { return this->Window; }
  vtkRenderWindowInteractor* GetInteractor() const { return this->Interactor; }
  vtkRenderer* GetLeft() const { return this->Left; }
  vtkRenderer* GetRight() const { return this->Right; }
  vtkImplicitFlowVolumeMapper* GetMapper() const { return this->Mapper; }
  PaintCanvas& GetCanvas() { return this->Canvas; }
  const PaintCanvas::Brush& GetBrush() const { return this->Brush; }

  ///@{
  /**
   * For the style: places are in pixels of the window.
   */
  bool IsOnLeft(int x) const;
  bool IsPainting() const { return this->Painting; }
  void BeginStroke(int x, int y);
  void ContinueStroke(int x, int y);
  void EndStroke() { this->Painting = false; }
  /// Returns whether the key means something.
  bool TakeKey(char key);
  /// Draws the flow with fewer pixels while something moves.
  void SetCoarse(bool isCoarse);
  ///@}

private:
  PainterWindow(const PainterWindow&) = delete;
  void operator=(const PainterWindow&) = delete;

  void ShowPage();
  void PlacePage(int columns, int rows, vtkTerminationSurface* surface);
  void ShowFlow(vtkImageData* flow, vtkTerminationSurface* surface);
  void ShowText();
  void ShowSlider(vtkSliderWidget* slider, const char* title, double from, double lower,
    double upper, double value);
  PaintCanvas::Place FindPlace(int x, int y) const;
  void TakeSliders();
  /// Gives the sliders what the brush has.
  void ShowBrush(double hue);

  vtkNew<vtkRenderer> Left;
  vtkNew<vtkRenderer> Right;
  vtkNew<vtkRenderWindow> Window;
  vtkNew<vtkRenderWindowInteractor> Interactor;
  vtkNew<vtkImplicitFlowVolumeMapper> Mapper;
  vtkNew<vtkSliderWidget> Size;
  vtkNew<vtkSliderWidget> Opacity;
  vtkNew<vtkSliderWidget> Hue;
  PaintCanvas Canvas;
  PaintCanvas::Brush Brush;
  PaintCanvas::Place Last{ { 0.0, 0.0 } };
  bool Painting = false;
  std::string File = "paint.png";
};

#endif
