// SPDX-License-Identifier: BSD-3-Clause
#ifndef PaintCanvas_h
#define PaintCanvas_h

#include <vtkImageData.h> // for conversions of its pointers
#include <vtkSmartPointer.h>

#include <array>
#include <string>
#include <vector>

/**
 * An image that is painted on with a round brush: RGBA, unsigned char, transparent at first. Places
 * are in pixels, (0, 0) in the middle of the first one.
 */
class PaintCanvas
{
public:
  using Place = std::array<double, 2>;

  struct Brush
  {
    /// In pixels. Where a pixel's middle is within half a pixel of the rim, paint covers a part.
    double Radius = 14.0;
    /// Red, green, blue and opacity, 0 to 1. Opacity 0 erases.
    std::array<double, 4> Colour{ { 0.9, 0.13, 0.13, 0.7 } };
  };

  PaintCanvas(int columns, int rows);

  /// Returns the paint, which becomes newer with each change.
  vtkImageData* GetPaint() const { return this->Paint; }
  /// Returns the paint on white paper, RGB.
  vtkImageData* GetPage() const { return this->Page; }

  /// Keeps what is there for Undo. Call it before each change that shall be undone alone.
  void Keep();
  /// Brings back what was kept last. Returns false where nothing is kept.
  bool Undo();
  /// Replaces the paint along a line: opacity and colour are the brush's, however often it passes.
  void Stroke(const Place& from, const Place& to, const Brush& brush);
  void Clear();

  ///@{
  /**
   * Reads an image file of any format that VTK knows, fitted to the size of the canvas, or writes a
   * PNG file. Both return what went wrong, or nothing.
   */
  std::string Load(const std::string& file);
  std::string Save(const std::string& file) const;
  ///@}

private:
  /// The largest number of steps that can be undone.
  static constexpr std::size_t MostSteps = 50;

  /// Tells that pixels of these columns and rows have changed, ends included.
  void Touch(int firstColumn, int lastColumn, int firstRow, int lastRow);
  void TouchAll();

  std::array<int, 2> Size;
  vtkSmartPointer<vtkImageData> Paint;
  vtkSmartPointer<vtkImageData> Page;
  std::vector<std::vector<unsigned char>> Steps;
};

#endif
