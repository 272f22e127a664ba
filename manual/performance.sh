#!/bin/sh
# Measures what manual/performance.md shows: writes performance.csv beside itself and prints the table.
# Run it on a quiet machine, from anywhere; takes some minutes.
set -eu
cd "$(dirname "$0")/.."
cmake --preset bench >/dev/null
cmake --build --preset bench >/dev/null
csv=manual/performance.csv
{
  echo "# $(sed -n 's/^model name.*: //p' /proc/cpuinfo | head -n 1), $(nproc) cores, $(c++ --version | head -n 1)"
  echo "# commit $(git rev-parse --short HEAD), one thread, median of 3"
  echo "what,facets,ns_a_facet"
  build-bench/benchmarks --benchmark_repetitions=3 --benchmark_report_aggregates_only=true --benchmark_min_time=0.3 \
    --benchmark_format=csv 2>/dev/null |
    sed -n 's|^"\([a-z_]*\)/\([0-9]*\)_median",|\1,\2,|p' |
    awk -F, '{ printf "%s,%d,%.1f\n", $1, $2, $13 }'
} >$csv

scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
memory() {  # FILE COMMANDS: peak of the whole program in bytes a facet, and the seconds it ran
  /usr/bin/time -f "%M %e %U" -o "$scratch/time" build-bench/lamella -q "$1" -e "$2; print facet_count" >"$scratch/count"
  awk -v facets="$(tail -n 1 "$scratch/count")" '{ printf "%.0f,%s\n", $1 * 1024 / facets, $2 }' "$scratch/time"
}
build-bench/lamella -q datafiles/double_bubble.fe -e "refine 5; save \"$scratch/large.fe\""
{
  echo "program,bytes_a_facet,seconds"
  echo "sphere of 786432 facets refined,$(memory datafiles/cube.fe 'refine 8')"
  echo "the same and relax 5,$(memory datafiles/cube.fe 'refine 8; relax 5')"
  echo "load a file of $(build-bench/lamella -q "$scratch/large.fe" -e 'print facet_count') facets,$(memory "$scratch/large.fe" 'print 1' | tail -n 1)"
} >>$csv

awk -F, '
  /^#/ { print substr($0, 3) "."; next }
  $1 == "what" { next }
  $1 == "program" { table(); programs = 1; print ""; print "| program | bytes a facet, at the peak | seconds |"; print "|---|---|---|"; next }
  programs { printf "| %s | %s | %s |\n", $1, $2, $3; next }
  { if (!($1 in seen)) { seen[$1] = 1; order[++count] = $1 } value[$1, $2] = $3 }
  function table(i, name) {
    print ""; print "| ns a facet | 10k | 100k | 1M |"; print "|---|---|---|---|"
    for (i = 1; i <= count; ++i) {
      name = order[i]; gsub(/_/, " ", name)
      printf "| %s | %s | %s | %s |\n", name, value[order[i], 10000], value[order[i], 100000], value[order[i], 1000000]
    }
  }' $csv
