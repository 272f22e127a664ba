# Kelvin cells, truncated octahedra, of a body-centred lattice: those with their middle within `radius`, as an OBJ file
# in which each cell has faces of its own. import joins them to a foam.
function corner(x, y, z) { printf "v %g %g %g\n", cx + x, cy + y, cz + z; return ++points }
function hexagon(sx, sy, sz,   a, b, c, d, e, f) {
  a = corner(0, sy, 2*sz); b = corner(sx, 0, 2*sz); c = corner(2*sx, 0, sz)
  d = corner(2*sx, sy, 0); e = corner(sx, 2*sy, 0); f = corner(0, 2*sy, sz)
  print "f", a, b, c, d, e, f
}
function cell(   s, t, u, a, b, c, d) {
  for (s = -1; s <= 1; s += 2) {
    for (t = -1; t <= 1; t += 2) for (u = -1; u <= 1; u += 2) hexagon(s, t, u)
    a = corner(2*s, 1, 0); b = corner(2*s, 0, 1); c = corner(2*s, -1, 0); d = corner(2*s, 0, -1); print "f", a, b, c, d
    a = corner(1, 2*s, 0); b = corner(0, 2*s, 1); c = corner(-1, 2*s, 0); d = corner(0, 2*s, -1); print "f", a, b, c, d
    a = corner(1, 0, 2*s); b = corner(0, 1, 2*s); c = corner(-1, 0, 2*s); d = corner(0, -1, 2*s); print "f", a, b, c, d
  }
}
BEGIN {
  for (i = -6; i <= 6; ++i) for (j = -6; j <= 6; ++j) for (k = -6; k <= 6; ++k) {
    if ((i + j) % 2 != 0 || (j + k) % 2 != 0) continue
    cx = 2*i; cy = 2*j; cz = 2*k
    if (cx*cx + cy*cy + cz*cz > radius*radius) continue
    cell()
  }
}
