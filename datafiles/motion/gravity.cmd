// On wire_cube.fe: the films in a wire cube under gravity, then under twenty times as much (Ishida et al. 2017,
// figure 9).
refine 4; relax
damping := 2
force (0, 0, -0.196)
evolve 800
print min(vertices, z)
force (0, 0, -20*0.196)
evolve 1500
print min(vertices, z)
