#include "core/detail/toml_parse.h"

#include <algorithm>

#include "core/detail/toml_hint.h"
#include "core/one_line.h"
#include "core/text.h"

namespace thaum::detail {
namespace {

/// The source up to and including the line with this number (from 1).
std::string_view first_lines(std::string_view source, std::size_t lines) {
    std::size_t at = 0;
    for (; lines > 0 && at < source.size(); --lines)
        at = std::min(source.find('\n', at), source.size() - 1) + 1;
    return source.substr(0, at);
}

bool is_asserting(std::string_view source) {
    try {
        const auto parsed = toml::parse(source);
        return false;
    } catch (const ParserAsserted&) {
        return true;
    }
}

/// The line that fails an assertion of the parser. The assertion names no line, so we look for the shortest
/// beginning of the file that fails.
std::size_t asserting_line(std::string_view source) {
    std::size_t good = 0, bad = 1 + static_cast<std::size_t>(std::ranges::count(source, '\n'));
    while (bad - good > 1) {
        const auto middle = good + (bad - good) / 2;
        (is_asserting(first_lines(source, middle)) ? bad : good) = middle;
    }
    return bad;
}

}  // namespace

Expected<toml::table> parse_toml(std::string_view source, const std::string& name) {
    if (const auto line = overdotted_line(source); line != 0)
        return fail(text(name, ":", line, ": more than ", max_dots, " dots in one line"));
    const auto refused = [&](std::size_t line, std::string_view what) {
        const auto slip = toml_slip(source, line, what);
        return fail(text(name, ":", slip.line, ": ", in_one_line(slip.words)));
    };
    try {
        auto result = toml::parse(source, name);
        if (result) return std::move(result).table();
        return refused(result.error().source().begin.line, result.error().description());
    } catch (const ParserAsserted&) {
        return refused(asserting_line(source),
                       "cannot be read as TOML; look for a wrong bracket, quote, date or time");
    }
}

}  // namespace thaum::detail
