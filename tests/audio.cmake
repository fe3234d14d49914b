thaum_test(test_audio
    SOURCES accuracy/audio_synth_test.cpp unit/audio_recipe_test.cpp unit/audio_sounds_test.cpp
    LINK thaum_audio
    NOT_SANITIZED GameSounds.EachIsTold*)
