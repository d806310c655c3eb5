// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkAnalyticFlowSource_h
#define vtkAnalyticFlowSource_h

#include "InterlumeSourcesModule.h" // for the export macro
#include "vtkBoundedImageSource.h"

/**
 * @class   vtkAnalyticFlowSource
 * @brief   generate steady analytic velocity fields on an image
 *
 * The output has one point array, the active vectors: `Velocity`, three components, in units of
 * length per unit of time. In the formulas, x is relative to Center, and a = Axis / |Axis|.
 * - UNIFORM: v = Velocity.
 * - ROTATION: rigid rotation, v = AngularVelocity cross(a, x).
 * - SADDLE: v = (SaddleRates[0] x, SaddleRates[1] y, SaddleRates[2] z).
 * - NODE: v = (NodeRates[0] x, NodeRates[1] y, NodeRates[2] z) + Swirl cross(a, x). This is a
 *   source, a sink if the rates are negative, and a spiral if Swirl is not 0.
 * - SOURCE_SINK: a source at -Separation/2 and a sink at +Separation/2, with volume flow rate
 *   Strength and cores of CoreRadius.
 * - COUPLED_CHARGE: the field of opposite charges at -Separation/2 and +Separation/2, with softened
 *   cores.
 * - SPHERE: potential flow around a sphere of Radius, with the far-field velocity Velocity.
 * - CYLINDER: potential flow around a cylinder of Radius along Axis, plus SpanwiseVelocity along
 *   the axis.
 * - ABC: v = (A sin kz + C cos ky, B sin kx + A cos kz, C sin ky + B cos kx), with (A, B, C) =
 *   Amplitudes and k = 2 pi / Period (Arnold, Beltrami and Childress). Its curl is k v.
 * - SHEAR: v = U tanh(a . x / Thickness), with U the component of Velocity perpendicular to Axis.
 * - HURRICANE: a vortex with an eye, around a tilted and bent axis. The ground is at z = -Height/2
 *   relative to Center.
 * - TORNADO: Burgers' vortex around the same axis, rising from the ground.
 *
 * COUPLED_CHARGE and HURRICANE stand in for data sets of C. Zhang's dissertation, Ohio State 2006,
 * figures 4.9 and 4.10. See Documentation/methods/sources.md for the formulas.
 *
 * With the default parameters, all fields except NODE, SOURCE_SINK and COUPLED_CHARGE are
 * divergence-free. SOURCE_SINK has divergence only in its cores. SADDLE is divergence-free if the
 * sum of its rates is 0.
 *
 * The output does not depend on the number of threads or on the requested extent.
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

  /// Values at points inside the obstacle of SPHERE and CYLINDER.
  enum Insides
  {
    /// The velocity is 0.
    ZERO = 0,
    /// The velocity is NaN.
    NOT_A_NUMBER = 1,
    /// The velocity is 0, and the points are marked as hidden in the array vtkGhostType.
    HIDDEN = 2,
    NUMBER_OF_INSIDES = 3
  };

  ///@{
  /// Returns the lowercase name of a field or of an Insides value, or null if the number is
  /// invalid.
  static const char* GetFieldName(int field);
  static const char* GetInsideName(int inside);
  ///@}

  ///@{
  /**
   * Set/Get the field. Default HURRICANE. Valid: see Fields; clamped.
   */
  vtkSetClampMacro(Field, int, UNIFORM, TORNADO);
  vtkGetMacro(Field, int);
  ///@}

  ///@{
  /**
   * Set/Get the type of the array: VTK_FLOAT or VTK_DOUBLE. Other types become VTK_DOUBLE. Default
   * VTK_DOUBLE.
   */
  void SetOutputScalarType(int type);
  vtkGetMacro(OutputScalarType, int);
  ///@}

  /// Computes the velocity at a point.
  void Evaluate(const double x[3], double velocity[3]) const;

  /// Computes the Jacobian of the velocity, dv[i]/dx[j] at [3 * i + j], exact up to rounding error.
  /// On the boundary of a core, the result is the Jacobian on the outer side.
  void EvaluateJacobian(const double x[3], double jacobian[9]) const;

  ///@{
  /**
   * Set/Get the center of the field. Default (0, 0, 0). This and all parameters below are clamped
   * to -1e12 ... 1e12 unless stated otherwise; NaN is ignored.
   */
  void SetCenter(double x, double y, double z) { this->SetVector(this->Center, x, y, z); }
  vtkGetVector3Macro(Center, double);
  ///@}

  ///@{
  /**
   * Set/Get the velocity of UNIFORM, the velocity far from SPHERE and CYLINDER, and the velocity on
   * one side of SHEAR. Default (1, 0, 0).
   */
  void SetVelocity(double x, double y, double z) { this->SetVector(this->Velocity, x, y, z); }
  vtkGetVector3Macro(Velocity, double);
  ///@}

  ///@{
  /**
   * Set/Get the axis of ROTATION, of CYLINDER and of the swirl of NODE, and the normal of SHEAR.
   * Its length is irrelevant. Default (0, 0, 1). Valid: finite and not 0; other values are an error
   * and are ignored.
   */
  void SetAxis(double x, double y, double z);
  vtkGetVector3Macro(Axis, double);
  ///@}

  ///@{
  /**
   * Set/Get the angular velocity of ROTATION, in radians per unit of time. Default 1.
   */
  void SetAngularVelocity(double value) { this->SetNumber(this->AngularVelocity, value); }
  vtkGetMacro(AngularVelocity, double);
  ///@}

  ///@{
  /**
   * Set/Get the rates of SADDLE, per unit of time. Default (1, 1, -2).
   */
  void SetSaddleRates(double x, double y, double z) { this->SetVector(this->SaddleRates, x, y, z); }
  vtkGetVector3Macro(SaddleRates, double);
  ///@}

  ///@{
  /**
   * Set/Get the rates of NODE, per unit of time, and its rotation in radians per unit of time.
   * Default (1, 1, 1), 0.
   */
  void SetNodeRates(double x, double y, double z) { this->SetVector(this->NodeRates, x, y, z); }
  vtkGetVector3Macro(NodeRates, double);
  void SetSwirl(double value) { this->SetNumber(this->Swirl, value); }
  vtkGetMacro(Swirl, double);
  ///@}

  ///@{
  /**
   * Set/Get the strength of the source of SOURCE_SINK and COUPLED_CHARGE, and the vector from the
   * source to the sink. Default 1, (1, 0, 0).
   */
  void SetStrength(double value) { this->SetNumber(this->Strength, value); }
  vtkGetMacro(Strength, double);
  void SetSeparation(double x, double y, double z) { this->SetVector(this->Separation, x, y, z); }
  vtkGetVector3Macro(Separation, double);
  ///@}

  ///@{
  /**
   * Set/Get the core radius of SOURCE_SINK, COUPLED_CHARGE and TORNADO. Default 0.1. Valid: 1e-12
   * to 1e12; clamped.
   */
  void SetCoreRadius(double value) { this->SetLength(this->CoreRadius, value); }
  vtkGetMacro(CoreRadius, double);
  ///@}

  ///@{
  /**
   * Set/Get the radius of SPHERE and CYLINDER. Default 0.25. Valid: 1e-12 to 1e12; clamped.
   */
  void SetRadius(double value) { this->SetLength(this->Radius, value); }
  vtkGetMacro(Radius, double);
  ///@}

  ///@{
  /**
   * Set/Get the value at points inside SPHERE and CYLINDER. Default ZERO. Valid: see Insides;
   * clamped.
   */
  vtkSetClampMacro(Inside, int, ZERO, HIDDEN);
  vtkGetMacro(Inside, int);
  ///@}

  ///@{
  /**
   * Set/Get the velocity that CYLINDER adds along its axis. Default 0.1.
   */
  void SetSpanwiseVelocity(double value) { this->SetNumber(this->SpanwiseVelocity, value); }
  vtkGetMacro(SpanwiseVelocity, double);
  ///@}

  ///@{
  /**
   * Set/Get the amplitudes A, B, C of ABC, and its period in units of length. Default (1, 1, 1), 2.
   * Valid period: 1e-12 to 1e12; clamped.
   */
  void SetAmplitudes(double a, double b, double c) { this->SetVector(this->Amplitudes, a, b, c); }
  vtkGetVector3Macro(Amplitudes, double);
  void SetPeriod(double value) { this->SetLength(this->Period, value); }
  vtkGetMacro(Period, double);
  ///@}

  ///@{
  /**
   * Set/Get the thickness of the shear layer of SHEAR. Default 0.1. Valid: 1e-12 to 1e12; clamped.
   */
  void SetThickness(double value) { this->SetLength(this->Thickness, value); }
  vtkGetMacro(Thickness, double);
  ///@}

  ///@{
  /**
   * Set/Get the height of HURRICANE and TORNADO, the horizontal offset (x, y) from the lower to the
   * upper end of their axis, and the deflection (x, y) of the axis at half the height. Default 2,
   * (0.2, 0.1), (0.1, -0.05). Valid height: 1e-12 to 1e12; clamped.
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
   * Set/Get the maximum tangential velocity of HURRICANE, the radius where it occurs, and the
   * maximum vertical velocity. Default 1, 0.2, 0.3. Valid radius: 1e-12 to 1e12; clamped.
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
   * Set/Get the circulation and the strain rate of TORNADO. Default 1, 0.5.
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

  /// Calls \a visit with the selected flow of ElementaryFlows or VortexFlows.
  template <typename Visitor>
  void Visit(const Visitor& visit) const;

  /// Returns whether \a x is inside the sphere or cylinder.
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
