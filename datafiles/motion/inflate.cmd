// On double_bubble.fe: one bubble is inflated while the other is deflated, then the other way round (Ishida et
// al. 2017, figure 7).
refine 3; relax
damping := 1
vc 1 1.8 over 4
vc 2 0.2 over 4
evolve 400 dt 0.01
vc 1 0.2 over 8
vc 2 1.8 over 8
evolve 800 dt 0.01
vc 1 1 over 4
vc 2 1 over 4
evolve 600 dt 0.01
relax
