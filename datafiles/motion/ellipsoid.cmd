// On cube.fe: a bubble of volume 1 stretched to an ellipsoid with axes 1.1 : 1 : 1/1.1 rings about the sphere.
refine 4; relax
set vertices x 0.5+1.1*(x-0.5)
set vertices z 0.5+(z-0.5)/1.1
log "ellipsoid.csv" every 5
evolve 1000 method=verlet
log off
