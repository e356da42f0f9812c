// Rays on a periodic height field: the one source of the tracer on the processor, which includes this file in
// a class (micro/march.h), and of the tracer on a Vulkan device (paths.comp). All numbers are double, and
// every result is `precise`, so that both have the same bits where the device rounds correctly.
//
// The includer defines heights[] (row by row), tops[], turns[], nx, ny, columns_per_frame, dx, dy and z_max as
// in micro/surface.h, the structs Facet and Turn, fresnel_dielectric(eta, cosine), and how a CONSTANT is
// declared.

// Cells along each side of a block, for which tops[] has the greatest height.
CONSTANT block_cells = 8;

// How a ray ends: it meets a facet, leaves the surface, or is still between the heights after the limit of
// steps.
CONSTANT hit = 0;
CONSTANT escaped = 1;
CONSTANT lost = 2;

// A point over one of the two triangles of a cell. `upper` is 1 for the triangle with the larger y.
struct Place {
  dvec3 at;
  int i;
  int j;
  int upper;
};

// The end of a ray: the place where the ray meets `facet`, unless `fate` says otherwise.
struct Meeting {
  int fate;
  Place place;
  Facet facet;
};

// Returns whether the diagonal of the cell runs from (i, j) to (i + 1, j + 1), and not from (i + 1, j) to
// (i, j + 1).
bool rising(int i, int j) {
  return ((i + j) & 1) == 0;
}

// Returns the plane of a triangle with 0 <= i < nx and 0 <= j < ny.
Facet facet_of(int i, int j, int upper) {
  int i1 = i + 1 == nx ? 0 : i + 1;
  int j1 = j + 1 == ny ? 0 : j + 1;
  double z00 = double(heights[j * nx + i]);
  double z10 = double(heights[j * nx + i1]);
  double z01 = double(heights[j1 * nx + i]);
  double z11 = double(heights[j1 * nx + i1]);
  bool rises = rising(i, j);
  precise double along = (upper == 0 ? z10 - z00 : z11 - z01) / dx;
  precise double across = ((upper == 0) == rises ? z11 - z10 : z01 - z00) / dy;
  precise double corner = z00;
  if (upper == 1 && !rises) corner = z11 - along * dx - across * dy;
  precise double x0 = double(i) * dx;
  precise double y0 = double(j) * dy;
  return Facet(x0, y0, corner, along, across);
}

// Returns the greatest height of a cell.
double top_of(int i, int j) {
  int i1 = i + 1 == nx ? 0 : i + 1;
  int j1 = j + 1 == ny ? 0 : j + 1;
  float low = max(heights[j * nx + i], heights[j * nx + i1]);
  float high = max(heights[j1 * nx + i], heights[j1 * nx + i1]);
  return double(max(low, high));
}

// Returns the height of the plane over (x, y).
double height_of(Facet f, double x, double y) {
  precise double z = f.z0 + f.slope_x * (x - f.x0) + f.slope_y * (y - f.y0);
  return z;
}

// Returns on which side of the cell's diagonal (x, y) lies: positive for the upper triangle.
double side_of(int i, int j, double x, double y) {
  precise double along = (x - double(i) * dx) * dy;
  precise double across = (y - double(j) * dy) * dx;
  precise double side = rising(i, j) ? across - along : across + along - dx * dy;
  return side;
}

// Returns the place of a point with 0 <= x <= nx dx and 0 <= y <= ny dy.
Place place_over(double x, double y, double z) {
  precise double u = x / dx;
  precise double v = y / dy;
  int i = min(int(u), nx - 1);
  int j = min(int(v), ny - 1);
  return Place(dvec3(x, y, z), i, j, side_of(i, j, x, y) > 0.0 ? 1 : 0);
}

// Returns the place at which a ray begins that arrives over the share (u, v) of the period: on the plane
// through the highest vertex.
Place entry(double u, double v) {
  precise double x = u * (double(nx) * dx);
  precise double y = v * (double(ny) * dy);
  return place_over(x, y, z_max);
}

// Follows the ray from `from` along the unit vector d, from triangle to triangle. Within a triangle the height
// over the surface is linear in the distance t, and the ray meets the plane if it falls towards the plane
// and has t before the edge. A point that rounding puts below its triangle is thereby met at once, or left if
// the ray rises, and no ray passes between two triangles. Cells, and blocks of cells, above which the ray
// stays are left out. A ray that leaves the period continues on the opposite side, from which its distances
// are counted again. It escapes when it rises above the highest vertex, and is lost after 2^24 steps.
Meeting march(Place from, dvec3 d) {
  const double far = 1267650600228229401496703205376.0;  // 2^100
  precise double x = from.at.x;
  precise double y = from.at.y;
  precise double z = from.at.z;
  precise double inverse_x = 1.0 / d.x;
  precise double inverse_y = 1.0 / d.y;
  int i = from.i;
  int j = from.j;
  int upper = from.upper;
  int blocks = (nx + block_cells - 1) / block_cells;
  Facet facet = facet_of(i, j, upper);
  precise double t = 0.0;
  bool new_block = true;
  bool new_cell = true;
  for (int step = 0; step < 16777216; ++step) {
    // The edges of the block or cell, and the distance at which the ray leaves it.
    int low_i = i;
    int low_j = j;
    int high_i = i + 1;
    int high_j = j + 1;
    if (new_block) {
      low_i = i / block_cells * block_cells;
      low_j = j / block_cells * block_cells;
      high_i = min(low_i + block_cells, nx);
      high_j = min(low_j + block_cells, ny);
    }
    precise double to_x = (double(d.x > 0.0 ? high_i : low_i) * dx - x) * inverse_x;
    precise double to_y = (double(d.y > 0.0 ? high_j : low_j) * dy - y) * inverse_y;
    if (d.x == 0.0) to_x = far;
    if (d.y == 0.0) to_y = far;
    int edge = to_y < to_x ? 2 : 1;
    precise double end = to_y < to_x ? to_y : to_x;
    end = max(end, t);
    bool over = false;
    if (new_cell) {
      precise double lowest = z + d.z * (d.z > 0.0 ? t : end);
      double top = 0.0;
      if (new_block) {
        top = double(tops[low_j / block_cells * blocks + low_i / block_cells]);
      } else {
        top = top_of(i, j);
      }
      over = lowest > top;
      if (new_block && !over) {
        new_block = false;
        continue;
      }
    }
    if (!over) {
      facet = facet_of(i, j, upper);
      precise double drift = rising(i, j) ? d.y * dx - d.x * dy : d.y * dx + d.x * dy;
      if (upper == 0 ? drift > 0.0 : drift < 0.0) {
        precise double to_other = -side_of(i, j, x, y) / drift;
        if (to_other <= end) {
          end = max(to_other, t);
          edge = 0;
        }
      }
      precise double rise = d.z - facet.slope_x * d.x - facet.slope_y * d.y;
      if (rise < 0.0) {
        precise double meets = (height_of(facet, x, y) - z) / rise;
        meets = max(meets, t);
        if (meets <= end) {
          x = x + d.x * meets;
          y = y + d.y * meets;
          return Meeting(hit, Place(dvec3(x, y, height_of(facet, x, y)), i, j, upper), facet);
        }
      }
    }
    precise double rises_to = z + d.z * end;
    if (d.z > 0.0 && rises_to >= z_max) return Meeting(escaped, from, facet);
    t = end;
    new_cell = edge != 0;
    if (edge == 0) {
      upper = 1 - upper;
      continue;
    }
    bool forward = edge == 1 ? d.x > 0.0 : d.y > 0.0;
    if (new_block) {  // the cell of the block's edge
      precise double column = (x + d.x * t) / dx;
      precise double row = (y + d.y * t) / dy;
      i = max(low_i, min(int(column), high_i - 1));
      j = max(low_j, min(int(row), high_j - 1));
    }
    if (edge == 1) {
      i = forward ? high_i : low_i - 1;
      new_block = (forward ? i : i + 1) % block_cells == 0;
    } else {
      j = forward ? high_j : low_j - 1;
      new_block = (forward ? j : j + 1) % block_cells == 0;
    }
    if (i == nx || i < 0 || j == ny || j < 0) {
      x = x + d.x * t;
      y = y + d.y * t;
      z = z + d.z * t;
      t = 0.0;
      new_block = true;
    }
    if (i == nx || i < 0) {
      x = forward ? 0.0 : double(nx) * dx;
      i = forward ? 0 : nx - 1;
    }
    if (j == ny || j < 0) {
      y = forward ? 0.0 : double(ny) * dy;
      j = forward ? 0 : ny - 1;
    }
    upper = edge == 1 ? (rising(i, j) == forward ? 1 : 0) : (forward ? 0 : 1);
  }
  return Meeting(lost, from, facet);
}

// The end of a path: the direction in which it travels, the share of its power that is left, the share that
// mirrors absorbed, and the number of reflections. `fate` is `hit` if the path was ended at its limit.
struct Path {
  dvec3 travel;
  double weight;
  double absorbed;
  int order;
  int fate;
};

// Returns v turned about the macroscopic normal by the angle with this cosine and sine.
dvec3 turned_by(dvec3 v, double c, double s) {
  precise double x = c * v.x - s * v.y;
  precise double y = s * v.x + c * v.y;
  return dvec3(x, y, v.z);
}

// Returns the cosine between the normal of a facet and the direction against d.
double facing(Facet f, dvec3 d) {
  precise double scale = 1.0 / sqrt(1.0 + f.slope_x * f.slope_x + f.slope_y * f.slope_y);
  precise double cosine = scale * (f.slope_x * d.x + f.slope_y * d.y - d.z);
  return cosine;
}

// Returns the unit vector along which light continues that travels along d and meets a mirror.
dvec3 mirrored(Facet f, dvec3 d) {
  precise double scale = 1.0 / sqrt(1.0 + f.slope_x * f.slope_x + f.slope_y * f.slope_y);
  precise double twice = 2.0 * (f.slope_x * d.x + f.slope_y * d.y - d.z) * scale * scale;
  precise double x = d.x - twice * f.slope_x;
  precise double y = d.y - twice * f.slope_y;
  precise double z = d.z + twice;
  precise double unit = 1.0 / sqrt(x * x + y * y + z * z);
  x = x * unit;
  y = y * unit;
  z = z * unit;
  return dvec3(x, y, z);
}

// Returns the share of the light that a mirror reflects, and the share `absorbed` after this reflection.
double reflected(double weight, double reflectance) {
  precise double share = weight * reflectance;
  return share;
}
double absorbed_by(double absorbed, double weight, double reflectance) {
  precise double share = absorbed + weight * (1.0 - reflectance);
  return share;
}

// Follows a ray over mirrors of relative index eta (0: perfect reflectors) until it leaves the surface or has
// been reflected `limit` times and meets the surface again. All arithmetic stands in functions: glslang does
// not end if a `precise` result of a loop depends on a struct that the loop replaces.
Path mirror_path(Place from, dvec3 direction, double eta, int limit) {
  Place p = from;
  dvec3 d = direction;
  double weight = 1.0;
  double absorbed = 0.0;
  for (int order = 0; order < limit; ++order) {
    Meeting m = march(p, d);
    if (m.fate != hit) return Path(d, weight, absorbed, order, m.fate);
    double reflectance = 1.0;
    if (eta != 0.0) reflectance = fresnel_dielectric(eta, facing(m.facet, d));
    absorbed = absorbed_by(absorbed, weight, reflectance);
    weight = reflected(weight, reflectance);
    p = m.place;
    d = mirrored(m.facet, d);
  }
  return Path(d, weight, absorbed, limit, march(p, d).fate);
}

// Follows a ray of weight 1 that arrives from `wi` (unit, towards the source) over the share (u, v) of the
// period, over mirrors.
Path path_over_mirrors(dvec3 wi, double u, double v, double eta, int limit) {
  Place p = entry(u, v);
  Turn turn = turns[p.i / columns_per_frame];
  Path path = mirror_path(p, turned_by(wi * -1.0, turn.cosine, -turn.sine), eta, limit);
  path.travel = turned_by(path.travel, turn.cosine, turn.sine);
  return path;
}
