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
class vtkTimeVaryingIntervalVolume;

namespace gallery
{
struct Scene;

/**
 * Where a scene puts its panels: lays them out in a grid with a caption under each and one legend
 * under all, draws them off-screen at twice the size, and counts what was used.
 */
class Stage
{
public:
  /**
   * A picture of width x height pixels.
   */
  Stage(int width, int height);
  ~Stage();

  /**
   * Number of columns of the grid of panels; rows follow. Default: one row.
   */
  void SetColumns(int columns) { this->Columns = columns; }

  /**
   * Adds a panel, left to right, then top to bottom. It lives as long as the stage.
   */
  Panel& AddPanel(const std::string& caption);

  /**
   * The same, with a camera that looks from \a from, and that the panels added like this share.
   */
  Panel& AddPanel(
    const std::string& caption, const vtkVector3d& from, const vtkVector3d& up = { 0.0, 0.0, 1.0 });

  ///@{
  /**
   * The legend under the panels, one of both: a bar where colour means a value, or a key where it
   * means an interval.
   */
  void SetColourBar(
    const std::string& title, vtkScalarsToColors* colours, double lower, double upper);
  void SetColourKey(const std::string& title, const std::vector<ColourEntry>& entries);
  ///@}

  /**
   * Runs an extraction filter on \a input and adds what it did to the report. Returns its
   * tetrahedra, which outlive another run. Boundary triangles, where asked for, are on the filter's
   * port 1.
   */
  vtkSmartPointer<vtkUnstructuredGrid> Extract(vtkIntervalVolume* filter, vtkDataObject* input);

  /**
   * The same for an interval volume in space and time of a temporal source, over the steps that the
   * filter takes. Boundaries, where asked for, are on the filter's port 1, and counted; 4-simplices
   * on its port 2.
   */
  vtkSmartPointer<vtkUnstructuredGrid> Extract(
    vtkTimeVaryingIntervalVolume* filter, vtkAlgorithm* source);

  /**
   * The same for a flow volume of an implicit flow field with its inflow. Stream surfaces, where
   * asked for, are on the filter's port 1, time surfaces on its port 2, and counted.
   */
  vtkSmartPointer<vtkUnstructuredGrid> Extract(vtkFlowVolume* filter, vtkDataObject* input);

  /**
   * The 4-simplices at one time, as tetrahedra, which are counted.
   */
  vtkSmartPointer<vtkUnstructuredGrid> Slice(vtkUnstructuredGrid* simplices, double time);

  /**
   * The scene moves: \a show makes it as it is at a part of the animation, 0 to 1. Default: none.
   */
  void SetAnimation(const std::function<void(double part)>& show) { this->Show = show; }
  bool HasAnimation() const { return this->Show != nullptr; }

  /**
   * Draws the picture: RGB, unsigned char.
   */
  vtkSmartPointer<vtkImageData> Render();

  /**
   * Draws the animation at a part, as a picture of width x height pixels. It is not counted in the
   * report.
   */
  vtkSmartPointer<vtkImageData> RenderFrame(double part, int width, int height);

  /**
   * Fits the cameras as Render() does, and returns the panels.
   */
  const std::vector<std::unique_ptr<Panel>>& FitPanels();

  /**
   * What was done up to now; complete after Render().
   */
  const SceneReport& GetReport() const { return this->Report; }

private:
  /// Place of a panel in the large picture, in pixels; Caption is the height of its lowest part.
  struct Cell
  {
    int Left;
    int Bottom;
    int Width;
    int Height;
    int Caption;
  };
  Cell GetCell(std::size_t panel) const;
  /// Runs a filter and counts what came out, and how long it took.
  vtkSmartPointer<vtkUnstructuredGrid> Run(vtkAlgorithm* filter);
  void FitCameras();
  vtkSmartPointer<vtkImageData> DrawPaper();

  int Width;
  int Height;
  int Columns = 0;
  std::vector<std::unique_ptr<Panel>> Panels;
  std::function<void(vtkRenderer*, double, double, int)> Legend;
  std::function<void(double)> Show;
  SceneReport Report;
};

/**
 * Builds and draws \a scene and fills the report.
 */
vtkSmartPointer<vtkImageData> RenderScene(
  const Scene& scene, int width, int height, SceneReport& report);

/**
 * The same, and where the scene has an animation gives \a take that many frames of it, evenly
 * spaced from part 0 on, without part 1, of half the picture's width and height.
 */
vtkSmartPointer<vtkImageData> RenderScene(const Scene& scene, int width, int height,
  SceneReport& report, int frames, const std::function<void(vtkImageData* frame)>& take);
}

#endif
