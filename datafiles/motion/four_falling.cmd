// On four_falling.fe: the bubbles fall, sink into the film, and come to rest as lenses in it (Ishida et al. 2017,
// figure 1).
refine 2; relax
set vertex velocity[3] z > 0.2 ? -0.5 : 0
damping := 0.5
evolve 600
damping := 4
evolve 400
remesh size 0.5 borders 0.056
evolve 100
check
print total_area
print facet_count
plateau
