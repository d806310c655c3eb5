// Interpolation of the implicit flow field within a cell. FlowGrid describes the data.

uniform sampler3D cells;
uniform sampler3D places;
#ifdef SPLITS
uniform sampler3D groups;
#endif
#ifdef TIMES
uniform sampler3D times;
#endif
#ifdef SURFACES
// For each label, the index of its inflow texture and the periodicity of u and v.
uniform sampler2D surfaces;
#endif

// One divided by the number of voxels along each axis.
uniform vec3 voxelSize;

const int SPLIT = 0;
const int SPLIT_BY_SIDES = 4095;
const int SEAM = 4096;
const int EMPTY = 8192;
#ifdef SMOOTH_POSITIONS
const float LARGEST_LABEL = 4094.5;
#endif

struct Sample
{
  int Paint;
  bvec2 Period;
  vec2 Coordinates;
  float Time;
  // Derivatives of surface coordinates and time with respect to voxel coordinates.
  mat3x2 Slope;
  vec3 TimeSlope;
#ifdef PAINT_FILTER
  // IsWide is true if the footprint may be longer than two texels. It is then split into Pieces
  // along its longest axis. Along and TimeAlong are the changes of surface coordinates and time
  // along this axis, and IsAlongRay is true if the axis is the view ray. Size is the maximum change
  // of surface coordinates in a piece.
  bool IsWide;
  bool IsAlongRay;
  vec2 Along;
  float TimeAlong;
  vec2 Size;
  int Pieces;
#endif
};

// Returns a sample without paint, with an unsplit footprint. All members are initialized, to avoid
// compiler warnings.
Sample noSample()
{
#ifdef PAINT_FILTER
  return Sample(0, bvec2(false), vec2(0.0), 0.0, mat3x2(0.0), vec3(0.0), false, true, vec2(0.0), 0.0,
    vec2(0.0), 1);
#else
  return Sample(0, bvec2(false), vec2(0.0), 0.0, mat3x2(0.0), vec3(0.0));
#endif
}

// Returns the kind of a cell, and the code of an upper bound of the slopes of u and v in it.
ivec2 kindAt(ivec3 cell)
{
  return ivec2(texelFetch(cells, cell, 0).rg * 65535.0 + 0.5);
}

void setSurface(inout Sample found, int label)
{
#ifdef SURFACES
  vec4 surface = texelFetch(surfaces, ivec2(label, 0), 0);
  found.Paint = int(surface.r);
  found.Period = greaterThan(surface.gb, vec2(0.5));
#else
  found.Paint = PAINT;
  found.Period = bvec2(PERIOD_U, PERIOD_V);
#endif
}

// Interpolates the values c of eight corners and computes the derivatives. Bit k of i is the
// position of corner i along axis k.
#define INTERPOLATE(TYPE, c, f, value, slopeX, slopeY, slopeZ) \
  { \
    TYPE x00 = c[1] - c[0]; \
    TYPE x10 = c[3] - c[2]; \
    TYPE x01 = c[5] - c[4]; \
    TYPE x11 = c[7] - c[6]; \
    TYPE y0 = c[0] + f.x * x00; \
    TYPE y1 = c[2] + f.x * x10; \
    TYPE y2 = c[4] + f.x * x01; \
    TYPE y3 = c[6] + f.x * x11; \
    TYPE z0 = mix(y0, y1, f.y); \
    TYPE z1 = mix(y2, y3, f.y); \
    value = mix(z0, z1, f.z); \
    slopeX = mix(mix(x00, x10, f.y), mix(x01, x11, f.y), f.z); \
    slopeY = mix(y1 - y0, y3 - y2, f.z); \
    slopeZ = z1 - z0; \
  }

#ifdef SMOOTH_POSITIONS
// Interpolates the data of SmoothVoxels: u, v, the maximum slope of adjacent cells, and the label.
vec4 storedAt(vec3 place)
{
  return texture(places, (place + 0.5) * voxelSize);
}

// Sets the surface coordinates and time from interpolated textures, without derivatives.
void lookUpPosition(vec3 place, vec4 stored, inout Sample found)
{
  found.Coordinates = stored.rg;
#ifdef TIMES
  found.Time = texture(times, (place + 0.5) * voxelSize).r;
#endif
}
#endif

// Interpolates within a cell whose corners all have the same label.
void lookUpPlain(ivec3 cell, vec3 f, bool isSeam, inout Sample found)
{
#ifdef SEAMS
  // At a seam, use coordinates in the period of the nearest corner.
  vec2 nearest = texelFetch(places, cell + ivec3(f + 0.5), 0).rg;
  vec2 period = mix(vec2(0.0), vec2(found.Period), bvec2(isSeam));
#endif
  vec2 c[8];
  for (int i = 0; i < 8; ++i)
  {
    c[i] = texelFetch(places, cell + ivec3(i & 1, (i >> 1) & 1, i >> 2), 0).rg;
#ifdef SEAMS
    c[i] -= period * floor(c[i] - nearest + 0.5);
#endif
  }
  vec2 slopeX;
  vec2 slopeY;
  vec2 slopeZ;
  INTERPOLATE(vec2, c, f, found.Coordinates, slopeX, slopeY, slopeZ)
  found.Slope = mat3x2(slopeX, slopeY, slopeZ);
#ifdef TIMES
  float t[8];
  for (int i = 0; i < 8; ++i)
  {
    t[i] = texelFetch(times, cell + ivec3(i & 1, (i >> 1) & 1, i >> 2), 0).r;
  }
  INTERPOLATE(float, t, f, found.Time, found.TimeSlope.x, found.TimeSlope.y, found.TimeSlope.z)
#endif
}

#ifdef SPLITS
bool isSplit(int kind)
{
  return kind == SPLIT || kind == SPLIT_BY_SIDES;
}

// Interpolates between the corners of the group with the largest weight. Returns whether this group
// reached a surface.
bool lookUpSplit(ivec3 cell, vec3 f, bool isBySides, inout Sample found)
{
  int group[8];
  float weight[8];
  vec3 slope[8];
  for (int i = 0; i < 8; ++i)
  {
    ivec3 corner = ivec3(i & 1, (i >> 1) & 1, i >> 2);
    int stored = int(texelFetch(groups, cell + corner, 0).r * 65535.0 + 0.5);
    group[i] = isBySides ? stored : stored / NUMBER_OF_SIDES;
    vec3 w = mix(1.0 - f, f, vec3(corner));
    vec3 s = mix(vec3(-1.0), vec3(1.0), vec3(corner));
    weight[i] = w.x * w.y * w.z;
    slope[i] = vec3(s.x * w.y * w.z, w.x * s.y * w.z, w.x * w.y * s.z);
  }
  int winner = 0;
  float most = -1.0;
  for (int i = 0; i < 8; ++i)
  {
    float sum = 0.0;
    for (int j = 0; j < 8; ++j)
    {
      sum += group[j] == group[i] ? weight[j] : 0.0;
    }
    if (sum > most)
    {
      most = sum;
      winner = group[i];
    }
  }
  int label = isBySides ? winner / NUMBER_OF_SIDES : winner;
  if (label == 0)
  {
    return false;
  }
  setSurface(found, label);
  // At a seam, use coordinates in the period of the nearest corner.
  vec2 c[8];
  vec2 nearest = vec2(0.0);
  float largest = -1.0;
  for (int i = 0; i < 8; ++i)
  {
    c[i] = texelFetch(places, cell + ivec3(i & 1, (i >> 1) & 1, i >> 2), 0).rg;
    weight[i] = group[i] == winner ? weight[i] : -1.0;
    nearest = weight[i] > largest ? c[i] : nearest;
    largest = max(largest, weight[i]);
  }
  vec2 value = vec2(0.0);
  for (int i = 0; i < 8; ++i)
  {
    vec2 way = c[i] - nearest;
    c[i] = way - mix(vec2(0.0), floor(way + 0.5), vec2(found.Period));
    value += max(weight[i], 0.0) * c[i];
  }
  value /= most;
  found.Coordinates = nearest + value;
  found.Slope = mat3x2(0.0);
  for (int i = 0; i < 8; ++i)
  {
    vec2 way = group[i] == winner ? (c[i] - value) / most : vec2(0.0);
    found.Slope += outerProduct(way, slope[i]);
  }
#ifdef TIMES
  found.Time = 0.0;
  found.TimeSlope = vec3(0.0);
  float t[8];
  for (int i = 0; i < 8; ++i)
  {
    t[i] = texelFetch(times, cell + ivec3(i & 1, (i >> 1) & 1, i >> 2), 0).r;
    found.Time += max(weight[i], 0.0) * t[i] / most;
  }
  for (int i = 0; i < 8; ++i)
  {
    found.TimeSlope += group[i] == winner ? (t[i] - found.Time) / most * slope[i] : vec3(0.0);
  }
#endif
  return true;
}
#endif

// Interpolates within a cell whose corners all have the same label. Computes derivatives if
// hasSlopes is true.
void lookUpSurface(vec3 place, vec3 cell, int kind, bool hasSlopes, inout Sample found)
{
  bool isSeam = kind > SEAM;
  setSurface(found, isSeam ? kind - SEAM : kind);
#ifdef SMOOTH_POSITIONS
  if (!hasSlopes && !isSeam)
  {
    lookUpPosition(place, storedAt(place), found);
    return;
  }
#endif
  lookUpPlain(ivec3(cell), place - cell, isSeam, found);
}

// Interpolates within a cell that is not empty. Returns whether the sample reached a surface.
bool lookUpCell(vec3 place, vec3 cell, int kind, bool hasSlopes, inout Sample found)
{
#ifdef SPLITS
  if (isSplit(kind))
  {
    return lookUpSplit(ivec3(cell), place - cell, kind == SPLIT_BY_SIDES, found);
  }
#endif
  lookUpSurface(place, cell, kind, hasSlopes, found);
  return true;
}
