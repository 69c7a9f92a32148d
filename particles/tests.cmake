hair_test(particles_test SANITISED SOURCES forces_test.cpp LIBRARIES hair_particles hair_check
          hair_dense_algebra)
hair_test(preconditioner_test SANITISED SOURCES preconditioner_test.cpp LIBRARIES hair_particles
          hair_allocations hair_dense_algebra)
hair_test(solve_implicit_test SOURCES solve_implicit_test.cpp LIBRARIES reference_H4 reference_S1)
