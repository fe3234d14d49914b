# Tests of the sound generator, the sounds of the game, and their pictures.
thaum_test(test_sounds
    SOURCES accuracy/audio_synth_test.cpp unit/audio_recipe_test.cpp unit/audio_sounds_test.cpp
    LINK thaum_audio
    NOT_SANITIZED GameSounds.EachIsTold*)
# Tests of code that several commands share.
thaum_test(test_commands
    SOURCES unit/content_test.cpp unit/drawing_hand_test.cpp unit/offscreen_duel_test.cpp unit/shots_test.cpp unit/sound_picture_test.cpp unit/stroke_desk_test.cpp
    LINK thaum_tools fake_arm)
