// On cube.fe: a bubble in the jet of a fan (Ishida et al. 2017, figure 8, equation 9).
refine 3; relax
damping := 2
air cells 32 from (-1.5, -1.5, -1.5) to (4.5, 2.5, 2.5) jet (2*(x > -1 && x < -0.6 && (y-0.5)^2+(z-0.5)^2 < 0.16), 0, 0)
evolve 300 dt 0.01
print sum(vertices, x)/vertex_count
