#!/bin/sh
# Writes failures.csv beside this file: what each method makes of the scenes in the table "where methods fail" of
# manual/plateau.md, and prints it as the rows of that table. Takes some minutes.
#   manual/pictures/failures.sh LAMELLA
# Surface Evolver takes part where it is installed.
set -eu
lamella=$(realpath "${1:?usage: failures.sh PATH_TO_LAMELLA}")
here=$(dirname "$(realpath "$0")")
files=$here/../../datafiles/difficult
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
csv=$here/failures.csv
seconds=${limit:-10}  # of processor time for each method
echo 'scene,method,outcome,energy,smallest angle,cpu seconds' > "$csv"

# Reads what a run printed; adds a line for it.
note() {  # scene, method
  awk -v scene="$1" -v method="$2" '
    /after [0-9]+ iterations: energy/ {
      outcome = $0; sub(/ after .*/, "", outcome)
      energy = $0; sub(/.*: energy /, "", energy); sub(/,.*/, "", energy)
    }
    /^saddle/ { outcome = outcome ", saddle" }
    /^unstable/ { outcome = outcome ", unstable" }
    /^stable/ { outcome = outcome ", stable" }
    /smallest angle/ { angle = $0; sub(/.*smallest angle /, "", angle); sub(/ .*/, "", angle) }
    /^energy / && $3 == "angle" { energy = $2; angle = $4
      outcome = $6 > 0.001 ? "volumes missed" : "500 steps" }
    /error: / && outcome == "" { outcome = $0; sub(/.*error: /, "refused: ", outcome); gsub(/,/, ";", outcome) }
    /^user / { user = $2 }
    END {
      if (energy ~ /nan|inf/) outcome = "not finite"
      if (outcome == "") outcome = "no end"
      printf "%s,%s,\"%s\",%s,%s,%s\n", scene, method, outcome, energy, angle, user
    }' >> "$csv"
}

timed() {
  bash -c 'TIMEFORMAT="user %U"; ulimit -t "$0"; time timeout 600 "$@"' "$seconds" "$@" 2>&1 || true
}

# The smallest angle of a facet, in degrees, as Surface Evolver can tell it.
corner() {
  echo "tt := atan2(2*ff.area, ($1^2 + $2^2 - $3^2)/2)*180/pi; if tt < least then least := tt"
}
angle="least := 180; foreach facet ff do { if ff.area > 0 then { aa := ff.edge[1].length; bb := ff.edge[2].length; \
cc := ff.edge[3].length; $(corner aa bb cc); $(corner bb cc aa); $(corner cc aa bb) } else least := 0 }"
miss="miss := 0; foreach body air do { if air.target != 0 then { tt := abs(air.volume/air.target - 1); \
if tt > miss then miss := tt } }"

scene() {  # name, datafile, commands before
  echo "$1" >&2
  for method in descent cg lbfgs newton; do
    timed "$lamella" "$2" -e "$3; relax 500 method=$method" | note "$1" "$method"
  done
  timed "$lamella" "$2" -e "$3; relax" | note "$1" relax
  timed "$lamella" "$2" -e "$3; relax topology saddle=leave" | note "$1" topology
  command -v evolver > /dev/null || return 0
  for mode in 'g 500' 'U; g 500' 'g 5; hessian; hessian; hessian; hessian; hessian'; do
    printf 'quiet\n%s\n%s\n%s\n%s\nprintf "energy %%.12g angle %%.3g miss %%.2g\\n", total_energy, least, miss\nq\nq\n' \
      "$3" "$mode" "$angle" "$miss" > "$work/commands"
    short=$(echo "$mode" | sed 's/g 5; .*/hessian/; s/U; g 500/U/; s/g 500/g/')
    timed sh -c 'evolver "$0" < "$1"' "$2" "$work/commands" | sed 's/.*\(energy [^ ]* angle [^ ]* miss [^ ]*\)$/\1/' |
      note "$1" "Evolver $short"
  done
}

with() {  # datafile, parameter, value
  sed "s|^parameter $2 = [^ ]*|parameter $2 = $3|" "$files/$1.fe" > "$work/$1.fe"
  echo "$work/$1.fe"
}

scene 'catenoid before its fold' "$(with fold half 0.65)" 'r'
scene 'catenoid past its fold' "$(with fold half 0.7)" 'r'
scene 'column below its limit' "$(with column length 6.22)" 'r'
scene 'column past its limit' "$(with column length 6.35)" 'r'
scene 'caps that share their air' "$files/two_caps.fe" 'r; r'
scene 'flat start' "$files/pancake.fe" 'r; r; r'
scene 'slivers' "$files/slivers.fe" 'r'
scene 'volume ratio 1000' "$files/unequal.fe" 'r; r'
scene 'blown up a hundredfold' "$files/blown_up.fe" 'r; r; r'
scene 'shrunk to 1e-4' "$(with blown_up wanted 1e-4)" 'r; r; r'
scene 'four films on an edge' "$files/four_films.fe" 'r; r'
scene 'wires that touch' "$files/touching_wires.fe" 'r; r; r'
scene 'volume of the wrong sign' "$files/inside_out.fe" 'r; r'
scene 'seven digits' "$files/rounded.fe" 'r'
scene 'far away' "$files/far_away.fe" 'r; r'

# The table: for each scene and method the outcome.
awk -F, '
  NR == 1 { next }
  {
    split($0, part, "\"")
    outcome = part[2]
    n = split(part[3], rest, ",")
    energy = rest[2]; angle = rest[3]
    if (!($1 in seen)) { seen[$1] = 1; order[++count] = $1 }
    outcome_of[$1, $2] = outcome; energy_of[$1, $2] = energy; angle_of[$1, $2] = angle
  }
  function cell(s, m,   excess, text) {
    text = outcome_of[s, m]
    if (text ~ /volumes cannot be brought/) text = "volumes missed"
    if (text == "step limit reached") text = "500 steps"
    if (text ~ /^refused/) text = "refused"
    if (m != "relax" && m != "topology" && text != "volumes missed" && outcome_of[s, "relax"] ~ /^converged/ && energy_of[s, m] != "") {
      excess = energy_of[s, m] / energy_of[s, "relax"] - 1
      text = sprintf("%+.0e", excess)
      if (excess < 1e-8 && excess > -1e-8) text = "there"
      if (angle_of[s, m] != "" && angle_of[s, m] + 0 < 5) text = text sprintf(", %.0f°", angle_of[s, m])
    }
    return text
  }
  END {
    for (i = 1; i <= count; ++i) {
      s = order[i]
      printf "| %s | %s | %s | %s | %s | %s | %s | %s | %s | %s |\n", s, cell(s, "descent"), cell(s, "cg"), cell(s, "lbfgs"),
        cell(s, "newton"), cell(s, "Evolver g"), cell(s, "Evolver U"), cell(s, "Evolver hessian"), cell(s, "relax"), cell(s, "topology")
    }
  }' "$csv"
