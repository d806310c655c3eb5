// SPDX-License-Identifier: BSD-3-Clause
// Functions of one light. INDEX is the light's index.

uniform vec3 diffuse_INDEX;
#ifdef SHADE
uniform vec3 specular_INDEX;
#endif
#ifdef POSITIONAL_INDEX
uniform vec3 position_INDEX;
uniform vec3 attenuation_INDEX;
#endif
#if defined(CONE_INDEX) || !defined(POSITIONAL_INDEX)
uniform vec3 direction_INDEX;
#endif
#ifdef CONE_INDEX
uniform vec2 cone_INDEX;
#endif
#ifdef SCREEN_INDEX
uniform mat4 screenFromUnit_INDEX;
uniform float edgeWidth_INDEX;
uniform float screenOpacity_INDEX;
#ifdef IMAGE_INDEX
uniform sampler2D image_INDEX;
#endif
#endif
#ifdef SHADOW_INDEX
uniform sampler2D buffer_INDEX;
uniform float strength_INDEX;
#ifdef WIDE_INDEX
uniform mat3 frame_INDEX;
#else
uniform mat4 bufferFromUnit_INDEX;
#ifdef THICK
// Copy of the buffer from a few slabs earlier. It holds the transmittance up to the plane at
// layerEntrance along the slice normal.
uniform sampler2D layer_INDEX;
uniform float layerEntrance_INDEX;
// Length of a voxel along the light direction.
uniform float voxelLength_INDEX;
#endif
#endif
#endif

// Returns the light's direction at the sample.
vec3 getDirection_INDEX()
{
#ifdef POSITIONAL_INDEX
  return normalize(sampleAt - position_INDEX);
#else
  return direction_INDEX;
#endif
}

// Returns the factor that multiplies the light's color at the sample, before attenuation by the
// medium. l is the light's direction.
vec3 getColor_INDEX(vec3 l)
{
  vec3 color = vec3(1.0);
#ifdef POSITIONAL_INDEX
  float d = distance(sampleAt, position_INDEX);
  color /= attenuation_INDEX.x + d * (attenuation_INDEX.y + d * attenuation_INDEX.z);
#endif
#ifdef CONE_INDEX
  float cosine = dot(l, direction_INDEX);
  color *= cosine < cone_INDEX.x ? 0.0 : pow(cosine, cone_INDEX.y);
#endif
#ifdef SCREEN_INDEX
  vec2 uv;
  color *= lightOfScreen(
    screenFromUnit_INDEX * vec4(sampleAt, 1.0), edgeWidth_INDEX, screenOpacity_INDEX, uv);
#ifdef IMAGE_INDEX
  color *= textureLod(image_INDEX, uv, 0.0).rgb;
#endif
#endif
  return color;
}

#ifdef SHADOW_INDEX
// Returns the length of the light ray that travels along l to x, counting only the part inside both
// the slab and the volume's box. p is x in texture coordinates; inverse is the reciprocal of l in
// texture coordinates.
float getDistance_INDEX(vec3 x, vec3 p, vec3 l, vec3 inverse)
{
  float path = (dot(x, sliceNormal) - sliceEntrance) / max(dot(l, sliceNormal), 1e-6);
#ifdef WIDE_INDEX
  path = min(path, distance(x, position_INDEX));
#endif
  float lower = -max(path, 0.0);
  float upper = 0.0;
  cutToMedium(x, l, p, inverse, lower, upper);
  return max(-lower, 0.0);
}

// Returns the length from getDistance_INDEX without the cropped parts of the ray.
float getPath_INDEX(vec3 x, vec3 p, vec3 l, vec3 inverse)
{
  float lower = -getDistance_INDEX(x, p, l, inverse);
  float upper = 0.0;
  cutToRegions(x, l, lower, upper);
  return upper - lower;
}

#if defined(THICK) || defined(WIDE_INDEX) || defined(SPANS)
// Returns the four texels around a position, and the interpolation weights (part) of the second
// column and row.
void getTexels_INDEX(sampler2D map, vec2 uv, out LIGHT texels[4], out vec2 part)
{
  ivec2 size = textureSize(map, 0);
  vec2 at = uv * vec2(size) - 0.5;
  ivec2 first = ivec2(floor(at));
  part = at - vec2(first);
#ifdef NEAREST_LOOKUP
  part = step(0.5, part);
#endif
  for (int i = 0; i < 4; ++i)
  {
    ivec2 texel = clamp(first + ivec2(i & 1, i >> 1), ivec2(0), size - 1);
    texels[i] = texelFetch(map, texel, 0).CHANNELS;
  }
}

LIGHT interpolate_INDEX(LIGHT texels[4], vec2 part)
{
  return mix(mix(texels[0], texels[1], part.x), mix(texels[2], texels[3], part.x), part.y);
}

#endif
#ifndef WIDE_INDEX
// Returns the transmittance up to the slab along the light ray through x. If opacity rises linearly
// from a surface, optical depth grows approximately as the square of the distance d from it, and
// transmittance is approximately (1 - d^2)^2. Therefore d, not the transmittance, is interpolated
// between texels.
LIGHT getOutside_INDEX(vec3 x)
{
  vec4 b = bufferFromUnit_INDEX * vec4(x, 1.0);
  vec2 uv = b.xy / b.w * 0.5 + 0.5;
#if defined(NEAREST_LOOKUP) || !defined(SPANS)
  return textureLod(buffer_INDEX, uv, 0.0).CHANNELS;
#else
#if defined(GL_ARB_texture_gather) && !defined(TRANSMISSION)
  vec2 part = fract(uv * vec2(textureSize(buffer_INDEX, 0)) - 0.5);
  vec4 texels = sqrt(max(1.0 - sqrt(textureGather(buffer_INDEX, uv)), vec4(0.0)));
  float depth = mix(mix(texels.w, texels.z, part.x), mix(texels.x, texels.y, part.x), part.y);
#else
  LIGHT texels[4];
  vec2 part;
  getTexels_INDEX(buffer_INDEX, uv, texels, part);
  for (int i = 0; i < 4; ++i)
  {
    texels[i] = sqrt(max(1.0 - sqrt(texels[i]), LIGHT(0.0)));
  }
  LIGHT depth = interpolate_INDEX(texels, part);
#endif
  LIGHT root = 1.0 - depth * depth;
  return root * root;
#endif
}

#endif
#ifdef WIDE_INDEX
// Returns the ray direction of a buffer texel, as in InterlumeSliceLightFS.glsl.
vec3 getTexelRay_INDEX(ivec2 texel)
{
  ivec2 size = textureSize(buffer_INDEX, 0);
  vec2 corner = (vec2(clamp(texel, ivec2(0), size - 1)) + 0.5) / vec2(size) * 2.0 - 1.0;
  vec2 across = vec2(corner.x + corner.y, corner.x - corner.y) * 0.5;
  return normalize(frame_INDEX * vec3(across, max(1.0 - abs(across.x) - abs(across.y), 1e-6)));
}

// Returns the length of the part of a light ray that is inside the volume's box and in front of the
// slab.
float getDistanceToSlab_INDEX(vec3 ray)
{
  float lower = 0.0;
  float upper = (sliceEntrance - dot(position_INDEX, sliceNormal)) / max(dot(ray, sliceNormal), 1e-6);
  cutToMedium(position_INDEX, ray, positionInTexture(position_INDEX),
    inverseOf(mat3(textureFromUnit) * ray), lower, upper);
  return max(upper - lower, 0.0);
}

// Returns the transmittance up to the slab along l.
LIGHT getOutside_INDEX(vec3 l)
{
  vec3 p = l * frame_INDEX;
  p.xy /= abs(p.x) + abs(p.y) + max(p.z, 0.0);
  vec2 uv = vec2(p.x + p.y, p.x - p.y) * 0.5 + 0.5;
  // Interpolate transmittance instead of optical depth. At a shadow edge, the mean of optical
  // depths would be as dark as the shadow.
  LIGHT texels[4];
  vec2 part;
  getTexels_INDEX(buffer_INDEX, uv, texels, part);
  ivec2 corner = ivec2(floor(uv * vec2(textureSize(buffer_INDEX, 0)) - 0.5));
  // Scale the optical depth of each texel's ray by the ratio of path lengths inside the volume.
  // Rays that exit the volume before the slab therefore keep about the same depth. The ratio of the
  // cosines between the rays and the normal limits the factor.
  float way = getDistanceToSlab_INDEX(l);
  float slope = max(dot(l, sliceNormal), 1e-6);
  for (int i = 0; i < 4; ++i)
  {
    vec3 ray = getTexelRay_INDEX(corner + ivec2(i & 1, i >> 1));
    float texelSlope = max(dot(ray, sliceNormal), 1e-6);
    float longer = texelSlope / slope;
    float ratio =
      clamp(way / max(getDistanceToSlab_INDEX(ray), 1e-6), min(longer, 1.0), max(longer, 1.0));
    texels[i] = exp(-texels[i] / texelSlope * ratio);
  }
  return interpolate_INDEX(texels, part);
}

#endif
#if defined(THICK) && !defined(WIDE_INDEX)
// Returns the optical depth along l from the layer to x, integrated in steps that grow with the
// distance from x. Sets isHard if extinction jumps in between.
LIGHT getNearDepth_INDEX(vec3 x, vec3 l, inout bool isHard)
{
  float whole =
    max((dot(x, sliceNormal) - layerEntrance_INDEX) / max(dot(l, sliceNormal), 1e-6), 0.0);
  float lower = -whole;
  float upper = 0.0;
  vec3 p = positionInTexture(x);
  vec3 q = mat3(textureFromUnit) * l;
  cutToMedium(x, l, p, inverseOf(q), lower, upper);
  float way = max(-lower, 0.0);
  int steps = clamp(int(ceil(way / voxelLength_INDEX)), 1, 8);
  MediumSample here = mediumSampleAt(x, p);
  LIGHT depth = LIGHT(0.0);
  float from = 0.0;
  for (int i = 1; i <= steps; ++i)
  {
    float share = float(i) / float(steps);
    float to = way * 0.5 * share * (1.0 + share);
    MediumSample there = mediumSampleAt(x - l * to, p - q * to);
    LIGHT part = 0.5 * (PART(here.Texel) + PART(there.Texel));
    depth += meanExtinction(here, there) * (to - from) * part;
    isHard = isHard || jumps(here, there);
    here = there;
    from = to;
  }
  isHard = isHard || (way < 0.99 * whole && extinctionOf(here) > 0.0);
  return depth;
}

// Computes the transmittance near sharp surfaces. There, some texels of the buffer belong to light
// rays that hit the surface and others to light rays that miss it. Therefore the transmittance is
// sampled from the earlier layer, and the fragment's own light ray is integrated from there.
// Returns false if there is no sharp surface.
bool findTransmittance_INDEX(vec3 l, out LIGHT result)
{
  // Largest invisible difference in transmittance.
  const float least = 0.02;
  // Visibility-weighted mean position in the segment, from 0 to 1.
  float seen = opticalDepth < 0.05 ? 0.5 - opticalDepth / 12.0
                                   : 1.0 / opticalDepth - (1.0 - opacity) / opacity;
  vec4 b = bufferFromUnit_INDEX * vec4(mix(segmentStart, segmentEnd, seen), 1.0);
  vec2 uv = b.xy / b.w * 0.5 + 0.5;
  vec2 part;
  LIGHT texels[4];
  getTexels_INDEX(buffer_INDEX, uv, texels, part);
  LIGHT layer[4];
  getTexels_INDEX(layer_INDEX, uv, layer, part);
  LIGHT darkest = LIGHT(2.0);
  LIGHT lightest = LIGHT(0.0);
  for (int i = 0; i < 4; ++i)
  {
    LIGHT through = texels[i] / max(layer[i], LIGHT(1e-6));
    darkest = min(darkest, through);
    lightest = max(lightest, through);
  }
  LIGHT far = interpolate_INDEX(layer, part);
  bool isUneven = isFront || largestOf((lightest - darkest) * far) > least;
  bool isHard = isFront;

  // If the medium begins inside the segment, the position where it begins is known to within a few
  // hundredths of a voxel. One sample is then placed in front of that position and another well
  // behind it. Otherwise the samples are the Gauss points of the visible part.
  float size = distance(segmentStart, segmentEnd);
  float reach = min(size, 3.0 / sampleExtinction);
  float ahead = isFront ? -0.15 * voxelLength_INDEX : 0.2113 * reach;
  float behind = isFront ? 0.35 * voxelLength_INDEX : 0.7887 * reach;
  LIGHT first = LIGHT(0.0);
  LIGHT last = LIGHT(0.0);
  // A loop avoids duplicated code.
  int places = isUneven && largestOf(far) > least ? 2 : 0;
  for (int i = 0; i < places; ++i)
  {
    first = last;
    last = getNearDepth_INDEX(
      segmentStart + viewRay * (i == 0 ? ahead : behind), l, isHard);
  }
  float start = max(ahead, 0.0);
  LIGHT slope = (last - first) / (behind - start);
  first = max(first - slope * start, LIGHT(0.0));
  last = max(first + slope * size, LIGHT(0.0));
  result = far * meanOfProduct(first, last);
  return places > 0 && isHard;
}
#endif

#if (defined(SPANS) || defined(BACK_TO_FRONT)) && !defined(WIDE_INDEX)
// Returns the transmittance along l up to the end of the segment on the side where light leaves the
// slab.
LIGHT getFarEnd_INDEX(vec3 l, vec3 inverse)
{
#ifdef BACK_TO_FRONT
  vec3 x = segmentStart;
  vec3 p = startInTexture;
#else
  vec3 x = segmentEnd;
  vec3 p = endInTexture;
#endif
  LIGHT outside = getOutside_INDEX(x);
#ifdef SPANS
  // In full shadow, the medium inside the slab makes no visible difference.
  if (!(largestOf(outside) > 1e-4))
  {
    return outside;
  }
#endif
  vec3 q = mat3(textureFromUnit) * l;
  float lower = -getDistance_INDEX(x, p, l, inverse);
  float upper = 0.0;
  cutToRegions(x, l, lower, upper);
  float way = upper - lower;
#ifndef SPANS
  float middle = 0.5 * (lower + upper);
  vec4 texel;
  vec4 parts;
  float extinction = extinctionsAt(x + l * middle, p + q * middle, texel, parts);
  LIGHT depth = extinction * way * PART(texel);
#else
#ifdef CROPPING
  MediumSample last = mediumSampleAt(x + l * upper, p + q * upper);
#elif defined(BACK_TO_FRONT)
  MediumSample last = startSample;
#else
  MediumSample last = endSample;
#endif
  LIGHT depth = depthBetween(mediumSampleAt(x + l * lower, p + q * lower), last, way);
#endif
  return outside * exp(-depth);
}

// Returns the transmittance along l up to the end of the segment on the side where light enters the
// slab. The light passes through the medium of the slab before it reaches that end only if the
// segment is cut.
LIGHT getNearEnd_INDEX(vec3 l, vec3 inverse)
{
#ifdef BACK_TO_FRONT
  float way = getPath_INDEX(segmentEnd, endInTexture, l, inverse);
  return getOutside_INDEX(segmentEnd) * exp(-sampleExtinction * way * LIGHT(samplePart));
#else
  float way = getPath_INDEX(segmentStart, startInTexture, l, inverse);
  return getOutside_INDEX(segmentStart) * exp(-sampleExtinction * way * LIGHT(samplePart));
#endif
}
#endif

// Returns the transmittance from the light to the segment. The transmittance up to the slab is
// looked up in the buffer. Inside the slab, it is the visibility-weighted mean over the segment.
LIGHT getTransmittance_INDEX(vec3 l)
{
#ifdef WIDE_INDEX
  if (!(dot(sampleAt - position_INDEX, sliceNormal) > 0.0))
  {
    return LIGHT(0.0);
  }
#else
#ifdef THICK
  LIGHT found;
  if (findTransmittance_INDEX(l, found))
  {
    return found;
  }
#endif
#endif
  vec3 inverse = inverseOf(mat3(textureFromUnit) * l);
#ifdef WIDE_INDEX
  LIGHT outside = getOutside_INDEX(l);
  float path = getDistance_INDEX(sampleAt, positionInTexture(sampleAt), l, inverse);
  if (path > 1.5 * sliceSpacing)
  {
    int steps = clamp(int(ceil(path / (1.5 * sliceSpacing))), 1, 256);
    float size = path / float(steps);
    LIGHT depth = LIGHT(0.0);
    for (int i = 0; i < steps; ++i)
    {
      vec4 texel;
      vec4 parts;
      vec3 x = sampleAt - l * ((float(i) + 0.5) * size);
      float from = -0.5 * size;
      float to = 0.5 * size;
      cutToRegions(x, l, from, to);
      x += l * (0.5 * (from + to));
      float extinction = extinctionsAt(x, positionInTexture(x), texel, parts);
      depth += extinction * (to - from) * PART(texel);
    }
    return outside * exp(-depth);
  }
#elif !defined(SPANS) && !defined(BACK_TO_FRONT)
  LIGHT outside = getOutside_INDEX(sampleAt);
#endif
#if defined(WIDE_INDEX) || !(defined(SPANS) || defined(BACK_TO_FRONT))
  LIGHT first = sampleExtinction * getPath_INDEX(segmentStart, startInTexture, l, inverse) * samplePart;
  LIGHT last = sampleExtinction * getPath_INDEX(segmentEnd, endInTexture, l, inverse) * samplePart;
  return outside * meanOfProduct(first, last);
#elif !defined(SPANS)
  // The transmittance is known at the start and at the center of the segment.
  LIGHT start = getFarEnd_INDEX(l, inverse);
  float way = getPath_INDEX(sampleAt, 0.5 * (startInTexture + endInTexture), l, inverse);
  LIGHT middle = getOutside_INDEX(sampleAt) * exp(-sampleExtinction * way * LIGHT(samplePart));
  return meanFrom(start,
    mix(2.0 * middle - start, middle * middle / max(start, LIGHT(1e-30)), step(middle, start)));
#elif defined(BACK_TO_FRONT)
  return meanFrom(getFarEnd_INDEX(l, inverse), getNearEnd_INDEX(l, inverse));
#else
  return meanFrom(getNearEnd_INDEX(l, inverse), getFarEnd_INDEX(l, inverse));
#endif
}
#endif

void shine_INDEX(inout vec3 sum)
{
  vec3 l = getDirection_INDEX();
#ifdef FORWARD_MAP_INDEX
  vec3 forward = fieldAt(FORWARD_MAP_INDEX);
#ifdef WIDE_INDEX
  forward *= dot(sampleAt - position_INDEX, sliceNormal) > 0.0 ? 1.0 : 0.0;
#endif
  addReflection(sum, l, forward, vec3(0.0));
#endif
  vec3 color = getColor_INDEX(l);
  if (!(max(max(color.r, color.g), color.b) > 0.0))
  {
    return;
  }
#ifdef SHADOW_INDEX
#ifdef OCCLUDERS_INDEX
  color *= 1.0 -
    strength_INDEX * (1.0 - OCCLUDER_FRACTION_INDEX * OF_TRANSLUCENT_INDEX getTransmittance_INDEX(l));
#else
  color *= 1.0 - strength_INDEX * (1.0 - OF_TRANSLUCENT_INDEX getTransmittance_INDEX(l));
#endif
#ifdef WIDE_INDEX
  color *= dot(sampleAt - position_INDEX, sliceNormal) > 0.0 ? 1.0 : 0.0;
#endif
#endif
  addReflection(sum, l, color * diffuse_INDEX,
#ifdef SHADE
    color * specular_INDEX
#else
    vec3(0.0)
#endif
  );
}
