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
 * A window with a page to paint on (left) and the flow that carries the paint (right).
 *
 * Page: the left button paints. Sliders: brush size, opacity and hue. Keys: 1 to 6 select a color,
 * k selects black, x selects the eraser, [ and ] shrink and enlarge the brush, z undoes, c clears,
 * s saves the file, l loads it, q quits. Flow: the left button rotates, the wheel zooms.
 */
class PainterWindow
{
public:
  /**
   * \a flow is an image with the output arrays of vtkImplicitFlowField. \a surface is the
   * termination surface to paint on; it must be up to date. The page has \a columns x \a rows
   * pixels.
   */
  PainterWindow(vtkImageData* flow, vtkTerminationSurface* surface, int columns, int rows);
  ~PainterWindow();

  /// Sets the file that the keys s and l save and load. Default: paint.png.
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
   * Called by the interactor style. Positions are in window pixels.
   */
  bool IsOverPage(int x) const;
  bool IsPainting() const { return this->Painting; }
  void BeginStroke(int x, int y);
  void ContinueStroke(int x, int y);
  void EndStroke() { this->Painting = false; }
  /// Handles a key. Returns false if the key is not assigned.
  bool HandleKey(char key);
  /// If \a isCoarse is true, renders the flow at reduced resolution, for interaction.
  void SetReducedResolution(bool isCoarse);
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
  PaintCanvas::Position FindCanvasPosition(int x, int y) const;
  void ReadSliders();
  /// Sets the brush to the color of \a hue, unless it is negative, and updates the sliders.
  void SetBrushHue(double hue);

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
  PaintCanvas::Position Last{ { 0.0, 0.0 } };
  bool Painting = false;
  std::string File = "paint.png";
};

#endif
