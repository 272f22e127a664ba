// On wire_cube.fe: the films in a wire cube under gravity, then under twenty times as much (Ishida et al. 2017,
// figure 9). Gravity draws films together below, so the mesh is kept.
refine 3; relax
damping := 2
force (0, 0, -0.05)
evolve 400
print min(vertices where valence == 8, z)
force (0, 0, -20*0.05)
evolve 600
print min(vertices where valence == 8, z)
