# A wand that only these tests have: one .cpp and one data file (sixth_wand/hail.*).
thaum_test(test_sixth_wand
    SOURCES sixth_wand/sixth_wand_test.cpp sixth_wand/hail.cpp
    LINK thaum_live
    NOT_SANITIZED SixthWand.BotsTakeIt*)

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

# The whole program with the sixth wand. It can also be played in a window: THAUM_ASSETS names a folder with hail.toml.
add_executable(thaum_with_hail ${PROJECT_SOURCE_DIR}/game/app/main.cpp sixth_wand/hail.cpp)
target_link_libraries(thaum_with_hail PRIVATE thaum_commands thaum_flags)
if(NOT THAUM_SANITIZE)  # test_sixth_wand shows the sanitizers the same code
    add_test(NAME sixth_wand.program COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/sixth_wand/program.sh
        $<TARGET_FILE:thaum_with_hail> $<TARGET_FILE:thaum> ${PROJECT_SOURCE_DIR}/assets)
endif()
