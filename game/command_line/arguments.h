// game/command_line/arguments.h: the words that follow a command on the command line, parsed against the
// command's options.
#pragma once
#include <filesystem>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.h"
#include "core/parse.h"
#include "render/context.h"

namespace thaum::game::inline command_line {

struct Option {
    std::string_view name;   ///< name of the option with its dashes: "--seed"
    std::size_t values = 0;  ///< number of words that follow the option
    bool repeats = false;    ///< true if the option may be given more than once
    bool writes = false;     ///< true if its last value names a file that the command writes
};

/// An option that names a file to be written. The value "-" is not a file.
constexpr Option output(std::string_view name, std::size_t values = 1) { return {name, values, false, true}; }

class Arguments {
public:
    /// Parses `words`. The error names the first wrong word, or an output file that another word names as
    /// well, because the command would overwrite it.
    static Expected<Arguments> parse(std::span<const std::string> words, std::span<const Option> options);

    const std::vector<std::string>& plain() const { return plain_; }
    bool has(std::string_view option) const { return given_.contains(std::string(option)); }
    /// First value of the option's last use, or std::nullopt if the option was not given.
    std::optional<std::string> value(std::string_view option) const;
    /// First value of the option's last use as a path.
    std::optional<std::filesystem::path> path(std::string_view option) const;
    /// Values of all uses of the option, in order.
    std::vector<std::string> values(std::string_view option) const;
    /// Value of the option as a number from `low` to `high`; `fallback` if the option was not given.
    Expected<double> number(std::string_view option, double low, double high, double fallback) const;
    Expected<std::uint64_t> whole(std::string_view option, std::uint64_t low, std::uint64_t high,
                                  std::uint64_t fallback) const;
    /// Value of the option as a number from `low` to `high`; std::nullopt if the option was not given.
    Expected<std::optional<double>> number(std::string_view option, double low, double high) const;
    Expected<std::optional<std::uint64_t>> whole(std::string_view option, std::uint64_t low,
                                                 std::uint64_t high) const;

private:
    std::vector<std::string> plain_;
    std::map<std::string, std::vector<std::string>> given_;
};

/// Parts of a word between commas or another separator: "a,b" -> "a", "b". There is always one part, which
/// may be empty.
std::vector<std::string> parts_of(std::string_view word, char between = ',');

/// Parses a size in pixels such as "1280x720".
Expected<render::Size> parse_size(std::string_view word, std::string_view what);

}  // namespace thaum::game::inline command_line
