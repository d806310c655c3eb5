// SPDX-License-Identifier: BSD-3-Clause
// Computes the silhouette of a tetrahedron. See TetrahedronSilhouette for the terms.

uniform samplerBuffer points;
uniform usamplerBuffer corners;
uniform samplerBuffer volumes;
// Rows of the matrix from mesh coordinates to pixel x, pixel y and eye z. Pixel x and y are not yet
// multiplied by depth or shifted by pixelOffset.
uniform vec4 eyeRows[3];
uniform vec2 pixelOffset;
uniform vec2 viewport;
// Factor that converts the values of `volumes`, six times the volume of each tetrahedron in mesh
// coordinates, to pixels and depth.
uniform float volumeScale;
#ifdef SCALARS
uniform samplerBuffer scalars;
#endif
#ifdef DELTA_T
uniform samplerBuffer deltaTs;
#endif
#if defined(POINT_COLORS) || defined(CELL_COLORS)
uniform samplerBuffer colors;
#endif

#ifdef SURFACE
// `faces` tells which faces of each tetrahedron are boundary triangles: bit k stands for the face
// opposite corner k. `surfacePoints` contains the normal and texture coordinates of each point.
uniform isamplerBuffer faces;
#ifdef SURFACE_MATERIALS
// Material of the triangle opposite corner k: byte k.
uniform usamplerBuffer faceMaterials;
#endif
uniform samplerBuffer surfacePoints;
#endif

// Inputs of the fragment shader. The outputs of a geometry shader are undefined after EmitVertex(),
// so `shape` keeps a copy.
flat out vec4 edgesX;
flat out vec4 edgesY;
flat out vec4 edgesOne;
flat out vec2 thick;
flat out vec4 depthPlane;
#ifdef SCALARS
flat out vec4 scalarPlane;
#endif
#ifdef DELTA_T
flat out vec4 deltaTPlane;
// Largest deltaT of the corners.
flat out float largestDeltaT;
#endif
#ifdef POINT_COLORS
flat out mat4 colorPlane;
#endif
#ifdef CELL_COLORS
flat out vec4 cellColor;
#endif
#ifdef SURFACE
// 1 plus the number of the material for boundary triangles, otherwise 0. baseFace is for the face on
// the base side, and otherFaces for the face on the other side next to each edge.
flat out float baseFace;
flat out vec4 otherFaces;
flat out mat3x4 normalPlane;
flat out mat2x4 texturePlane;
#endif

struct Shape
{
  // Affine function for each edge of the silhouette: edgesOne + x * edgesX + y * edgesY, with x and
  // y relative to the thick point. lambda is the smallest of the four values.
  vec4 edgesX;
  vec4 edgesY;
  vec4 edgesOne;
  vec2 thick;
  // Planes that interpolate values: the value on the base side at the thick point, its slopes in x
  // and y, and the difference to the other side.
  vec4 depthPlane;
  vec4 scalarPlane;
  vec4 deltaTPlane;
  float largestDeltaT;
  mat4 colorPlane;
  vec4 cellColor;
  float baseFace;
  vec4 otherFaces;
  mat3x4 normalPlane;
  mat2x4 texturePlane;
};
Shape shape;

struct Corner
{
  // Position in pixels relative to the first corner, and depth.
  vec2 place;
  float depth;
  // Twice the signed area of the projected face opposite the corner.
  float area;
  float scalar;
  float deltaT;
  vec4 color;
  // 1 plus the number of the material if the opposite face is a boundary triangle.
  float face;
  vec3 normal;
  vec2 texturePosition;
};

float cross2(vec2 a, vec2 b)
{
  return a.x * b.y - a.y * b.x;
}

void swap(bool condition, inout Corner a, inout Corner b)
{
  if (condition)
  {
    Corner c = a;
    a = b;
    b = c;
  }
}

// Returns the slopes of the affine function with values v at three points.
vec2 slopes(vec3 v, vec2 a, vec2 b, vec2 c)
{
  vec2 ab = b - a;
  vec2 ac = c - a;
  float area = cross2(ab, ac);
  vec2 slope = vec2((v.y - v.x) * ac.y - (v.z - v.x) * ab.y, (v.z - v.x) * ab.x - (v.y - v.x) * ac.x);
  return area == 0.0 ? vec2(0.0) : slope / area;
}

// Minimum distance in pixels over which lambda decreases to 0 in a widened silhouette. It limits
// the slope if an edge contains the thick point, for example if two corners coincide. If such an
// edge were ignored, the other edges would extrapolate the tetrahedron across it.
const float STEEPEST = 1.0 / 1024.0;
// Smallest difference of pixel coordinates that single precision resolves. An edge closer than this
// to the thick point is ignored unless the silhouette is widened, so that only the GPU's
// rasterization decides which tetrahedron covers a pixel. Rasterization assigns the pixel to
// exactly one of two neighbors, whereas lambda could be negative in both.
const float DIGITS = 1.0 / 32768.0;

// Sets the function of edge i, from a to b. The silhouette is counterclockwise, or clockwise if
// turn < 0. atThick is twice the signed area of the triangle of a, b and the thick point.
void setEdge(int i, vec2 a, vec2 b, float atThick, float turn, bool isWide)
{
  vec2 edge = turn > 0.0 ? b - a : a - b;
  float size = length(edge);
  float toThick = (turn > 0.0 ? atThick : -atThick) / max(size, 1e-20);
  bool isUsed = size > 0.0 && (isWide || toThick > DIGITS);
  float ramp = max(toThick, STEEPEST);
  shape.edgesX[i] = isUsed ? -edge.y / (size * ramp) : 0.0;
  shape.edgesY[i] = isUsed ? edge.x / (size * ramp) : 0.0;
  shape.edgesOne[i] = isUsed ? 0.5 + 0.5 * max(toThick, 0.0) / ramp : 1.0;
}

// Fetches a corner. Pixel position and depth are relative to the first corner, which has the mesh
// position `first`.
Corner fetch(uint id, vec3 first)
{
  Corner corner;
  vec3 position = texelFetch(points, int(id)).xyz - first;
  corner.place = vec2(dot(eyeRows[0].xyz, position), dot(eyeRows[1].xyz, position));
  corner.depth = dot(eyeRows[2].xyz, position);
  corner.area = 0.0;
  corner.scalar = 0.0;
#ifdef SCALARS
  corner.scalar = texelFetch(scalars, int(id)).x;
#endif
  corner.deltaT = 1.0;
#ifdef DELTA_T
  corner.deltaT = texelFetch(deltaTs, int(id)).x;
#endif
  corner.face = 0.0;
  corner.normal = vec3(0.0);
  corner.texturePosition = vec2(0.0);
#ifdef SURFACE
  corner.normal = texelFetch(surfacePoints, 2 * int(id)).xyz;
  corner.texturePosition = texelFetch(surfacePoints, 2 * int(id) + 1).xy;
#endif
  corner.color = vec4(0.0);
#ifdef POINT_COLORS
  corner.color = texelFetch(colors, int(id));
#endif
  return corner;
}

// Projects corners and returns the pixel position of the first corner. On input, corners are in eye
// coordinates relative to the first corner, whose eye coordinates are `eye`. On output, they have
// depths and pixel positions relative to the first corner. Differences are computed before
// divisions and rounding, so small and thin tetrahedra keep their shape.
vec2 project(inout Corner c[4], vec3 eye)
{
  vec2 first = eye.xy;
#ifdef PERSPECTIVE
  float w = -eye.z;
  for (int k = 0; k < 4; ++k)
  {
    float depth = 1.0 / (w - c[k].depth);
    c[k].place = (c[k].place + first * (c[k].depth / w)) * depth;
    c[k].depth = depth;
    c[k].scalar *= depth;
    c[k].deltaT *= depth;
    c[k].color *= depth;
    c[k].normal *= depth;
    c[k].texturePosition *= depth;
  }
  first /= w;
#else
  for (int k = 0; k < 4; ++k)
  {
    c[k].depth += eye.z;
  }
#endif
  return first + pixelOffset;
}

// Returns the plane (see Shape) of a value that is v at the corners of the base triangle (a, b, c)
// and atThick on the base side at the thick point.
vec4 makePlane(float atThick, float difference, vec3 v, Corner a, Corner b, Corner c)
{
  return vec4(atThick, slopes(v, a.place, b.place, c.place), difference);
}

#define PLANE(value)                                                                               \
  makePlane(base.value, other.value - base.value, vec3(a.value, b.value, c.value), a, b, c)

// Sets the planes of all values over the base triangle (a, b, c). base and other are the values at
// the thick point on the base side and on the other side of the tetrahedron.
void setPlanes(Corner base, Corner other, float depthDifference, Corner a, Corner b, Corner c)
{
  shape.depthPlane =
    makePlane(base.depth, depthDifference, vec3(a.depth, b.depth, c.depth), a, b, c);
#ifdef SCALARS
  shape.scalarPlane = PLANE(scalar);
#endif
#ifdef DELTA_T
  shape.deltaTPlane = PLANE(deltaT);
#endif
#ifdef POINT_COLORS
  shape.colorPlane = mat4(PLANE(color.x), PLANE(color.y), PLANE(color.z), PLANE(color.w));
#endif
#ifdef SURFACE
  shape.normalPlane = mat3x4(PLANE(normal.x), PLANE(normal.y), PLANE(normal.z));
  shape.texturePlane = mat2x4(PLANE(texturePosition.x), PLANE(texturePosition.y));
#endif
}

Corner mixCorners(Corner a, Corner b, float t)
{
  a.place = mix(a.place, b.place, t);
  a.depth = mix(a.depth, b.depth, t);
  a.scalar = mix(a.scalar, b.scalar, t);
  a.deltaT = mix(a.deltaT, b.deltaT, t);
  a.color = mix(a.color, b.color, t);
  a.normal = mix(a.normal, b.normal, t);
  a.texturePosition = mix(a.texturePosition, b.texturePosition, t);
  return a;
}

// Width in pixels of the margin around thin silhouettes. GPUs round vertices to a fraction of a
// pixel, so thin silhouettes would lose pixels. They are drawn wider, and lambda, clamped to 0,
// makes the margin transparent.
const float MARGIN = 1.0 / 64.0;
const float THIN = 0.5;
const float THINNEST = 2e-3;

vec2 outward(vec2 a, vec2 b)
{
  vec2 edge = b - a;
  return vec2(edge.y, -edge.x) / max(length(edge), 1e-20);
}

// Returns the corner, moved outward by margin, which is negative for clockwise polygons.
vec2 widen(vec2 before, vec2 corner, vec2 after, float margin)
{
  vec2 first = outward(before, corner);
  vec2 second = outward(corner, after);
  // Limit the offset of sharp corners.
  return corner + margin * (first + second) / max(1.0 + dot(first, second), 0.02);
}

// Three or four corners of the silhouette as a triangle strip, in pixels. Four corners form two
// triangles, each with its own planes (see Shape).
vec2 strip[4];
// c: the corners in the order of the silhouette. base, other: the values at the thick point on the
// base side and on the other side. difference: the difference of their depths.
Corner c[4];
Corner base;
Corner other;
float difference;

// Computes the silhouette. Returns its number of corners, or 0 if nothing is to be drawn.
int makeSilhouette(int tetrahedron)
{
  uvec4 ids = texelFetch(corners, tetrahedron);
  vec3 first = texelFetch(points, int(ids.x)).xyz;
  c[0] = fetch(ids.x, first);
  c[1] = fetch(ids.y, first);
  c[2] = fetch(ids.z, first);
  c[3] = fetch(ids.w, first);
  shape.largestDeltaT = max(max(c[0].deltaT, c[1].deltaT), max(c[2].deltaT, c[3].deltaT));
  vec4 position = vec4(first, 1.0);
  vec2 origin = project(
    c, vec3(dot(eyeRows[0], position), dot(eyeRows[1], position), dot(eyeRows[2], position)));
  vec2 low = origin + min(min(c[0].place, c[1].place), min(c[2].place, c[3].place));
  vec2 high = origin + max(max(c[0].place, c[1].place), max(c[2].place, c[3].place));
  // Skip tetrahedra whose bounding rectangle contains no pixel center.
  if (any(greaterThan(ceil(max(low, 0.0) - 0.5), min(high, viewport) - 0.5)))
  {
    return 0;
  }

  vec2 p1 = c[1].place;
  vec2 p2 = c[2].place;
  vec2 p3 = c[3].place;
  vec4 areas = vec4(cross2(p2 - p1, p3 - p1), -cross2(p2, p3), cross2(p1, p3), -cross2(p1, p2));
  float sum = dot(max(areas, 0.0), vec4(1.0));
  if (!(sum > 0.0))
  {
    return 0;
  }
  int positive = int(dot(vec4(greaterThan(areas, vec4(0.0))), vec4(1.0)));
  // Compute the thickness from the volume, which remains accurate for thin tetrahedra, unlike a sum
  // over depths.
  float thickness = texelFetch(volumes, tetrahedron).x * volumeScale / sum;
#ifdef PERSPECTIVE
  thickness *= c[0].depth * c[1].depth * c[2].depth * c[3].depth;
#endif
  vec2 extent = high - low;
  float width = sum / max(extent.x, extent.y);
  float margin = width < THIN && width > THINNEST ? MARGIN : 0.0;
  c[0].area = areas.x;
  c[1].area = areas.y;
  c[2].area = areas.z;
  c[3].area = areas.w;
#ifdef SURFACE
  int tagged = texelFetch(faces, tetrahedron).x;
  for (int k = 0; k < 4; ++k)
  {
    c[k].face = float((tagged >> k) & 1);
#ifdef SURFACE_MATERIALS
    c[k].face *= 1.0 + float((texelFetch(faceMaterials, tetrahedron).x >> uint(8 * k)) & 255u);
#endif
  }
#endif
#ifdef CELL_COLORS
  shape.cellColor = texelFetch(colors, tetrahedron);
#endif

  if (positive != 2)
  {
    // A corner is inside the triangle of the others. Move it to the end.
    float sign = positive == 1 ? 1.0 : -1.0;
    for (int k = 0; k < 3; ++k)
    {
      swap(sign * c[k].area > sign * c[3].area, c[k], c[3]);
    }
    shape.thick = origin + c[3].place;
    float whole = cross2(c[1].place - c[0].place, c[2].place - c[0].place);
    shape.edgesX = vec4(0.0);
    shape.edgesY = vec4(0.0);
    shape.edgesOne = vec4(1.0);
    setEdge(0, c[0].place, c[1].place, cross2(c[1].place - c[0].place, c[3].place - c[0].place),
      whole, margin > 0.0);
    setEdge(1, c[1].place, c[2].place, cross2(c[2].place - c[1].place, c[3].place - c[1].place),
      whole, margin > 0.0);
    setEdge(2, c[2].place, c[0].place, cross2(c[0].place - c[2].place, c[3].place - c[2].place),
      whole, margin > 0.0);
    // Barycentric weights of the thick point on the base side.
    vec3 weights = abs(vec3(c[0].area, c[1].area, c[2].area));
    weights /= weights.x + weights.y + weights.z;
    base = mixCorners(c[0], c[1], weights.y / max(weights.x + weights.y, 1e-30));
    base = mixCorners(base, c[2], weights.z);
    shape.otherFaces = vec4(c[2].face, c[0].face, c[1].face, 0.0);
    other = c[3];
    difference = sign * thickness;
    margin *= whole > 0.0 ? 1.0 : -1.0;
    strip[0] = origin + widen(c[2].place, c[0].place, c[1].place, margin);
    strip[1] = origin + widen(c[0].place, c[1].place, c[2].place, margin);
    strip[2] = origin + widen(c[1].place, c[2].place, c[0].place, margin);
    strip[3] = strip[2];
    return 3;
  }

  // Two projected edges cross. The corners with positive area become corners 0 and 2.
  swap(c[0].area <= 0.0 && c[1].area > 0.0, c[0], c[1]);
  swap(c[0].area <= 0.0, c[0], c[3]);
  swap(c[2].area <= 0.0 && c[1].area > 0.0, c[2], c[1]);
  swap(c[2].area <= 0.0, c[2], c[3]);
  float share = c[2].area / sum;
  float otherFraction = abs(c[3].area) / (abs(c[1].area) + abs(c[3].area));
  base = mixCorners(c[0], c[2], share);
  other = mixCorners(c[1], c[3], otherFraction);
  shape.thick = origin + base.place;
  float turn = cross2(c[2].place - c[0].place, c[3].place - c[1].place);
  for (int i = 0; i < 4; ++i)
  {
    bool isFirst = i == 0 || i == 3;
    vec2 from = i == 0 ? c[0].place : i == 1 ? c[1].place : i == 2 ? c[2].place : c[3].place;
    vec2 to = i == 0 ? c[1].place : i == 1 ? c[2].place : i == 2 ? c[3].place : c[0].place;
    vec2 across = isFirst ? c[2].place : c[0].place;
    float area = cross2(to - from, across - from);
    setEdge(
      i, from, to, area * (isFirst ? share : 1.0 - share), turn, margin > 0.0);
  }
  shape.otherFaces = vec4(c[2].face, c[0].face, c[0].face, c[2].face);
  difference = -thickness;
  margin *= turn > 0.0 ? 1.0 : -1.0;
  strip[0] = origin + widen(c[0].place, c[1].place, c[2].place, margin);
  strip[1] = origin + widen(c[3].place, c[0].place, c[1].place, margin);
  strip[2] = origin + widen(c[1].place, c[2].place, c[3].place, margin);
  strip[3] = origin + widen(c[2].place, c[3].place, c[0].place, margin);
  return 4;
}

// Sets the planes for the first or second half of a silhouette with `size` corners. A triangle
// takes its flat outputs from its last vertex.
void setHalf(int size, bool isSecond)
{
  if (size == 3)
  {
    shape.baseFace = c[3].face;
    setPlanes(base, other, difference, c[0], c[1], c[2]);
  }
  else
  {
    shape.baseFace = isSecond ? c[1].face : c[3].face;
    setPlanes(base, other, difference, c[0], c[2], isSecond ? c[3] : c[1]);
  }
}

// Sets the outputs of a corner at a pixel position.
void setOutputs(vec2 pixel)
{
  edgesX = shape.edgesX;
  edgesY = shape.edgesY;
  edgesOne = shape.edgesOne;
  thick = shape.thick;
  depthPlane = shape.depthPlane;
#ifdef SCALARS
  scalarPlane = shape.scalarPlane;
#endif
#ifdef DELTA_T
  deltaTPlane = shape.deltaTPlane;
  largestDeltaT = shape.largestDeltaT;
#endif
#ifdef POINT_COLORS
  colorPlane = shape.colorPlane;
#endif
#ifdef CELL_COLORS
  cellColor = shape.cellColor;
#endif
#ifdef SURFACE
  baseFace = shape.baseFace;
  otherFaces = shape.otherFaces;
  normalPlane = shape.normalPlane;
  texturePlane = shape.texturePlane;
#endif
  gl_Position = vec4(2.0 * pixel / viewport - 1.0, 0.0, 1.0);
}
