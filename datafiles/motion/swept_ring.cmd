// On swept_ring.fe: a ring is swept through the air, and its film bulges behind it.
refine 4
wind (0, 0, 0)
evolve 300 dt 0.005
print min(vertices, z) - max(vertices, z)
