# A spell that only these tests have: one .cpp, one data file and the file of its gesture (fifth_spell/mend.*, w.toml).
add_library(spell_mend OBJECT fifth_spell/mend.cpp)
target_link_libraries(spell_mend PRIVATE thaum_flags thaum_wand_parts)
thaum_test(test_fifth_spell
    SOURCES fifth_spell/fifth_spell_test.cpp $<TARGET_OBJECTS:spell_mend>
    LINK thaum_live
    NOT_SANITIZED FifthSpell.BotsCastIt*)

# Under sanitizers the program below is left out, because it runs no code that test_fifth_spell does not run.
if(THAUM_SANITIZE)
    return()
endif()

# The whole program with the fifth spell. It can also be played in a window: THAUM_ASSETS names a folder with mend.toml
# and w.toml.
add_executable(thaum_with_mend ${PROJECT_SOURCE_DIR}/game/app/tools_main.cpp $<TARGET_OBJECTS:spell_mend>)
target_link_libraries(thaum_with_mend PRIVATE thaum_tools thaum_flags)
add_test(NAME fifth_spell.program COMMAND ${timed} ${CMAKE_CURRENT_SOURCE_DIR}/fifth_spell/program.sh
    $<TARGET_FILE:thaum_with_mend> $<TARGET_FILE:thaum> ${PROJECT_SOURCE_DIR}/assets)
