// SPDX-License-Identifier: BSD-3-Clause
//VTK::System::Dec
//INTERLUME::FEATURES

// Integrates along the segment of a view ray in a tetrahedron, like FragmentIntegration. See
// TetrahedronSilhouette for the terms. The output is a sum, a maximum or a premultiplied color,
// depending on the blend mode.
//VTK::Output::Dec

flat in vec4 edgesX;
flat in vec4 edgesY;
flat in vec4 edgesOne;
flat in vec2 thick;
flat in vec4 depthPlane;
#ifdef SCALARS
flat in vec4 scalarPlane;
uniform samplerBuffer pieces;
uniform samplerBuffer starts;
uniform isamplerBuffer buckets;
#endif
#ifdef DELTA_T
flat in vec4 deltaTPlane;
flat in float largestDeltaT;
#endif
#ifdef POINT_COLORS
flat in mat4 colorPlane;
#endif
#ifdef CELL_COLORS
flat in vec4 cellColor;
#endif
#ifdef OPAQUE
uniform sampler2D opaqueDepth;
// Coefficients of depth: constant term, factor of the depth buffer value, factors of x and y.
uniform vec4 depthOfBuffer;
uniform int pixelStride;
#endif
uniform float lengthScale;
#if defined(PERSPECTIVE) || defined(SURFACE)
// Eye x and y of the point on a pixel's view ray where z is -1 in perspective and 0 in parallel
// projection. Each has three coefficients, for the pixel's x, y and 1.
uniform vec3 eyeOfPixel[2];

vec2 getEye()
{
  vec3 pixel = vec3(gl_FragCoord.xy, 1.0);
  return vec2(dot(eyeOfPixel[0], pixel), dot(eyeOfPixel[1], pixel));
}
#endif
#ifdef MAXIMUM
uniform float opacityOfExtinction;
#endif

#ifdef SURFACE
// Inputs for the shading of boundary triangles; see BoundaryShading.
flat in float baseFace;
flat in vec4 otherFaces;
flat in mat3x4 normalPlane;
flat in mat2x4 texturePlane;
const int MAXIMUM_LIGHTS = 8;
uniform int numberOfLights;
// Positions of the lights (w = 1), or directions toward them (w = 0).
uniform vec4 lightPositions[MAXIMUM_LIGHTS];
uniform vec3 lightColors[MAXIMUM_LIGHTS];
uniform vec3 normalRows[3];
#ifdef SURFACE_MATERIALS
// Four vectors for each material: color, coefficients, specular color, and the texture's first
// pixel, width, height and number of levels, which is negative if it is not repeated. The width is
// 0 without a texture. The first pixel is the number in the fourth vector plus 4096 times the
// number after the specular color.
uniform samplerBuffer surfaceMaterials;
uniform samplerBuffer surfacePixels;
// 1 plus the number of the material that shade() uses.
float shadedFace;

vec4 sampleLevel(int start, vec2 size, bool isRepeated, vec2 position)
{
  vec2 at = (isRepeated ? fract(position) : clamp(position, 0.0, 1.0)) * size - 0.5;
  vec2 first = floor(at);
  vec4 ends = vec4(first, first + 1.0);
  ends = isRepeated ? mod(ends + size.xyxy, size.xyxy) : clamp(ends, vec4(0.0), size.xyxy - 1.0);
  ivec4 pixels = ivec4(ends + 0.5);
  int width = int(size.x);
  vec2 share = at - first;
  vec4 low = mix(texelFetch(surfacePixels, start + pixels.y * width + pixels.x),
    texelFetch(surfacePixels, start + pixels.y * width + pixels.z), share.x);
  vec4 high = mix(texelFetch(surfacePixels, start + pixels.w * width + pixels.x),
    texelFetch(surfacePixels, start + pixels.w * width + pixels.z), share.x);
  return mix(low, high, share.y);
}

// The columns of change are the changes of the position to the next pixels along x and y.
vec4 sampleTexture(float pages, vec4 image, vec2 position, mat2 change)
{
  bool isRepeated = image.w > 0.0;
  int start = int(image.x) + 4096 * int(pages);
  vec2 size = image.yz;
  float texels = max(length(change[0] * size), length(change[1] * size));
  float level = texels > 1.0 ? min(log2(texels), abs(image.w) - 1.0) : 0.0;
  for (float before = 1.0; before <= level; before += 1.0)
  {
    start += int(size.x * size.y);
    size = max(floor(0.5 * size), 1.0);
  }
  vec4 color = sampleLevel(start, size, isRepeated, position);
  float share = fract(level);
  return share == 0.0
    ? color
    : mix(color,
        sampleLevel(start + int(size.x * size.y), max(floor(0.5 * size), 1.0), isRepeated, position),
        share);
}
#else
uniform vec4 surfaceColor;
uniform vec4 surfaceCoefficients;
uniform vec3 specularColor;
#endif
#ifndef PERSPECTIVE
// Change of eye x and y along a view ray, per unit of depth.
uniform vec2 tilt;
#endif

vec4 shade(float depth, vec3 meshNormal, vec2 texturePosition, mat2 textureChange)
{
#ifdef SURFACE_MATERIALS
  int material = 4 * (int(shadedFace + 0.5) - 1);
  vec4 surfaceColor = texelFetch(surfaceMaterials, material);
  vec4 surfaceCoefficients = texelFetch(surfaceMaterials, material + 1);
  vec4 third = texelFetch(surfaceMaterials, material + 2);
  vec3 specularColor = third.rgb;
  vec4 image = texelFetch(surfaceMaterials, material + 3);
  surfaceColor *= image.y > 0.0 ? sampleTexture(third.w, image, texturePosition, textureChange) : vec4(1.0);
#endif
  vec4 base = surfaceColor;
#ifdef PERSPECTIVE
  vec3 eye = vec3(getEye(), -1.0) / depth;
#else
  vec3 eye = vec3(getEye() - tilt * depth, depth);
#endif
  vec3 normal = vec3(dot(normalRows[0], meshNormal), dot(normalRows[1], meshNormal),
    dot(normalRows[2], meshNormal));
  normal = normal / max(length(normal), 1e-30);
  vec3 view = normalize(-eye);
  normal = dot(normal, view) < 0.0 ? -normal : normal;
  vec3 color = base.rgb * surfaceCoefficients.x;
  for (int i = 0; i < numberOfLights; ++i)
  {
    vec3 toward = normalize(lightPositions[i].xyz - lightPositions[i].w * eye);
    float cosine = dot(normal, toward);
    float shine =
      pow(max(dot(2.0 * cosine * normal - toward, view), 1e-30), surfaceCoefficients.w);
    color += cosine > 0.0
      ? lightColors[i] *
        (base.rgb * surfaceCoefficients.y * cosine + specularColor * surfaceCoefficients.z * shine)
      : vec3(0.0);
  }
  return vec4(min(color, 1.0) * base.a, base.a);
}
#endif

// Series expansions are used up to this optical depth. Thicker segments are split.
const float LIMIT = 0.5;
// Opacity at which everything behind is considered hidden.
const float OPAQUE_ENOUGH = 0.999995;

float thinOpacityOf(float x)
{
  return x *
    (1.0 -
      x * (0.5 - x * (1.0 / 6.0 - x * (1.0 / 24.0 - x * (1.0 / 120.0 - x * (1.0 / 720.0))))));
}

// Returns optical depth per unit length, and the relative change of extinction.
vec2 getMoments(float t0, float t1, float d0, float d1)
{
#ifdef DELTA_T
  float a = t0 * d0;
  float b = t0 * d1 + t1 * d0;
  float c = t1 * d1;
  float mean = (2.0 * a + b + 2.0 * c) / 6.0;
  float center = (a + b + 3.0 * c) / 12.0 / max(mean, 1e-37);
  return vec2(mean, clamp(6.0 * center - 3.0, -1.0, 1.0));
#else
  float sum = t0 + t1;
  return vec2(0.5 * sum, (t1 - t0) / max(sum, 1e-37));
#endif
}

// Returns the weights of the front and back colors, and their sum: opacity or optical depth. With
// OPACITY and EXACT, depth must be at most LIMIT.
vec3 getWeights(float depth, float delta)
{
#ifdef OPACITY
#ifdef EXACT
  float opacity = thinOpacityOf(depth);
  float g1 = 0.5 - delta / 6.0;
  float g2 = 1.0 / 3.0 - delta * (1.0 / 6.0 - delta / 30.0);
  float g3 = 0.25 - delta * (0.15 - delta * (0.05 - delta / 140.0));
  float g4 = 0.2 - delta * (2.0 / 15.0 - delta * (2.0 / 35.0));
  float front = depth *
    (g1 - depth * 0.5 * (g2 - depth / 3.0 * (g3 - depth * 0.25 * g4)));
#else
  float opacity = depth < LIMIT ? thinOpacityOf(depth) : 1.0 - exp(-depth);
  float front = 0.5 * opacity;
#endif
  return vec3(front, opacity - front, opacity);
#else
#ifdef EXACT
  float front = depth * (0.5 - delta / 6.0);
#else
  float front = 0.5 * depth;
#endif
  return vec3(front, depth - front, depth);
#endif
}

#ifdef SCALARS
int findPiece(float f)
{
  int piece = texelFetch(buckets, int(f * 1024.0)).x;
  while (f >= texelFetch(starts, piece + 1).x)
  {
    ++piece;
  }
  return piece;
}

#ifndef EXACT
vec4 evaluate(int piece, float f)
{
  return texelFetch(pieces, 2 * piece) +
    texelFetch(pieces, 2 * piece + 1) * (f - texelFetch(starts, piece).x);
}
#endif
#endif

#ifdef SURFACE
// Returns the changes of texture coordinates to the next pixels along x and y. The position is that
// before the division by depth in perspective. slope is the change of lambda.
mat2 getTextureChange(vec2 position, float depth, vec2 slope)
{
  vec2 s = texturePlane[0].yz + slope * texturePlane[0].w;
  vec2 t = texturePlane[1].yz + slope * texturePlane[1].w;
#ifdef PERSPECTIVE
  vec2 change = depthPlane.yz + slope * depthPlane.w;
  s = (s - position.x / depth * change) / depth;
  t = (t - position.y / depth * change) / depth;
#endif
  return mat2(s.x, t.x, s.y, t.y);
}
#endif

void main()
{
  vec2 offset = gl_FragCoord.xy - thick;
  vec4 shares = edgesOne + edgesX * offset.x + edgesY * offset.y;
  float lambda = clamp(min(min(shares.x, shares.y), min(shares.z, shares.w)), 0.0, 1.0);
  vec3 plane = vec3(1.0, offset);
  bool baseIsBack = depthPlane.w > 0.0;

  float baseDepth = dot(depthPlane.xyz, plane);
  float otherDepth = baseDepth + lambda * depthPlane.w;
  float len = lambda * abs(depthPlane.w) * lengthScale;
#ifdef PERSPECTIVE
  vec2 direction = getEye();
  len *= sqrt(1.0 + dot(direction, direction)) / (baseDepth * otherDepth);
  vec2 weight = 1.0 / vec2(baseDepth, otherDepth);
#else
  vec2 weight = vec2(1.0);
#endif
  weight = baseIsBack ? weight.yx : weight;
  vec2 depths = baseIsBack ? vec2(otherDepth, baseDepth) : vec2(baseDepth, otherDepth);

#define ENDS(p, ends)                                                                              \
  float base_##ends = dot(p.xyz, plane);                                                           \
  vec2 ends = vec2(base_##ends, base_##ends + lambda * p.w);                                       \
  ends = (baseIsBack ? ends.yx : ends) * weight;

#ifdef SCALARS
  ENDS(scalarPlane, scalars)
#endif
  vec2 time = vec2(1.0);
#ifdef DELTA_T
  ENDS(deltaTPlane, times)
  // In a pixel that a thin silhouette covers only because of rounding, the interpolated value can
  // be far outside the range of the values at the corners.
  time = clamp(times, 0.0, largestDeltaT);
#endif
#ifdef POINT_COLORS
  vec4 base = vec4(dot(colorPlane[0].xyz, plane), dot(colorPlane[1].xyz, plane),
    dot(colorPlane[2].xyz, plane), dot(colorPlane[3].xyz, plane));
  vec4 other = base +
    lambda * vec4(colorPlane[0].w, colorPlane[1].w, colorPlane[2].w, colorPlane[3].w);
  vec4 front = (baseIsBack ? other : base) * weight.x;
  vec4 back = (baseIsBack ? base : other) * weight.y;
#endif
#ifdef CELL_COLORS
  vec4 front = cellColor;
  vec4 back = cellColor;
#endif

#ifdef SURFACE
  bool isCut = false;
#endif
#ifdef OPAQUE
  // Cut the segment at an opaque surface or the far plane.
  float buffered = texelFetch(opaqueDepth, min(pixelStride * ivec2(gl_FragCoord.xy) + pixelStride / 2,
    textureSize(opaqueDepth, 0) - 1), 0).r;
  float wall = dot(depthOfBuffer, vec4(1.0, buffered, gl_FragCoord.xy));
  if (depths.y < wall)
  {
    if (depths.x <= wall)
    {
      discard;
    }
    float share = (depths.x - wall) / (depths.x - depths.y);
#ifdef PERSPECTIVE
    share *= depths.y / wall;
#endif
    share = min(share, 1.0);
#ifdef SURFACE
    isCut = true;
#endif
    len *= share;
#ifdef SCALARS
    scalars.y = mix(scalars.x, scalars.y, share);
#endif
#ifdef DELTA_T
    time.y = mix(time.x, time.y, share);
#endif
#ifdef POINT_COLORS
    back = mix(front, back, share);
#endif
  }
#endif

#ifdef MAXIMUM
#ifdef SCALARS
  if (!(len > 0.0))
  {
    discard;
  }
  gl_FragData[0] = vec4(clamp(max(scalars.x, scalars.y), 0.0, 1.0));
#else
  float first = min(front.a * opacityOfExtinction, 1.0);
  float second = min(back.a * opacityOfExtinction, 1.0);
  gl_FragData[0] = max(vec4(front.rgb * first, first), vec4(back.rgb * second, second));
#endif
#else
#ifdef SCALARS
  scalars = clamp(scalars, 0.0, 1.0);
  int piece = findPiece(scalars.x);
#endif
#ifdef EXACT
  vec4 sum = vec4(0.0);
  float from = 0.0;
#ifdef SCALARS
  float rise = scalars.y - scalars.x;
#endif
  // Integrate in parts that end at control points and have an optical depth of at most LIMIT. Most
  // segments have one part.
  while (true)
  {
    float to = 1.0;
#ifdef SCALARS
    float start = texelFetch(starts, piece).x;
    float bound = rise > 0.0 ? texelFetch(starts, piece + 1).x : start;
    to = rise == 0.0 ? 1.0 : clamp((bound - scalars.x) / rise, from, 1.0);
    // If the scalar decreases, piece 0 is the last piece and extends to the end of the segment.
    to = rise < 0.0 && piece == 0 ? 1.0 : to;
    vec4 value = texelFetch(pieces, 2 * piece);
    vec4 slope = texelFetch(pieces, 2 * piece + 1);
    vec4 first = value + slope * (scalars.x + from * rise - start);
    vec4 last = value + slope * (scalars.x + to * rise - start);
#else
    vec4 first = mix(front, back, from);
    vec4 last = back;
#endif
    float part = (to - from) * len;
    vec2 moments =
      getMoments(first.a, last.a, mix(time.x, time.y, from), mix(time.x, time.y, to));
    float depth = part * moments.x;
    bool isUncut = true;
#ifdef OPACITY
    if (depth > LIMIT)
    {
      isUncut = false;
#ifdef DELTA_T
      float share = LIMIT / depth;
#else
      // Fraction of the part at which the optical depth reaches LIMIT if extinction varies
      // linearly.
      float growth = (last.a - first.a) / part;
      float root = sqrt(max(first.a * first.a + 2.0 * growth * LIMIT, 0.0));
      float share = min(2.0 * LIMIT / (first.a + root) / part, 1.0);
#endif
      to = from + share * (to - from);
      last = mix(first, last, share);
      moments = getMoments(first.a, last.a, mix(time.x, time.y, from), mix(time.x, time.y, to));
      depth = share * part * moments.x;
    }
#endif
    vec3 weights = getWeights(depth, moments.y);
    vec4 color = vec4(weights.x * first.rgb + weights.y * last.rgb, weights.z);
#ifdef OPACITY
    sum += (1.0 - sum.a) * color;
    if (sum.a > OPAQUE_ENOUGH)
    {
      break;
    }
#else
    sum += color;
#endif
    if (isUncut)
    {
      if (to >= 1.0)
      {
        break;
      }
#ifdef SCALARS
      piece += rise > 0.0 ? 1 : -1;
#endif
    }
    from = to;
  }
  vec4 result = sum;
#else
#ifdef SCALARS
  vec4 front = evaluate(piece, scalars.x);
  vec4 back = evaluate(findPiece(scalars.y), scalars.y);
#endif
  vec3 weights = getWeights(0.25 * (front.a + back.a) * (time.x + time.y) * len, 0.0);
  vec4 result = vec4(weights.x * front.rgb + weights.y * back.rgb, weights.z);
#endif
#ifdef SURFACE
  // The edge that determines lambda also determines the face on the other side.
  shares = mix(shares, vec4(1e30), vec4(equal(abs(edgesX) + abs(edgesY), vec4(0.0))));
  float least = min(min(shares.x, shares.y), min(shares.z, shares.w));
  vec4 isLeast = vec4(equal(shares, vec4(least)));
  isLeast.yzw *= 1.0 - isLeast.x;
  isLeast.zw *= 1.0 - isLeast.y;
  isLeast.w *= 1.0 - isLeast.z;
  float otherFace = dot(otherFaces, isLeast);
  vec2 isFace = baseIsBack ? vec2(otherFace, baseFace) : vec2(baseFace, otherFace);
  if (isFace.x > 0.0 || (isFace.y > 0.0 && !isCut))
  {
    vec3 baseNormal = plane * mat3(normalPlane[0].xyz, normalPlane[1].xyz, normalPlane[2].xyz);
    vec3 otherNormal =
      baseNormal + lambda * vec3(normalPlane[0].w, normalPlane[1].w, normalPlane[2].w);
    vec2 baseTexturePosition = vec2(dot(texturePlane[0].xyz, plane), dot(texturePlane[1].xyz, plane));
    vec2 otherTexturePosition = baseTexturePosition + lambda * vec2(texturePlane[0].w, texturePlane[1].w);
    vec2 slope = vec2(dot(edgesX, isLeast), dot(edgesY, isLeast));
    mat2 baseChange = getTextureChange(baseTexturePosition, baseDepth, vec2(0.0));
    mat2 otherChange = getTextureChange(otherTexturePosition, otherDepth, slope);
    if (isFace.y > 0.0 && !isCut)
    {
#ifdef SURFACE_MATERIALS
      shadedFace = isFace.y;
#endif
      vec4 behind = shade(baseIsBack ? baseDepth : otherDepth,
        (baseIsBack ? baseNormal : otherNormal) * weight.y,
        (baseIsBack ? baseTexturePosition : otherTexturePosition) * weight.y,
        baseIsBack ? baseChange : otherChange);
      result += (1.0 - result.a) * behind;
    }
    if (isFace.x > 0.0)
    {
#ifdef SURFACE_MATERIALS
      shadedFace = isFace.x;
#endif
      vec4 before = shade(baseIsBack ? otherDepth : baseDepth,
        (baseIsBack ? otherNormal : baseNormal) * weight.x,
        (baseIsBack ? otherTexturePosition : baseTexturePosition) * weight.x,
        baseIsBack ? otherChange : baseChange);
      result = before + (1.0 - before.a) * result;
    }
  }
#endif
  gl_FragData[0] = result;
#endif
}
