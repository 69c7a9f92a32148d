# STAFF ONLY. Whole strands: the given simulation with all of the reference's exercises.
list(TRANSFORM HAIR_EXERCISES PREPEND reference_ OUTPUT_VARIABLE exercises)
hair_test(simulation_test SANITISED SOURCES simulation_test.cpp simulation_collisions_test.cpp
          simulation_description_test.cpp
          LIBRARIES hair_allocations hair_simulation ${exercises})
hair_test(strand_motion_test SOURCES strand_motion_test.cpp LIBRARIES hair_simulation ${exercises})
hair_test(bodies_test SOURCES bodies_test.cpp LIBRARIES hair_allocations hair_validate hair_scene
          hair_simulation ${exercises})
hair_test(energy_watch_test SANITISED SOURCES energy_watch_test.cpp LIBRARIES hair_simulation ${exercises})
hair_test(models_test SANITISED SOURCES models_test.cpp LIBRARIES hair_simulation ${exercises})
hair_test(linked_guides_test SOURCES linked_guides_test.cpp LIBRARIES hair_check hair_mesh hair_simulation
          ${exercises})
