// Computes texture colors at surface coordinates. Alpha is the opacity per
// ScalarOpacityUnitDistance. Red, green and blue are premultiplied.

uniform vec4 defaultColor;
#ifdef DETAIL
uniform vec3 detailScale;
#endif
#if defined(DETAIL) && DETAIL == 3
uniform sampler3D detail;
uniform vec3 detailSize;
#endif
#if defined(DETAIL) && DETAIL == 2
uniform sampler2D detail;
uniform vec3 detailSize;
#endif
#ifdef TIMES
uniform float timePeriod;
uniform float timePhase;
#endif
#ifdef GATE
uniform sampler2D gate;
// Start and length of the range of the TimeGate function.
uniform vec2 gateRange;
#endif
#ifdef TRANSFER
uniform sampler3D opacityValues;
uniform sampler2D transfer;
uniform vec2 transferRange;
#endif
#ifdef PAINT_FILTER
uniform vec2 paintSize;
uniform int largestPieces;
#endif

// Maps [0, 1] to the range from the center of the first texel to the center of the last. frame
// contains the size of this range and its start.
vec2 inTexture(vec2 place, vec4 frame)
{
  return clamp(place, 0.0, 1.0) * frame.xy + frame.zw;
}

//INTERLUME::PAINTS

#ifdef PAINT_FILTER
// The axes of a sample's footprint, in voxel coordinates: the sample's segment of the ray, and the
// width and height of a pixel at the distance of the sample.
struct Footprint
{
  vec3 Piece;
  vec3 PixelX;
  vec3 PixelY;
};

// Returns the length of the longest axis, in voxels.
float reachOf(Footprint footprint)
{
  return sqrt(max(dot(footprint.Piece, footprint.Piece),
    max(dot(footprint.PixelX, footprint.PixelX), dot(footprint.PixelY, footprint.PixelY))));
}

// Returns whether the footprint of a sample may be longer than two texels. Such a footprint needs
// more than one lookup. code represents an upper bound of the slopes in the cell.
bool isWide(int code, Footprint footprint)
{
  return reachOf(footprint) * max(paintSize.x, paintSize.y) >
    2.0 * exp2(128.0 - float(code) / 256.0);
}

// Splits the footprint along its longest axis, and determines the size of the pieces.
void setFootprint(inout Sample found, Footprint footprint)
{
  vec2 along = found.Slope * footprint.Piece;
  vec2 x = found.Slope * footprint.PixelX;
  vec2 y = found.Slope * footprint.PixelY;
  vec3 axis = footprint.Piece;
  vec2 across;
  found.IsAlongRay = true;
  float a = dot(along, along);
  float b = dot(x, x);
  float c = dot(y, y);
  // If the axis is the ray, the pieces are composited. Otherwise, they are averaged.
  if (b > a && b >= c)
  {
    axis = footprint.PixelX;
    found.IsAlongRay = false;
    across = a > c ? along : y;
    found.Along = x;
  }
  else if (c > a)
  {
    axis = footprint.PixelY;
    found.IsAlongRay = false;
    across = a > b ? along : x;
    found.Along = y;
  }
  else
  {
    across = b > c ? x : y;
    found.Along = along;
  }
  found.TimeAlong = dot(found.TimeSlope, axis);
  vec2 texels = abs(found.Along) * paintSize;
  found.Pieces = clamp(int(ceil(max(texels.x, texels.y))), 1, largestPieces);
  found.Size = max(abs(across), abs(found.Along) / float(found.Pieces));
}

float levelOf(vec2 texels)
{
  return log2(max(max(texels.x, texels.y), 1.0));
}
#endif

// Returns -log(1 - alpha), limited to 69. The result is accurate for small alpha.
float depthOf(float alpha)
{
  return alpha < 0.05 ? alpha * (1.0 + alpha * (1.0 / 2.0 + alpha * (1.0 / 3.0 + alpha / 4.0)))
                      : -log(max(1.0 - alpha, 1e-30));
}

float strengthAt(vec3 place)
{
#ifdef TRANSFER
  float value = texture(opacityValues, (place + 0.5) * voxelSize).r;
  float column = clamp((value - transferRange.x) * transferRange.y, 0.0, 1.0);
  float size = float(TRANSFER);
  return texture(transfer, vec2((column * (size - 1.0) + 0.5) / size, 0.5)).r;
#else
  return 1.0;
#endif
}

#ifdef GATE
float gateAt(float injected)
{
#ifdef GATE_REPEATS
  float column = fract(injected);
#else
  float column = clamp((injected - gateRange.x) / gateRange.y, 0.0, 1.0);
#endif
  float size = float(GATE);
  return texture(gate, vec2((column * (size - 1.0) + 0.5) / size, 0.5)).r;
}
#endif

// Returns the texture color at a position along the longest axis of the footprint. share is the
// position in [-0.5, 0.5].
vec4 paintOf(Sample found, float share)
{
  vec2 place = found.Coordinates;
  float level = 0.0;
#ifdef PAINT_FILTER
  if (found.IsWide)
  {
    place += share * found.Along;
    level = levelOf(found.Size * paintSize);
  }
#endif
  vec2 inside = place - mix(vec2(0.0), floor(place), vec2(found.Period));
  vec4 paint = inflowAt(found.Paint, inside, level);
#ifdef TIMES
  float time = found.Time;
#ifdef PAINT_FILTER
  time += found.IsWide ? share * found.TimeAlong : 0.0;
#endif
  // Time of inflow, in periods.
  float injected = timePhase - time / timePeriod;
#endif
#ifdef GATE
  float open = gateAt(injected);
#ifdef GATE_INFLOW
  paint *= open;
#endif
#endif
#ifdef DETAIL
  vec2 pattern = inside * detailScale.xy;
#ifdef PAINT_FILTER
  level = found.IsWide ? levelOf(found.Size * abs(detailSize.xy * detailScale.xy)) : 0.0;
#endif
#if DETAIL == 3
  vec4 fine = textureLod(detail, vec3(pattern, -injected * timePeriod * detailScale.z), level);
#else
  vec4 fine = textureLod(detail, pattern, level);
#endif
#if defined(GATE_DETAIL) && defined(DETAIL_MODULATE)
  fine = mix(vec4(1.0), fine, open);
#elif defined(GATE_DETAIL)
  fine *= open;
#endif
#if defined(DETAIL_OVER)
  paint = fine + (1.0 - fine.a) * paint;
#elif defined(DETAIL_ADD)
  paint = min(paint + fine, 1.0);
#else
  paint *= fine;
#endif
#endif
  return paint;
}

// Returns the number of pieces of a sample that are composited along the ray.
int partsOf(Sample found)
{
#ifdef PAINT_FILTER
  return found.IsAlongRay ? found.Pieces : 1;
#else
  return 1;
#endif
}

// Computes the color of a piece of a footprint. Returns whether to draw it: if the longest axis is
// the ray, each piece is drawn, otherwise only the last one, with the mean color of all pieces.
bool takePiece(Sample found, int piece, inout vec4 sum, out vec4 paint)
{
#ifdef PAINT_FILTER
  sum += paintOf(found, (float(piece) + 0.5) / float(found.Pieces) - 0.5);
  if (!found.IsAlongRay)
  {
    paint = sum / float(found.Pieces);
    return piece == found.Pieces - 1;
  }
  paint = sum;
  sum = vec4(0.0);
#else
  paint = paintOf(found, 0.0);
#endif
  return true;
}
