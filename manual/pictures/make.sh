#!/bin/sh
# make.sh
# Makes the pictures of the README and of the manual anew, beside itself.
#
#   sh manual/pictures/make.sh [LAMELLA]
#
# LAMELLA is the program, build/lamella unless given.
set -eu

here=$(cd "$(dirname "$0")" && pwd)
root=$(cd "$here/../.." && pwd)
lamella=${1-"$root/build/lamella"}

# picture NAME DATAFILE COMMANDS [OPTIONS OF show]
picture() {
  "$lamella" -q "$root/datafiles/$2.fe" -e "$3" \
    -e "show \"$here/$1.png\" width 720 height 540 ${4-}"
  echo "$1.png"
}

picture double_bubble double_bubble 'refine; refine; g 100; u; V; g 100; refine; V; u; relax 60'
picture wire_cube wire_cube 'refine; refine; relax; refine; relax 50'
picture twisted_wire twisted_wire 'refine; relax; refine; relax; refine; relax 50'
picture lattice lattice 'refine; refine; refine; g 5; V; g 20'
sh "$here/interference.sh" "$lamella"

picture styles_glass double_bubble 'refine; refine; g 100; u; V; g 100; refine; V; u; relax 60' 'style=glass'
picture styles_paper wire_cube 'refine; refine; relax; refine; relax 50' 'style=paper'
picture styles_wire twisted_wire 'refine; relax; refine; relax 50' 'style=wire'
picture styles_regions lattice 'refine; refine; refine; g 5; V; g 20' 'style=regions explode=0.35 legend'
picture styles_flat double_bubble 'refine; refine; g 100; u; V; g 50' 'style=flat'
picture colours catenoid 'refine; refine; g 100; V; g 50' 'color=vertex z axes scale_bar'
