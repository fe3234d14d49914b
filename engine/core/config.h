// core/config.h: strict reading of TOML data files. Every key that a file has must be asked for, every value must be
// in its range; the first fault is kept with file, line and key, and `check` returns it. So a reader asks for all it
// needs, as if the file were right, and checks once at the end.
#pragma once
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.h"
#include "core/maths.h"

namespace thaum {

struct Range {
    double low = -std::numeric_limits<double>::max();
    double high = std::numeric_limits<double>::max();
};

class ConfigTable;

/// One parsed file.
class Config {
public:
    /// name is used in messages. The file must have an integer `version` equal to the given one.
    static Expected<Config> parse(std::string_view toml, std::string name, std::int64_t version);

    ConfigTable root() const;
    /// Replaces the value of a key that the file has: path "shot.damage", value as TOML writes it.
    Expected<void> replace(std::string_view path, std::string_view value);
    /// A fault that the caller found itself, such as two entries that contradict each other.
    void report(std::string_view message) const;
    /// The first fault of all reads so far; then any key that nobody asked for.
    Expected<void> check() const;

    struct State;

private:
    explicit Config(std::shared_ptr<State> state) : state_(std::move(state)) {}
    std::shared_ptr<State> state_;
};

/// One table of a Config. After a fault reads return the fallback or the low end of the range.
class ConfigTable {
public:
    bool has(std::string_view key) const;

    double number(std::string_view key, Range range) const;
    double number(std::string_view key, Range range, double fallback) const;
    std::int64_t integer(std::string_view key, Range range) const;
    std::int64_t integer(std::string_view key, Range range, std::int64_t fallback) const;
    bool boolean(std::string_view key, bool fallback) const;
    std::string string(std::string_view key) const;
    std::string string(std::string_view key, std::string fallback) const;
    /// Three numbers, each in the range.
    vec3 vector(std::string_view key, Range range) const;
    vec3 vector(std::string_view key, Range range, vec3 fallback) const;
    /// One of the names; the index of it.
    std::size_t choice(std::string_view key, const std::vector<std::string_view>& names) const;
    std::size_t choice(std::string_view key, const std::vector<std::string_view>& names,
                       std::size_t fallback) const;

    /// A sub-table; an empty one where the key is missing.
    ConfigTable table(std::string_view key) const;
    /// An array of tables; none where the key is missing.
    std::vector<ConfigTable> tables(std::string_view key) const;
    /// The keys, sorted; they count as asked for.
    std::vector<std::string> keys() const;
    /// A fault at this key (or at the table, with an empty key).
    void report(std::string_view key, std::string_view message) const;

private:
    friend class Config;
    ConfigTable(std::shared_ptr<Config::State> state, const void* table)
        : state_(std::move(state)), table_(table) {}
    std::shared_ptr<Config::State> state_;
    const void* table_;  // toml::table, or null for one that is missing
};

}  // namespace thaum
