#!/bin/sh
# speed.sh
# What a picture costs: style film, 1600x1200, of lattices of bubbles at three sizes. Writes speed.csv beside itself.
#
#   sh manual/pictures/speed.sh [LAMELLA]
#
# Processor seconds (user and system, of all threads) and wall seconds, the least of REPEAT runs (3 unless set), and the
# greatest memory. What is not drawing is taken off: a run that only makes the mesh, and one that draws a single pixel, which
# prepares all that a picture needs (normals, lines, thickness) and paints next to nothing.
set -eu

here=$(cd "$(dirname "$0")" && pwd)
root=$(cd "$here/../.." && pwd)
lamella=${1-"$root/build/lamella"}
repeat=${REPEAT-3}
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

# measure COMMANDS: "user+system wall kilobytes", the least of each
measure() {
  i=0
  while [ $i -lt "$repeat" ]; do
    /usr/bin/time -a -o "$scratch/times" -f '%U %S %e %M' "$lamella" -q "$scratch/lattice.fe" -e "$1" >/dev/null
    i=$((i + 1))
  done
  awk '{ cpu = $1 + $2
         if (NR == 1 || cpu < least) least = cpu
         if (NR == 1 || $3 < wall) wall = $3
         if ($4 > most) most = $4 }
       END { print least, wall, most }' "$scratch/times"
  rm "$scratch/times"
}

{
  echo "facets,prepare_cpu_s,paint_cpu_s,show_cpu_s,show_wall_s,memory_MB"
  for size in 2:3 5:3 4:5; do
    refinements=${size#*:}
    sh "$root/datafiles/lattice.sh" "${size%:*}" > "$scratch/lattice.fe"
    facets=$("$lamella" -q "$scratch/lattice.fe" -e "refine $refinements; print facet_count")
    mesh=$(measure "refine $refinements")
    pixel=$(measure "refine $refinements; show \"$scratch/a.png\" size=1x1 samples=1")
    whole=$(measure "refine $refinements; show \"$scratch/a.png\" size=1600x1200")
    echo "$facets $mesh $pixel $whole" | awk '{ printf "%d,%.2f,%.2f,%.2f,%.2f,%.0f\n", $1, $5 - $2, $8 - $5, $8 - $2, $9 - $3, $10 / 1024 }'
  done
} > "$scratch/speed.csv"
mv "$scratch/speed.csv" "$here/speed.csv"
cat "$here/speed.csv"
