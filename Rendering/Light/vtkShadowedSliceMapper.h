// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkShadowedSliceMapper_h
#define vtkShadowedSliceMapper_h

#include "InterlumeLightModule.h"     // for the export macro
#include "vtkInterlumeReport.h"       // for GetReport()
#include "vtkNew.h"                   // for the report
#include "vtkShadowedSliceSettings.h" // for what is set
#include "vtkVolumeMapper.h"

#include <memory> // for the image
#include <string> // for errors

class vtkColorTransferFunction;
class vtkDataArray;
class vtkImageData;
class vtkLight;
class vtkPiecewiseFunction;
class vtkSliceMedium;

namespace interlume
{
class Error;
class PeelingDeferral;
class VolumeImage;
}

/**
 * @class   vtkShadowedSliceMapper
 * @brief   draws a volume in half-angle slices, with the shadows of every light in it
 *
 * The volume is cut by planes perpendicular to the half vector between the directions of view and
 * of light, so that one order of slices serves both (C. Zhang, dissertation, Ohio State 2006, 2.3;
 * J. Kniss, S. Premoze, C. Hansen, D. Ebert, "Interactive translucent volume rendering and
 * procedural modeling", 2002). Each slice is first drawn into the picture, lit by what one
 * two-dimensional buffer for each light holds, then into that buffer, which holds the transmittance
 * T(x) from the light to the slice.
 *
 * A slice stands for the slab of matter around it. Along the eye's ray through it, of length l
 * within the volume, the slab has transmittance exp(-tau l); a light loses exp(-tau m) along its
 * own ray of length m. Inside the slab both fall exponentially, and their product is integrated
 * exactly for constant tau, and opaque surfaces do not darken as slices get thicker. What a buffer
 * has between its texels is interpolated, so that a homogeneous medium is not exact at any spacing:
 * a cube of opacity 0.5 a voxel, lit aslant, is off by 0.0014 in the mean at the default spacing,
 * by 0.015 at 4 voxels and by 0.074 at 17; one of 0.05 a voxel by 0.0002, 0.0016 and 0.011.
 *
 * **Sharp surfaces** lie within a slab, and texels of a buffer around a place beside them have met
 * them or not, whatever the place's own ray has. Where opacity changes by steps alone, and not with
 * the gradient, and a slab's optical depth is above 0.15, the place in the slab is found where
 * opacity begins to jump, and light is asked for where it was some slabs before and followed to
 * that place along its own ray. An opaque cube is off by 0.004 in the mean and a plate with a jump
 * of opacity by 2.3 % (rms) or less for light from 0 to 60 degrees; single pixels at edges by more.
 * Ramps of opacity, steep ones too, and sheets and shells one voxel thick are looked up in the
 * buffer: off by 0.01 in the mean. Where all such matter is thick this takes 1.1 to
 * 1.2 times the time on a bonsai, up to 2.3 on a cube that fills the picture; with thin matter
 * beside it 1.4 to 1.9; and nothing elsewhere.
 *
 * **Extinction** tau = -ln(1 - opacity) / ScalarOpacityUnitDistance per unit of length, the opacity
 * from the property's scalar opacity function, times its gradient opacity function of the
 * gradient's magnitude where there is one - taken as vtkGPUVolumeRayCastMapper takes it, with the
 * image's spacings s without their signs: (sx + sy + sz) / 3 |(df/dx, df/dy, df/dz)|, central
 * differences in the image's own units - classified after interpolation for each fragment.
 * Functions are looked up over their own points: a voxel far beyond all others changes nothing,
 * steps and peaks are where they are, however narrow, and all else is within 1e-3 of the function's
 * largest value.
 *
 * **Colour** with the property's Shade on: equation 2.6, for each channel (2.9),
 *   C = c (ka Ia + sum kd I T (N.L)) + sum ks I T (E.R)^n,
 * over all lights that are switched on, I their colour, intensity, cone, fall-off and screen, N the
 * normalised gradient by central differences, towards lower values. Where the gradient is zero
 * there is no surface, and light is scattered evenly: N.L is 1 and nothing is specular. Ia is the
 * sum of the lights' ambient colours times intensity, or white where all of them are black. With
 * Shade off and a light that casts shadows: C = c (ka + sum kd I T). With Shade off and no shadows:
 * C = c, as in other mappers of VTK.
 *
 * Light falls through the same matter as sight. Where that is opaque, light of transmittance
 * exp(-b s) is seen with exp(-a s), and a / (a + b) of it, a half where both come in at the same
 * angle, comes back: a solid is lit less than without shadows, however thin its edge is. Stronger
 * lights make up for it.
 *
 * **Lights** are those of the renderer: headlights, camera lights and scene lights, directional,
 * positional, with cone, and vtkProjectiveLight. A light casts shadows if Shadows is on and its
 * ShadowAttenuation is above 0: it then shines with 1 - ShadowAttenuation (1 - T). Lights behind
 * the viewer are swept from front to back, those behind the volume from back to front; lights on
 * both sides take two sweeps, and so does a positional light inside the volume.
 *
 * Each light has one buffer of two dimensions. It takes four bytes of transmittance for each
 * sample, twelve with TransmissionColor, two that spare what lies behind opaque matter, and two
 * layers of the former where surfaces are sharp.
 *
 * A positional light inside the volume, or as close that rays run along the slices, has two sweeps,
 * which are halves of one picture where it is alone, and its rays are followed in steps: it takes
 * 1.8 to 3.6 times the time without shadows, where others take 1.1 to 2; lights on both sides of
 * the volume take about 2.8 times. These are of pictures of 512^2 pixels; small pictures of large
 * volumes, where the light's buffer has more samples than the picture, cost more. Where a light
 * nears the volume so that one sweep becomes two, the picture's brightness makes a step of the size
 * of the slices' error: 3.3 % in the mean on seven nearly opaque rings in 64^3 samples.
 *
 * **Soft shadows** are those of a vtkAreaLight. By SoftShadowMethod:
 * - SAMPLE_LAYERS: what matter takes from light is found once for each slice, from the emitter's
 * centre, and multiplied, some slabs together, into one layer of transmittance for each of
 * NumberOfLightSamples stratified samples, as seen from there; the buffer is the mean of the layers
 * times what the slabs of the last batches take, which cast the shadows of the centre. So near
 * matter, whose penumbra is a few texels wide, is as sharp as for other lights, and layers need
 * half the buffer's columns and rows. A penumbra is that of the samples, in steps of one over their
 * number, up to two texels, and converges as samples, buffer and slices are refined: behind a half
 * plane, dZ / Z 0.05 to 5, its width is off by 4 % or less with 16 samples in buffers of 128^2 and
 * by 3 % with 32 in 256^2, and the profile by 0.035 and 0.015 at most. Penumbras of few texels are
 * too wide: by 7 % or less from 6 to 12 texels, by 15 % at 4 and by 40 % at 3. Wide penumbras of
 * sharp edges want 16 to 24 samples, since fewer show as steps. An automatic buffer has 96 columns
 * at least, and up to one and a half times those of other lights where the picture has two pixels
 * to each. Beside the buffer it takes three of its size and a quarter of one for each sample.
 * - ACCUMULATED_CONVOLUTION: the buffer is convolved with boxes as light goes through the slices
 * (dissertation, 2.4; the virtual light of 2.14, widths below two texels are accumulated). It has
 * neither the emitter's shape nor its image, and its penumbrae shrink as slices and buffers get
 * finer, since n boxes of width w spread by w sqrt(n / 12), not n w / sqrt(12).
 * - SAMPLED_LIGHTS: each sample is a light of its own, with its buffer, its shading and a share of
 * the light: the reference, of one sweep for each four samples. In a vtkShadowedScenePass it is
 * SAMPLE_LAYERS.
 * Colours and directions of shading are those of the emitter's centre but in the last; an emitter's
 * image is grey to its shadows then, and its mean colour is the light's. A light inside the volume,
 * or so close or large that slices are seen edge-on from some of it, shines from its centre with
 * hard shadows but by SAMPLED_LIGHTS; the report counts these (AreaLightsWithHardShadows). A light
 * for each sample inside the volume takes some forty times the picture without shadows, and
 * software OpenGL minutes to compile at first. All else (both sweeps, several lights,
 * TransmissionColor, cropping, clipping) is as for other lights. A vtkAreaLight of size 0 takes
 * what a vtkLight takes.
 *
 * **Scattering** (dissertation, 2.6), where MultipleScattering is on, takes the place of the colour
 * above: matter of albedo c, the share of light that goes on where it meets matter, sends
 *   C = c (sum I T 4 pi p(cos) + D)
 * to the eye, p the phase function at the angle between light and eye, whose integral over the
 * sphere is 1. Ambient, Diffuse, Specular and Shade have no part, nor have lights' ambient and
 * specular colours. With p isotropic, D none and c the colours it is what evenly scattered light of
 * Diffuse 1 and Ambient 0 is. Where TransmissionColor lets light pass, only the rest is scattered.
 * By MultipleScattering:
 * - SINGLE_SCATTERING: D is 0. It takes no buffer, no pass and no cells.
 * - FORWARD_SCATTERING: D is light that was scattered before by less than a right angle, and goes
 * on as its light does, spread by ForwardSpread. Light that is scattered back is lost.
 * - FULL_SCATTERING: D is light that was scattered before in any direction. Over all directions of
 * view none is gained; seen from one, edges of matter whose cells have optical depths above 3 are
 * too bright. Under even light from all sides on a cube that absorbs nothing, in 16 cells and seen
 * face on, pixels are off by 0.001 in the mean at a depth of 0.1, 0.01 at 1, 0.03 at 3 and 0.06 at
 * 10; of 500 random settings with 4 to 8 cells and depths to 1e3 14 have a pixel above 1.05, 1.62
 * at most. A light of colour 1 lights thin white matter to 1, and thick white matter to up to 4, as
 * a white wall that faces it would be in these units; light of colour 1 from all sides together,
 * to 1.
 *
 * D does not depend on the eye. It is found by threads on the CPU in the cells of a grid
 * (ScatteringGridSize) around the blocks that can be seen, which have the mean extinction and
 * albedo of their matter, and is kept until volume, functions, clipping, cropping or lights have
 * changed. The slices look it up between the cells' middles. Volumes that a vtkShadowedScenePass
 * draws together have one grid around all of them, so that light goes from one to another and D has
 * the shadows of all, each finds D by its own mode and phase function in all their matter, and
 * those that do not scatter on take light; the grid's cells are as small as the smallest that one
 * of them has by itself, but for the largest number, 64 or what one of them asks for. Volumes that
 * are drawn by themselves know nothing of each other. Surfaces of a vtkShadowedScenePass cast their
 * shadows in D, and opaque ones that do stop light that was scattered: the cells that their
 * triangles go through take it, a layer of cells for a thin sheet, and send none on; so do the
 * copies that a vtkGlyph3DMapper draws. Surfaces that receive shadows are lit by D as well, by its
 * first two moments, within the box of the cells and, by an estimate, beyond it; in physically
 * based shading it is light of the environment for the diffuse part alone. Translucent surfaces are
 * lit so where the pass draws them in order with volumes. Where lights have soft shadows D is of up
 * to 16 samples of each. Lights that cast no shadows are scattered once; one of ShadowAttenuation a
 * below 1 gives D its share a, and is not taken from by as much, so that then light is gained.
 *
 * **Input**: vtkImageData, point or cell scalars by ScalarMode, ArrayName, ArrayId as in VTK's
 * other mappers, of any type and of
 * - one component: colour and opacity functions of it;
 * - two to four independent components: the functions and the weight of each, extinctions added,
 *   colours weighted by extinction;
 * - two without IndependentComponents: colour of the first, opacity of the second;
 * - four without: RGB, 0 to 255 in unsigned char and 0 to 1 otherwise, and the opacity function of
 * the fourth. Three without IndependentComponents are an error. Samples with NaN or infinity in any
 * component are transparent, with a ramp of one voxel around them; they are counted and warned of
 * once for each input.
 *
 * Samples of points reach from the first sample to the last; values of cells fill the image's
 * bounds, level within half a voxel of them.
 *
 * Selection (vtkHardwareSelector) finds the volume as a whole, wherever a line of sight meets
 * matter before an opaque prop.
 *
 * Cropping, clipping planes and the camera's near and far planes cut the matter exactly along the
 * ray, whatever the direction matrix of the image is. Where region flags leave several pieces of a
 * ray within one slab, these are one piece of their length around their common center. Light takes
 * no notice of the camera's planes. Opaque props occlude by depth, within a slab too. Translucent
 * polygons are behind the volume wherever they are: UseDepthPeelingForVolumes is not supported, is
 * warned of once, and draws the picture that is drawn without it. The only BlendMode is composite.
 *
 * Opaque actors cast shadows in the volume, and the volume on them, where vtkShadowedScenePass
 * draws the renderer; there volumes of several mappers share slices, and cast shadows on each
 * other.
 *
 * Errors (vtkErrorMacro; the picture of the frame before stays where there is one): no scalars, a
 * blend mode or number of components that is not supported, a volume larger than the graphics
 * card's three-dimensional textures, textures that do not fit into its memory or beyond
 * MaximumTextureMemory, a projective light whose image has no samples (the others still shine).
 *
 * @sa vtkAreaLight vtkProjectiveLight vtkShadowedScenePass vtkShadowedSliceSettings
 */
class INTERLUMELIGHT_EXPORT vtkShadowedSliceMapper
  : public vtkVolumeMapper
  , private vtkShadowedSliceSettings
{
public:
  static vtkShadowedSliceMapper* New();
  vtkTypeMacro(vtkShadowedSliceMapper, vtkVolumeMapper);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The modes, as vtkShadowedSliceSettings has them.
   */
  using vtkShadowedSliceSettings::ACCUMULATED_CONVOLUTION;
  using vtkShadowedSliceSettings::BILINEAR_LIGHT;
  using vtkShadowedSliceSettings::FORWARD_SCATTERING;
  using vtkShadowedSliceSettings::FULL_SCATTERING;
  using vtkShadowedSliceSettings::HENYEY_GREENSTEIN_PHASE;
  using vtkShadowedSliceSettings::ISOTROPIC_PHASE;
  using vtkShadowedSliceSettings::LightLookups;
  using vtkShadowedSliceSettings::NEAREST_LIGHT;
  using vtkShadowedSliceSettings::NO_SCATTERING;
  using vtkShadowedSliceSettings::PhaseFunctions;
  using vtkShadowedSliceSettings::SAMPLE_LAYERS;
  using vtkShadowedSliceSettings::SAMPLED_LIGHTS;
  using vtkShadowedSliceSettings::ScatteringModes;
  using vtkShadowedSliceSettings::SINGLE_SCATTERING;
  using vtkShadowedSliceSettings::SoftShadowMethods;
  using vtkShadowedSliceSettings::TABLE_PHASE;
  ///@}

  ///@{
  /**
   * Whether lights cast shadows in the volume. Off, no light has a buffer, and nothing of shadows
   * is drawn, kept or in the shaders. Default on.
   */
  vtkSetMacro(Shadows, bool);
  vtkGetMacro(Shadows, bool);
  vtkBooleanMacro(Shadows, bool);
  ///@}

  ///@{
  /**
   * The largest number of lights that cast shadows, the brightest ones; the others shine through. A
   * light kit has five lights, of which one matters. Default 16. Valid: 0 to 16.
   */
  vtkSetClampMacro(MaximumNumberOfShadows, int, 0, 16);
  vtkGetMacro(MaximumNumberOfShadows, int);
  ///@}

  ///@{
  /**
   * The distance of the slices, in world units. 0, the default: half the length within one voxel of
   * a line along the slices' normal, or, where that is more, what a line of sight goes along the
   * normal in half its length within one voxel. Valid: 0 and above. No more than 65,536 slices are
   * drawn: a smaller distance is enlarged to that, and the report has the one in use.
   */
  vtkSetClampMacro(SliceSpacing, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(SliceSpacing, double);
  ///@}

  ///@{
  /**
   * The number of columns and rows of the buffer of each light. 0, the default: as many as the
   * volume has voxels across, seen from the light, 64 to 2048; layers of voxels that are all within
   * less than 1/2048 of the buffer do not count. For hard shadows on dense matter, up to one and a
   * half times as many, if the image has the pixels. Steep ramps of opacity under oblique light
   * want two to three times the number of voxels. Valid: 0, and 16 to 8192, up to what the graphics
   * card can do.
   */
  void SetLightBufferSize(int size);
  vtkGetMacro(LightBufferSize, int);
  ///@}

  ///@{
  /**
   * Whether the nearest sample of the light's buffer is taken, or the four around. Default
   * BILINEAR_LIGHT. Valid: see LightLookups; clamped.
   */
  vtkSetClampMacro(LightLookup, int, NEAREST_LIGHT, BILINEAR_LIGHT);
  vtkGetMacro(LightLookup, int);
  void SetLightLookupToNearest() { this->SetLightLookup(NEAREST_LIGHT); }
  void SetLightLookupToBilinear() { this->SetLightLookup(BILINEAR_LIGHT); }
  ///@}

  ///@{
  /**
   * The number of pixels of the viewport for each pixel of the picture, along an edge; the picture
   * is interpolated between its pixels, and not across the edges of opaque surfaces in front of or
   * in the volume. Surfaces narrower than a pixel of the picture may be missed by it. Default 1.
   * Valid: 0.25 to 100.
   */
  vtkSetClampMacro(ImageSampleDistance, double, 0.25, 100.0);
  vtkGetMacro(ImageSampleDistance, double);
  ///@}

  ///@{
  /**
   * Whether slices and pixels are made coarser where the renderer allots less time than the last
   * picture took, as while a view is turned. Default on. Only automatic values are changed: a
   * SliceSpacing that is set stays.
   */
  vtkSetMacro(AutoAdjustSampleDistances, bool);
  vtkGetMacro(AutoAdjustSampleDistances, bool);
  vtkBooleanMacro(AutoAdjustSampleDistances, bool);
  ///@}

  ///@{
  /**
   * The change of a scalar from one voxel to the next, as a share of its range, from which on
   * matter is shaded as a surface. Below it, light is scattered evenly in proportion: the factor
   * N.L goes from 1 at no change to its own value, and the specular part from nothing to its own
   * value. Smoke and surfaces in one volume want a few hundredths, so does data with noise. Default
   * 0: every gradient is one of a surface. Valid: 0 to 1.
   */
  vtkSetClampMacro(SurfaceGradient, double, 0.0, 1.0);
  vtkGetMacro(SurfaceGradient, double);
  ///@}

  ///@{
  /**
   * Whether surfaces are lit from both sides: N is turned towards each light, as VTK's other volume
   * mappers turn it by vtkRenderer::TwoSidedLighting. Matter whose values grow towards the eye, as
   * where the volume ends within it, is dark otherwise. Default false: equation 2.6 as it stands.
   */
  vtkSetMacro(TwoSidedLighting, bool);
  vtkGetMacro(TwoSidedLighting, bool);
  vtkBooleanMacro(TwoSidedLighting, bool);
  ///@}

  ///@{
  /**
   * The way to find the soft shadows of each vtkAreaLight; see the description of the class.
   * Default SAMPLE_LAYERS. Valid: see SoftShadowMethods; clamped.
   */
  vtkSetClampMacro(SoftShadowMethod, int, ACCUMULATED_CONVOLUTION, SAMPLED_LIGHTS);
  vtkGetMacro(SoftShadowMethod, int);
  void SetSoftShadowMethodToAccumulatedConvolution()
  {
    this->SetSoftShadowMethod(ACCUMULATED_CONVOLUTION);
  }
  void SetSoftShadowMethodToSampleLayers() { this->SetSoftShadowMethod(SAMPLE_LAYERS); }
  void SetSoftShadowMethodToSampledLights() { this->SetSoftShadowMethod(SAMPLED_LIGHTS); }
  ///@}

  ///@{
  /**
   * The number of samples of the emitter of each vtkAreaLight: layers, or lights, by
   * SoftShadowMethod. Accumulated convolution has none. In a vtkShadowedScenePass layers are at
   * least as many as the pass has samples, where surfaces cast the light's shadows. Default 8.
   * Valid: 1 to 1024.
   */
  vtkSetClampMacro(NumberOfLightSamples, int, 1, 1024);
  vtkGetMacro(NumberOfLightSamples, int);
  ///@}

  ///@{
  /**
   * The colour of light that the matter lets through, as a function of the scalar: channel k of a
   * light is attenuated with extinction tau (1 - colour_k), so that white lets all light pass and
   * black none. Light buffers have three channels then, else one. For volumes of one component or
   * of two without IndependentComponents. Default null: black.
   */
  void SetTransmissionColor(vtkColorTransferFunction* function);
  vtkColorTransferFunction* GetTransmissionColor() const { return this->TransmissionColor; }
  ///@}

  ///@{
  /**
   * How light is scattered on its way to the eye; see the description of the class. Default
   * NO_SCATTERING. Valid: see ScatteringModes; clamped.
   */
  vtkSetClampMacro(MultipleScattering, int, NO_SCATTERING, FULL_SCATTERING);
  vtkGetMacro(MultipleScattering, int);
  void SetMultipleScatteringToOff() { this->SetMultipleScattering(NO_SCATTERING); }
  void SetMultipleScatteringToSingle() { this->SetMultipleScattering(SINGLE_SCATTERING); }
  void SetMultipleScatteringToForward() { this->SetMultipleScattering(FORWARD_SCATTERING); }
  void SetMultipleScatteringToFull() { this->SetMultipleScattering(FULL_SCATTERING); }
  ///@}

  ///@{
  /**
   * The share of light that goes on where it meets matter, red, green and blue, as a function of
   * the scalar; the rest is absorbed. Values are clamped to 0 to 1. Only where MultipleScattering
   * is on, and for volumes of one component or of two without IndependentComponents. Default null:
   * the colours of the volume's property.
   */
  void SetScatteringAlbedo(vtkColorTransferFunction* function);
  vtkColorTransferFunction* GetScatteringAlbedo() const { return this->ScatteringAlbedo; }
  ///@}

  ///@{
  /**
   * The distribution of scattered light over the angle to where it came from: even in all
   * directions, Henyey and Greenstein's with Anisotropy, or PhaseTable. Only where
   * MultipleScattering is on. Default ISOTROPIC_PHASE. Valid: see PhaseFunctions; clamped.
   */
  vtkSetClampMacro(PhaseFunction, int, ISOTROPIC_PHASE, TABLE_PHASE);
  vtkGetMacro(PhaseFunction, int);
  void SetPhaseFunctionToIsotropic() { this->SetPhaseFunction(ISOTROPIC_PHASE); }
  void SetPhaseFunctionToHenyeyGreenstein() { this->SetPhaseFunction(HENYEY_GREENSTEIN_PHASE); }
  void SetPhaseFunctionToTable() { this->SetPhaseFunction(TABLE_PHASE); }
  ///@}

  ///@{
  /**
   * The mean cosine g of HENYEY_GREENSTEIN_PHASE, (1 - g^2) / (4 pi (1 + g^2 - 2 g cos)^1.5): above
   * 0 light is scattered forwards, as by clouds and tissue, below 0 backwards. Default 0, which is
   * isotropic. Valid: -0.999 to 0.999.
   */
  vtkSetClampMacro(Anisotropy, double, -0.999, 0.999);
  vtkGetMacro(Anisotropy, double);
  ///@}

  ///@{
  /**
   * The phase function of TABLE_PHASE over the cosine of the angle, from -1, light that goes back,
   * to 1, light that goes on; it is sampled at 4096 cosines and scaled so that its integral over
   * the sphere is 1. Values below 0 or that are not finite, or all 0, are an error. Default null:
   * isotropic.
   */
  void SetPhaseTable(vtkPiecewiseFunction* function);
  vtkPiecewiseFunction* GetPhaseTable() const { return this->PhaseTable; }
  ///@}

  ///@{
  /**
   * What FORWARD_SCATTERING adds to the variance of light's angle to each of two axes across it, in
   * square radians, for each unit of scattering optical depth: the same whatever the distance of
   * slices and cells. 0, the default: that of the phase function's forward half, half of the mean
   * square of the sine. Valid: 0 and above.
   */
  vtkSetClampMacro(ForwardSpread, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(ForwardSpread, double);
  ///@}

  ///@{
  /**
   * What all scattered light is multiplied by on its way to the eye, as by the exposure of a
   * camera; surfaces receive it as it is. At 1, the default, thick white matter is up to four times
   * as bright as a light of colour 1; at 0.25 it is as a white wall that faces the light. Valid: 0
   * and above.
   */
  vtkSetClampMacro(ScatteringBrightness, double, 0.0, VTK_FLOAT_MAX);
  vtkGetMacro(ScatteringBrightness, double);
  ///@}

  ///@{
  /**
   * The number of layers of cells behind a place, away from the light, from which light comes back
   * to it in FULL_SCATTERING (C. Zhang, dissertation, 2.6, keeps three slices). 0, the default:
   * all. Valid: 0 and above.
   */
  vtkSetClampMacro(BackwardLayers, int, 0, VTK_INT_MAX);
  vtkGetMacro(BackwardLayers, int);
  ///@}

  ///@{
  /**
   * The number of cells along the volume's longest edge in which FORWARD_SCATTERING and
   * FULL_SCATTERING find scattered light. 0, the default: 32, or one for each voxel where there are
   * fewer. Valid: 0, and 4 to 128.
   */
  void SetScatteringGridSize(int size);
  vtkGetMacro(ScatteringGridSize, int);
  ///@}

  ///@{
  /**
   * The largest number of bytes that textures and buffers of one picture may take; more is an
   * error. Default 0: what the graphics card gives. Valid: 0 and above.
   */
  vtkSetClampMacro(MaximumTextureMemory, vtkIdType, 0, VTK_ID_MAX);
  vtkGetMacro(MaximumTextureMemory, vtkIdType);
  ///@}

  /**
   * Sets a medium that is evaluated by functions of its own instead of the scalars; for mappers of
   * such media. Default null.
   */
  void SetMedium(vtkSliceMedium* medium);

  /**
   * Returns the report of the last image:
   * - ShadowedLights: lights that cast shadows in the volume
   * - AreaLightsWithHardShadows: area lights too close or too large for soft shadows
   * - Slices: slices of all sweeps; SliceSpacing: their distance in world units
   * - LightBufferSize: columns and rows of the largest light buffer
   * - ImageSampleDistance: viewport pixels per pixel of the image, along an edge
   * - NonFiniteVoxels: voxels with NaN or infinity, which are transparent
   * - TextureBytes: bytes of the textures of the volume and its functions
   * - ScatteringSeconds: time of the last computation of multiply scattered light
   * - Seconds: time of the image
   */
  vtkInterlumeReport* GetReport() { return this->Report; }

  /**
   * Reads the transmittance of the whole volume along each ray of a light, as its buffer holds it
   * after the last picture, into an image of floats of one or three components, and in its field
   * data `BufferFromWorld` (16 values, rows of a matrix to texture coordinates 0 to 1 after
   * division by the fourth). Only for lights seen through a plane: a light inside or close to the
   * volume returns false, as does one that casts no shadows.
   */
  bool ReadLightBuffer(vtkRenderer* renderer, vtkLight* light, vtkImageData* image);

  /**
   * For internal use by vtkShadowedScenePass: begins an image of the volume, which Render shows if
   * the pass has rendered it by then.
   */
  interlume::VolumeImage& UpdateImage(vtkRenderer* renderer, vtkVolume* volume);

  /**
   * WARNING: for the renderer only.
   */
  void Render(vtkRenderer* renderer, vtkVolume* volume) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

  vtkMTimeType GetMTime() override;

protected:
  vtkShadowedSliceMapper();
  ~vtkShadowedSliceMapper() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;

private:
  vtkShadowedSliceMapper(const vtkShadowedSliceMapper&) = delete;
  void operator=(const vtkShadowedSliceMapper&) = delete;

  interlume::Error FindScalars(vtkImageData* image, vtkDataArray*& scalars, bool& isOfCells);
  void ReportErrors();

  vtkNew<vtkInterlumeReport> Report;
  vtkMTimeType ErrorTime = 0;
  std::string ErrorText;
  vtkMTimeType WarningTime = 0;
  vtkSmartPointer<vtkSliceMedium> Medium;
  std::unique_ptr<interlume::PeelingDeferral> Peels;
  std::unique_ptr<interlume::VolumeImage> Image;
};

#endif
