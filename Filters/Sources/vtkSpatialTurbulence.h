// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkSpatialTurbulence_h
#define vtkSpatialTurbulence_h

#include "InterlumeSourcesModule.h" // for the export macro
#include "vtkSpatialObject.h"
#include "vtkTurbulenceSource.h" // for the sums

#include <vector> // for the noises

/**
 * @class   vtkSpatialTurbulence
 * @brief   hypertexture: displace or modify the density of a spatial object with noise
 *
 * The method is from K. Perlin and E. Hoffert, "Hypertexture", SIGGRAPH 1989. Let d be the
 * operand's density at x, A the amplitude, n(x) the sum of octaves at the point Frequency * x (see
 * vtkTurbulenceSource), and n1, n2, n3 three such sums with different seeds. The density is
 * - DISPLACEMENT: d(x + A (n1, n2, n3)), with the color at the displaced position;
 * - MODULATION: d (1 + A n);
 * - EROSION: 1/2 + G (d - A n - 1/2) if d > 0, with the gain G. It frays soft edges, or turns them
 *   into fur if the frequency is high.
 *
 * The density is clamped to 0 ... 1. MODULATION and EROSION keep the color, and the density remains
 * 0 where d is 0.
 *
 * Errors (vtkErrorMacro): the new operand contains this object (it is ignored); there is no operand
 * when the object is evaluated (density 0).
 */
class INTERLUMESOURCES_EXPORT vtkSpatialTurbulence : public vtkSpatialObject
{
public:
  static vtkSpatialTurbulence* New();
  vtkTypeMacro(vtkSpatialTurbulence, vtkSpatialObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum Modes
  {
    DISPLACEMENT = 0,
    MODULATION = 1,
    EROSION = 2,
    NUMBER_OF_MODES = 3
  };

  /// Returns the lowercase name of a mode, or null if there is no such mode.
  static const char* GetModeName(int mode);

  ///@{
  /**
   * Set/Get the object to modify. Default null; evaluating without an operand is an error.
   */
  void SetOperand(vtkSpatialObject* operand);
  vtkSpatialObject* GetOperand() const;
  ///@}

  ///@{
  /**
   * Set/Get the effect of the noise. Default DISPLACEMENT. Valid: see Modes; clamped.
   */
  vtkSetClampMacro(Mode, int, DISPLACEMENT, EROSION);
  vtkGetMacro(Mode, int);
  void SetModeToDisplacement() { this->SetMode(DISPLACEMENT); }
  void SetModeToModulation() { this->SetMode(MODULATION); }
  void SetModeToErosion() { this->SetMode(EROSION); }
  ///@}

  ///@{
  /**
   * Set/Get the method of summing octaves. Default TURBULENCE. Valid: see
   * vtkTurbulenceSource::Sums; clamped.
   */
  vtkSetClampMacro(Sum, int, vtkTurbulenceSource::NOISE, vtkTurbulenceSource::TURBULENCE);
  vtkGetMacro(Sum, int);
  ///@}

  ///@{
  /**
   * Set/Get the number of octaves. Default 4. Valid: 1 to 16; clamped.
   */
  vtkSetClampMacro(NumberOfOctaves, int, 1, vtkTurbulenceSource::MaximumNumberOfOctaves);
  vtkGetMacro(NumberOfOctaves, int);
  ///@}

  ///@{
  /**
   * Set/Get the number of noise cells per unit of length along x, y and z, for the first octave.
   * Default (4, 4, 4). Valid: 0 to 1e12; clamped, NaN is ignored.
   */
  void SetFrequency(double x, double y, double z);
  void SetFrequency(double frequency) { this->SetFrequency(frequency, frequency, frequency); }
  vtkGetVector3Macro(Frequency, double);
  ///@}

  ///@{
  /**
   * Set/Get the factor A of the noise: a length for DISPLACEMENT, a relative change of the density
   * for MODULATION, and a density for EROSION. Default 0.1. Valid: -1e12 to 1e12; clamped, NaN is
   * ignored.
   */
  void SetAmplitude(double amplitude);
  vtkGetMacro(Amplitude, double);
  ///@}

  ///@{
  /**
   * Set/Get the gain G of EROSION. Larger values sharpen the eroded edge. Default 1. Valid: 0 to
   * 1e12; clamped, NaN is ignored.
   */
  void SetGain(double gain);
  vtkGetMacro(Gain, double);
  ///@}

  ///@{
  /**
   * Set/Get the seed of the noise. Default 0.
   */
  void SetSeed(int seed);
  vtkGetMacro(Seed, int);
  ///@}

  bool Contains(const vtkSpatialObject* object) const override;
  vtkMTimeType GetMTime() override;

protected:
  vtkSpatialTurbulence();
  ~vtkSpatialTurbulence() override;

  std::string Prepare(double bounds[6]) override;
  bool EvaluateLocally(const double (*points)[3], int number, Sample* samples) const override;

private:
  vtkSpatialTurbulence(const vtkSpatialTurbulence&) = delete;
  void operator=(const vtkSpatialTurbulence&) = delete;

  /// Creates one noise function per direction from the seed.
  void MakeNoises();
  double GetNoise(const interlume::GradientNoise& noise, const double x[3]) const;
  bool Displace(const double (*points)[3], int number, Sample* samples) const;

  vtkSmartPointer<vtkSpatialObject> Operand;
  std::vector<interlume::GradientNoise> Noises;

  int Mode = DISPLACEMENT;
  int Sum = vtkTurbulenceSource::TURBULENCE;
  int NumberOfOctaves = 4;
  double Frequency[3] = { 4.0, 4.0, 4.0 };
  double Amplitude = 0.1;
  double Gain = 1.0;
  int Seed = 0;
};

#endif
