// On moving_rings.fe: the film comes to rest between the rings (exact area 1.648957), which are then pulled
// apart at 0.04 each. Beyond a half distance of 0.331 no film can hang between them: it pinches and becomes
// two discs (Ishida et al. 2017, figure 6).
refine 3; relax
print total_area
damping := 1
speed := 0.04
start := total_time
evolve 400 dt 0.01
print gap + speed*(total_time - start)
print min(vertices where not fixed, sqrt(x^2+y^2))
