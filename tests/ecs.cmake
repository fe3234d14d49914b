thaum_test(test_ecs
    SOURCES unit/ecs_world_test.cpp unit/ecs_schedule_test.cpp unit/ecs_snapshot_test.cpp stability/ecs_model_test.cpp
    LINK thaum_ecs
    NOT_SANITIZED EcsSnapshot.EveryTruncation*)
