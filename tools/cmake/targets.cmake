# One engine folder is one static library: thaum_engine(core SOURCES ... LINK ...).
# Includes are written from engine/ ("core/error.h") and, for the game, from the top ("game/match/match.h").
function(thaum_engine name)
    cmake_parse_arguments(ARG "" "" "SOURCES;LINK;PRIVATE_LINK" ${ARGN})
    add_library(thaum_${name} STATIC ${ARG_SOURCES})
    target_include_directories(thaum_${name} PUBLIC ${PROJECT_SOURCE_DIR}/engine)
    target_link_libraries(thaum_${name} PUBLIC ${ARG_LINK} PRIVATE thaum_flags ${ARG_PRIVATE_LINK})
endfunction()
