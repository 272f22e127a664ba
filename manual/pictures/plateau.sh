#!/bin/sh
# Makes the charts of manual/plateau.md with their tables beside them, and prints what they end with:
#   manual/pictures/plateau.sh LAMELLA
# Takes some minutes; `limit` in the environment sets the seconds for each method (10). Surface Evolver takes part where it is installed.
set -eu
lamella=$(realpath "${1:?usage: plateau.sh PATH_TO_LAMELLA}")
here=$(dirname "$(realpath "$0")")
files=$here/../../datafiles
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

chart() {  # datafile, levels, exact energy or nothing
  name=$(basename "$1" .fe)
  echo "== $name"
  "$lamella" "$1" -e "chart \"$here/chart_$name.png\" levels=$2 ${3:+exact=$3} limit=${limit:-10}"
}

chart "$files/cube.fe" 8 4.835975862049
chart "$files/double_bubble.fe" 7 9.139421678069
chart "$files/wire_cube.fe" 7 4.23956311
chart "$files/catenoid.fe" 7 7.6049687
chart "$files/weaire_phelan.fe" 6 21.153356
sh "$files/lattice.sh" 5 > "$work/lattice_125.fe"
chart "$work/lattice_125.fe" 4 ""
