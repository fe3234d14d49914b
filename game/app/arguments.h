// game/app/arguments.h: the words after a command, checked against what the command knows.
#pragma once
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.h"
#include "render/context.h"

namespace thaum::app {

struct Option {
    std::string_view name;   ///< "--seed"
    std::size_t values = 0;  ///< words that follow it
    bool repeats = false;    ///< may be given more than once
};

class Arguments {
public:
    /// The error names the word that is wrong.
    static Expected<Arguments> parse(std::span<const std::string> words, std::span<const Option> options);

    const std::vector<std::string>& plain() const { return plain_; }
    bool has(std::string_view option) const { return given_.contains(std::string(option)); }
    /// The first value of the option's last use.
    std::optional<std::string> value(std::string_view option) const;
    /// All values of all its uses, in order.
    std::vector<std::string> values(std::string_view option) const;
    /// As a number in a range; `fallback` where the option was not given.
    Expected<double> number(std::string_view option, double low, double high, double fallback) const;
    Expected<std::uint64_t> whole(std::string_view option, std::uint64_t low, std::uint64_t high,
                                  std::uint64_t fallback) const;
    /// The same; nothing where the option was not given.
    Expected<std::optional<double>> number(std::string_view option, double low, double high) const;
    Expected<std::optional<std::uint64_t>> whole(std::string_view option, std::uint64_t low,
                                                 std::uint64_t high) const;

private:
    std::vector<std::string> plain_;
    std::map<std::string, std::vector<std::string>> given_;
};

/// "12" -> 12; the error says what is wrong with it, for `what`.
Expected<std::uint64_t> parse_whole(std::string_view word, std::string_view what, std::uint64_t low,
                                    std::uint64_t high);
Expected<double> parse_number(std::string_view word, std::string_view what, double low, double high);
/// "1280x720".
Expected<render::Size> parse_size(std::string_view word, std::string_view what);

}  // namespace thaum::app
