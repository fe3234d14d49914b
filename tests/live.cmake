thaum_test(test_hud
    SOURCES unit/brew_look_test.cpp unit/hud_anchor_test.cpp unit/hud_carried_test.cpp unit/hud_casting_test.cpp unit/hud_contrast_test.cpp unit/hud_layout_test.cpp unit/hud_moments_test.cpp unit/hud_pictures_test.cpp unit/hud_prompts_test.cpp unit/hud_rim_test.cpp unit/hud_station_card_test.cpp unit/hud_stations_test.cpp unit/ingredient_shapes_test.cpp unit/likely_spell_test.cpp
        unit/hud_test.cpp unit/picture_test.cpp
    LINK thaum_duel thaum_range thaum_render_audit
    NOT_SANITIZED IngredientShapes.DifferInOutline*)
thaum_test(test_live
    SOURCES unit/arm_pace_test.cpp unit/audio_jacket_test.cpp unit/control_names_test.cpp unit/hid_jacket_test.cpp unit/live_hands_test.cpp
        unit/body_trial_test.cpp unit/feel_profile_test.cpp unit/gesture_wall_test.cpp unit/live_menu_test.cpp unit/live_pause_test.cpp unit/live_recording_test.cpp unit/live_seats_test.cpp
        unit/live_session_test.cpp unit/live_start_screen_test.cpp unit/own_pads_test.cpp unit/pad_setup_test.cpp unit/match_requests_test.cpp unit/menu_pages_test.cpp unit/menu_seams_test.cpp unit/menu_test.cpp unit/own_gestures_test.cpp
        unit/recorded_names_test.cpp unit/replay_view_test.cpp
        unit/faulty_settings_test.cpp unit/settings_test.cpp unit/apprentice_course_test.cpp unit/screen_player.cpp unit/screen_player_test.cpp
        unit/screen_reader.cpp
    THREAD_SOURCES
        unit/bhaptics_jacket_test.cpp unit/fake_bhaptics.cpp unit/felt_recorder_test.cpp unit/jacket_test.cpp
        unit/live_arm_test.cpp unit/live_body_test.cpp unit/live_sound_test.cpp unit/live_tactile_test.cpp
        unit/live_threads_test.cpp unit/osc_jacket_test.cpp unit/practice_test.cpp unit/replay_threads_test.cpp
    LINK thaum_live fake_arm nlohmann_json::nlohmann_json PkgConfig::websockets PkgConfig::openal
    NOT_SANITIZED ScreenPlayer.Wins* ScreenPlayer.Reads* BhapticsJacketThreads.EachAddress* OscJacket.AHostGets*  # sanitizers have a getaddrinfo of their own
    THREADS LiveSoundTest.* LiveArms.* LiveTactileThreads.* LiveTactileSession.* PracticeTest.Thread* LiveThreadsTest.* ReplayThreads.* LiveJacketThreads.* LiveBodyThreads.* FeltRecorder.EveryFrame* BhapticsJacketThreads.* TactilePlayerThreads.*)

add_executable(live_shot drivers/shot.cpp)
target_link_libraries(live_shot PRIVATE thaum_flags thaum_duel thaum_hud)
add_executable(live_session drivers/live_main.cpp)
target_link_libraries(live_session PRIVATE thaum_flags thaum_live)
add_executable(live_log_probe drivers/log_probe.cpp)
target_link_libraries(live_log_probe PRIVATE thaum_flags thaum_duel)
add_executable(press_keys drivers/press_keys.cpp)
add_executable(look_at drivers/look_at.cpp)
if(NOT THAUM_SANITIZE)  # tests start these two again and again, and a start under sanitizers takes ten times as long
    target_link_libraries(press_keys PRIVATE thaum_flags)
    target_link_libraries(look_at PRIVATE thaum_flags)
endif()

# A virtual pad, if umockdev is installed.
pkg_check_modules(umockdev IMPORTED_TARGET umockdev-1.0)
if(umockdev_FOUND)
    add_library(fake_pad STATIC drivers/fake_pad.cpp)
    target_include_directories(fake_pad PUBLIC ${CMAKE_CURRENT_SOURCE_DIR})
    target_link_libraries(fake_pad PUBLIC PkgConfig::umockdev PRIVATE thaum_flags)
    add_executable(pad_harness drivers/pad_harness.cpp)
    target_link_libraries(pad_harness PRIVATE thaum_flags fake_pad)
    add_executable(pad_models drivers/pad_models.cpp)
    target_link_libraries(pad_models PRIVATE thaum_flags fake_pad thaum_pads PkgConfig::sdl2)
    add_executable(rumble_probe drivers/rumble_probe.cpp)
    target_link_libraries(rumble_probe PRIVATE thaum_flags thaum_live)
endif()

# Tests in real time with a screen. They wait most of the time, so they run beside others, but only one of them draws
# at once, and they start first. Their limit ends only tests that hang: with other programs on every core a test takes
# ten times as long.
function(thaum_driver_test name)
    add_test(NAME drivers.${name} COMMAND ${timed} ${ARGN})
    set(environment LOOK_AT=$<TARGET_FILE:look_at> ${sanitizer_environment})
    set_tests_properties(drivers.${name} PROPERTIES
        SKIP_RETURN_CODE 77 RESOURCE_LOCK screen COST 100 TIMEOUT ${longest_test} ENVIRONMENT "${environment}")
endfunction()
thaum_driver_test(window ${CMAKE_CURRENT_SOURCE_DIR}/drivers/with_screen.sh
    $<TARGET_FILE:test_render> --gtest_filter=WindowTest.*)
add_executable(key_probe drivers/key_probe.cpp)
target_link_libraries(key_probe PRIVATE thaum_flags thaum_render)
thaum_driver_test(key_labels ${CMAKE_CURRENT_SOURCE_DIR}/drivers/key_labels.sh $<TARGET_FILE:key_probe>)
thaum_driver_test(resize ${CMAKE_CURRENT_SOURCE_DIR}/drivers/resize.sh
    $<TARGET_FILE:thaum> $<TARGET_FILE:live_log_probe>)
set(part_of_range "")
if(THAUM_SANITIZE STREQUAL thread)
    set(part_of_range range)  # range.sh leaves out its match: the thread sanitizer sees one in live_threads
endif()
thaum_driver_test(range ${CMAKE_CURRENT_SOURCE_DIR}/drivers/range.sh
    $<TARGET_FILE:thaum> $<TARGET_FILE:press_keys> ${part_of_range})
thaum_driver_test(gesture_wall ${CMAKE_CURRENT_SOURCE_DIR}/drivers/gesture_wall.sh
    $<TARGET_FILE:thaum> $<TARGET_FILE:press_keys>)
thaum_driver_test(replay_window ${CMAKE_CURRENT_SOURCE_DIR}/drivers/replay_window.sh
    $<TARGET_FILE:thaum> $<TARGET_FILE:press_keys>)
thaum_driver_test(sound ${CMAKE_CURRENT_SOURCE_DIR}/drivers/sound.sh $<TARGET_FILE:thaum>)
thaum_driver_test(lab ${CMAKE_CURRENT_SOURCE_DIR}/drivers/lab.sh
    $<TARGET_FILE:thaum> $<TARGET_FILE:press_keys>)
thaum_driver_test(volume_lab ${CMAKE_CURRENT_SOURCE_DIR}/drivers/volume_lab.sh
    $<TARGET_FILE:thaum> $<TARGET_FILE:press_keys>)
if(NOT THAUM_SANITIZE)
    # These tests measure times, which sanitizers would falsify.
    thaum_driver_test(stalled ${CMAKE_CURRENT_SOURCE_DIR}/drivers/stalled.sh
        $<TARGET_FILE:live_session> $<TARGET_FILE:live_log_probe>)
    thaum_driver_test(input_delay ${CMAKE_CURRENT_SOURCE_DIR}/drivers/input_delay.sh
        $<TARGET_FILE:live_session> $<TARGET_FILE:thaum>)
endif()
thaum_driver_test(live_threads ${CMAKE_CURRENT_SOURCE_DIR}/drivers/live_threads.sh
    $<TARGET_FILE:thaum> $<TARGET_FILE:fake_hd> $<TARGET_FILE:live_log_probe> $<TARGET_FILE:press_keys>)
set_tests_properties(drivers.range drivers.live_threads PROPERTIES LABELS threads)
thread_program(thaum fake_hd live_log_probe look_at press_keys)
add_executable(forge_log drivers/forge_log.cpp)
target_link_libraries(forge_log PRIVATE thaum_flags thaum_input)
thaum_driver_test(fake_phantom_plays ${CMAKE_CURRENT_SOURCE_DIR}/drivers/fake_phantom_plays.sh
    $<TARGET_FILE:thaum> $<TARGET_FILE:fake_hd> $<TARGET_FILE:fake_hd_old> $<TARGET_FILE:live_log_probe>)
thaum_driver_test(fake_phantom_feels ${CMAKE_CURRENT_SOURCE_DIR}/drivers/fake_phantom_feels.sh
    $<TARGET_FILE:thaum> $<TARGET_FILE:fake_hd> $<TARGET_FILE:forge_log>)
thaum_driver_test(fake_phantom_fails ${CMAKE_CURRENT_SOURCE_DIR}/drivers/fake_phantom_fails.sh
    $<TARGET_FILE:thaum> $<TARGET_FILE:fake_hd>)
thaum_driver_test(gesture_record ${CMAKE_CURRENT_SOURCE_DIR}/drivers/gesture_record.sh
    $<TARGET_FILE:thaum> $<TARGET_FILE:fake_hd>)
set(slow_drivers drivers.fake_phantom_plays drivers.fake_phantom_feels drivers.fake_phantom_fails)
if(NOT THAUM_SANITIZE)
    # The program with a driver that only this test has, and two arms in one match.
    add_executable(thaum_with_fake_arms ${PROJECT_SOURCE_DIR}/game/app/tools_main.cpp)
    target_link_libraries(thaum_with_fake_arms PRIVATE thaum_flags thaum_tools fake_arm)
    thaum_driver_test(two_arms ${CMAKE_CURRENT_SOURCE_DIR}/drivers/two_arms.sh
        $<TARGET_FILE:thaum_with_fake_arms> $<TARGET_FILE:live_log_probe>)
    list(APPEND slow_drivers drivers.two_arms)
endif()
# slow: each of these tests takes a minute of real time. Sanitizers see the same code in shorter tests. These
# tests draw few pictures or none, so one of them runs beside a test that draws.
set_tests_properties(${slow_drivers} PROPERTIES LABELS slow RESOURCE_LOCK arm)
# A hundred runs by hand: kill_recording 100
add_executable(kill_recording drivers/kill_recording.cpp)
target_link_libraries(kill_recording PRIVATE thaum_flags thaum_duel)
add_test(NAME drivers.kill_recording COMMAND ${timed} $<TARGET_FILE:kill_recording> 8)
set_tests_properties(drivers.kill_recording PROPERTIES RESOURCE_LOCK screen COST 100 TIMEOUT ${longest_test})
add_test(NAME drivers.hostile_files COMMAND ${timed} ${CMAKE_CURRENT_SOURCE_DIR}/drivers/hostile_files.sh $<TARGET_FILE:thaum>)
add_test(NAME drivers.hostile_files_all COMMAND ${timed} ${CMAKE_CURRENT_SOURCE_DIR}/drivers/hostile_files.sh $<TARGET_FILE:thaum> all)
set_tests_properties(drivers.hostile_files_all PROPERTIES LABELS long TIMEOUT ${longest_test})
if(THAUM_SANITIZE)
    # The sanitizers' shadow memory takes terabytes of address space, so memory is not limited.
    set_tests_properties(drivers.hostile_files PROPERTIES ENVIRONMENT "THAUM_MEMORY_KB=unlimited;THAUM_PATIENCE_S=30")
endif()
add_test(NAME drivers.verify COMMAND ${timed} ${CMAKE_CURRENT_SOURCE_DIR}/drivers/verify.sh $<TARGET_FILE:thaum> $<TARGET_FILE:forge_log>)
thaum_driver_test(homeless ${CMAKE_CURRENT_SOURCE_DIR}/drivers/homeless.sh $<TARGET_FILE:thaum>)
thaum_driver_test(lost_display ${CMAKE_CURRENT_SOURCE_DIR}/drivers/lost_display.sh $<TARGET_FILE:thaum>)
if(NOT THAUM_SANITIZE)  # sanitizers see the code that writes files in other tests
    add_test(NAME drivers.outputs COMMAND ${timed} ${CMAKE_CURRENT_SOURCE_DIR}/drivers/outputs.sh $<TARGET_FILE:thaum>)
    set_tests_properties(drivers.outputs PROPERTIES COST 50)
endif()
add_test(NAME drivers.lab_files COMMAND ${timed} ${CMAKE_CURRENT_SOURCE_DIR}/drivers/lab_files.sh $<TARGET_FILE:thaum>)
add_test(NAME drivers.gesture_check COMMAND ${timed} ${CMAKE_CURRENT_SOURCE_DIR}/drivers/gesture_check.sh $<TARGET_FILE:thaum>)
add_test(NAME drivers.commands COMMAND ${timed} ${CMAKE_CURRENT_SOURCE_DIR}/drivers/commands.sh $<TARGET_FILE:thaum>)
set_tests_properties(drivers.hostile_files drivers.commands PROPERTIES COST 50)
if(umockdev_FOUND)
    thaum_driver_test(duel_to_death ${CMAKE_CURRENT_SOURCE_DIR}/drivers/duel_to_death.sh
        $<TARGET_FILE:thaum> $<TARGET_FILE:pad_harness> $<TARGET_FILE:live_log_probe> $<TARGET_FILE:press_keys>)
    thaum_driver_test(menu ${CMAKE_CURRENT_SOURCE_DIR}/drivers/menu.sh
        $<TARGET_FILE:thaum> $<TARGET_FILE:pad_harness> $<TARGET_FILE:live_log_probe> $<TARGET_FILE:press_keys>)
    thaum_driver_test(pad_duel ${CMAKE_CURRENT_SOURCE_DIR}/drivers/pad_duel.sh
        $<TARGET_FILE:thaum> $<TARGET_FILE:pad_harness> $<TARGET_FILE:live_log_probe>)
    thaum_driver_test(two_pads ${CMAKE_CURRENT_SOURCE_DIR}/drivers/two_pads.sh
        $<TARGET_FILE:thaum> $<TARGET_FILE:pad_harness> $<TARGET_FILE:live_log_probe> $<TARGET_FILE:press_keys>)
    thaum_driver_test(pads ${CMAKE_CURRENT_SOURCE_DIR}/drivers/pads.sh
        $<TARGET_FILE:thaum> $<TARGET_FILE:pad_harness> $<TARGET_FILE:live_log_probe> $<TARGET_FILE:press_keys>)
    # Tests without a screen, which run beside all other tests.
    add_test(NAME drivers.rumble COMMAND ${timed} ${CMAKE_CURRENT_SOURCE_DIR}/drivers/rumble.sh
        $<TARGET_FILE:rumble_probe> $<TARGET_FILE:pad_harness>)
    add_test(NAME drivers.pad_models COMMAND ${timed} ${CMAKE_CURRENT_SOURCE_DIR}/drivers/pad_models.sh
        $<TARGET_FILE:pad_models>)
    set_tests_properties(drivers.rumble drivers.pad_models PROPERTIES
        SKIP_RETURN_CODE 77 TIMEOUT ${longest_test} ENVIRONMENT "${sanitizer_environment}")
    set_tests_properties(drivers.duel_to_death PROPERTIES LABELS slow)
endif()
