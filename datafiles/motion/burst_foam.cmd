// On six_bubbles.fe: the bubbles of a foam burst one after the other, and what is left comes to rest each time
// (Ishida et al. 2017, figure 5), on a mesh that is fine along borders.
refine 3; relax
damping := 4
number := 6
while number > 0 do {
  burst body[number];
  if facet_count > 0 then { evolve 300; remesh size 0.4 borders 0.034; evolve 100; check; print total_area; print facet_count; plateau };
  number := number - 1
}
print facet_count
