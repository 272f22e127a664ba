// On lattice.fe or what lattice.sh writes: cubic bubbles ring and settle.
refine 3
damping := 3
evolve 300
