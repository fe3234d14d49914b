# Things that only these tests have, each in one source: a maker of jackets, a command, an effect, an event.
# So each of them takes no more files than game/README.md says. They stand in programs of their own, since an event and
# an effect change what all matches of a program have.
thaum_test(test_new_command SOURCES seams/command_test.cpp LINK thaum_tools)
thaum_test(test_new_jacket
    SOURCES seams/jacket_test.cpp
    LINK thaum_live
    THREADS NewJacketThreads.*)
thaum_test(test_new_event SOURCES seams/event_test.cpp LINK thaum_duel)
thaum_test(test_new_effect SOURCES seams/effect_test.cpp LINK thaum_duel)
thaum_test(test_added_files SOURCES seams/added_files_test.cpp LINK thaum_duel)
