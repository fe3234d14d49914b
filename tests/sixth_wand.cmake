# A wand that only these tests have: one .cpp and one data file (sixth_wand/hail.*).
thaum_test(test_sixth_wand
    SOURCES sixth_wand/sixth_wand_test.cpp sixth_wand/hail.cpp
    LINK thaum_live)

# The same program with the wands' objects linked in either order. The archive of the game gives it everything but
# the wands, since no object of the archive refers to one.
file(GLOB wand_sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/game/wands/*.cpp)
list(APPEND wand_sources ${CMAKE_CURRENT_SOURCE_DIR}/sixth_wand/hail.cpp)
set(wand_objects "")
foreach(source ${wand_sources})
    get_filename_component(name ${source} NAME_WE)
    add_library(wand_object_${name} OBJECT ${source})
    target_link_libraries(wand_object_${name} PRIVATE thaum_flags thaum_game)
    list(APPEND wand_objects $<TARGET_OBJECTS:wand_object_${name}>)
endforeach()
foreach(order forward reverse)
    add_executable(wands_${order} sixth_wand/link_order.cpp ${wand_objects})
    target_compile_definitions(wands_${order} PRIVATE THAUM_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
    target_link_libraries(wands_${order} PRIVATE thaum_flags thaum_game)
    list(REVERSE wand_objects)
endforeach()
add_test(NAME sixth_wand.link_order COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/sixth_wand/same_output.sh
    $<TARGET_FILE:wands_forward> $<TARGET_FILE:wands_reverse>)

# The whole game with the sixth wand, to be seen in a window: THAUM_ASSETS names a folder that has hail.toml too.
get_target_property(program_sources thaum SOURCES)
list(TRANSFORM program_sources PREPEND ${PROJECT_SOURCE_DIR}/game/ REGEX "^app/")
add_executable(thaum_with_hail EXCLUDE_FROM_ALL ${program_sources} sixth_wand/hail.cpp)
target_link_libraries(thaum_with_hail PRIVATE thaum_live thaum_lab thaum_scenario thaum_plot
    nlohmann_json::nlohmann_json thaum_flags)
