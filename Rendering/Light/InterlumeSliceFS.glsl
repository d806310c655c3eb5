// SPDX-License-Identifier: BSD-3-Clause
//VTK::System::Dec
//INTERLUME::FEATURES
#if defined(OCCLUDER_GATHER) || defined(SPANS)
#extension GL_ARB_texture_gather : enable
#endif
#define COLOR

// Draws one slab as seen from the camera: color times opacity, and opacity.
in vec3 place;
#ifndef CUSTOM_MEDIUM
uniform sampler2D colors;
#endif
#ifdef PERSPECTIVE
uniform vec3 eyePosition;
#else
uniform vec3 eyeDirection;
#endif
#ifdef NEAR_PLANE
uniform vec4 nearPlane;
#endif
#ifdef FAR_PLANE
uniform vec4 farPlane;
#endif
#ifdef OPAQUE
uniform sampler2D opaqueDepth;
uniform vec2 imageSize;
uniform mat4 unitFromClip;
#ifdef FRONT
// The volume is visible only behind this depth, and only if the depth is below 1.
uniform sampler2D frontDepth;
#endif
#endif
#ifdef LIT
#ifndef SCATTER
uniform vec4 materials[ROWS];
uniform vec3 ambient;
#endif
#if defined(SHADE) && !defined(CUSTOM_MEDIUM)
// For each table row, the change per voxel, in table columns, above which a sample is shaded
// entirely as a surface.
uniform vec4 surfaceColumns;
#endif
#endif

//VTK::Output::Dec
//INTERLUME::MEDIUM

// Segment of the view ray inside the slab, the sample that represents it, and the segment's optical
// depth. main sets these variables; the initial values avoid compiler warnings.
vec3 segmentStart = vec3(0.0);
vec3 segmentEnd = vec3(0.0);
vec3 startInTexture = vec3(0.0);
vec3 endInTexture = vec3(0.0);
vec3 sampleAt = vec3(0.0);
vec3 viewRay = vec3(0.0);
float sampleExtinction = 0.0;
float opticalDepth = 0.0;
float opacity = 0.0;
#ifdef THICK
// If true, the medium begins inside the segment.
bool isFront = false;
#endif
#ifdef SPANS
// Samples at the ends of the segment. The initial values avoid warnings from Mesa.
const MediumSample noMedium = MediumSample(VALUES(0.0), VALUES(0.0), VALUES(0.0), 0.0, vec4(0.0));
MediumSample startSample = noMedium;
MediumSample endSample = noMedium;
#endif

vec3 colorAt(vec4 texel, int row)
{
#if defined(CUSTOM_MEDIUM)
  return texel.rgb;
#elif defined(RGB)
  return (texel.rgb - colorColumnOrigin.rgb) * colorColumnScale.rgb;
#else
  return lookUpColor(colors, texel, row);
#endif
}

#ifdef TRANSMISSION
vec3 samplePart = vec3(0.0);
#else
#define samplePart 1.0
#endif

#ifdef LIT
// For each table row, color, fraction of the extinction, normal, and surface weight from 0 to 1.
vec3 rowColors[ROWS];
float rowFractions[ROWS];
#if defined(SHADE) && defined(CUSTOM_MEDIUM)
vec3 sampleAxis = vec3(0.0);
#elif defined(SHADE)
vec3 rowNormals[ROWS];
float rowSurfaces[ROWS];
#endif

// Returns the mean of exp(-b) over the segment with visibility weights exp(-a) da. b varies
// linearly from first to last while a varies from 0 to opticalDepth.
float meanOfProduct(float first, float last)
{
  float sum = opticalDepth + last - first;
  float integral = abs(sum) < 1e-2
    ? exp(-first) * (1.0 - sum * (0.5 - sum * (1.0 / 6.0 - sum / 24.0)))
    : (exp(-first) - exp(-(opticalDepth + last))) / sum;
  return integral * opticalDepth / opacity;
}

#ifdef TRANSMISSION
vec3 meanOfProduct(vec3 first, vec3 last)
{
  return vec3(meanOfProduct(first.r, last.r), meanOfProduct(first.g, last.g),
    meanOfProduct(first.b, last.b));
}
#endif

#if defined(BACK_TO_FRONT) || defined(SPANS)
// Returns the visibility-weighted mean of light over the segment, given its values at both ends.
// Decreasing light is interpolated exponentially, increasing light linearly, since exponential
// growth is unbounded.
float meanFrom(float start, float end)
{
  float transmittance = 1.0 - opacity;
  float weight = opticalDepth / opacity;
  if (start > end)
  {
    float sum = opticalDepth + log(start / max(end, 1e-30));
    float mean = sum < 1e-2 ? start * (1.0 - sum * (0.5 - sum * (1.0 / 6.0)))
                            : (start - transmittance * end) / sum;
    return mean * weight;
  }
  float seen = opticalDepth < 0.05 ? 0.5 - opticalDepth / 12.0
                                   : (1.0 - transmittance * weight) / opticalDepth;
  return mix(start, end, seen);
}

#ifdef TRANSMISSION
vec3 meanFrom(vec3 start, vec3 end)
{
  return vec3(meanFrom(start.r, end.r), meanFrom(start.g, end.g), meanFrom(start.b, end.b));
}
#endif
#endif

//INTERLUME::SCATTER
// Adds the light from direction l that is reflected (C. Zhang, dissertation, equation 2.6, without
// the ambient term) or scattered toward the camera.
void addReflection(inout vec3 sum, vec3 l, vec3 diffuse, vec3 specular)
{
#ifdef SCATTER
  sum += sampleAlbedo * diffuse * phaseOf(l);
#elif defined(SHADE) && defined(CUSTOM_MEDIUM)
  vec2 shares = reflectionOf(sampleAxis, -l, -viewRay);
  sum += rowColors[0] * diffuse * (materials[0].y * shares.x);
  sum += specular * (materials[0].z * shares.y);
#else
  for (int row = 0; row < ROWS; ++row)
  {
#ifdef SHADE
    vec3 n = rowNormals[row];
    float surface = rowSurfaces[row];
    float cosine = -dot(n, l);
#ifdef TWO_SIDED
    n = cosine < 0.0 ? -n : n;
    cosine = abs(cosine);
#endif
    float incidence = mix(1.0, max(cosine, 0.0), surface);
    sum += rowFractions[row] * rowColors[row] * diffuse * (materials[row].y * incidence);
    if (cosine > 0.0)
    {
      float mirrored = max(-dot(l + 2.0 * cosine * n, viewRay), 0.0);
      sum += rowFractions[row] * specular *
        (materials[row].z * surface * pow(mirrored, materials[row].w));
    }
#else
    sum += rowFractions[row] * rowColors[row] * diffuse * materials[row].y;
#endif
  }
#endif
}

//INTERLUME::LIGHTS
#endif

void main()
{
#ifdef CUSTOM_MEDIUM
  // All fragments of a slab are coplanar, so the derivatives are exact.
  vec3 pixelX = dFdx(place);
  vec3 pixelY = dFdy(place);
#endif
#ifdef PERSPECTIVE
  vec3 ray = place - eyePosition;
  viewRay = normalize(ray);
#else
  viewRay = eyeDirection;
#endif
  float across = sliceSpacing / max(abs(dot(viewRay, sliceNormal)), 1e-6);
  float lower = -4.0;
  float upper = 4.0;
#ifdef NEAR_PLANE
  lower = max(
    lower, -(dot(nearPlane.xyz, place) + nearPlane.w) / dot(nearPlane.xyz, viewRay));
#endif
#ifdef FAR_PLANE
  upper = min(upper, -(dot(farPlane.xyz, place) + farPlane.w) / dot(farPlane.xyz, viewRay));
#endif
#ifdef OPAQUE
  vec2 image = gl_FragCoord.xy / imageSize;
  float window = texture(opaqueDepth, image).r;
  if (window < 1.0)
  {
    vec4 surface = unitFromClip * vec4(vec3(image, window) * 2.0 - 1.0, 1.0);
    upper = min(upper, dot(surface.xyz / surface.w - place, viewRay));
  }
#ifdef FRONT
  float front = texture(frontDepth, image).r;
  if (!(front < 1.0))
  {
    discard;
  }
  vec4 before = unitFromClip * vec4(vec3(image, front) * 2.0 - 1.0, 1.0);
  lower = max(lower, dot(before.xyz / before.w - place, viewRay));
#endif
#endif
  vec3 p = positionInTexture(place);
  vec3 q = mat3(textureFromUnit) * viewRay;
  cutToMedium(place, viewRay, p, inverseOf(q), lower, upper);
#ifdef THICK
  float mediumStart = lower;
  float mediumEnd = upper;
#endif
  lower = max(lower, -0.5 * across);
  upper = min(upper, 0.5 * across);
  cutToRegions(place, viewRay, lower, upper);
  if (!(upper > lower))
  {
    discard;
  }
#ifdef SPANS
  spanOf(p, q, lower, upper, startSample, endSample);
  vec4 parts = vec4(0.0);
#if ROWS == 1
  parts.x = meanExtinctions(startSample, endSample);
#else
  parts = meanExtinctions(startSample, endSample);
#endif
  sampleExtinction = dot(parts, vec4(1.0));
  float center = meanPosition(startSample, endSample);
  vec4 texel = mix(startSample.Texel, endSample.Texel, center);
  float middle = mix(lower, upper, center);
#else
  float middle = 0.5 * (lower + upper);
#endif
  sampleAt = place + viewRay * middle;
  vec3 sampleInTexture = p + q * middle;
#ifdef CUSTOM_MEDIUM
  setSampleSize(viewRay, upper - lower, pixelX, pixelY);
#endif
#ifndef SPANS
  vec4 texel;
  vec4 parts;
  sampleExtinction = extinctionsAt(sampleAt, sampleInTexture, texel, parts);
#endif
#ifdef EMPTY
  // Nonempty fragments are discarded without writing a depth, so that the next program draws them.
  if (sampleExtinction > 0.0)
  {
    discard;
  }
  gl_FragData[0] = vec4(0.0);
#else
#ifdef THIN
  // Thick fragments are discarded without writing a depth, so that the next program draws them.
  if (sampleExtinction * (upper - lower) > MINIMUM_DEPTH)
  {
    discard;
  }
  if (!(sampleExtinction > 0.0))
  {
    gl_FragData[0] = vec4(0.0);
    return;
  }
#else
  if (!(sampleExtinction > 0.0))
  {
    discard;
  }
#endif
  opticalDepth = sampleExtinction * (upper - lower);
#ifdef THICK
  opticalDepth = depthOfSlab(place, viewRay, p, q, across, mediumStart, mediumEnd,
    sampleExtinction, lower, upper, isFront);
#endif
  opacity = opticalDepth < 0.05
    ? opticalDepth *
      (1.0 - opticalDepth * (0.5 - opticalDepth * (1.0 / 6.0 - opticalDepth / 24.0)))
    : 1.0 - exp(-opticalDepth);
  vec3 color = vec3(0.0);
#ifdef LIT
  segmentStart = place + viewRay * lower;
  segmentEnd = place + viewRay * upper;
  startInTexture = p + q * lower;
  endInTexture = p + q * upper;
#ifdef TRANSMISSION
  samplePart = PART(texel);
#endif
#if defined(SHADE) && defined(CUSTOM_MEDIUM)
  sampleAxis = axisAt(sampleInTexture);
#elif defined(SHADE)
  vec4 differences[3];
  differencesAt(sampleInTexture, texel, differences);
#endif
  for (int row = 0; row < ROWS; ++row)
  {
    rowFractions[row] = parts[row] / sampleExtinction;
    rowColors[row] = colorAt(texel, row);
#if defined(SHADE) && !defined(CUSTOM_MEDIUM)
#if ROWS == 1
    vec3 difference =
      vec3(differences[0].OPACITY_OF, differences[1].OPACITY_OF, differences[2].OPACITY_OF);
    float scale = abs(columnScale.OPACITY_OF);
    float value = texel.OPACITY_OF;
#else
    vec3 difference = vec3(differences[0][row], differences[1][row], differences[2][row]);
    float scale = abs(columnScale[row]);
    float value = texel[row];
#endif
    float change = 0.5 * max(max(abs(difference.x), abs(difference.y)), abs(difference.z)) * scale;
    bool isFlat = change == 0.0;
    rowNormals[row] = isFlat ? vec3(0.0) : -gradientOf(difference);
    // Changes below a millionth of the value are rounding errors.
    rowSurfaces[row] = min(change / max(surfaceColumns[row], 1e-6 * abs(value) * scale), 1.0);
#endif
#ifdef SCATTER
    sampleAlbedo += rowFractions[row] * clamp(rowColors[row], 0.0, 1.0) * samplePart;
#else
    color += rowFractions[row] * rowColors[row] * ambient * materials[row].x;
#endif
  }
#ifdef SCATTER_BRIGHTNESS
  sampleAlbedo *= brightness;
#endif
#ifdef FIELD_MAPS
  findSeenNode();
#endif
  //INTERLUME::SHINE
#else
  for (int row = 0; row < ROWS; ++row)
  {
    color += parts[row] / sampleExtinction * colorAt(texel, row);
  }
#endif
  gl_FragData[0] = vec4(color * opacity, opacity);
#endif
}
