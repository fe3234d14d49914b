thaum_test(test_audio
    SOURCES stability/audio_hostile_test.cpp unit/audio_bands_test.cpp unit/audio_mixer_test.cpp unit/audio_playback_test.cpp unit/audio_stream_test.cpp
        unit/audio_wav_test.cpp
    THREAD_SOURCES
        unit/audio_speakers_test.cpp
    LINK thaum_audio PkgConfig::openal
    THREADS Speakers.*)
