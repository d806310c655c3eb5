// SPDX-License-Identifier: BSD-3-Clause
//VTK::System::Dec
//INTERLUME::FEATURES

// Computes the transmittance from a light to the surface of the scene that a pixel shows. It is the
// light buffer's transmittance up to the surface's slab, times the transmittance of the medium
// inside the slab. WITHIN is set for all volumes except the first; the result is then only the
// transmittance inside the slab.
in vec3 place;

//VTK::Output::Dec
//INTERLUME::MEDIUM

// The light functions expect a visible segment. Here it is a point.
vec3 segmentStart = vec3(0.0);
vec3 segmentEnd = vec3(0.0);
vec3 startInTexture = vec3(0.0);
vec3 endInTexture = vec3(0.0);
vec3 sampleAt = vec3(0.0);
float sampleExtinction = 0.0;
#ifdef TRANSMISSION
vec3 samplePart = vec3(0.0);
#else
#define samplePart 1.0
#endif

LIGHT meanOfProduct(LIGHT first, LIGHT last)
{
  return exp(-0.5 * (first + last));
}

void addReflection(inout vec3 sum, vec3 l, vec3 diffuse, vec3 specular)
{
}

//INTERLUME::LIGHTS

void main()
{
  sampleAt = place;
  vec3 l = getDirection_0();
  float path = max((dot(place, sliceNormal) - sliceEntrance) / max(dot(l, sliceNormal), 1e-6), 0.0);
#ifdef WIDE_0
  // The other half space of the light has a separate sweep.
  if (!(dot(place - position_0, sliceNormal) > 0.0))
  {
    discard;
  }
  path = min(path, distance(place, position_0));
#else
  vec4 inBuffer = bufferFromUnit_0 * vec4(place, 1.0);
  if (!(max(abs(inBuffer.x), abs(inBuffer.y)) <= inBuffer.w))
  {
    discard;
  }
#endif
  // If the surface is behind the medium, use the position where light exits the medium.
  float lower = -path;
  float upper = 0.0;
  vec3 p = positionInTexture(place);
  vec3 q = mat3(textureFromUnit) * l;
  cutToMedium(place, l, p, inverseOf(q), lower, upper);
  bool isWithin = upper > lower;
  float end = isWithin ? upper : -path;
  sampleAt = place + l * end;
  cutToRegions(place, l, lower, upper);
  if (isWithin)
  {
    float middle = 0.5 * (lower + upper);
    vec4 texel;
    vec4 parts;
    sampleExtinction = extinctionsAt(place + l * middle, p + q * middle, texel, parts);
#ifdef TRANSMISSION
    samplePart = PART(texel);
#endif
  }
  segmentStart = sampleAt;
  segmentEnd = sampleAt;
  startInTexture = positionInTexture(sampleAt);
  endInTexture = startInTexture;
  gl_FragData[0] = vec4(1.0);
#ifdef WITHIN
  gl_FragData[0].CHANNELS =
    exp(-sampleExtinction * max(upper - lower, 0.0) * LIGHT(samplePart));
#else
  gl_FragData[0].CHANNELS = getTransmittance_0(l);
#endif
}
