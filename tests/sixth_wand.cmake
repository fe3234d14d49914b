# A wand that only these tests have: one .cpp and one data file (sixth_wand/hail.*).
add_library(wand_hail OBJECT sixth_wand/hail.cpp)
target_link_libraries(wand_hail PRIVATE thaum_flags thaum_wand_parts)
thaum_test(test_sixth_wand
    SOURCES sixth_wand/sixth_wand_test.cpp $<TARGET_OBJECTS:wand_hail>
    LINK thaum_live
    NOT_SANITIZED SixthWand.BotsTakeIt*)

# Under sanitizers the programs below are left out, because they run no code that test_sixth_wand does not
# run.
if(THAUM_SANITIZE)
    return()
endif()

# link_order.cpp with the objects of the wands linked in either order. The game's archive gives the program
# everything but the wands, since no object of the archive refers to a wand.
set(wand_objects ${THAUM_WANDS} ${THAUM_SPELLS} ${THAUM_EFFECTS} $<TARGET_OBJECTS:wand_hail>)
foreach(order forward reverse)
    add_executable(wands_${order} sixth_wand/link_order.cpp ${wand_objects})
    target_compile_definitions(wands_${order} PRIVATE THAUM_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
    target_link_libraries(wands_${order} PRIVATE thaum_flags thaum_wand_parts thaum_bots)
    list(REVERSE wand_objects)
endforeach()
add_test(NAME sixth_wand.link_order COMMAND ${timed} ${CMAKE_CURRENT_SOURCE_DIR}/sixth_wand/same_output.sh
    $<TARGET_FILE:wands_forward> $<TARGET_FILE:wands_reverse>)

# The whole program with the sixth wand. It can also be played in a window: THAUM_ASSETS names a folder with hail.toml.
add_executable(thaum_with_hail ${PROJECT_SOURCE_DIR}/game/app/tools_main.cpp $<TARGET_OBJECTS:wand_hail>)
target_link_libraries(thaum_with_hail PRIVATE thaum_tools thaum_flags)
add_test(NAME sixth_wand.program COMMAND ${timed} ${CMAKE_CURRENT_SOURCE_DIR}/sixth_wand/program.sh
    $<TARGET_FILE:thaum_with_hail> $<TARGET_FILE:thaum> ${PROJECT_SOURCE_DIR}/assets)
