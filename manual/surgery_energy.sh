#!/bin/sh
# What remeshing takes of the energy of a bubble that swings: 1000 steps with the mesh kept, with what its changes cost
# given back to velocities, and with interpolation alone. Writes surgery_energy.csv and pictures/surgery_energy.svg.
#   sh manual/surgery_energy.sh build/lamella
set -eu
program=$(realpath "$1")
cd "$(dirname "$0")"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
echo "way,time,part_of_the_swing_lost" >surgery_energy.csv
swing() {  # NAME COMMAND OPTION
  "$program" -q ../datafiles/cube.fe -e "refine 4; relax; rest := total_energy; set vertices x 0.5+1.1*(x-0.5); set vertices z 0.5+(z-0.5)/1.1
    $2; evolve 1 dt=1e-9 keep_mesh; printf \"%.17g %.17g\n\", rest, total_energy+kinetic_energy; log \"$work/log.csv\" every 10; evolve 1000 $3; log off" >"$work/out" 2>&1
  grep -v '^[0-9.]* [0-9.]*$' "$work/out" || true
  awk -F, -v way="$1" -v text="$(grep '^[0-9.]* [0-9.]*$' "$work/out")" 'BEGIN { split(text, w, " ") }
    NR > 1 { printf "%s,%.6g,%.4g\n", way, $1, (w[2] - $5)/(w[2] - w[1]) }' "$work/log.csv" >>surgery_energy.csv
}
swing "no remeshing" "topology off" keep_mesh
swing "given back" "topology energy=kept" ""
swing "interpolated" "topology energy=lost" ""
gnuplot <<EOF
set terminal svg size 720,440 font "DejaVu Sans,12"
set output "pictures/surgery_energy.svg"
set datafile separator ","
set key top left
set xlabel "time"
set ylabel "part of the swing's energy lost"
set grid
plot for [way in "'no remeshing' 'given back' interpolated"] "<awk -F, -v w=\"".way."\" '\$1 == w' surgery_energy.csv" using 2:3 with lines lw 2 title way
EOF
awk -F, 'NR > 1 { last[$1] = $3; t[$1] = $2 } END { for (w in last) printf "%s: %s at %s\n", w, last[w], t[w] }' surgery_energy.csv
