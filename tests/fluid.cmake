thaum_test(test_fluid
    SOURCES
        accuracy/fluid_accuracy_test.cpp accuracy/fluid_classic_test.cpp accuracy/fluid_spring_surface_test.cpp accuracy/fluid_solids_test.cpp
        accuracy/fluid_buoyancy_test.cpp accuracy/fluid_transport_test.cpp
        stability/fluid_hostile_test.cpp stability/fluid_spring_surface_hostile_test.cpp
        unit/fluid_resample_test.cpp unit/fluid_saved_test.cpp
    THREAD_SOURCES unit/fluid_team_test.cpp
    LINK thaum_classic
    NOT_SANITIZED FluidBuoyancy.NoFlowGains* FluidAccuracy.ABowlBrakes* FluidAccuracy.PushesAdd* FluidAccuracy.FluidDriven* FluidAccuracy.ADrifting* TransportAccuracy.AStretched*
        FluidBuoyancy.AWaveInLayers* FluidHostile.ASemiLagrangian* FluidHostile.ABowlLeftAlone* SpringSurfaceStability.JumpingProbes*
    LONG FluidAccuracyLong.*
    THREADS FluidTeam.*)
