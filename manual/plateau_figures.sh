#!/bin/bash
# Measures the figures of manual/plateau.md and writes them to plateau_figures.csv beside this file. Takes some minutes.
#   manual/plateau_figures.sh LAMELLA
# Times are processor seconds of one thread, the least of `runs` (3); rows on threads are seconds on the wall. Surface Evolver takes part where it is installed. With large=1
# Newton's step is taken on 1.6 million facets too (some minutes and gigabytes more).
set -eu
lamella=$(realpath "${1:?usage: plateau_figures.sh PATH_TO_LAMELLA}")
here=$(dirname "$(realpath "$0")")
files=$here/../datafiles
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
csv=$here/plateau_figures.csv
runs=${runs:-3}
export OMP_NUM_THREADS=1
echo 'figure,scene,facets,program,value,unit' > "$csv"

row() {
  (IFS=,; echo "$*") | tee -a "$csv"
}

# The least processor seconds of some runs of a command; what it prints goes to $work/out.
seconds() {
  local least=1e9 spent
  for _ in $(seq "$runs"); do
    spent=$(bash -c 'TIMEFORMAT=%U; time timeout -s KILL 600 "$@" > "$0" 2>&1' "$work/out" "$@" 2>&1 | tail -1)
    least=$(awk -v a="$least" -v b="$spent" 'BEGIN { print b < a ? b : a }')
  done
  echo "$least"
}

ours() {  # datafile, commands
  seconds "$lamella" "$1" -e "$2"
}

theirs() {  # datafile, commands
  printf '%s\nq\nq\n' "$2" > "$work/commands"
  seconds sh -c 'evolver "$0" < "$1"' "$1" "$work/commands"
}

have_evolver() {
  command -v evolver > /dev/null
}

calculate() {
  awk "BEGIN { printf \"%.3g\", $1 }"
}

repeated() {  # how often, command
  local all=''
  for _ in $(seq "$1"); do all="$all$2; "; done
  echo "$all"
}

descent_step() {
  local begin end facets=98304
  begin=$(ours "$files/cube.fe" 'r 6; g 100')
  end=$(ours "$files/cube.fe" 'r 6; g 300')
  row 'one step of g' cube $facets Lamella "$(calculate "($end - $begin)/200/$facets*1e6")" 'us a facet'
  have_evolver || return 0
  begin=$(theirs "$files/cube.fe" 'r 6; g 2')
  end=$(theirs "$files/cube.fe" 'r 6; g 7')
  row 'one step of g' cube $facets Evolver "$(calculate "($end - $begin)/5/$facets*1e6")" 'us a facet'
}

# The first `hessian` on a mesh finds the order of elimination, those after it have it.
newton_step() {  # levels, facets
  local begin first end
  "$lamella" "$files/cube.fe" -e "relax levels=$1; save \"$work/cube.fe\"" > /dev/null
  begin=$(ours "$work/cube.fe" 'counts')
  first=$(ours "$work/cube.fe" hessian)
  end=$(ours "$work/cube.fe" "$(repeated 4 hessian)")
  row "first Newton step along normals" cube "$2" Lamella "$(calculate "$first - $begin")" s
  row "a further one" cube "$2" Lamella "$(calculate "($end - $first)/3")" s
  have_evolver || return 0
  begin=$(theirs "$work/cube.fe" 'hessian_normal')
  end=$(theirs "$work/cube.fe" 'hessian_normal; hessian')
  row "one Newton step along normals" cube "$2" Evolver "$(calculate "$end - $begin")" s
}

# To within 1e-4 of the energy that the mesh of 28 800 facets has in the end.
lattice() {
  local best spent energy steps
  sh "$files/lattice.sh" 5 > "$work/lattice.fe"
  best=$("$lamella" "$work/lattice.fe" -e 'relax levels=2; print total_energy' 2> /dev/null | tail -1)
  spent=$(ours "$work/lattice.fe" 'relax levels=1 tolerance=1e-3; refine; U; g 5; print total_energy')
  energy=$(tail -1 "$work/out")
  row 'lattice of 125 bubbles: seconds' lattice 28800 Lamella "$spent" s
  row 'lattice of 125 bubbles: above the end' lattice 28800 Lamella "$(calculate "$energy/$best - 1")" 1
  have_evolver || return 0
  for steps in 10 20 40 80; do
    spent=$(runs=1 theirs "$work/lattice.fe" "quiet; g 10; r; U; g $steps; U; r; U; g $steps; printf \"energy %.12g\\n\", total_energy")
    energy=$(sed -n 's/.*energy \([0-9.]*\)$/\1/p' "$work/out" | tail -1)
    awk "BEGIN { exit !($energy/$best - 1 < 1e-4) }" && break
  done
  row 'lattice of 125 bubbles: seconds' lattice 28800 Evolver "$spent" s
  row 'lattice of 125 bubbles: above the end' lattice 28800 Evolver "$(calculate "$energy/$best - 1")" 1
}

volumes() {  # scene, datafile, levels
  local facets
  "$lamella" "$2" -e "relax levels=$3; worst := 0; foreach body b do { d := abs(b.volume/b.target - 1); \
if d > worst then worst := d }; printf \"%d %.2g\\n\", facet_count, worst" 2> /dev/null | tail -1 > "$work/out"
  facets=$(cut -d' ' -f1 "$work/out")
  row 'volumes at the end: relative error' "$1" "$facets" Lamella "$(cut -d' ' -f2 "$work/out")" 1
}

angles() {  # scene, commands
  "$lamella" "$files/$1.fe" -e "$2; plateau; print facet_count" > "$work/out" 2>&1
  local facets lines quads
  facets=$(tail -1 "$work/out")
  lines=$(awk '/^triple lines/ { print $5 }' "$work/out")
  quads=$(awk '/^quad points/ && $4 != "none" { print $5 }' "$work/out")
  row 'angles at triple lines: rms off 120 degrees' "$1" "$facets" Lamella "$lines" degrees
  [ -z "$quads" ] || row 'angles at quad points: rms off 109.47 degrees' "$1" "$facets" Lamella "$quads" degrees
}

# From a start that is the same for every mesh, to a residual of 1e-8.
iterations() {  # scene, commands before
  "$lamella" "$files/$1.fe" -e "$2; relax 500 method=lbfgs tolerance=1e-8; print facet_count" > "$work/out" 2>&1
  row 'iterations of lbfgs' "$1" "$(tail -1 "$work/out")" Lamella \
    "$(sed -n 's/^converged after \([0-9]*\) iter.*/\1/p' "$work/out" | tail -1)" iterations
}

levels() {  # scene, levels
  local spent
  spent=$(ours "$files/$1.fe" "relax levels=$2; print facet_count")
  row 'relax levels from the datafile' "$1" "$(tail -1 "$work/out")" Lamella "$spent" s
}

# The least seconds on the wall of five runs of a command on so many threads.
wall() {  # threads, datafile, commands
  local least=1e9 spent
  for _ in 1 2 3 4 5; do
    spent=$(OMP_NUM_THREADS=$1 bash -c 'TIMEFORMAT=%R; time "$@" > "$0" 2>&1' "$work/out" "$lamella" "$2" -e "$3" 2>&1 | tail -1)
    least=$(awk -v a="$least" -v b="$spent" 'BEGIN { print b < a ? b : a }')
  done
  echo "$least"
}

threads() {  # scene, refinements, facets, steps, what
  local count begin end
  for count in 1 2; do
    begin=$(wall "$count" "$files/$1.fe" "r $2; g 2")
    end=$(wall "$count" "$files/$1.fe" "r $2; g 2; $5")
    row "$5 on $count threads" "$1" "$3" Lamella "$(calculate "($end - $begin)/$4/$3*1e6")" 'us a facet'
  done
}

levels wire_cube 4
levels double_bubble 4
levels weaire_phelan 3
levels cube 6
levels wire_cube 6
levels double_bubble 6
descent_step
threads cube 6 98304 200 'g 200'
threads cube 7 393216 50 'g 50'
threads catenoid 6 786432 50 'g 50'
threads cube 6 98304 20 'hessian 20'
newton_step 6 98304
[ -z "${large:-}" ] || runs=1 newton_step 8 1572864
lattice
volumes double_bubble "$files/double_bubble.fe" 4
volumes weaire_phelan "$files/weaire_phelan.fe" 3
volumes lattice "$work/lattice.fe" 2
angles double_bubble 'refine 2; relax'
angles double_bubble 'refine 3; relax'
angles bubble_in_frame "read \"$files/motion/plateau_angles.cmd\""
angles wire_cube 'relax levels=3'
angles wire_cube 'relax levels=4'
for refine in 4 5 6 7; do
  iterations wire_cube "refine $refine"
done
for refine in 4 5 6; do
  iterations catenoid "refine $refine"
done
for level in 4 5 6; do
  iterations cube "relax levels=$level; set vertex z z*1.5 + 0.2*x*x"
done
