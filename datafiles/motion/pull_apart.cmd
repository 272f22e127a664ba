// On double_bubble.fe: the two bubbles are pulled apart along their axis. The film between them shrinks to
// nothing, and each becomes a sphere: the area is then 2 (36 pi)^(1/3) = 9.671952 and a little, for the mesh.
refine 2; relax
damping := 0.2
kick (0, 0, 1.5*((z > 0.001) - (z < -0.001)))
evolve 160
print count(facet where frontbody != 0 and backbody != 0)
damping := 4
evolve 100
check
print total_area
