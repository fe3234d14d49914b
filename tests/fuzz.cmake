# Fuzzing of all readers: as many inputs each as tests/fuzz_runs.txt says, by the sanitizers' build alone, and 3,000 others in
# `./thaum test --long`. A longer run of one reader by hand: thaum_fuzz arena --runs 10000 --seed 3
add_executable(thaum_fuzz
    fuzz/carving_readers.cpp fuzz/data_readers.cpp fuzz/device_reader.cpp fuzz/gesture_readers.cpp fuzz/jacket_reader.cpp fuzz/lab_reader.cpp fuzz/log_reader.cpp fuzz/main.cpp fuzz/volume_session_reader.cpp fuzz/mutate.cpp fuzz/scenario_reader.cpp
    fuzz/sound_reader.cpp fuzz/tactile_readers.cpp fuzz/volume_readers.cpp
    unit/tact_writer.cpp)
target_include_directories(thaum_fuzz PRIVATE ${CMAKE_CURRENT_SOURCE_DIR})
target_compile_definitions(thaum_fuzz PRIVATE THAUM_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
target_link_libraries(thaum_fuzz PRIVATE thaum_flags thaum_live thaum_lab thaum_scenario thaum_haptics thaum_gesture_trials thaum_audio thaum_tactile PkgConfig::zstd)
set(fuzz_runs ${CMAKE_CURRENT_SOURCE_DIR}/fuzz_runs.txt)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${fuzz_runs})
file(STRINGS ${fuzz_runs} readers REGEX "^[a-z]")
foreach(line ${readers})
    string(REPLACE " " ";" line ${line})
    list(POP_FRONT line reader runs)
    add_test(NAME fuzz.${reader} COMMAND ${timed} $<TARGET_FILE:thaum_fuzz> ${reader} --runs ${runs})
    add_test(NAME fuzz_long.${reader} COMMAND ${timed} $<TARGET_FILE:thaum_fuzz> ${reader} --runs 3000 --seed 2)
    set_tests_properties(fuzz.${reader} fuzz_long.${reader} PROPERTIES TIMEOUT ${longest_test})
    set_tests_properties(fuzz_long.${reader} PROPERTIES LABELS long)
endforeach()
