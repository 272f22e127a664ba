// On swept_ring.fe: a ring is swept through the air. Its film bulges behind it until its neck closes: a bubble is
// left behind, and its volume is kept from then on.
speed := 3
refine 3
wind (0, 0, 0) pressure 2
on birth { print "a bubble is born" }
evolve 150 dt 0.01
print body_count
print sum(bodies, volume)
