// SPDX-License-Identifier: BSD-3-Clause
// Scattering of light toward the camera.

// Albedo at the sample.
vec3 sampleAlbedo = vec3(0.0);
#ifdef SCATTER_BRIGHTNESS
uniform float brightness;
#endif
#ifdef PHASE_ANISOTROPY
// Terms of the Henyey-Greenstein phase function: 1 - g^2, (1 - g)^2 and g.
uniform vec3 phase;
#endif
#ifdef PHASE_TABLE
uniform sampler2D phases;
#endif

// Returns 4 pi times the phase function for light in direction l.
float phaseOf(vec3 l)
{
  // turn is 1 minus the cosine of the scattering angle, computed accurately for small angles.
  vec3 change = l + viewRay;
  float turn = min(0.5 * dot(change, change), 2.0);
#ifdef PHASE_ANISOTROPY
  float square = phase.y + 2.0 * phase.z * turn;
  return phase.x / (square * sqrt(square));
#elif defined(PHASE_TABLE)
  float column = (1.0 - 0.5 * turn) * float(PHASE_COLUMNS - 1);
  int first = min(int(column), PHASE_COLUMNS - 2);
  return mix(texelFetch(phases, ivec2(first, 0), 0).r, texelFetch(phases, ivec2(first + 1, 0), 0).r,
    column - float(first));
#else
  return 1.0;
#endif
}
#ifdef FIELD_MAPS
// Multiply scattered light at the nodes of FIELD_MAPS maps, stacked along z: fluence, normalized
// net flux, and the forward-scattered light of each light.
uniform sampler3D scattered;
uniform mat4 nodeFromUnit;
uniform vec3 fieldNodes;
uniform float meanCosine;

// Visibility-weighted mean position in the segment, in node coordinates.
vec3 seenNode = vec3(0.0);

void findSeenNode()
{
  float seen = opticalDepth < 0.05 ? 0.5 - opticalDepth / 12.0
                                   : 1.0 / opticalDepth - (1.0 - opacity) / opacity;
  vec3 x = mix(segmentStart, segmentEnd, seen);
  seenNode = clamp((nodeFromUnit * vec4(x, 1.0)).xyz, vec3(0.0), fieldNodes - 1.0);
}

vec3 fieldAt(int map)
{
  vec3 at = vec3(seenNode.xy, seenNode.z + float(map) * fieldNodes.z) + 0.5;
  return textureLod(scattered, at / (fieldNodes * vec3(1.0, 1.0, float(FIELD_MAPS))), 0.0).rgb;
}

// Adds the scattering of light from all directions.
void addScattered(inout vec3 sum)
{
  float lean = 1.0 - 3.0 * meanCosine * dot(fieldAt(1), viewRay);
  sum += sampleAlbedo * max(fieldAt(0), vec3(0.0)) * max(lean, 0.0);
}
#endif
