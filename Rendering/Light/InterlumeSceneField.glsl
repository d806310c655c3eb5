// SPDX-License-Identifier: BSD-3-Clause
// Multiple scattering of a volume at a position in view coordinates. FIELD is the volume's index.
uniform sampler3D sceneFieldFIELD;
uniform mat4 sceneNodeFromViewFIELD;
uniform mat4 sceneWorldFromViewFIELD;
// Number of nodes of a map along each axis, and the texture size along z, or 0 if there is no
// scattered light.
uniform vec4 sceneNodesFIELD;
uniform float sceneAheadFIELD;
//INTERLUME::LIGHTS
vec3 sceneFieldAtFIELD(vec3 node, float map)
{
  vec3 inside = clamp(node, vec3(0.0), sceneNodesFIELD.xyz - 1.0) + 0.5;
  inside.z += map * sceneNodesFIELD.z;
  return textureLod(sceneFieldFIELD, inside / sceneNodesFIELD.xyw, 0.0).rgb;
}
vec3 sceneScatteredFIELD(vec3 place, vec3 normal)
{
  if (sceneNodesFIELD.w == 0.0)
  {
    return vec3(0.0);
  }
  vec3 here = (sceneNodeFromViewFIELD * vec4(place, 1.0)).xyz;
  vec3 n = normalize(mat3(sceneNodeFromViewFIELD) * normal);
  vec3 node = here + sceneAheadFIELD * dot(abs(n), vec3(1.0)) * n;
  // Vector to the nearest point of the grid's box, whose faces are half a cell outside the
  // outermost nodes.
  vec3 way = clamp(here, vec3(-0.5), sceneNodesFIELD.xyz - 0.5) - here;
  float distance = length(way);
  vec3 toBox = distance > 0.0 ? way / distance : n;
  float beyond = min(distance, 1.0);
  vec3 sides = sceneNodesFIELD.xyz * sceneNodesFIELD.yzx;
  float disk = max(max(sides.x, sides.y), sides.z) / 3.14159265;
  float s = disk / (disk + distance * distance);
  float c = dot(n, toBox);
  float seen = mix(1.0, s * mix(max(c, 0.0), 0.5 + 0.5 * c, s), beyond);
  vec3 sum = vec3(0.0);
#if HAS_FLUENCE
  vec3 facing = mix(n, toBox, beyond) * mat3(sceneNodeFromViewFIELD);
  facing = normalize(mat3(sceneWorldFromViewFIELD) * facing);
  float lean = dot(sceneFieldAtFIELD(node, 1.0), facing);
  sum += max(sceneFieldAtFIELD(node, 0.0), vec3(0.0)) * max(0.25 - 0.5 * lean, 0.0);
#endif
//INTERLUME::FORWARD
  return sum * seen;
}
