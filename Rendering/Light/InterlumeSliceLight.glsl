// SPDX-License-Identifier: BSD-3-Clause
// The functions of one light; INDEX is its number.

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
// The buffer as it was some slabs before, up to layerEntrance along the slices' normal.
uniform sampler2D layer_INDEX;
uniform float layerEntrance_INDEX;
// The length of a voxel along the light.
uniform float voxelLength_INDEX;
#endif
#endif
#endif

// Returns the direction in which light goes at the sample.
vec3 getDirection_INDEX()
{
#ifdef POSITIONAL_INDEX
  return normalize(sampleAt - position_INDEX);
#else
  return direction_INDEX;
#endif
}

// Returns the share of the light's colours that reaches the sample without the matter.
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
// Returns how far light that goes along l, inverse in the texture, has come in the slab within the
// volume before it is at x, p in the texture.
float getWay_INDEX(vec3 x, vec3 p, vec3 l, vec3 inverse)
{
  float path = (dot(x, sliceNormal) - sliceEntrance) / max(dot(l, sliceNormal), 1e-6);
#ifdef WIDE_INDEX
  path = min(path, distance(x, position_INDEX));
#endif
  float lower = -max(path, 0.0);
  float upper = 0.0;
  cutToMatter(x, l, p, inverse, lower, upper);
  return max(-lower, 0.0);
}

// Returns how much of that way cropping leaves.
float getPath_INDEX(vec3 x, vec3 p, vec3 l, vec3 inverse)
{
  float lower = -getWay_INDEX(x, p, l, inverse);
  float upper = 0.0;
  cutToRegions(x, l, lower, upper);
  return upper - lower;
}

#if defined(THICK) || defined(WIDE_INDEX) || defined(SPANS)
// The four texels around a place in a map, and its share of the way between them.
void getTexels_INDEX(sampler2D map, vec2 uv, out LIGHT texels[4], out vec2 part)
{
  ivec2 size = textureSize(map, 0);
  vec2 at = uv * vec2(size) - 0.5;
  ivec2 first = ivec2(floor(at));
  part = at - vec2(first);
#ifdef NEAREST_LIGHT
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
// Returns the transmittance up to the slab of the light ray that goes on to x. If opacity rises
// evenly from the surface of matter, optical depth grows about as the square of the distance d from
// there, and transmittance is about (1 - d^2)^2: texels are interpolated as d.
LIGHT getOutside_INDEX(vec3 x)
{
  vec4 b = bufferFromUnit_INDEX * vec4(x, 1.0);
  vec2 uv = b.xy / b.w * 0.5 + 0.5;
#if defined(NEAREST_LIGHT) || !defined(SPANS)
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
// Returns the direction of the ray that a texel of the buffer holds: see SliceLightFS.
vec3 getTexelRay_INDEX(ivec2 texel)
{
  ivec2 size = textureSize(buffer_INDEX, 0);
  vec2 corner = (vec2(clamp(texel, ivec2(0), size - 1)) + 0.5) / vec2(size) * 2.0 - 1.0;
  vec2 across = vec2(corner.x + corner.y, corner.x - corner.y) * 0.5;
  return normalize(frame_INDEX * vec3(across, max(1.0 - abs(across.x) - abs(across.y), 1e-6)));
}

// Returns the length of a light ray in the box of the matter before the slab.
float getWayToSlab_INDEX(vec3 ray)
{
  float lower = 0.0;
  float upper = (sliceEntrance - dot(position_INDEX, sliceNormal)) / max(dot(ray, sliceNormal), 1e-6);
  cutToMatter(position_INDEX, ray, placeInTexture(position_INDEX),
    inverseOf(mat3(textureFromUnit) * ray), lower, upper);
  return max(upper - lower, 0.0);
}

// Returns the transmittance up to the slab of the light ray along l.
LIGHT getOutside_INDEX(vec3 l)
{
  vec3 p = l * frame_INDEX;
  p.xy /= abs(p.x) + abs(p.y) + max(p.z, 0.0);
  vec2 uv = vec2(p.x + p.y, p.x - p.y) * 0.5 + 0.5;
  // Beside the edge of a shadow the mean of depths would be as dark as the shadow.
  LIGHT texels[4];
  vec2 part;
  getTexels_INDEX(buffer_INDEX, uv, texels, part);
  ivec2 corner = ivec2(floor(uv * vec2(textureSize(buffer_INDEX, 0)) - 0.5));
  // Rays of texels that leave the matter before they reach the slab keep their depth, others have it in
  // proportion to their length, the more, the more they go along the slices.
  float way = getWayToSlab_INDEX(l);
  float slope = max(dot(l, sliceNormal), 1e-6);
  for (int i = 0; i < 4; ++i)
  {
    vec3 ray = getTexelRay_INDEX(corner + ivec2(i & 1, i >> 1));
    float texelSlope = max(dot(ray, sliceNormal), 1e-6);
    float longer = texelSlope / slope;
    float ratio =
      clamp(way / max(getWayToSlab_INDEX(ray), 1e-6), min(longer, 1.0), max(longer, 1.0));
    texels[i] = exp(-texels[i] / texelSlope * ratio);
  }
  return interpolate_INDEX(texels, part);
}

#endif
#if defined(THICK) && !defined(WIDE_INDEX)
// The optical depth that light along l meets from the layer on to x, in steps that grow away from x,
// and whether extinctions jump on the way.
LIGHT getNearDepth_INDEX(vec3 x, vec3 l, inout bool isHard)
{
  float whole =
    max((dot(x, sliceNormal) - layerEntrance_INDEX) / max(dot(l, sliceNormal), 1e-6), 0.0);
  float lower = -whole;
  float upper = 0.0;
  vec3 p = placeInTexture(x);
  vec3 q = mat3(textureFromUnit) * l;
  cutToMatter(x, l, p, inverseOf(q), lower, upper);
  float way = max(-lower, 0.0);
  int steps = clamp(int(ceil(way / voxelLength_INDEX)), 1, 8);
  Place here = placeAt(x, p);
  LIGHT depth = LIGHT(0.0);
  float from = 0.0;
  for (int i = 1; i <= steps; ++i)
  {
    float share = float(i) / float(steps);
    float to = way * 0.5 * share * (1.0 + share);
    Place there = placeAt(x - l * to, p - q * to);
    LIGHT part = 0.5 * (PART(here.Texel) + PART(there.Texel));
    depth += meanExtinction(here, there) * (to - from) * part;
    isHard = isHard || jumps(here, there);
    here = there;
    from = to;
  }
  isHard = isHard || (way < 0.99 * whole && extinctionOf(here) > 0.0);
  return depth;
}

// Finds the transmittance beside sharp surfaces, where texels of the buffer belong to light rays
// that have or have not met the surface, whatever the ray of this fragment has: there the buffer is
// asked for the light that has come as far as to the layer, and from there on the fragment's own
// ray is followed. Returns false where all around is even.
bool findTransmittance_INDEX(vec3 l, out LIGHT result)
{
  // A depth of light too little to be seen.
  const float least = 0.02;
  // The place where the eye sees the segment on the average.
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

  // Where matter begins by its values, its begin is known to some hundredths of a voxel: one place
  // is before it and one well behind. Else both places are Gauss's, within what can be seen.
  float size = distance(segmentStart, segmentEnd);
  float reach = min(size, 3.0 / sampleExtinction);
  float ahead = isFront ? -0.15 * voxelLength_INDEX : 0.2113 * reach;
  float behind = isFront ? 0.35 * voxelLength_INDEX : 0.7887 * reach;
  LIGHT first = LIGHT(0.0);
  LIGHT last = LIGHT(0.0);
  // A loop holds the code only once.
  int places = isUneven && largestOf(far) > least ? 2 : 0;
  for (int i = 0; i < places; ++i)
  {
    first = last;
    last = getNearDepth_INDEX(
      segmentStart + sightline * (i == 0 ? ahead : behind), l, isHard);
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
// Returns the transmittance from the light along l to the end of the segment at which light leaves the
// slab. The other end is where light enters the slab.
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
  // In a shadow the matter of the slab changes nothing that can be seen.
  if (!(largestOf(outside) > 1e-4))
  {
    return outside;
  }
#endif
  vec3 q = mat3(textureFromUnit) * l;
  float lower = -getWay_INDEX(x, p, l, inverse);
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
  Place last = placeAt(x + l * upper, p + q * upper);
#elif defined(BACK_TO_FRONT)
  Place last = startPlace;
#else
  Place last = endPlace;
#endif
  LIGHT depth = depthBetween(placeAt(x + l * lower, p + q * lower), last, way);
#endif
  return outside * exp(-depth);
}

// Returns the same for the end at which light enters the slab: there is matter before it only if the
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

// Returns the transmittance from the light: up to the slab from the buffer, within it the mean over
// what the eye sees of the segment.
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
  float path = getWay_INDEX(sampleAt, placeInTexture(sampleAt), l, inverse);
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
      float extinction = extinctionsAt(x, placeInTexture(x), texel, parts);
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
  // Light is known where the segment starts and in its middle.
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
#ifdef CASTERS_INDEX
  color *= 1.0 -
    strength_INDEX * (1.0 - CASTER_SHARE_INDEX * OF_PANES_INDEX getTransmittance_INDEX(l));
#else
  color *= 1.0 - strength_INDEX * (1.0 - OF_PANES_INDEX getTransmittance_INDEX(l));
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
