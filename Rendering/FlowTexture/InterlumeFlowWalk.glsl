// Traverses a view ray sample by sample. A sample represents the segment of the ray around it. The
// last segment may be shorter.

struct Ray
{
  vec3 Origin;
  vec3 Direction;
  // Length of the direction before its normalization, in world units.
  float Unit;
  float Lower;
  float Upper;
  // Start of the next sample's segment, and the number of previous samples.
  float From;
  float Number;
};

bool goesOn(Ray ray, vec4 sum)
{
  return ray.From < ray.Upper && sum.a < OPAQUE_ENOUGH;
}

float pieceOf(Ray ray)
{
  return min(sampleDistance, ray.Upper - ray.From);
}

vec3 positionOnRay(Ray ray)
{
  return ray.Origin + (ray.From + 0.5 * pieceOf(ray)) * ray.Direction;
}

vec3 cellOf(vec3 place)
{
  return clamp(floor(place), vec3(0.0), lastCell);
}

void pass(inout Ray ray, float samples)
{
  ray.Number += samples;
  ray.From = ray.Lower + ray.Number * sampleDistance;
}

// Composites the texture color of a sample.
void add(Ray ray, Sample found, vec3 place, inout vec4 sum)
{
  float to = 0.5 * pieceOf(ray);
  float from = -to;
  cutToRegions(place, ray.Direction, from, to);
  float depth = (to - from) * inverseUnitDistance / float(partsOf(found));
  float strength = to > from ? strengthAt(place) : 0.0;
#ifdef SHADE
  Light light = lightAt(place, ray.Direction);
#endif
#ifdef PAINT_FILTER
  int pieces = found.Pieces;
#else
  const int pieces = 1;
#endif
  vec4 pending = vec4(0.0);
  for (int i = 0; i < pieces && strength > 0.0; ++i)
  {
    vec4 paint;
    if (takePiece(found, i, pending, paint))
    {
      paint *= strength;
      float opacity = opacityOf(paint.a, depth);
      vec3 color = paint.rgb * (opacity / max(paint.a, 1e-30));
#ifdef SHADE
      color = color * light.Diffuse + opacity * light.Specular;
#endif
      sum += (1.0 - sum.a) * vec4(color, opacity);
    }
  }
}

#ifdef PAINT_FILTER
Footprint footprintOf(Ray ray, float from, float piece)
{
  float share = (from + 0.5 * piece) / ray.Unit;
  return Footprint(ray.Direction * piece, (rayOriginX + share * rayDirectionX) * pixelSize.x,
    (rayOriginY + share * rayDirectionY) * pixelSize.y);
}

// Returns the size of the footprint at a distance along the ray, in voxels. On an interval of the
// ray, the size is largest at one of the ends.
float reachOf(Ray ray, float from)
{
  return reachOf(footprintOf(ray, from - 0.5 * sampleDistance, sampleDistance));
}
#endif

// Composites a sample, filtered over its footprint. Returns whether the footprint may be longer
// than two texels.
bool addSized(Ray ray, Sample found, int code, vec3 place, inout vec4 sum)
{
#ifdef PAINT_FILTER
  Footprint footprint = footprintOf(ray, ray.From, pieceOf(ray));
  found.IsWide = isWide(code, footprint);
  if (found.IsWide)
  {
    setFootprint(found, footprint);
  }
#endif
  add(ray, found, place, sum);
#ifdef PAINT_FILTER
  return found.IsWide;
#else
  return false;
#endif
}

#ifdef SMOOTH_POSITIONS
// Software OpenGL executes both sides of each branch, and each loop at least once. Therefore rare
// cases have separate outer loops around the loop of the common case.

// Traverses samples in empty cells, and samples in cells of one surface whose footprint is at most
// two texels long.
void walkSmooth(inout Ray ray, float reach, float stride, inout vec4 sum)
{
  while (true)
  {
    vec3 place = positionOnRay(ray);
    vec4 stored = storedAt(place);
    bool isOver = !goesOn(ray, sum);
#if defined(SPLITS) || defined(SEAMS)
    isOver = isOver || stored.a > LARGEST_LABEL;
#endif
#ifdef PAINT_FILTER
    isOver = isOver || stored.b * reach > 2.0;
#endif
    if (isOver)
    {
      break;
    }
#ifdef EMPTY_CELLS
    if (stored.a > 0.0)
#endif
    {
      Sample found = noSample();
      setSurface(found, int(stored.a));
      lookUpPosition(place, stored, found);
      add(ray, found, place, sum);
    }
#ifdef EMPTY_CELLS
    // The distance from a position to the next cell that is not empty is at least the stored
    // distance minus 1.
    pass(ray, max(floor((-1.0 - stored.a) * stride), 1.0));
#else
    pass(ray, 1.0);
#endif
  }
}

#ifdef PLAIN_CELLS
// Traverses cells that are not split, while footprints may be longer than two texels or adjacent
// cells are of another kind. Returns whether a split cell is next.
bool walkPlain(inout Ray ray, inout vec4 sum)
{
  bool isOver = false;
  bool isBeforeSplit = false;
  while (!isOver && goesOn(ray, sum))
  {
    vec3 place = positionOnRay(ray);
    vec3 cell = cellOf(place);
    ivec2 stored = kindAt(ivec3(cell));
#ifdef SPLITS
    if (isSplit(stored.x))
    {
      isBeforeSplit = true;
      break;
    }
#endif
    bool isSeam = stored.x > SEAM;
    Sample found = noSample();
    setSurface(found, isSeam ? stored.x - SEAM : stored.x);
    lookUpPlain(ivec3(cell), place - cell, isSeam, found);
    if (stored.x < EMPTY)
    {
      isOver = !addSized(ray, found, stored.y, place, sum) && (stored.y & 1) == 1;
    }
    else
    {
      isOver = stored.x > EMPTY + 1;
    }
    pass(ray, 1.0);
  }
  return isBeforeSplit;
}
#endif

#ifdef SPLITS
void walkSplits(inout Ray ray, inout vec4 sum)
{
  while (goesOn(ray, sum))
  {
    vec3 place = positionOnRay(ray);
    vec3 cell = cellOf(place);
    ivec2 stored = kindAt(ivec3(cell));
    if (!isSplit(stored.x))
    {
      break;
    }
    Sample found = noSample();
    if (lookUpSplit(ivec3(cell), place - cell, stored.x == SPLIT_BY_SIDES, found))
    {
      addSized(ray, found, stored.y, place, sum);
    }
    pass(ray, 1.0);
  }
}
#endif
#else
// Traverses cells of all kinds.
void walkCells(inout Ray ray, vec3 inverse, inout vec4 sum)
{
  while (goesOn(ray, sum))
  {
    vec3 place = positionOnRay(ray);
    vec3 cell = cellOf(place);
    ivec2 stored = kindAt(ivec3(cell));
    float samples = 1.0;
    if (stored.x >= EMPTY)
    {
      // All cells closer than this distance are empty, so skip their samples.
      float distance = float(stored.x - EMPTY);
      vec3 ends = mix(cell + 1.0 - distance, cell + distance, greaterThan(ray.Direction, vec3(0.0)));
      vec3 exits = (ends - place) * inverse;
      samples += max(ceil(min(min(exits.x, exits.y), exits.z) / sampleDistance) - 1.0, 0.0);
    }
    else
    {
      Sample found = noSample();
      if (lookUpCell(place, cell, stored.x, true, found))
      {
        addSized(ray, found, stored.y, place, sum);
      }
    }
    pass(ray, samples);
  }
}
#endif
