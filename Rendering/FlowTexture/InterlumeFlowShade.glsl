// Shades samples by the direction of a vector array or by the gradient of a scalar array.

#ifdef SHADE
uniform sampler3D shadingValues;
uniform vec3 shadingVoxels;
uniform float power;
#ifdef LIGHTS
uniform vec3 material; // Ambient, diffuse, specular.
uniform vec3 ambientLight;
uniform vec3 worldOrigin; // Position of the first voxel relative to the center of the volume.
#if LIGHTS > 0
uniform vec3 lightDirections[LIGHTS]; // Direction toward the light or its position, in world units.
uniform vec3 lightColors[LIGHTS];
uniform float lightIsPositional[LIGHTS];
#endif
#endif
uniform mat3 worldFromVolume;

#ifdef LIGHTS
struct Light
{
  vec3 Diffuse;
  vec3 Specular;
};
#endif

vec3 shadingAt(vec3 place)
{
  return texture(shadingValues, (place + 0.5) / shadingVoxels).rgb;
}

// Returns the normalized vector or negative gradient in world space, or 0 if it is zero.
vec3 axisAtVoxel(vec3 place)
{
#ifdef SHADE_VECTORS
  vec3 axis = worldFromVolume * shadingAt(place);
#else
  vec3 slope = vec3(
    shadingAt(place + vec3(1.0, 0.0, 0.0)).r - shadingAt(place - vec3(1.0, 0.0, 0.0)).r,
    shadingAt(place + vec3(0.0, 1.0, 0.0)).r - shadingAt(place - vec3(0.0, 1.0, 0.0)).r,
    shadingAt(place + vec3(0.0, 0.0, 1.0)).r - shadingAt(place - vec3(0.0, 0.0, 1.0)).r);
  vec3 axis = -(slope * inverse(worldFromVoxels));
#endif
  float size = length(axis);
  return size > 1e-20 ? axis / size : vec3(0.0);
}

// Returns the diffuse and specular factors. l and eye are unit vectors toward the light and camera.
vec2 reflectionOf(vec3 axis, vec3 l, vec3 eye)
{
  bool isFlat = axis == vec3(0.0);
#ifdef SHADE_VECTORS
  // Shade like a line along axis. Of its normals, use the one that is coplanar with the line and l.
  float along = dot(l, axis);
  float diffuse = isFlat ? 1.0 : sqrt(max(1.0 - along * along, 0.0));
  float mirrored = diffuse * sqrt(max(1.0 - dot(eye, axis) * dot(eye, axis), 0.0)) -
    along * dot(eye, axis);
#else
  float diffuse = isFlat ? 1.0 : max(dot(l, axis), 0.0);
  float mirrored = diffuse > 0.0 ? dot(reflect(-l, axis), eye) : 0.0;
#endif
  return vec2(diffuse, isFlat ? 0.0 : pow(max(mirrored, 0.0), power));
}

#ifdef LIGHTS
Light lightAt(vec3 place, vec3 way)
{
  vec3 axis = axisAtVoxel(place);
  vec3 eye = -normalize(worldFromVoxels * way);
  vec3 world = worldOrigin + worldFromVoxels * place;
  Light light = Light(material.x * ambientLight, vec3(0.0));
#if LIGHTS > 0
  for (int i = 0; i < LIGHTS; ++i)
  {
    vec3 l = normalize(lightDirections[i] - lightIsPositional[i] * world);
    vec2 shares = reflectionOf(axis, l, eye);
    light.Diffuse += material.y * shares.x * lightColors[i];
    light.Specular += material.z * shares.y * lightColors[i];
  }
#endif
  return light;
}
#endif
#endif
