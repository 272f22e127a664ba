// On four_bubbles.fe: the edge of four films parts, and two of the bubbles, 2 and 3, share a film. Sheared, the
// other two, 1 and 4, come together in their stead (a T1).
refine 2
damping := 3
evolve 160
print count(facet where frontbody == 2 and backbody == 3 or frontbody == 3 and backbody == 2)
kick (-y, -x, 0)
damping := 1
evolve 90
damping := 4
evolve 200
print count(facet where frontbody == 2 and backbody == 3 or frontbody == 3 and backbody == 2)
print count(facet where frontbody == 1 and backbody == 4 or frontbody == 4 and backbody == 1)
remesh size 0.4 borders 0.05
evolve 100
check
print total_area
print facet_count
plateau
