// fuzz/fuzz.h: readers of files under fire. Run i of a seed is one input, always the same: real files (the shipped ones, and
// tests/fuzz/seeds/READER) after some mutations. The reader must take it or refuse it in one line; it must not crash, hang,
// or ask for much memory.
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

/// Where a reader finds files and may write its own.
struct Places {
    std::filesystem::path assets;   ///< a copy that may be spoilt
    std::filesystem::path scratch;  ///< an empty folder
};

struct Outcome {
    bool accepted = false;
    std::string refusal{};  ///< the reader's message where it was not accepted
    std::string fault{};    ///< what the reader or what follows it did wrong; empty: nothing
};

struct Reader {
    std::string_view name;
    /// Real inputs, beside those in tests/fuzz/seeds.
    std::vector<std::string> (*seeds)(const Places& places);
    std::string (*mutate)(const std::vector<std::string>& seeds, Random& random);
    Outcome (*read)(const std::string& input, const Places& places);
};

/// All of them, each from a file of this folder.
std::span<const Reader> readers();
extern const Reader log_reader, scenario_reader, settings_reader, arena_reader, rules_reader, wizard_reader,
    wand_reader, blast_reader, lob_reader, bot_reader, range_reader, device_reader, lab_reader;

/// Flipped bits, striking bytes, cuts, repetitions, pieces of other seeds.
std::string mutate_bytes(const std::vector<std::string>& seeds, Random& random);
/// Slips of the keyboard, hostile numbers, lost, doubled and moved lines, cuts, repetitions, pieces of other seeds.
std::string mutate_text(const std::vector<std::string>& seeds, Random& random);

}  // namespace thaum::fuzz
