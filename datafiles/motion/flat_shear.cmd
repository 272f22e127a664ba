// On flat_foam.fe: the cell in which the foam repeats itself is sheared by its own height, so that every row of cells
// glides past the next by five cells. Edges that have become short vanish, and where four meet then the
// point is resolved: neighbours swap (T1). Strings are kept to a length by dividing and joining them.
refine edges
g 10
swaps := 0
while shear < 0.999 do {
  shear += 0.02;
  steps := 0;
  while steps < 4 do {
    g 10;
    delete edges where length < 0.02;
    o;
    swaps += vertex_pop_count;
    refine edges where length > 0.12;
    steps += 1;
  };
}
check
printf "shear %g: length %.6f, %g swaps\n", shear, total_length, swaps
