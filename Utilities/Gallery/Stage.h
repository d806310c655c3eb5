// SPDX-License-Identifier: BSD-3-Clause
#ifndef Stage_h
#define Stage_h

#include "Gallery/Legend.h"
#include "Gallery/Panel.h"
#include "Gallery/SceneReport.h"

#include "vtkImageData.h"
#include "vtkSmartPointer.h"
#include "vtkUnstructuredGrid.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

class vtkAlgorithm;
class vtkDataObject;
class vtkFlowVolume;
class vtkIntervalVolume;
class vtkRenderer;
class vtkScalarsToColors;
class vtkSimplexTimeSlice;
class vtkTimeVaryingIntervalVolume;

namespace gallery
{
struct Scene;

/**
 * Width and height of an image in pixels, and the number of samples per pixel in each direction.
 */
struct ImageSize
{
  int Width;
  int Height;
  int Samples = 2;
};

/**
 * Arranges the panels of a scene in a grid, with a caption under each panel and one legend under
 * all panels. Renders the image off-screen with several samples per pixel, averages them, and
 * counts the resources used.
 */
class Stage
{
public:
  explicit Stage(const ImageSize& size);
  ~Stage();

  /**
   * Sets the number of columns of the panel grid. Default: all panels in one row.
   */
  void SetColumns(int columns) { this->Columns = columns; }

  /**
   * Adds a panel. Panels are arranged from left to right, then from top to bottom. The panel lives
   * as long as the stage.
   */
  Panel& AddPanel(const std::string& caption);

  /**
   * Adds a panel whose camera looks from \a from. All panels added with this overload share the
   * camera of the first panel.
   */
  Panel& AddPanel(
    const std::string& caption, const vtkVector3d& from, const vtkVector3d& up = { 0.0, 0.0, 1.0 });

  ///@{
  /**
   * Set the legend under the panels: a color bar for values, or a color key for intervals. Each
   * call replaces the previous legend.
   */
  void SetColorBar(
    const std::string& title, vtkScalarsToColors* colors, double lower, double upper);
  void SetColorKey(const std::string& title, const std::vector<ColorEntry>& entries);
  ///@}

  /**
   * Runs an extraction filter on \a input and adds its statistics to the report. Returns a copy of
   * its tetrahedra, which is not affected by further runs. Boundary triangles, if generated, are on
   * port 1 of the filter.
   */
  vtkSmartPointer<vtkUnstructuredGrid> Extract(vtkIntervalVolume* filter, vtkDataObject* input);

  /**
   * Runs a time-varying interval volume on a temporal source, over the time steps selected in the
   * filter, and adds its statistics to the report. Boundaries, if generated, are on port 1 of the
   * filter, and 4-simplices on port 2.
   */
  vtkSmartPointer<vtkUnstructuredGrid> Extract(
    vtkTimeVaryingIntervalVolume* filter, vtkAlgorithm* source);

  /**
   * Runs a flow volume on an implicit flow field with inflow values, and adds its statistics to the
   * report. Stream surfaces, if generated, are on port 1 of the filter, and time surfaces on port
   * 2.
   */
  vtkSmartPointer<vtkUnstructuredGrid> Extract(vtkFlowVolume* filter, vtkDataObject* input);

  /**
   * Runs a time slice on 4-simplices and adds its statistics to the report. Returns its tetrahedra.
   */
  vtkSmartPointer<vtkUnstructuredGrid> Extract(
    vtkSimplexTimeSlice* filter, vtkDataObject* simplices);

  /**
   * Sets the animation: \a show sets the scene to its state at \a fraction, 0 to 1, of the
   * animation. Default: no animation.
   */
  void SetAnimation(const std::function<void(double fraction)>& show) { this->Show = show; }
  bool HasAnimation() const { return this->Show != nullptr; }

  /**
   * Renders the image (RGB, unsigned char).
   */
  vtkSmartPointer<vtkImageData> Render();

  /**
   * Renders the frame at \a fraction of the animation. The report does not include it.
   */
  vtkSmartPointer<vtkImageData> RenderFrame(double fraction, const ImageSize& size);

  /**
   * Fits the cameras as Render() does, and returns the panels.
   */
  const std::vector<std::unique_ptr<Panel>>& FitPanels();

  /**
   * Returns the statistics collected so far. They are complete after Render().
   */
  const SceneReport& GetReport() const { return this->Report; }

private:
  /// Location of a panel in the supersampled image, in pixels. Caption is the height of the caption
  /// at the bottom of the cell.
  struct Cell
  {
    int Left;
    int Bottom;
    int Width;
    int Height;
    int Caption;
  };
  Cell GetCell(std::size_t panel) const;
  /// Runs a filter and returns its tetrahedra. Adds their number and the run time to the report.
  vtkSmartPointer<vtkUnstructuredGrid> Run(vtkAlgorithm* filter);
  void FitCameras();
  vtkSmartPointer<vtkImageData> DrawCaptions();

  int GetFontSize() const;

  /// Width and height of the supersampled image, and samples per pixel in each direction.
  int Width;
  int Height;
  int Samples;
  int Columns = 0;
  std::vector<std::unique_ptr<Panel>> Panels;
  std::function<void(vtkRenderer*, double, double, int)> Legend;
  std::function<void(double)> Show;
  SceneReport Report;
};

/**
 * Builds and renders \a scene, and fills the report.
 */
vtkSmartPointer<vtkImageData> RenderScene(
  const Scene& scene, const ImageSize& size, SceneReport& report);

/**
 * As above. If the scene has an animation, also renders \a frames frames and passes each to
 * \a take. Frames are evenly spaced over fractions from 0 (inclusive) to 1 (exclusive). They have
 * half the width and height of the image, and at most 2 x 2 samples per pixel.
 */
vtkSmartPointer<vtkImageData> RenderScene(const Scene& scene, const ImageSize& size,
  SceneReport& report, int frames, const std::function<void(vtkImageData* frame)>& take);
}

#endif
