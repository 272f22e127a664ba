// On twisted_wire.fe: the film on a twisted wire is hit, swings and comes to rest (Ishida et al. 2017, figure 1).
refine 4; relax
damping := 0.5
kick (0, 0, 0.5*exp(-20*((x-0.5)^2+y^2)))
evolve 600
print kinetic_energy
