// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkSpatialTurbulence_h
#define vtkSpatialTurbulence_h

#include "InterlumeSourcesModule.h" // for the export macro
#include "vtkSpatialObject.h"
#include "vtkTurbulenceSource.h" // for the sums

#include <vector> // for the noises

/**
 * @class   vtkSpatialTurbulence
 * @brief   hypertexture: noise that displaces or changes the density of a spatial object
 *
 * K. Perlin and E. Hoffert, "Hypertexture", SIGGRAPH 1989. With d the operand's density at x, A the
 * amplitude, n(x) the chosen sum of octaves at Frequency x (see vtkTurbulenceSource) and n1, n2, n3
 * three such sums, with different seeds, the density is
 * - DISPLACEMENT: d(x + A (n1, n2, n3)), with the colour of that place;
 * - MODULATION: d (1 + A n);
 * - EROSION: 1/2 + G (d - A n - 1/2) where d > 0, with the gain G. Soft edges get fringes, and with
 *   a high frequency fur.
 *
 * Each density is clamped to 0 ... 1; the last two modes keep the colour and add nothing where d is
 * 0.
 *
 * Errors (vtkErrorMacro): an operand that has this object among its parts, which is not taken; no
 * operand (density 0).
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

  /// Returns the mode's name in small letters; null for a number that is not a mode.
  static const char* GetModeName(int mode);

  ///@{
  /**
   * The object that is changed. Default null, which is an error when it is evaluated.
   */
  void SetOperand(vtkSpatialObject* operand);
  vtkSpatialObject* GetOperand() const;
  ///@}

  ///@{
  /**
   * The effect of the noise. Default DISPLACEMENT. Valid: see Modes; clamped.
   */
  vtkSetClampMacro(Mode, int, DISPLACEMENT, EROSION);
  vtkGetMacro(Mode, int);
  void SetModeToDisplacement() { this->SetMode(DISPLACEMENT); }
  void SetModeToModulation() { this->SetMode(MODULATION); }
  void SetModeToErosion() { this->SetMode(EROSION); }
  ///@}

  ///@{
  /**
   * The way octaves are summed. Default TURBULENCE. Valid: see vtkTurbulenceSource::Sums; clamped.
   */
  vtkSetClampMacro(Sum, int, vtkTurbulenceSource::NOISE, vtkTurbulenceSource::TURBULENCE);
  vtkGetMacro(Sum, int);
  ///@}

  ///@{
  /**
   * The number of octaves. Default 4. Valid: 1 to 16; clamped.
   */
  vtkSetClampMacro(NumberOfOctaves, int, 1, vtkTurbulenceSource::MaximumNumberOfOctaves);
  vtkGetMacro(NumberOfOctaves, int);
  ///@}

  ///@{
  /**
   * The number of lattice cells of the first octave in a unit of length, each 0 or more, along x,
   * y, z. Default 4 each. Valid: 0 to 1e12; clamped, NaN changes nothing.
   */
  void SetFrequency(double x, double y, double z);
  void SetFrequency(double frequency) { this->SetFrequency(frequency, frequency, frequency); }
  vtkGetVector3Macro(Frequency, double);
  ///@}

  ///@{
  /**
   * The factor A of the noise: a length for DISPLACEMENT, a density else. Default 0.1. Valid: -1e12
   * to 1e12; clamped, NaN changes nothing.
   */
  void SetAmplitude(double amplitude);
  vtkGetMacro(Amplitude, double);
  ///@}

  ///@{
  /**
   * The gain G of EROSION: the larger, the sharper the edge of what is left. Default 1. Valid: 0 to
   * 1e12; clamped, NaN changes nothing.
   */
  void SetGain(double gain);
  vtkGetMacro(Gain, double);
  ///@}

  ///@{
  /**
   * The seed of the noise. Default 0.
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

  /// Makes one noise for each direction, all from the seed.
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
