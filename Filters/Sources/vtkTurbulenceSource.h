// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkTurbulenceSource_h
#define vtkTurbulenceSource_h

#include "InterlumeSourcesModule.h" // for the export macro
#include "vtkBoundedImageSource.h"

namespace interlume
{
class GradientNoise;
}

/**
 * @class   vtkTurbulenceSource
 * @brief   generate noise and turbulence on an image: smoke, haze, clouds
 *
 * The output has one point array, the active scalars: `Turbulence`, float. With n(x) the sum of
 * octaves at the point Frequency * x (see Sums), falloff F and envelope E, the value at x is E(x)
 * F(h) (Offset + Amplitude n(x)), or, for the envelope CLOUD, max(0, E(x) + F(h) (Offset +
 * Amplitude n(x)) - 1).
 *
 * The noise is K. Perlin's improved gradient noise ("Improving noise", SIGGRAPH 2002). It is 0 at
 * integer points and has continuous second derivatives, a mean of 0, values between about -1 and 1,
 * and a period of 256 in each direction. Seed 0 uses the published permutation. Other seeds shuffle
 * the numbers 0 to 255, with the same result for every compiler and library.
 *
 * The falloff F depends on the height h, 0 at the lower and 1 at the upper bound of VerticalAxis.
 * With t = TopFraction it is
 * - NO_FALLOFF: 1;
 * - LINEAR: 1 - (1 - t) h;
 * - EXPONENTIAL: t^h.
 *
 * The envelope E depends on r, 0 at the center of the bounds and 1 on the largest ellipsoid in the
 * bounds. It is
 * - NO_ENVELOPE: 1;
 * - SPHERE and CLOUD: max(0, 1 - r^2).
 *
 * The output does not depend on the number of threads or on the requested extent.
 *
 * @sa vtkSpatialTurbulence
 */
class INTERLUMESOURCES_EXPORT vtkTurbulenceSource : public vtkBoundedImageSource
{
public:
  static vtkTurbulenceSource* New();
  vtkTypeMacro(vtkTurbulenceSource, vtkBoundedImageSource);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Methods of summing octaves: the noise itself, the sum of noise(2^i x) / 2^i, or the sum of
  /// |noise(2^i x)| / 2^i (C. Zhang, dissertation, Ohio State 2006, section 2.3.2).
  enum Sums
  {
    NOISE = 0,
    FRACTAL_SUM = 1,
    TURBULENCE = 2
  };

  static constexpr int MaximumNumberOfOctaves = 16;

  enum Falloffs
  {
    NO_FALLOFF = 0,
    LINEAR = 1,
    EXPONENTIAL = 2,
    NUMBER_OF_FALLOFFS = 3
  };

  enum Envelopes
  {
    NO_ENVELOPE = 0,
    SPHERE = 1,
    CLOUD = 2,
    NUMBER_OF_ENVELOPES = 3
  };

  ///@{
  /// Returns the lowercase name of a sum, falloff or envelope, or null if the number is invalid.
  static const char* GetSumName(int sum);
  static const char* GetFalloffName(int falloff);
  static const char* GetEnvelopeName(int envelope);
  ///@}

  ///@{
  /**
   * Set/Get the method of summing octaves. Default TURBULENCE. Valid: see Sums; clamped.
   */
  vtkSetClampMacro(Sum, int, NOISE, TURBULENCE);
  vtkGetMacro(Sum, int);
  ///@}

  ///@{
  /**
   * Set/Get the number of octaves. Default 5. Valid: 1 to 16; clamped.
   */
  vtkSetClampMacro(NumberOfOctaves, int, 1, MaximumNumberOfOctaves);
  vtkGetMacro(NumberOfOctaves, int);
  ///@}

  ///@{
  /**
   * Set/Get the number of noise cells per unit of length, for the first octave. Default 2. Valid: 0
   * to 1e12; clamped, NaN is ignored.
   */
  void SetFrequency(double frequency);
  vtkGetMacro(Frequency, double);
  ///@}

  ///@{
  /**
   * Set/Get the factor that multiplies the noise, and the value that is then added. Default 1, 0.
   * Valid: -1e12 to 1e12; clamped, NaN is ignored.
   */
  void SetAmplitude(double amplitude);
  vtkGetMacro(Amplitude, double);
  void SetOffset(double offset);
  vtkGetMacro(Offset, double);
  ///@}

  ///@{
  /**
   * Set/Get the seed of the noise. Default 0.
   */
  vtkSetMacro(Seed, int);
  vtkGetMacro(Seed, int);
  ///@}

  ///@{
  /**
   * Set/Get the falloff with height. Default NO_FALLOFF. Valid: see Falloffs; clamped.
   */
  vtkSetClampMacro(Falloff, int, NO_FALLOFF, EXPONENTIAL);
  vtkGetMacro(Falloff, int);
  ///@}

  ///@{
  /**
   * Set/Get the axis along which the height is measured: 0, 1, 2 for x, y, z. Default 2. Valid: 0
   * to 2; clamped.
   */
  vtkSetClampMacro(VerticalAxis, int, 0, 2);
  vtkGetMacro(VerticalAxis, int);
  ///@}

  ///@{
  /**
   * Set/Get the value of the falloff at the upper bound. Default 0.1. Valid: 1e-6 to 1; clamped,
   * NaN is ignored.
   */
  void SetTopFraction(double fraction);
  vtkGetMacro(TopFraction, double);
  ///@}

  ///@{
  /**
   * Set/Get the envelope. Default NO_ENVELOPE. Valid: see Envelopes; clamped.
   */
  vtkSetClampMacro(Envelope, int, NO_ENVELOPE, CLOUD);
  vtkGetMacro(Envelope, int);
  ///@}

  /**
   * Returns the value at one point. Each call recomputes the permutation of the noise.
   */
  double Evaluate(const double x[3]) const;

protected:
  vtkTurbulenceSource() = default;
  ~vtkTurbulenceSource() override = default;

  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkTurbulenceSource(const vtkTurbulenceSource&) = delete;
  void operator=(const vtkTurbulenceSource&) = delete;

  double Evaluate(const interlume::GradientNoise& noise, const double x[3]) const;
  double GetFalloffFactor(const double x[3]) const;
  double GetEnvelopeFactor(const double x[3]) const;

  int Sum = TURBULENCE;
  int NumberOfOctaves = 5;
  double Frequency = 2.0;
  double Amplitude = 1.0;
  double Offset = 0.0;
  int Seed = 0;
  int Falloff = NO_FALLOFF;
  int VerticalAxis = 2;
  double TopFraction = 0.1;
  int Envelope = NO_ENVELOPE;
};

#endif
