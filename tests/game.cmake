thaum_test(test_game
    SOURCES unit/apprentice_test.cpp unit/game_match_test.cpp unit/aim_assist_test.cpp unit/game_tables_test.cpp unit/balance_test.cpp unit/bots_test.cpp unit/arena_test.cpp unit/range_test.cpp unit/game_touch_test.cpp unit/game_arm_test.cpp unit/game_cauldron_test.cpp unit/potions_test.cpp unit/game_probe_test.cpp unit/game_wand_coupling_test.cpp unit/game_wands_test.cpp unit/casting_test.cpp unit/game_systems_test.cpp unit/replay_index_test.cpp stability/game_replay_test.cpp stability/game_hostile_test.cpp stability/game_hands_test.cpp
    LINK thaum_duel thaum_range thaum_haptics_audit
    NOT_SANITIZED ArenaMatch.Bots* ArenaMatch.AnArena* Bot.HigherLevels* Bot.LeadingTheFoe* Bot.DodgingIsHit* Bot.WaitsNowhere* GameMatch.TwoBots* GameSystemsOfBots.* HapticSetup.TheAuditFinds* Lob.AStoneNever* Probe.TurningAndWalking* GameCauldron.FadersTake* GameCauldron.TheSameWithAnyNumber* Bot.FetchesHealth* Bot.DoesNotWaitForACharge*)
thaum_test(test_orb
    SOURCES accuracy/orb_force_test.cpp stability/orb_hostile_test.cpp unit/orb_test.cpp
    LINK thaum_duel)
thaum_test(test_crystal
    SOURCES unit/crystal_test.cpp unit/crystal_turn_test.cpp unit/crystal_shape_test.cpp
    LINK thaum_duel
    NOT_SANITIZED CrystalShape.KeysOfAThousand* Crystal.CarvingUnderTheHand*)
thaum_test(test_free_casting
    SOURCES unit/free_casting_test.cpp unit/free_idling_test.cpp
    LINK thaum_duel
    NOT_SANITIZED FreeIdling.* FreeCasting.TenMinutes* FreeCasting.FindsTheStrokes*
    LONG FreeCasting.TenMinutesOfBots*)
thaum_test(test_game_threads
    SOURCES unit/game_threads_test.cpp
    LINK thaum_duel
    THREADS *)
thaum_test(test_choices
    SOURCES unit/bot_file_test.cpp unit/gravity_test.cpp unit/mutator_test.cpp unit/rule_files_test.cpp
    LINK thaum_duel)
thaum_test(test_easiest_bot
    SOURCES unit/easiest_bot_test.cpp
    LINK thaum_duel
    NOT_SANITIZED EasiestBot.*
    LONG EasiestBot.*)
thaum_test(test_lab
    SOURCES unit/hand_path_test.cpp unit/lab_test.cpp unit/saved_body_test.cpp unit/volume_lab_test.cpp unit/volume_session_test.cpp
    LINK thaum_lab)
