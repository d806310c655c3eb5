#ifndef vtkTemporalImageSource_h
#define vtkTemporalImageSource_h

#include "InterlumeSourcesModule.h" // for the export macro
#include "vtkFieldSampler.h"        // for the time steps and the array
#include "vtkImageAlgorithm.h"

/**
 * @class   vtkTemporalImageSource
 * @brief   a scalar field of space and time on an image: the part that does not depend on the field
 *
 * The output has one point array, the active scalars, and the time in DATA_TIME_STEP. The field is
 * evaluated for the time that is asked for, whether it is one of the time steps, between them or
 * beyond them; without one, for the first time step. Any part of the whole extent is made alone,
 * with the same values as in the whole.
 *
 * Errors (vtkErrorMacro, empty output): a time that is not finite.
 *
 * @sa vtkAnalyticFieldSource vtkTemporalGridSource
 */
class INTERLUMESOURCES_EXPORT vtkTemporalImageSource : public vtkImageAlgorithm
{
public:
  vtkAbstractTypeMacro(vtkTemporalImageSource, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * The field at one point and time.
   */
  double Evaluate(const double x[3], double t) const { return this->GetFieldAtTime(t)(x); }

  ///@{
  /**
   * The extent of the whole image, in point indices. Default 0 to 63 in each direction. Valid:
   * -32768 to 32767, the upper index not below the lower; clamped.
   */
  void SetWholeExtent(int x0, int x1, int y0, int y1, int z0, int z1);
  void SetWholeExtent(const int extent[6]);
  vtkGetVector6Macro(WholeExtent, int);
  ///@}

  /**
   * Makes the whole extent start at 0 with so many points in each direction.
   */
  void SetDimensions(int x, int y, int z);

  ///@{
  /**
   * The positions of the first and the last points of the whole extent in each direction, in units
   * of length. Default -1 to 1. Valid: finite, the upper one above the lower; other values are an
   * error and change nothing. With one point in a direction the point is at the lower one.
   */
  void SetBounds(double x0, double x1, double y0, double y1, double z0, double z1);
  void SetBounds(const double bounds[6]);
  vtkGetVector6Macro(Bounds, double);
  ///@}

  ///@{
  /**
   * Number of time steps, evenly spaced over the time range. One step is at its start, and there is
   * one where the range has no length. Default 3. Valid: 1 to 100000; clamped.
   */
  void SetNumberOfTimeSteps(int number) { this->Sampler.SetNumberOfTimeSteps(number, this); }
  int GetNumberOfTimeSteps() const { return this->Sampler.GetNumberOfTimeSteps(); }
  ///@}

  ///@{
  /**
   * The times of the first and the last time step, in units of time. Default 0, 2. Valid: finite,
   * else an error; put in order.
   */
  void SetTimeRange(double first, double last) { this->Sampler.SetTimeRange(first, last, this); }
  const double* GetTimeRange() const VTK_SIZEHINT(2) { return this->Sampler.GetTimeRange(); }
  ///@}

  ///@{
  /**
   * Type of the array: VTK_FLOAT or VTK_DOUBLE; anything else is taken as float. Default VTK_FLOAT.
   */
  void SetOutputScalarType(int type) { this->Sampler.SetScalarType(type, this); }
  int GetOutputScalarType() const { return this->Sampler.GetScalarType(); }
  ///@}

  ///@{
  /**
   * Name of the point array. Default "f", which null and an empty name stand for too.
   */
  void SetArrayName(const char* name) { this->Sampler.SetArrayName(name, this); }
  const char* GetArrayName() const { return this->Sampler.GetArrayName(); }
  ///@}

protected:
  vtkTemporalImageSource();
  ~vtkTemporalImageSource() override = default;

  /// The field at time \a t, for many positions. It is called by several threads at once.
  virtual vtkFieldSampler::Field GetFieldAtTime(double t) const = 0;

  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  int WholeExtent[6] = { 0, 63, 0, 63, 0, 63 };
  double Bounds[6] = { -1.0, 1.0, -1.0, 1.0, -1.0, 1.0 };
  vtkFieldSampler Sampler;

private:
  vtkTemporalImageSource(const vtkTemporalImageSource&) = delete;
  void operator=(const vtkTemporalImageSource&) = delete;

  /// Places the point of index 0 and the distance of points.
  void GetLattice(double origin[3], double spacing[3]) const;
};

#endif
