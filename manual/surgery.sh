#!/bin/sh
# Runs the scenes that change their topology and writes surgery.csv: events by kind, what check says every 50
# steps, the area at the end, the worst volume error, processor time. Usage: manual/surgery.sh [PROGRAM]
program=${1:-build/lamella}
folder=$(cd "$(dirname "$0")/.." && pwd)
table=$folder/manual/surgery.csv
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
echo "scene,steps,facets,pinch,merge,t1,vanish,split,birth,pop,checks failed,area,volume error,seconds" > "$table"

# scene NAME FILE SETUP STEPS
scene() {
  log=$work/$1.csv
  blocks=$(($4 / 50))
  text="$3; log events \"$log\"; log \"$work/motion.csv\""
  i=0
  while [ $i -lt $blocks ]; do
    text="$text; evolve 50; check"
    i=$((i + 1))
  done
  text="$text; print facet_count; print total_area"
  /usr/bin/time -f '%U' -o "$work/time" "$program" -q "$folder/datafiles/$2" -e "$text" > "$work/out" 2> "$work/err"
  failed=$(grep -c 'error' "$work/err")
  facets=$(tail -2 "$work/out" | head -1)
  area=$(tail -1 "$work/out")
  worst=$(tail -n +2 "$work/motion.csv" | cut -d, -f12 | sort -g | tail -1)
  row="$1,$4,$facets"
  for kind in pinch merge t1 vanish split birth pop; do
    row="$row,$(grep -c ",$kind," "$log")"
  done
  echo "$row,$failed,$area,$worst,$(tail -1 "$work/time")" >> "$table"
}

scene rings rings_apart.fe 'refine 3; relax; damping := 1' 500
scene two_bubbles two_bubbles.fe throw 500
scene bubble_and_film bubble_and_film.fe fall 500
scene at_rest double_bubble.fe 'refine 4; relax' 500
cat "$table"
