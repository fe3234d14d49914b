// core/config.h: strict reading of TOML data files.
//
// A reader must ask for every key of a file, and every value must be in its range. A Config keeps all faults
// with file, line and key, and `check` returns them. A reader asks for all values as if the file were
// correct, then checks once at the end.
#pragma once
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.h"
#include "core/maths.h"

namespace thaum {

/// Range in which a number of a file must lie, both ends included. By default every finite number is allowed.
struct Range {
    double low = -std::numeric_limits<double>::max();
    double high = std::numeric_limits<double>::max();
};

class ConfigTable;

/// A parsed file, and the faults that its readers have found in it.
class Config {
public:
    /// Parses the text of a file, which messages call `name`. The file must have an integer `version` equal
    /// to the given one.
    static Expected<Config> parse(std::string_view toml, std::string name, std::int64_t version);

    /// The table that holds all others.
    ConfigTable root() const;
    /// Replaces the value of an existing key. The path has the form "shot.damage"; the value is written as in
    /// TOML.
    Expected<void> replace(std::string_view path, std::string_view value);
    /// Takes every value that this file lacks from `base`, also within tables that both have. A list is one
    /// value. The base must have been checked: faults in its values are reported without a line.
    void inherit(const Config& base);
    /// Reports a fault found by the caller, such as two entries that contradict each other. Nothing is
    /// reported if a value of the file is wrong: the caller then worked with a fallback value.
    void report(std::string_view message) const;
    /// Returns all faults of the reads so far, and the keys that no reader asked for: the first one as the
    /// message of the error, the others in Error::more.
    Expected<void> check() const;
    /// Whether no fault has been found so far. Keys that no reader asked for do not count as faults here.
    bool is_sound() const;
    /// Hash of all keys and values. It ignores comments, spaces, the order of keys and the spelling of a
    /// number (1 or 1.0). It also ignores the top-level keys in `without`.
    std::uint64_t value_hash(std::span<const std::string_view> without = {}) const;

    struct State;

private:
    explicit Config(std::shared_ptr<State> state) : state_(std::move(state)) {}
    std::shared_ptr<State> state_;
};

/// One table of a Config. After a fault, reads return the fallback or the low end of the range.
class ConfigTable {
public:
    /// Whether the table has this key.
    bool has(std::string_view key) const;

    /// Reads a number. A missing key is a fault unless there is a `fallback`; the same holds for the
    /// other reads of values.
    double number(std::string_view key, Range range) const;
    double number(std::string_view key, Range range, double fallback) const;
    /// Reads a whole number.
    std::int64_t integer(std::string_view key, Range range) const;
    std::int64_t integer(std::string_view key, Range range, std::int64_t fallback) const;
    /// Reads true or false.
    bool boolean(std::string_view key, bool fallback) const;
    /// Reads a text.
    std::string string(std::string_view key) const;
    std::string string(std::string_view key, std::string fallback) const;
    /// Reads an array of three numbers, each within the range.
    vec3 vector(std::string_view key, Range range) const;
    vec3 vector(std::string_view key, Range range, vec3 fallback) const;
    /// Reads an array of 1 to `most` numbers, each within the range.
    std::vector<double> numbers(std::string_view key, Range range, std::size_t most,
                                const std::vector<double>& fallback) const;
    /// Reads a string that must be one of `names`. Returns its index.
    std::size_t choice(std::string_view key, const std::vector<std::string_view>& names) const;
    std::size_t choice(std::string_view key, const std::vector<std::string_view>& names,
                       std::size_t fallback) const;

    /// Reads a colour "#RRGGBB" as 0xRRGGBB. std::nullopt if the key has no text: older
    /// files write colours in other ways.
    std::optional<std::uint32_t> hex_colour(std::string_view key) const;

    /// Returns a sub-table, which is empty if the key is missing.
    ConfigTable table(std::string_view key) const;
    /// Returns an array of tables, which is empty if the key is missing.
    std::vector<ConfigTable> tables(std::string_view key) const;
    /// Returns all keys in sorted order and marks them as asked for, so that none is reported as unknown.
    std::vector<std::string> keys() const;
    /// Reports a fault at this key, or at the table if the key is empty. Nothing is reported if a value of
    /// the table is wrong: the caller then worked with a fallback value.
    void report(std::string_view key, std::string_view message) const;
    /// Place of the key, or of the table if it has no such key, for messages: "wand.toml:12".
    std::string place(std::string_view key) const;

private:
    friend class Config;
    ConfigTable(std::shared_ptr<Config::State> state, const void* table, const void* holder, std::string path)
        : state_(std::move(state)), table_(table), holder_(holder), path_(std::move(path)) {}
    /// Reports a key as missing if the table lacks it. `allowed` says in words which values it may have.
    /// `misleads`: true if the value decides which other keys the table has.
    void demand(std::string_view key, std::string_view allowed, bool misleads = false) const;

    std::shared_ptr<Config::State> state_;
    const void* table_;   // a toml::table; null if the table is missing
    const void* holder_;  // the table itself; if missing, the innermost table around it in the file
    std::string path_;    // keys by which a missing table would be reached from holder_: "shot.trail"
};

/// A text as a quoted TOML string. Control characters become escapes.
std::string in_quotes(std::string_view words);

}  // namespace thaum
