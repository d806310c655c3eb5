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
 * @brief   noise and turbulence on an image: smoke, haze, clouds
 *
 * The output has one point array, the active scalars: `Turbulence`, float. With n(x) the chosen sum
 * of octaves at Frequency x (see Sums), the value at x is
 *   E(x) F(h) (Offset + Amplitude n(x)),
 * or for the envelope CLOUD max(0, E(x) + F(h) (Offset + Amplitude n(x)) - 1).
 *
 * The noise is K. Perlin's improved gradient noise ("Improving noise", SIGGRAPH 2002): 0 at the
 * points of the unit lattice, with continuous second derivatives, mean 0, values between about -1
 * and 1 and period 256 in each direction. Seed 0 is the published permutation; another seed
 * shuffles it in the same way with every compiler and library.
 *
 * The falloff F depends on the height h, 0 at the lower and 1 at the upper bound of VerticalAxis,
 * with t = TopFraction:
 * - NO_FALLOFF: 1;
 * - LINEAR: 1 - (1 - t) h;
 * - EXPONENTIAL: t^h.
 *
 * The envelope E depends on r, 0 at the centre of the bounds and 1 on the ellipsoid that touches
 * all of their sides:
 * - NO_ENVELOPE: 1;
 * - SPHERE and CLOUD: max(0, 1 - r^2).
 *
 * The bytes do not depend on the number of threads. Any part of the whole extent is made alone,
 * with the same values as in the whole.
 *
 * @sa vtkSpatialTurbulence
 */
class INTERLUMESOURCES_EXPORT vtkTurbulenceSource : public vtkBoundedImageSource
{
public:
  static vtkTurbulenceSource* New();
  vtkTypeMacro(vtkTurbulenceSource, vtkBoundedImageSource);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// The ways to sum octaves: the noise alone, the sum of noise(2^i x) / 2^i, or of its absolute
  /// value (C. Zhang, dissertation, Ohio State 2006, section 2.3.2).
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
  /// Returns the name of a sum, falloff or envelope in small letters; null for any other number.
  static const char* GetSumName(int sum);
  static const char* GetFalloffName(int falloff);
  static const char* GetEnvelopeName(int envelope);
  ///@}

  ///@{
  /**
   * The way octaves are summed. Default TURBULENCE. Valid: see Sums; clamped.
   */
  vtkSetClampMacro(Sum, int, NOISE, TURBULENCE);
  vtkGetMacro(Sum, int);
  ///@}

  ///@{
  /**
   * The number of octaves. Default 5. Valid: 1 to 16; clamped.
   */
  vtkSetClampMacro(NumberOfOctaves, int, 1, MaximumNumberOfOctaves);
  vtkGetMacro(NumberOfOctaves, int);
  ///@}

  ///@{
  /**
   * The number of lattice cells of the first octave in a unit of length. Default 2. Valid: 0 to
   * 1e12; clamped, NaN changes nothing.
   */
  void SetFrequency(double frequency);
  vtkGetMacro(Frequency, double);
  ///@}

  ///@{
  /**
   * The factor of the noise, and the value that is added. Default 1, 0. Valid: -1e12 to 1e12;
   * clamped, NaN changes nothing.
   */
  void SetAmplitude(double amplitude);
  vtkGetMacro(Amplitude, double);
  void SetOffset(double offset);
  vtkGetMacro(Offset, double);
  ///@}

  ///@{
  /**
   * The seed of the noise. Default 0.
   */
  vtkSetMacro(Seed, int);
  vtkGetMacro(Seed, int);
  ///@}

  ///@{
  /**
   * The way values fall with height. Default NO_FALLOFF. Valid: see Falloffs; clamped.
   */
  vtkSetClampMacro(Falloff, int, NO_FALLOFF, EXPONENTIAL);
  vtkGetMacro(Falloff, int);
  ///@}

  ///@{
  /**
   * The axis of height: 0, 1, 2 for x, y, z. Default 2. Valid: 0 to 2; clamped.
   */
  vtkSetClampMacro(VerticalAxis, int, 0, 2);
  vtkGetMacro(VerticalAxis, int);
  ///@}

  ///@{
  /**
   * The share of the values that is left at the top. Default 0.1. Valid: 1e-6 to 1; clamped, NaN
   * changes nothing.
   */
  void SetTopFraction(double fraction);
  vtkGetMacro(TopFraction, double);
  ///@}

  ///@{
  /**
   * The shape that values are kept to. Default NO_ENVELOPE. Valid: see Envelopes; clamped.
   */
  vtkSetClampMacro(Envelope, int, NO_ENVELOPE, CLOUD);
  vtkGetMacro(Envelope, int);
  ///@}

  /**
   * Returns the value at one point. It makes the noise's permutation anew.
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
