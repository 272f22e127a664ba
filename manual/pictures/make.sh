#!/bin/sh
# make.sh
# Makes the pictures of the README and of the manual anew, beside itself.
#
#   sh manual/pictures/make.sh [LAMELLA [NAME...]]
#
# LAMELLA is the program, build/lamella unless given; NAME the pictures to make, all unless given.
set -eu

here=$(cd "$(dirname "$0")" && pwd)
root=$(cd "$here/../.." && pwd)
lamella=${1-"$root/build/lamella"}
[ $# -eq 0 ] || shift
names=$*
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

wanted() { [ -z "$names" ] || case " $names " in *" $1 "*) ;; *) return 1 ;; esac; }

# picture NAME DATAFILE COMMANDS [OPTIONS OF show]
picture() {
  wanted "$1" || return 0
  "$lamella" -q "$2" -e "$3" -e "show \"$here/$1.png\" size=720x540 ${4-}"
  echo "$1.png"
}
data=$root/datafiles

double_bubble='refine 3; relax; refine; relax'
wire_cube='refine 3; relax; refine; relax'
picture double_bubble "$data/double_bubble.fe" "$double_bubble"
picture wire_cube "$data/wire_cube.fe" "$wire_cube"
picture lattice "$data/lattice.fe" 'refine; refine; refine; g 5; V; g 20'

# A wire of 96 sides that winds three times around a ring, and its film: one polygon to begin with.
awk 'BEGIN { n = 96; step = 8*atan2(1, 1)/n
       for (i = 0; i < n; ++i) { t = i*step; r = 1 + 0.4*cos(3*t); print "v", r*cos(t), r*sin(t), 0.4*sin(3*t) }
       printf "f"; for (i = 1; i <= n; ++i) printf " %d", i; print "" }' > "$scratch/wire.obj"
if wanted twisted_wire; then
  "$lamella" -q -e "import \"$scratch/wire.obj\"; relax; refine; relax; refine; relax" \
    -e "show \"$here/twisted_wire.png\" size=720x540 from (1, -0.4, 1.2)"
  echo twisted_wire.png
fi

# A film on a ring in a jet of air.
awk 'BEGIN { n = 64; step = 8*atan2(1, 1)/n; for (i = 0; i < n; ++i) print "v", cos(i*step), sin(i*step), 0
       printf "f"; for (i = 1; i <= n; ++i) printf " %d", i; print "" }' > "$scratch/ring.obj"
if wanted wind; then
  "$lamella" -q -e "import \"$scratch/ring.obj\"; relax; refine 3; relax; damping := 1" \
    -e 'wind (0, 0, 4*exp(-1.5*(x^2+y^2))) pressure 1; evolve 600' \
    -e "show \"$here/wind.png\" size=720x540 from (1, -1.3, 0.7)"
  echo wind.png
fi

# A bubble that the wind dents.
if wanted wind_bubble; then
  "$lamella" -q "$data/cube.fe" -e 'refine 4; relax; damping := 0.5' \
    -e 'wind (6*exp(-3*((y-0.5)^2+(z-0.5)^2)), 0, 0) pressure 1; evolve 120' \
    -e "show \"$here/wind_bubble.png\" size=720x540 from (0.2, -1, 0.3) shadow"
  echo wind_bubble.png
fi

# A foam of 59 Kelvin cells, whose outer ones have room to become round.
if wanted foam || wanted foam_cells; then
  awk -v radius=7 -f "$here/kelvin.awk" > "$scratch/kelvin.obj"
  "$lamella" -q -e "import \"$scratch/kelvin.obj\"; relax; refine; relax" \
    -e "show \"$here/foam.png\" size=1200x900" \
    -e "show \"$here/foam_cells.png\" size=1200x900 style=regions explode=0.3"
  echo foam.png foam_cells.png
fi

# A periodic foam, every cell whole; and what is left of a foam in which bubbles have burst.
picture weaire_phelan "$data/weaire_phelan.fe" 'refine; refine; relax; refine; relax' 'shadow'
if wanted foam_burst; then
  "$lamella" -q "$data/six_bubbles.fe" -e 'refine; refine; relax' -e "show \"$here/foam_burst_1.png\" size=360x300 shadow" \
    -e 'burst body[2]; relax; refine; relax' -e "show \"$here/foam_burst_2.png\" size=360x300 shadow" \
    -e 'burst body[5]; relax' -e "show \"$here/foam_burst_3.png\" size=360x300 shadow"
  echo foam_burst_1.png to foam_burst_3.png
fi

# Two rings drawn apart: further than 1.3255 radii the film between them gives way. What is left of its neck is a thread
# without area, which is not drawn.
if wanted pinch_1; then
  sed 's/cosh(half)/1/' "$data/catenoid_on_rings.fe" > "$scratch/rings.fe"
  view='size=360x420 from (0.3, -1, 0.25)'
  "$lamella" -q "$scratch/rings.fe" -e 'half := 0.4; refine 3; relax' -e "show \"$here/pinch_1.png\" $view" \
    -e 'half := 0.66; relax' -e "show \"$here/pinch_2.png\" $view" \
    -e 'half := 0.68; recalc; { relax 2 } 4' -e "show \"$here/pinch_3.png\" $view" \
    -e '{ relax 2 } 4; relax 20' -e "show facets where area > 2e-4 \"$here/pinch_4.png\" $view"
  echo pinch_1.png to pinch_4.png
fi

if [ -z "$names" ]; then sh "$here/interference.sh" "$lamella"; fi

picture styles_glass "$data/double_bubble.fe" "$double_bubble" 'style=glass'
picture styles_paper "$data/wire_cube.fe" "$wire_cube" 'style=paper'
picture styles_wire "$data/twisted_wire.fe" 'refine; refine; relax; refine; relax 50' 'style=wire'
picture styles_regions "$data/lattice.fe" 'refine; refine; refine; g 5; V; g 20' 'style=regions explode=0.35 legend'
picture styles_flat "$data/double_bubble.fe" 'refine; refine; g 100; u; V; g 50' 'style=flat'
picture colours "$data/catenoid.fe" 'refine; refine; g 100; V; g 50' 'color=vertex z axes scale_bar'
