if(TARGET thaum_bench)
    thaum_test(test_bench
        SOURCES unit/audio_bench_test.cpp unit/bench_test.cpp
        LINK thaum_bench nlohmann_json::nlohmann_json
        LONG BenchPhysics.TheShippedStep*)
endif()
