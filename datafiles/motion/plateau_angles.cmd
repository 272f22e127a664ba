// On bubble_in_frame.fe (or any scene with borders of three films): the film settles on a mesh that is finest
// where four borders meet, as there its angles are worst. Facets and angles are printed.
define vertex attribute borders integer
refine_quad_points := {
  set vertices borders 0;
  foreach edge ee where valence == 3 do foreach ee.vertex vv do vv.borders += 1;
  foreach edge ee where ee.vertex[1].borders == 4 or ee.vertex[2].borders == 4 do refine ee
}
refine 3; relax
refine_quad_points; u; relax
refine_quad_points; u; relax
damping := 3
evolve 1000
report
