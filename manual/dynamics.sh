#!/bin/sh
# Makes what manual/dynamics.md shows: tables in manual/dynamics/*.csv and charts in manual/pictures. Takes some
# minutes on a quiet machine.
#
#   sh manual/dynamics.sh [PROGRAM] [PART ...]      build/lamella unless given; parts: accuracy drift volumes bounds cost
set -eu
cd "$(dirname "$0")/.."
program=${1:-build/lamella}
[ $# -gt 0 ] && shift
parts=${*:-"accuracy drift volumes bounds cost"}
mkdir -p manual/dynamics
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

# A bubble that swings in mode 2, of 1536 facets unless told otherwise.
swing='relax; kick (0.1*(x-0.5), 0.1*(y-0.5), -0.2*(z-0.5))'
# Less, as its triangles are not drawn out in ten periods.
small_swing='relax; kick (0.02*(x-0.5), 0.02*(y-0.5), -0.04*(z-0.5))'
places='foreach vertex vv do printf "%.17g %.17g %.17g\n", vv.x, vv.y, vv.z'

# plot NAME "settings" "columns" [PICTURE]: a picture of manual/dynamics/NAME.csv, a curve for each of its first words
plot() {
  names=$(awk -F, 'NR > 1 && !seen[$1]++ { printf "%s ", $1 }' "manual/dynamics/$1.csv")
  {
    echo "set terminal svg size 800,560 dynamic background 'white' noenhanced"
    echo "set output 'manual/pictures/${4:-$1}.svg'"
    echo "set datafile separator ','; set key outside right; set grid; set logscale xy; set format '%g'; $2"
    printf 'plot '
    first=1
    for name in $names; do
      [ $first = 1 ] || printf ', '
      first=0
      printf "'< grep ^%s, manual/dynamics/%s.csv' using %s with linespoints pointtype 7 pointsize 0.5 title '%s'" \
        "$name" "$1" "$3" "$name"
    done
    echo
  } | gnuplot
}

# Error of the places after one period against Verlet with a tenth of its shortest step, over CPU seconds and over
# the step.
accuracy() {
  time=1.95
  run() {  # METHOD STEPS: places into $scratch/places, seconds on standard output
    "$program" -q datafiles/cube.fe -e "refine 3; $swing; start := clock;
      evolve $2 dt=$time/$2 method=$1 volumes=exact keep_mesh; printf \"%g\n\", clock-start; $places" >"$scratch/out" || return 1
    sed -n 1p "$scratch/out"
    sed 1d "$scratch/out" >"$scratch/places"
  }
  run verlet 32000 >/dev/null
  mv "$scratch/places" "$scratch/exact"
  echo "method,steps,dt,seconds,error" >manual/dynamics/accuracy.csv
  for method in euler verlet implicit midpoint; do
    case $method in
      euler | verlet) counts="100 200 400 800 1600 3200" ;;
      *) counts="5 10 20 40 80 160 320" ;;
    esac
    for steps in $counts; do
      seconds=$(run $method $steps) || continue
      error=$(paste -d ' ' "$scratch/places" "$scratch/exact" |
        awk '{ s += ($1-$4)^2 + ($2-$5)^2 + ($3-$6)^2 } END { printf "%.6g", sqrt(s/NR) }')
      echo "$method,$steps,$(awk "BEGIN { print $time/$steps }"),$seconds,$error" >>manual/dynamics/accuracy.csv
    done
  done
  plot accuracy "set xlabel 'processor time, s'; set ylabel 'error of the places after a period'" 4:5
  plot accuracy "set xlabel 'error of the places after a period'; set ylabel 'step'" 5:3 steps_at_error
}

# Largest departure of the total energy in 10 periods, in parts of the energy that swings, over the step.
drift() {
  echo "method,dt,departure" >manual/dynamics/drift.csv
  for method in euler verlet implicit midpoint; do
    case $method in
      euler | verlet) steps="0.02 0.01 0.005 0.0025" ;;
      *) steps="0.16 0.08 0.04 0.02" ;;
    esac
    for dt in $steps; do
      "$program" -q datafiles/cube.fe -e "refine 3; relax; rest := total_energy; $small_swing; evolve 1 dt=1e-9;
        whole := total_energy + kinetic_energy - rest; log \"$scratch/log.csv\"; evolve ceil(19.5/$dt) dt=$dt method=$method keep_mesh;
        printf \"%.12g %.12g\n\", rest, whole" >"$scratch/whole" || continue
      departure=$(awk -F, -v text="$(cat "$scratch/whole")" 'BEGIN { split(text, w, " ") }
        NR > 1 { d = ($5 - w[1] - w[2])/w[2]; if (d < 0) d = -d; if (d > m) m = d } END { printf "%.4g", m }' "$scratch/log.csv")
      echo "$method,$dt,$departure" >>manual/dynamics/drift.csv
    done
  done
  plot drift "set xlabel 'step'; set ylabel 'largest departure of the energy, parts of what swings'" 2:3
}

# Ways of keeping volumes: cost, error, energy.
volumes() {
  echo "way,scene,facets,us_a_step,volume_error,energy_departure" >manual/dynamics/volumes.csv
  for way in auto lagged exact paper paper_area; do
    for scene in "cube.fe 4" "double_bubble.fe 3"; do
      set -- $scene
      mass=carried
      [ $way = paper_area ] && mass=area
      "$program" -q "datafiles/$1" -e "refine $2; relax; mass $mass; kick (0.1*x, 0.1*y, -0.2*z); evolve 1 dt=1e-9; rest := total_energy+kinetic_energy;
        log \"$scratch/log.csv\"; start := clock; evolve 500 volumes=${way%_area} keep_mesh; printf \"%d %g %.12g\n\", facet_count, 1e6*(clock-start)/500, rest" >"$scratch/out"
      awk -F, -v way=$way -v scene="$1" -v text="$(tail -n 1 "$scratch/out")" 'BEGIN { split(text, w, " ") }
        NR > 1 { if ($12 > e) e = $12; d = $5 - w[3]; if (d < 0) d = -d; if (d > m) m = d }
        END { printf "%s,%s,%s,%.1f,%.2g,%.3g\n", way, scene, w[1], w[2], e, m/w[3] }' "$scratch/log.csv" >>manual/dynamics/volumes.csv
    done
  done
  cat manual/dynamics/volumes.csv
}

# Predicted bound against the largest step that survives: each scene as it is and refined once, at its tension and at
# four times that; implicit methods on coarser ones.
bounds() {
  echo "scene,method,facets,tension,bound,largest,ratio,failure" >manual/dynamics/bounds.csv
  try() {  # NAME FILE COMMANDS OPTIONS
    "$program" -q "$2" -e "$3; stability \"$scratch/chart.svg\" $4" >/dev/null 2>"$scratch/message" || { cat "$scratch/message"; return 0; }
    sed 1d "$scratch/chart.csv" | sed "s/^/$1,/" | tee -a manual/dynamics/bounds.csv
  }
  fast='methods="euler,verlet,gradient" tensions=2'
  slow='methods="implicit,midpoint"'
  each() {  # NAME FILE BEFORE AFTER COARSE FINE: refined COARSE times for all methods, and FINE times
    try "$1" "$2" "$3 refine $5; $4" "$fast"
    try "$1" "$2" "$3 refine $6; $4" "$fast"
    try "$1" "$2" "$3 refine $5; $4" "$slow"
  }
  squeeze='foreach vertex vv where vv.z > 0.5 do { vv.x := 0.5 + 0.1*(vv.x-0.5);
    q := 0.62035/sqrt((vv.x-0.5)^2 + (vv.y-0.5)^2 + (vv.z-0.5)^2);
    vv.x := 0.5 + q*(vv.x-0.5); vv.y := 0.5 + q*(vv.y-0.5); vv.z := 0.5 + q*(vv.z-0.5) }; vc; relax 3 keep_mesh'
  each cubic_bubble datafiles/cube.fe "" relax 2 3
  each double_bubble datafiles/double_bubble.fe "" relax 1 3
  each catenoid_rings datafiles/moving_rings.fe "" relax 2 3
  each frame datafiles/wire_cube.fe "" relax 2 3
  each bubble_in_frame datafiles/bubble_in_frame.fe "" relax 1 2
  each six_bubbles datafiles/six_bubbles.fe "" relax 1 2
  each slivers datafiles/cube.fe "" "relax; $squeeze" 2 3
  try high_valence datafiles/motion/high_valence.fe "vc off" "$fast"
  try high_valence datafiles/motion/high_valence.fe "vc off" "$slow"
  each obtuse datafiles/wire_cube.fe "" "relax; shake 0.25" 2 3
  each obtuse_near_rest datafiles/wire_cube.fe "" "relax; shake 0.05; relax 3 keep_mesh" 2 3
  names=$(awk -F, 'NR > 1 && !seen[$1]++ { printf "%s ", $1 }' manual/dynamics/bounds.csv)
  {
    echo "set terminal svg size 800,560 dynamic background 'white' noenhanced"
    echo "set output 'manual/pictures/bounds.svg'"
    echo "set datafile separator ','; set key outside right; set grid; set logscale xy; set format '%g'"
    echo "set xlabel 'predicted bound'; set ylabel 'largest step that survives'"
    printf "plot x with lines linecolor 'black' title 'equal', x/0.75 with lines dashtype 2 linecolor 'black' title '4/3 of it'"
    shape=6  # another one for each
    for name in $names; do
      shape=$((shape + 1))
      printf ", '< grep -E \"^%s,(euler|verlet|gradient),\" manual/dynamics/bounds.csv' using 5:6 with points pointtype %d pointsize 0.6 title '%s'" \
        "$name" $shape "$name"
    done
    echo
  } | gnuplot
}

# Nanoseconds a facet of processor time of a step, least of three, without what the start of a run takes.
cost() {
  echo "scene,facets,regions,ns_a_facet" >manual/dynamics/cost.csv
  try() {  # NAME FILE COMMANDS STEPS
    "$program" -q "$2" -e "$3; evolve 3 keep_mesh; short := 1e9; long := 1e9;
      for (i := 1; i <= 3; i += 1) {
        start := clock; evolve 1 keep_mesh; short := minimum(short, clock-start);
        start := clock; evolve $4+1 keep_mesh; long := minimum(long, clock-start) };
      printf \"$1,%d,%d,%.2f\n\", facet_count, body_count, 1e9*(long-short)/$4/facet_count" | tail -n 1 | tee -a manual/dynamics/cost.csv
  }
  try six_bubbles datafiles/six_bubbles.fe "refine 3" 200
  sh datafiles/lattice.sh 5 >"$scratch/lattice.fe"
  try lattice_of_125 "$scratch/lattice.fe" "refine 2" 50
  for n in 2 5 9 17; do
    sh datafiles/lattice.sh $n >"$scratch/lattice.fe"
    case $n in 2) r=5 ;; 5) r=3 ;; 9) r=2 ;; 17) r=1 ;; esac
    try "lattice_$n" "$scratch/lattice.fe" "refine $r" 10
  done
  try sphere_10k datafiles/cube.fe "refine 4" 500
  try sphere_100k datafiles/cube.fe "refine 6" 50
  try sphere_400k datafiles/cube.fe "refine 7" 20
  try sphere_1600k datafiles/cube.fe "refine 8" 10
}

for part in $parts; do $part; done
