#!/bin/sh
# The energies of Surface Evolver's examples in both programs, for the table in manual/evolver.md: right after each file's own
# `gogo`, and at the equilibrium that further commands, the same for both, lead to. Writes evolver_energies.csv beside
# itself and prints the table. Needs the Debian packages evolver and evolver-doc, and a Release build in build/.
set -eu
cd "$(dirname "$0")/.."
examples=/usr/share/doc/evolver/fe
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

theirs() {  # FILE COMMANDS, separated by semicolons
  { printf '%s\n' "$2" | tr ';' '\n'; printf 'printf "is %%.16g\\n", total_energy\nq\nq\n'; } >"$work/ask"
  timeout -s KILL 120 evolver "$1" <"$work/ask" 2>/dev/null | sed -n 's/^.*is \([0-9.]*\).*/\1/p' | tail -n 1
}
ours() {
  timeout -s KILL 120 build/lamella -q "$1" -e "$2" -e 'printf "is %.16g\n", total_energy' 2>/dev/null | sed -n 's/^is //p'
}
to_the_end='hessian_normal off;U;g 300;U;g 50;{hessian_seek} 10;{hessian} 4'
row() {  # NAME COMMANDS
  file=$examples/$1.fe
  echo "$1,$(theirs "$file" gogo),$(ours "$file" gogo),$2,$(theirs "$file" "gogo;$2"),$(ours "$file" "gogo;$2")"
}
csv=manual/evolver_energies.csv
{
  echo "# $(sed -n 's/^model name.*: //p' /proc/cpuinfo | head -n 1), commit $(git rev-parse --short HEAD)"
  echo "file,evolver_after_gogo,here_after_gogo,then,evolver,here"
  row cube 'hessian_normal off;{hessian_seek} 10;{hessian} 4'
  row quad '{hessian} 4'
  row mound "$to_the_end"
  row qmound "$to_the_end"
  row catbody '{hessian} 4'
  row catman "$to_the_end"
  row sphere 'U;g 6000;U;g 50'
  row twointor '{hessian} 2'
  row phelanc '{hessian} 2'
  row slidestr "$to_the_end"
  row popstr '{hessian} 2'
  row octa '{hessian} 2'
  row addload_example "$to_the_end"
  row column "$to_the_end"
} >$csv
awk -F, '
  function apart(a, b, d) { d = (b - a) / a; if (d < 0) d = -d; return sprintf("%.0e", d) }
  /^#/ { print substr($0, 3) "."; next }
  $1 == "file" { print ""; print "| file | energy after `gogo`, here | apart | at equilibrium, here | apart |"; print "|---|---|---|---|---|"; next }
  { printf "| %s | %s | %s | %s | %s |\n", $1, $3, apart($2, $3), $6, apart($5, $6) }' $csv
