// On cube.fe: a cube is let go, rings about the sphere, and comes to rest.
refine 4
damping := 1
evolve 400
relax
