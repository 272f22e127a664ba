#!/bin/sh
# Prints what each method makes of the scenes in the table "where methods fail" of manual/plateau.md:
#   manual/pictures/failures.sh LAMELLA
# Surface Evolver takes part where it is installed.
set -eu
lamella=$(realpath "${1:?usage: failures.sh PATH_TO_LAMELLA}")
files=$(dirname "$(realpath "$0")")/../../datafiles
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

row() {  # name, datafile, commands before
  echo "== $1"
  for method in descent cg lbfgs newton; do
    printf '%-9s' "$method"
    timeout 120 "$lamella" "$2" -e "$3; relax 500 method=$method" 2>&1 | tail -2 | tr '\n' ';' | cut -c1-150
    echo
  done
  printf '%-9s' relax
  timeout 120 "$lamella" "$2" -e "$3; relax" 2>&1 | tail -2 | tr '\n' ';' | cut -c1-200
  echo
  command -v evolver > /dev/null || return 0
  for mode in 'g 500' 'U; g 500' 'g 5; hessian; hessian; hessian; hessian'; do
    printf 'evolver %s: ' "$mode"
    printf 'quiet\n%s\n%s\nprintf "energy %%.12g smallest facet %%.3g\\n", total_energy, min(facet,area)\nq\nq\n' "$3" "$mode" |
      timeout 120 evolver "$2" 2>&1 | grep -a 'energy .* smallest\|WARNING\|ERROR' | tail -2 | tr '\n' ';' | cut -c1-150
    echo
  done
}

with() {  # datafile, parameter, value
  sed "s|^parameter $2 = [^ ]*|parameter $2 = $3|" "$files/difficult/$1.fe" > "$work/$1.fe"
  echo "$work/$1.fe"
}

row 'catenoid before its fold' "$(with fold half 0.65)" 'r'
row 'catenoid past its fold' "$(with fold half 0.7)" 'r'
row 'column below its limit' "$(with column length 6.2)" 'r'
row 'column past its limit' "$(with column length 7)" 'r'
row 'caps that share their air' "$files/difficult/two_caps.fe" 'r; r'
row 'flat start' "$files/difficult/pancake.fe" 'r; r; r'
row 'slivers' "$files/difficult/slivers.fe" 'r'
row 'volume ratio 1000' "$files/double_bubble.fe" 'r; r; body[1].target := 1000'
row 'blown up a hundredfold' "$files/cube.fe" 'r; r; r; body[1].target := 100'
row 'four films on an edge' "$files/difficult/four_films.fe" 'r; r'
row 'wires that touch' "$files/difficult/touching_wires.fe" 'r; r; r'
row 'wrong sign' "$files/cube.fe" 'r; r; set vertex z -z'
row 'far away' "$files/wire_cube.fe" 'r; r; r'
