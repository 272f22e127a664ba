#!/bin/sh
# What a step costs with everything on: writes surgery_steps.csv, the least of three runs each. Usage:
# manual/surgery_steps.sh [PROGRAM]
program=${1:-build/lamella}
folder=$(cd "$(dirname "$0")/.." && pwd)
table=$folder/manual/surgery_steps.csv
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
sh "$folder/datafiles/lattice.sh" 5 > "$work/lattice125.fe"
{
  echo "# $(sed -n 's/^model name.*: //p' /proc/cpuinfo | head -n 1), $(nproc) cores"
  echo "# commit $(git -C "$folder" rev-parse --short HEAD)"
  echo "scene,facets,ms a step,of it surgery,steps,events"
} > "$table"

# scene NAME FILE SETUP STEPS
scene() {
  for run in 1 2 3; do
    text="$3; log events \"$work/events.csv\"; evolve $4; print step_ms; print step_surgery_ms; print facet_count"
    "$program" -q "$2" -e "$text" 2> /dev/null | tail -3 | tr '\n' ' '
    echo "$(($(wc -l < "$work/events.csv") - 1))"
  done | sort -g | head -1 | awk -v name="$1" -v steps="$4" '{ print name "," $3 "," $1 "," $2 "," steps "," $4 }' >> "$table"
}

scene 'cubic bubble' "$folder/datafiles/cube.fe" 'refine 3' 200
scene 'double bubble at rest' "$folder/datafiles/double_bubble.fe" 'refine 3; relax' 200
scene 'lattice of 125' "$work/lattice125.fe" 'refine 1; damping := 2' 100
scene 'films in a cube at rest' "$folder/datafiles/wire_cube.fe" 'refine 4; relax' 200
scene 'rings drawn apart' "$folder/datafiles/rings_apart.fe" 'refine 3; relax; damping := 1' 200
scene 'six bubbles' "$folder/datafiles/six_bubbles.fe" 'refine 3; damping := 1' 200
scene 'bubble falls on a film' "$folder/datafiles/bubble_and_film.fe" 'fall' 200
cat "$table"
