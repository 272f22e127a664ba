// On twisting_frame.fe: the far end of the frame turns by half a turn.
refine 4; relax
damping := 1
turning := 0.5
evolve 600 dt 0.01
