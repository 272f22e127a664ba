#!/bin/sh
# interference.sh
# Makes interference.png, the colours of a film of water in air from 0 to 1000 nm.
#
#   sh manual/pictures/interference.sh [LAMELLA]
set -eu

here=$(cd "$(dirname "$0")" && pwd)
lamella=${1-"$here/../../build/lamella"}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# A flat film, in nanometres along x.
cat > "$work/strip.fe" <<'END'
vertices
1 0 0 0
2 1000 0 0
3 1000 90 0
4 0 90 0
edges
1 1 2
2 2 3
3 3 4
4 4 1
faces
1 1 2 3 4
END

"$lamella" -q "$work/strip.fe" -e 'refine; refine; refine; refine; refine' \
  -e "show \"$here/interference.png\" size=1000x110 view top lens 0 thickness=vertex x opacity 1 iridescence 1 \
      background black line_width 0.02"
