thaum_test(test_audio
    SOURCES unit/audio_mixer_test.cpp
    LINK thaum_audio)
