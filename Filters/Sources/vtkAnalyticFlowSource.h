// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkAnalyticFlowSource_h
#define vtkAnalyticFlowSource_h

#include "InterlumeSourcesModule.h" // for the export macro
#include "vtkBoundedImageSource.h"

/**
 * @class   vtkAnalyticFlowSource
 * @brief   steady velocity fields with known formulas, on an image
 *
 * The output has one point array, the active vectors: `Velocity`, three components, in units of
 * length per unit of time. In the formulas x is relative to Center, and a = Axis / |Axis|:
 *
 * - UNIFORM: v = Velocity.
 * - ROTATION: v = AngularVelocity a x x, as of a rigid body.
 * - SADDLE: v = (SaddleRates[0] x, SaddleRates[1] y, SaddleRates[2] z).
 * - NODE: v = (NodeRates[0] x, NodeRates[1] y, NodeRates[2] z) + Swirl a x x. A source, a sink with
 *   rates below 0, and spirals with a Swirl.
 * - SOURCE_SINK: a source at -Separation/2 and a sink at +Separation/2, each with
 *   v = Strength d / (4 pi |d|^3), d the way from it, and inside CoreRadius R from it
 *   v = Strength d / (4 pi R^3). Through a surface around the source goes the volume Strength in a
 *   unit of time. Free of divergence outside of both cores.
 * - COUPLED_CHARGE: the field of two charges of opposite sign there, with cores that are softened
 *   all over, Strength d / (|d|^2 + CoreRadius^2)^(3/2). A stand-in for the data of C. Zhang,
 *   dissertation, Ohio State 2006, figure 4.9.
 * - SPHERE: potential flow of far velocity U = Velocity around a sphere of Radius R:
 *   v = U (1 + R^3 / (2 r^3)) - 3 R^3 / (2 r^5) (U . x) x.
 * - CYLINDER: potential flow around a cylinder of Radius R along Axis: with U the part of Velocity
 *   across the axis, y that of x, v = U (1 + R^2 / r^2) - 2 R^2 / r^4 (U . y) y, and along the axis
 *   that of Velocity + SpanwiseVelocity.
 * - ABC: v = (A sin kz + C cos ky, B sin kx + A cos kz, C sin ky + B cos kx) with (A, B, C) =
 *   Amplitudes and k = 2 pi / Period (Arnold, Beltrami and Childress). Its curl is k v.
 * - SHEAR: v = U tanh(a . x / Thickness), U the part of Velocity across Axis.
 * - HURRICANE: a stand-in for the data of hurricane Isabel (ibid., figures 4.10 and 4.17). The
 *   ground is at z = -Height/2, h = 0 there and 1 at the top. The axis passes AxisTilt (h - 1/2) +
 *   AxisBend sin(pi h) in (x,y). With r the distance from it in its plane z = const, R = EyeRadius
 *   and s = (r/R)^2:
 *     swirl  2 MaximumWind (r/R) / ((1 + s) (1 + h^2)): largest at r = R on the ground,
 *     rise   (1/r) dpsi/dr,  inflow  -(1/r) dpsi/dz, of the stream function
 *     psi = Updraft R^2 / (2 q) sin(pi h) s (s - 0.2) / (2 + s)^2.
 *   q = 0.14174... is such that Updraft is the largest rise: a ring at r = 1.07 R. Inside 0.31 R,
 *   the eye, air sinks by up to 0.35 Updraft. Wind flows in below the middle and out above. The
 *   rise goes along the axis: where it leans, a part of it is horizontal.
 * - TORNADO: Burgers' vortex around an axis that bends like the hurricane's, with r, h, and Height
 *   as there: swirl Circulation / (2 pi r) (1 - exp(-r^2 / CoreRadius^2)), inflow -Strain r / 2,
 *   rise Strain Height h, which is 0 on the ground.
 *
 * All but NODE, SOURCE_SINK and COUPLED_CHARGE are free of divergence with the defaults, SADDLE if
 * its rates have the sum 0.
 *
 * The bytes do not depend on the number of threads. Any part of the whole extent is made alone,
 * with the same values as in the whole.
 *
 * @sa vtkAnalyticFieldSource
 */
class INTERLUMESOURCES_EXPORT vtkAnalyticFlowSource : public vtkBoundedImageSource
{
public:
  static vtkAnalyticFlowSource* New();
  vtkTypeMacro(vtkAnalyticFlowSource, vtkBoundedImageSource);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum Fields
  {
    UNIFORM = 0,
    ROTATION = 1,
    SADDLE = 2,
    NODE = 3,
    SOURCE_SINK = 4,
    COUPLED_CHARGE = 5,
    SPHERE = 6,
    CYLINDER = 7,
    ABC = 8,
    SHEAR = 9,
    HURRICANE = 10,
    TORNADO = 11,
    NUMBER_OF_FIELDS = 12
  };

  enum Insides
  {
    /// The velocity is 0.
    ZERO = 0,
    /// The velocity is NaN.
    NOT_A_NUMBER = 1,
    /// The velocity is 0, and the points are hidden: the output has an array vtkGhostType.
    HIDDEN = 2,
    NUMBER_OF_INSIDES = 3
  };

  ///@{
  /// Returns the name of a field in small letters; null for a number that is not a field.
  static const char* GetFieldName(int field);
  static const char* GetInsideName(int inside);
  ///@}

  ///@{
  /**
   * The field that is computed. Default HURRICANE. Valid: see Fields; clamped.
   */
  vtkSetClampMacro(Field, int, UNIFORM, TORNADO);
  vtkGetMacro(Field, int);
  ///@}

  ///@{
  /**
   * The type of the array: VTK_FLOAT or VTK_DOUBLE; anything else is taken as double. Default
   * VTK_DOUBLE.
   */
  void SetOutputScalarType(int type);
  vtkGetMacro(OutputScalarType, int);
  ///@}

  /// Computes the velocity at any point.
  void Evaluate(const double x[3], double velocity[3]) const;

  /// Computes the derivatives of the velocity, dv[i]/dx[j] at [3 i + j], exact to rounding. At the
  /// edge of a core they are those outside of it.
  void EvaluateJacobian(const double x[3], double jacobian[9]) const;

  ///@{
  /**
   * The centre of a field. Default (0, 0, 0). For this and all values below, NaN changes nothing,
   * and other values are clamped, to -1e12 ... 1e12 where nothing else is said.
   */
  void SetCenter(double x, double y, double z) { this->SetVector(this->Center, x, y, z); }
  vtkGetVector3Macro(Center, double);
  ///@}

  ///@{
  /**
   * The velocity of UNIFORM, far from SPHERE and CYLINDER, and on one side of SHEAR. Default (1, 0,
   * 0).
   */
  void SetVelocity(double x, double y, double z) { this->SetVector(this->Velocity, x, y, z); }
  vtkGetVector3Macro(Velocity, double);
  ///@}

  ///@{
  /**
   * The axis of ROTATION, of NODE's swirl, of CYLINDER, and SHEAR's normal; its length does not
   * matter. Default (0, 0, 1). Valid: finite and not 0; else an error, and nothing changes.
   */
  void SetAxis(double x, double y, double z);
  vtkGetVector3Macro(Axis, double);
  ///@}

  ///@{
  /**
   * The angular velocity of ROTATION, in radians in a unit of time. Default 1.
   */
  void SetAngularVelocity(double value) { this->SetNumber(this->AngularVelocity, value); }
  vtkGetMacro(AngularVelocity, double);
  ///@}

  ///@{
  /**
   * The rates of SADDLE, in one over units of time. Default (1, 1, -2).
   */
  void SetSaddleRates(double x, double y, double z) { this->SetVector(this->SaddleRates, x, y, z); }
  vtkGetVector3Macro(SaddleRates, double);
  ///@}

  ///@{
  /**
   * The rates of NODE, in one over units of time, and its rotation in radians in a unit of time.
   * Default (1, 1, 1), 0.
   */
  void SetNodeRates(double x, double y, double z) { this->SetVector(this->NodeRates, x, y, z); }
  vtkGetVector3Macro(NodeRates, double);
  void SetSwirl(double value) { this->SetNumber(this->Swirl, value); }
  vtkGetMacro(Swirl, double);
  ///@}

  ///@{
  /**
   * The strength of the source of SOURCE_SINK and COUPLED_CHARGE, and the way from it to the sink.
   * Default 1, (1, 0, 0).
   */
  void SetStrength(double value) { this->SetNumber(this->Strength, value); }
  vtkGetMacro(Strength, double);
  void SetSeparation(double x, double y, double z) { this->SetVector(this->Separation, x, y, z); }
  vtkGetVector3Macro(Separation, double);
  ///@}

  ///@{
  /**
   * The radius of the cores of SOURCE_SINK, COUPLED_CHARGE and TORNADO. Default 0.1. Valid: 1e-12
   * to 1e12.
   */
  void SetCoreRadius(double value) { this->SetLength(this->CoreRadius, value); }
  vtkGetMacro(CoreRadius, double);
  ///@}

  ///@{
  /**
   * The radius of SPHERE and CYLINDER. Default 0.25. Valid: 1e-12 to 1e12.
   */
  void SetRadius(double value) { this->SetLength(this->Radius, value); }
  vtkGetMacro(Radius, double);
  ///@}

  ///@{
  /**
   * What points inside SPHERE and CYLINDER get. Default ZERO. Valid: see Insides; clamped.
   */
  vtkSetClampMacro(Inside, int, ZERO, HIDDEN);
  vtkGetMacro(Inside, int);
  ///@}

  ///@{
  /**
   * The velocity that CYLINDER adds along its axis. Default 0.1.
   */
  void SetSpanwiseVelocity(double value) { this->SetNumber(this->SpanwiseVelocity, value); }
  vtkGetMacro(SpanwiseVelocity, double);
  ///@}

  ///@{
  /**
   * The amplitudes A, B, C of ABC, and its period in units of length. Default (1, 1, 1), 2. Valid
   * period: 1e-12 to 1e12.
   */
  void SetAmplitudes(double a, double b, double c) { this->SetVector(this->Amplitudes, a, b, c); }
  vtkGetVector3Macro(Amplitudes, double);
  void SetPeriod(double value) { this->SetLength(this->Period, value); }
  vtkGetMacro(Period, double);
  ///@}

  ///@{
  /**
   * The thickness of SHEAR's layer. Default 0.1. Valid: 1e-12 to 1e12.
   */
  void SetThickness(double value) { this->SetLength(this->Thickness, value); }
  vtkGetMacro(Thickness, double);
  ///@}

  ///@{
  /**
   * The height of HURRICANE and TORNADO from the ground to the top, how far their axis leans in x
   * and y over that height, and how far it bends aside in the middle. Default 2, (0.2, 0.1), (0.1,
   * -0.05). Valid height: 1e-12 to 1e12.
   */
  void SetHeight(double value) { this->SetLength(this->Height, value); }
  vtkGetMacro(Height, double);
  void SetAxisTilt(double x, double y) { this->SetVector(this->AxisTilt, x, y); }
  vtkGetVector2Macro(AxisTilt, double);
  void SetAxisBend(double x, double y) { this->SetVector(this->AxisBend, x, y); }
  vtkGetVector2Macro(AxisBend, double);
  ///@}

  ///@{
  /**
   * The largest swirl of HURRICANE, the radius where it is, and the largest rise. Default 1, 0.2,
   * 0.3. Valid radius: 1e-12 to 1e12.
   */
  void SetMaximumWind(double value) { this->SetNumber(this->MaximumWind, value); }
  vtkGetMacro(MaximumWind, double);
  void SetEyeRadius(double value) { this->SetLength(this->EyeRadius, value); }
  vtkGetMacro(EyeRadius, double);
  void SetUpdraft(double value) { this->SetNumber(this->Updraft, value); }
  vtkGetMacro(Updraft, double);
  ///@}

  ///@{
  /**
   * The circulation and the strain of TORNADO. Default 1, 0.5.
   */
  void SetCirculation(double value) { this->SetNumber(this->Circulation, value); }
  vtkGetMacro(Circulation, double);
  void SetStrain(double value) { this->SetNumber(this->Strain, value); }
  vtkGetMacro(Strain, double);
  ///@}

protected:
  vtkAnalyticFlowSource() = default;
  ~vtkAnalyticFlowSource() override = default;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkAnalyticFlowSource(const vtkAnalyticFlowSource&) = delete;
  void operator=(const vtkAnalyticFlowSource&) = delete;

  void SetNumber(double& member, double value);
  void SetLength(double& member, double value);
  void SetVector(double (&member)[3], double x, double y, double z);
  void SetVector(double (&member)[2], double x, double y);

  /// Calls \a visit with the formula of the field.
  template <typename Visitor>
  void Visit(const Visitor& visit) const;

  /// Whether x is inside the sphere or the cylinder.
  bool IsInside(const double x[3]) const;

  int Field = HURRICANE;
  int OutputScalarType = VTK_DOUBLE;
  double Center[3] = { 0.0, 0.0, 0.0 };
  double Velocity[3] = { 1.0, 0.0, 0.0 };
  double Axis[3] = { 0.0, 0.0, 1.0 };
  double AngularVelocity = 1.0;
  double SaddleRates[3] = { 1.0, 1.0, -2.0 };
  double NodeRates[3] = { 1.0, 1.0, 1.0 };
  double Swirl = 0.0;
  double Strength = 1.0;
  double Separation[3] = { 1.0, 0.0, 0.0 };
  double CoreRadius = 0.1;
  double Radius = 0.25;
  int Inside = ZERO;
  double SpanwiseVelocity = 0.1;
  double Amplitudes[3] = { 1.0, 1.0, 1.0 };
  double Period = 2.0;
  double Thickness = 0.1;
  double Height = 2.0;
  double AxisTilt[2] = { 0.2, 0.1 };
  double AxisBend[2] = { 0.1, -0.05 };
  double MaximumWind = 1.0;
  double EyeRadius = 0.2;
  double Updraft = 0.3;
  double Circulation = 1.0;
  double Strain = 0.5;
};

#endif
