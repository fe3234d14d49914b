# Tests of what players hear of a match, and of what they feel on the body.
thaum_test(test_sound
    SOURCES unit/felt_sound_test.cpp unit/felt_words_test.cpp unit/sound_scene_test.cpp unit/tactile_scene_test.cpp
    LINK thaum_duel thaum_senses
    NOT_SANITIZED SoundScene.ADuelIsHeardWhole)
