#!/bin/sh
# lattice.sh
# Writes a datafile with a lattice of N x N x N cubic bubbles to standard output.
#
#   sh lattice.sh 5 > lattice5.fe          side 2/sqrt(3)
#   sh lattice.sh 5 1 > lattice5.fe        side 1; any formula of the datafile language will do
#
# Neighbours share their wall.  Each wall is one face, and each bubble one body
# whose volume is that of its cube.

usage="usage: sh lattice.sh N [SIDE]"

case $# in
  1 | 2) ;;
  *) echo "$usage" >&2; exit 2 ;;
esac
case $1 in
  '' | *[!0-9]* | 0*) echo "lattice.sh: N must be a whole number of at least 1, not '$1'" >&2
                      echo "$usage" >&2; exit 2 ;;
esac

n=$1 side=${2-"2/sqrt(3)"} exec awk '
# Ids count from 1, x fastest.  A vertex has 0..n in each direction, an edge or
# a wall along an axis 0..n-1 in its own directions.
function vertex(i, j, k)  { return 1 + i + (n+1)*(j + (n+1)*k) }
function edge_x(i, j, k)  { return 1 + i + n*(j + (n+1)*k) }
function edge_y(i, j, k)  { return 1 + edges + i + (n+1)*(j + n*k) }
function edge_z(i, j, k)  { return 1 + 2*edges + i + (n+1)*(j + (n+1)*k) }
function wall_x(i, j, k)  { return 1 + i + (n+1)*(j + n*k) }
function wall_y(i, j, k)  { return 1 + walls + i + n*(j + (n+1)*k) }
function wall_z(i, j, k)  { return 1 + 2*walls + i + n*(j + n*k) }

BEGIN {
  n = ENVIRON["n"] + 0
  side = ENVIRON["side"]
  edges = n*(n+1)*(n+1)             # along each axis
  walls = n*n*(n+1)                 # across each axis

  print "// A lattice of " n " x " n " x " n " cubic bubbles, made by: sh lattice.sh " n \
        (side == "2/sqrt(3)" ? "" : " \"" side "\"")
  print "// Each wall is one face, shared by the two bubbles beside it."
  print "// At an inner edge four walls meet, where a foam has three: it settles by\n// changing its topology."
  print ""
  print "parameter side_length = " side
  print ""

  print "vertices                            // id   x  y  z"
  for (k = 0; k <= n; k++) for (j = 0; j <= n; j++) for (i = 0; i <= n; i++)
    print vertex(i,j,k) "  " i "*side_length  " j "*side_length  " k "*side_length"

  print ""
  print "edges                               // id   tail  head"
  print "// along x"
  for (k = 0; k <= n; k++) for (j = 0; j <= n; j++) for (i = 0; i < n; i++)
    print edge_x(i,j,k) "  " vertex(i,j,k) " " vertex(i+1,j,k)
  print "// along y"
  for (k = 0; k <= n; k++) for (j = 0; j < n; j++) for (i = 0; i <= n; i++)
    print edge_y(i,j,k) "  " vertex(i,j,k) " " vertex(i,j+1,k)
  print "// along z"
  for (k = 0; k < n; k++) for (j = 0; j <= n; j++) for (i = 0; i <= n; i++)
    print edge_z(i,j,k) "  " vertex(i,j,k) " " vertex(i,j,k+1)

  print ""
  print "faces                               // oriented loops of edges"
  print "// walls across x; normals point to +x"
  for (k = 0; k < n; k++) for (j = 0; j < n; j++) for (i = 0; i <= n; i++)
    print wall_x(i,j,k) "  " edge_y(i,j,k) " " edge_z(i,j+1,k) " -" edge_y(i,j,k+1) " -" edge_z(i,j,k)
  print "// walls across y; normals point to +y"
  for (k = 0; k < n; k++) for (j = 0; j <= n; j++) for (i = 0; i < n; i++)
    print wall_y(i,j,k) "  " edge_z(i,j,k) " " edge_x(i,j,k+1) " -" edge_z(i+1,j,k) " -" edge_x(i,j,k)
  print "// walls across z; normals point to +z"
  for (k = 0; k <= n; k++) for (j = 0; j < n; j++) for (i = 0; i < n; i++)
    print wall_z(i,j,k) "  " edge_x(i,j,k) " " edge_y(i+1,j,k) " -" edge_x(i,j+1,k) " -" edge_y(i,j,k)

  print ""
  print "bodies                              // walls; a minus where the normal points into the bubble"
  for (k = 0; k < n; k++) for (j = 0; j < n; j++) for (i = 0; i < n; i++)
    print ++body "  -" wall_x(i,j,k) " " wall_x(i+1,j,k) " -" wall_y(i,j,k) " " wall_y(i,j+1,k) \
          " -" wall_z(i,j,k) " " wall_z(i,j,k+1) "  volume side_length^3"

  print ""
  print "read"
  print ""
  print "// Type `gogo` to relax."
  print "gogo := { r; u; g 20; r; u; V; g 40 }"
}'
