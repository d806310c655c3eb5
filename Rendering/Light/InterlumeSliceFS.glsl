// SPDX-License-Identifier: BSD-3-Clause
//VTK::System::Dec
//INTERLUME::FEATURES
#if defined(CASTER_GATHER) || defined(SPANS)
#extension GL_ARB_texture_gather : enable
#endif
#define COLOR

// Draws one slab as the eye sees it: colour times opacity, and opacity.
in vec3 place;
#ifndef MATTER
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
// Nothing is drawn before it, and nothing at all where it is not below 1.
uniform sampler2D frontDepth;
#endif
#endif
#ifdef LIT
#ifndef SCATTER
uniform vec4 materials[ROWS];
uniform vec3 ambient;
#endif
#if defined(SHADE) && !defined(MATTER)
// The change from voxel to voxel, in columns of each row, from which on there is a surface.
uniform vec4 surfaceColumns;
#endif
#endif

//VTK::Output::Dec
//INTERLUME::MEDIUM

// The segment that this fragment stands for, the sample in its middle, and its optical depth. main sets
// them; compilers that look from top to bottom would say that they are used before.
vec3 segmentStart = vec3(0.0);
vec3 segmentEnd = vec3(0.0);
vec3 startInTexture = vec3(0.0);
vec3 endInTexture = vec3(0.0);
vec3 sampleAt = vec3(0.0);
vec3 sightline = vec3(0.0);
float sampleExtinction = 0.0;
float opticalDepth = 0.0;
float opacity = 0.0;
#ifdef THICK
// Whether matter begins within the segment.
bool isFront = false;
#endif
#ifdef SPANS
// The matter at the ends of the segment. Mesa warns of globals without a value.
const Place noMatter = Place(VALUES(0.0), VALUES(0.0), VALUES(0.0), 0.0, vec4(0.0));
Place startPlace = noMatter;
Place endPlace = noMatter;
#endif

vec3 colorAt(vec4 texel, int row)
{
#if defined(MATTER)
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
// The rows' colours, shares of the extinction and normals, and how much of a surface there is, 0 to 1.
vec3 rowColors[ROWS];
float rowShares[ROWS];
#if defined(SHADE) && defined(MATTER)
vec3 sampleAxis = vec3(0.0);
#elif defined(SHADE)
vec3 rowNormals[ROWS];
float rowSurfaces[ROWS];
#endif

// Returns the mean of exp(-b) over the segment, weighted by what the eye sees, exp(-a) da: b goes
// from first to last and a from 0 to opticalDepth, both evenly.
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
// Returns the mean over the segment, weighted by what the eye sees, of light that is known at its
// ends: on an exponential where it falls; where it rises, which has no bound on an exponential,
// between both.
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
// Adds equation 2.6, without the ambient part, for light that goes along l; or what is scattered of it.
void addReflection(inout vec3 sum, vec3 l, vec3 diffuse, vec3 specular)
{
#ifdef SCATTER
  sum += sampleAlbedo * diffuse * phaseOf(l);
#elif defined(SHADE) && defined(MATTER)
  vec2 shares = reflectionOf(sampleAxis, -l, -sightline);
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
    sum += rowShares[row] * rowColors[row] * diffuse * (materials[row].y * incidence);
    if (cosine > 0.0)
    {
      float mirrored = max(-dot(l + 2.0 * cosine * n, sightline), 0.0);
      sum += rowShares[row] * specular *
        (materials[row].z * surface * pow(mirrored, materials[row].w));
    }
#else
    sum += rowShares[row] * rowColors[row] * diffuse * materials[row].y;
#endif
  }
#endif
}

//INTERLUME::LIGHTS
#endif

void main()
{
#ifdef MATTER
  // All places of a slab's fragments are in one plane, so that differences are exact.
  vec3 pixelX = dFdx(place);
  vec3 pixelY = dFdy(place);
#endif
#ifdef PERSPECTIVE
  vec3 ray = place - eyePosition;
  sightline = normalize(ray);
#else
  sightline = eyeDirection;
#endif
  float across = sliceSpacing / max(abs(dot(sightline, sliceNormal)), 1e-6);
  float lower = -4.0;
  float upper = 4.0;
#ifdef NEAR_PLANE
  lower = max(
    lower, -(dot(nearPlane.xyz, place) + nearPlane.w) / dot(nearPlane.xyz, sightline));
#endif
#ifdef FAR_PLANE
  upper = min(upper, -(dot(farPlane.xyz, place) + farPlane.w) / dot(farPlane.xyz, sightline));
#endif
#ifdef OPAQUE
  vec2 image = gl_FragCoord.xy / imageSize;
  float window = texture(opaqueDepth, image).r;
  if (window < 1.0)
  {
    vec4 surface = unitFromClip * vec4(vec3(image, window) * 2.0 - 1.0, 1.0);
    upper = min(upper, dot(surface.xyz / surface.w - place, sightline));
  }
#ifdef FRONT
  float front = texture(frontDepth, image).r;
  if (!(front < 1.0))
  {
    discard;
  }
  vec4 before = unitFromClip * vec4(vec3(image, front) * 2.0 - 1.0, 1.0);
  lower = max(lower, dot(before.xyz / before.w - place, sightline));
#endif
#endif
  vec3 p = placeInTexture(place);
  vec3 q = mat3(textureFromUnit) * sightline;
  cutToMatter(place, sightline, p, inverseOf(q), lower, upper);
#ifdef THICK
  float matterStart = lower;
  float matterEnd = upper;
#endif
  lower = max(lower, -0.5 * across);
  upper = min(upper, 0.5 * across);
  cutToRegions(place, sightline, lower, upper);
  if (!(upper > lower))
  {
    discard;
  }
#ifdef SPANS
  spanOf(p, q, lower, upper, startPlace, endPlace);
  vec4 parts = vec4(0.0);
#if ROWS == 1
  parts.x = meanExtinctions(startPlace, endPlace);
#else
  parts = meanExtinctions(startPlace, endPlace);
#endif
  sampleExtinction = dot(parts, vec4(1.0));
  float center = middleOf(startPlace, endPlace);
  vec4 texel = mix(startPlace.Texel, endPlace.Texel, center);
  float middle = mix(lower, upper, center);
#else
  float middle = 0.5 * (lower + upper);
#endif
  sampleAt = place + sightline * middle;
  vec3 sampleInTexture = p + q * middle;
#ifdef MATTER
  setSampleSize(sightline, upper - lower, pixelX, pixelY);
#endif
#ifndef SPANS
  vec4 texel;
  vec4 parts;
  sampleExtinction = extinctionsAt(sampleAt, sampleInTexture, texel, parts);
#endif
#ifdef EMPTY
  // What is not marked by its depth is drawn next.
  if (sampleExtinction > 0.0)
  {
    discard;
  }
  gl_FragData[0] = vec4(0.0);
#else
#ifdef THIN
  // A fragment that is not marked by its depth is drawn as thick matter next.
  if (sampleExtinction * (upper - lower) > LEAST_DEPTH)
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
  opticalDepth = depthOfSlab(place, sightline, p, q, across, matterStart, matterEnd,
    sampleExtinction, lower, upper, isFront);
#endif
  opacity = opticalDepth < 0.05
    ? opticalDepth *
      (1.0 - opticalDepth * (0.5 - opticalDepth * (1.0 / 6.0 - opticalDepth / 24.0)))
    : 1.0 - exp(-opticalDepth);
  vec3 color = vec3(0.0);
#ifdef LIT
  segmentStart = place + sightline * lower;
  segmentEnd = place + sightline * upper;
  startInTexture = p + q * lower;
  endInTexture = p + q * upper;
#ifdef TRANSMISSION
  samplePart = PART(texel);
#endif
#if defined(SHADE) && defined(MATTER)
  sampleAxis = axisAt(sampleInTexture);
#elif defined(SHADE)
  vec4 differences[3];
  differencesAt(sampleInTexture, texel, differences);
#endif
  for (int row = 0; row < ROWS; ++row)
  {
    rowShares[row] = parts[row] / sampleExtinction;
    rowColors[row] = colorAt(texel, row);
#if defined(SHADE) && !defined(MATTER)
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
    // A change by a millionth of the value is rounding.
    rowSurfaces[row] = min(change / max(surfaceColumns[row], 1e-6 * abs(value) * scale), 1.0);
#endif
#ifdef SCATTER
    sampleAlbedo += rowShares[row] * clamp(rowColors[row], 0.0, 1.0) * samplePart;
#else
    color += rowShares[row] * rowColors[row] * ambient * materials[row].x;
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
