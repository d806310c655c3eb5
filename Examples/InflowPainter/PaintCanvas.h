// SPDX-License-Identifier: BSD-3-Clause
#ifndef PaintCanvas_h
#define PaintCanvas_h

#include <vtkImageData.h> // required by conversions of pointers to it
#include <vtkSmartPointer.h>

#include <array>
#include <string>
#include <vector>

/**
 * An image to paint on with a round brush: RGBA, unsigned char, initially transparent. Positions
 * are in pixels; (0, 0) is the center of the first pixel.
 */
class PaintCanvas
{
public:
  using Position = std::array<double, 2>;

  struct Brush
  {
    /// Radius in pixels. Pixels whose centers are within half a pixel of the brush's edge are
    /// partly covered.
    double Radius = 14.0;
    /// Red, green, blue and opacity, each in [0, 1]. Opacity 0 erases.
    std::array<double, 4> Color{ { 0.9, 0.13, 0.13, 0.7 } };
  };

  PaintCanvas(int columns, int rows);

  /// Returns the painted image. Each change increases its modification time.
  vtkImageData* GetPaint() const { return this->Paint; }
  /// Returns the painted image on a white background, as RGB.
  vtkImageData* GetPage() const { return this->Page; }

  /// Saves the current state for Undo(). Call it before each change that can be undone.
  void SaveState();
  /// Restores the last saved state. Returns false if no state is saved.
  bool Undo();
  /// Paints along a line. Covered pixels get the color and opacity of the brush, so repeated
  /// strokes do not accumulate.
  void Stroke(const Position& from, const Position& to, const Brush& brush);
  void Clear();

  ///@{
  /**
   * Load() reads an image file in any format that VTK supports and scales it to the canvas. Save()
   * writes a PNG file. Both return an error message, or an empty string on success.
   */
  std::string Load(const std::string& file);
  std::string Save(const std::string& file) const;
  ///@}

private:
  /// Maximum number of steps that can be undone.
  static constexpr std::size_t MaximumSteps = 50;

  /// Updates a range of columns and rows of the page from the paint. The bounds are inclusive.
  void UpdatePage(int firstColumn, int lastColumn, int firstRow, int lastRow);
  void UpdateEntirePage();

  std::array<int, 2> Size;
  vtkSmartPointer<vtkImageData> Paint;
  vtkSmartPointer<vtkImageData> Page;
  std::vector<std::vector<unsigned char>> Steps;
};

#endif
