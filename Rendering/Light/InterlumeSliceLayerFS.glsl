// SPDX-License-Identifier: BSD-3-Clause
//VTK::System::Dec

// Looks a map up as it is seen from another sample of an emitter: two views of one plane are a
// homography apart.
in vec2 texCoord;
uniform sampler2D map;
// From clip coordinates of the texture that is drawn to those of the map.
uniform mat3 mapFromTarget;
uniform float factor;

//VTK::Output::Dec

void main()
{
  vec3 place = mapFromTarget * vec3(texCoord * 2.0 - 1.0, 1.0);
  // Nothing lies in planes behind a light.
  gl_FragData[0] = place.z > 0.0
    ? factor * textureLod(map, place.xy / place.z * 0.5 + 0.5, 0.0)
    : vec4(factor);
}
