// fuzz/fuzz.h: tests readers of files with mutated input. Run i of a seed always gives the same input:
// mutations of real files (the shipped ones, and those in tests/fuzz/seeds/READER). The reader must accept
// the input, or refuse it in one line. The reader must not crash, hang or use much memory.
//
//     thaum_fuzz READER [--runs N] [--seed S] [--from I]
#pragma once
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/random.h"

namespace thaum::fuzz {

/// Folders in which the test of a reader puts its files.
struct Places {
    std::filesystem::path assets;   ///< copy of the assets that the reader may change
    std::filesystem::path scratch;  ///< an empty folder for temporary files
};

struct Outcome {
    bool accepted = false;
    std::string refusal{};  ///< the reader's message if it refused the input
    std::string fault{};    ///< fault of the reader or of the code that used the result; empty: none
};

struct Reader {
    std::string_view name;
    /// Real inputs to start from, in addition to those in tests/fuzz/seeds.
    std::vector<std::string> (*seeds)(const Places& places);
    std::string (*mutate)(const std::vector<std::string>& seeds, Random& random);
    Outcome (*read)(const std::string& input, const Places& places);
};

/// All readers. Each source file of this folder defines some of them.
std::span<const Reader> readers();
extern const Reader log_reader, scenario_reader, settings_reader, arena_reader, rules_reader, wizard_reader,
    wand_reader, blast_reader, lob_reader, potion_reader, bot_reader, range_reader, lessons_reader,
    device_reader, lab_reader, volume_session_reader, sound_reader, layout_reader, effect_reader, tact_reader,
    bhaptics_reader, jacket_reader, stroke_reader, gesture_reader, profile_reader, gzip_reader, nrrd_reader,
    nhdr_reader, raw_volume_reader, carving_tool_reader, materials_reader, voxels_reader;

/// Mutates bytes: flipped bits, special byte values, cuts, repetitions and pieces of other seeds.
std::string mutate_bytes(const std::vector<std::string>& seeds, Random& random);
/// Mutates text: typing errors, hostile numbers, lost, doubled and moved lines, cuts, repetitions and pieces
/// of other seeds.
std::string mutate_text(const std::vector<std::string>& seeds, Random& random);

}  // namespace thaum::fuzz
