// SPDX-License-Identifier: BSD-3-Clause
//VTK::System::Dec
//INTERLUME::FEATURES

// Computes a light's transmittance through one slab, which is multiplied into the buffer. For a
// light inside or near the volume, the buffer accumulates optical depth times the cosine between
// ray and normal. This product varies smoothly along the slices, unlike the transmittance of
// increasingly long rays. place is a position in unit space or, for a light inside or near the
// volume, in the buffer (from 0 to 1).
in vec3 place;
#ifdef WIDE
uniform mat3 frame;
#endif
#ifdef POSITIONAL
uniform vec3 position;
#else
uniform vec3 direction;
#endif

//VTK::Output::Dec
//INTERLUME::MEDIUM

void main()
{
#if defined(CUSTOM_MEDIUM) && !defined(WIDE)
  vec3 texelX = dFdx(place);
  vec3 texelY = dFdy(place);
#endif
#ifdef WIDE
  // Octahedral map of the directions in the half space lit by this sweep.
  vec2 corner = place.xy * 2.0 - 1.0;
  vec2 across = vec2(corner.x + corner.y, corner.x - corner.y) * 0.5;
  vec3 l = normalize(frame * vec3(across, max(1.0 - abs(across.x) - abs(across.y), 1e-6)));
#ifdef CUSTOM_MEDIUM
  // Vectors between the rays of adjacent texels, at distance 1 from the light.
  vec3 texelX = dFdx(l);
  vec3 texelY = dFdy(l);
#endif
  vec3 x = position;
  float slope = max(dot(l, sliceNormal), 1e-6);
  float first = (sliceEntrance - dot(position, sliceNormal)) / slope;
  float lower = max(first, 0.0);
  float upper = first + sliceSpacing / slope;
#else
#ifdef POSITIONAL
  vec3 l = normalize(place - position);
#else
  vec3 l = direction;
#endif
  vec3 x = place;
  float upper = 0.5 * sliceSpacing / dot(l, sliceNormal);
  float lower = -upper;
#endif
  vec3 p = positionInTexture(x);
  vec3 q = mat3(textureFromUnit) * l;
  cutToMedium(x, l, p, inverseOf(q), lower, upper);
  if (!(upper > lower))
  {
    discard;
  }
  vec4 texel;
  vec4 parts;
#ifdef WIDE
  int steps = clamp(int(ceil((upper - lower) / (1.5 * sliceSpacing))), 1, 256);
  float size = (upper - lower) / float(steps);
  LIGHT depth = LIGHT(0.0);
  for (int i = 0; i < steps; ++i)
  {
    float s = lower + (float(i) + 0.5) * size;
    float from = -0.5 * size;
    float to = 0.5 * size;
    cutToRegions(x + l * s, l, from, to);
    s += 0.5 * (from + to);
#ifdef CUSTOM_MEDIUM
    setSampleSize(l, size, s * texelX, s * texelY);
#endif
    float extinction = extinctionsAt(x + l * s, p + q * s, texel, parts);
    depth += extinction * (to - from) * PART(texel);
  }
#elif defined(SPANS)
  cutToRegions(x, l, lower, upper);
  MediumSample start;
  MediumSample end;
  spanOf(p, q, lower, upper, start, end);
  LIGHT depth = depthBetween(start, end, upper - lower);
  if (!(largestOf(depth) > 0.0))
  {
    discard;
  }
#else
  cutToRegions(x, l, lower, upper);
  float middle = 0.5 * (lower + upper);
#ifdef CUSTOM_MEDIUM
  setSampleSize(l, upper - lower, texelX, texelY);
#endif
  float extinction = extinctionsAt(x + l * middle, p + q * middle, texel, parts);
  if (!(extinction > 0.0))
  {
    discard;
  }
  LIGHT depth = extinction * (upper - lower) * PART(texel);
#endif
  gl_FragData[0] = vec4(1.0);
#ifdef WIDE
  gl_FragData[0].CHANNELS = depth * slope;
#else
  gl_FragData[0].CHANNELS = exp(-depth);
#endif
  //INTERLUME::BATCH
}
