hair_test(solver_study_test SOURCES solver_study_test.cpp LIBRARIES hair_bowl_path hair_solver_study
          hair_dense_algebra)
