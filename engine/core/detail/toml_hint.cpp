#include "core/detail/toml_hint.h"

#include <algorithm>
#include <charconv>

#include "core/config.h"
#include "core/one_line.h"
#include "core/text.h"

namespace thaum::detail {
namespace {

constexpr std::string_view blanks = " \t\r";

/// A part of the source for a message of one line.
std::string shown(std::string_view words) { return printable(words, 60); }

std::string_view trimmed(std::string_view words) {
    const auto first = words.find_first_not_of(blanks);
    if (first == std::string_view::npos) return {};
    return words.substr(first, words.find_last_not_of(blanks) - first + 1);
}

std::string_view line_of(std::string_view source, std::size_t line) {
    for (; line > 1; --line) {
        const auto end = source.find('\n');
        if (end == std::string_view::npos) return {};
        source.remove_prefix(end + 1);
    }
    return source.substr(0, source.find('\n'));
}

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

/// Returns true if the digits around the dot are a number, not part of a key such as 1.1.1.
bool is_decimal_point(std::string_view line, std::size_t dot) {
    if (dot == 0 || dot + 1 >= line.size() || !is_digit(line[dot - 1]) || !is_digit(line[dot + 1]))
        return false;
    std::size_t first = dot - 1;
    while (first > 0 && is_digit(line[first - 1])) --first;
    return first == 0 || line[first - 1] != '.';
}

bool has_too_many_dots(std::string_view line) {
    std::size_t dots = 0;
    for (auto at = line.find('.'); at != std::string_view::npos; at = line.find('.', at + 1)) {
        if (!is_decimal_point(line, at)) ++dots;
    }
    return dots > most_dots;
}

/// Length of the digits at the beginning, after a sign.
std::size_t digits_of(std::string_view words) {
    const std::size_t sign = !words.empty() && (words[0] == '-' || words[0] == '+') ? 1 : 0;
    std::size_t length = sign;
    while (length < words.size() && is_digit(words[length])) ++length;
    return length > sign ? length : 0;
}

/// The number that "1,5" means, as TOML writes it; empty if the text is none with a comma.
std::string with_point(std::string_view words) {
    const auto whole = digits_of(words);
    if (whole == 0 || whole + 1 >= words.size() || words[whole] != ',') return {};
    const auto after = words.substr(whole + 1);
    if (!is_digit(after[0]) || digits_of(after) != after.size()) return {};
    return text(words.substr(0, whole), ".", after);
}

bool has_curly_quotes(std::string_view words) {
    constexpr std::string_view quotes[] = {"\u201c", "\u201d", "\u201e", "\u2018",
                                           "\u2019", "\u00ab", "\u00bb"};
    return std::ranges::any_of(quotes,
                               [&](auto quote) { return words.find(quote) != std::string_view::npos; });
}

/// A line up to the '#' that begins its comment, which is none within quotes.
std::string_view without_comment(std::string_view line) {
    char quote = 0;
    for (std::size_t i = 0; i < line.size(); ++i) {
        if (quote == 0 && line[i] == '#') return line.substr(0, i);
        if (quote == 0 && (line[i] == '"' || line[i] == '\''))
            quote = line[i];
        else if (line[i] == quote)
            quote = 0;
    }
    return line;
}

std::string hint_of_value(std::string_view value) {
    if (value.empty()) return "; write a value after '='";
    if (const auto number = with_point(value); !number.empty()) return text("; write ", shown(number));
    if (value.ends_with(',') || value.ends_with(';'))
        return text("; leave out the '", value.substr(value.size() - 1), "' at the end");
    if (value == "True" || value == "False" || value == "yes" || value == "no" || value == "TRUE")
        return "; write true or false";
    if (value[0] == '.' || value.ends_with('.')) return "; a number has digits before and after its point";
    if (is_letter(value[0])) return text("; a text stands in quotes: \"", shown(value), "\"");
    if (const auto digits = digits_of(value); digits > 0 && digits < value.size()) {
        const char next = value[digits];
        if (next == ' ' || (is_letter(next) && next != 'e' && next != 'E' && next != 'x'))
            return "; a number has no unit and no blanks";
        return "";
    }
    const auto quotes = std::ranges::count(value, '"');
    if (quotes % 2 == 1) return "; a quote is not closed";
    if (value[0] == '[') return "; a list is [1, 2, 3], with commas between its values";
    return "";
}

}  // namespace

std::size_t overdotted_line(std::string_view source) {
    std::size_t number = 1;
    while (!source.empty()) {
        const auto end = std::min(source.find('\n'), source.size());
        if (has_too_many_dots(source.substr(0, end))) return number;
        source.remove_prefix(std::min(end + 1, source.size()));
        ++number;
    }
    return 0;
}

std::string toml_hint(std::string_view source, std::size_t line) {
    const auto zero = source.substr(0, 2).find('\0');
    if (zero != std::string_view::npos || source.starts_with("\xff\xfe") || source.starts_with("\xfe\xff"))
        return "; save the file as UTF-8";
    auto words = line_of(source, line);
    if (words.find('\r') < words.size() - 1) return "; end lines with a line feed";
    if (has_curly_quotes(words)) return "; write straight quotes, \"like this\"";
    words = trimmed(without_comment(words));
    if (words.empty()) return "";
    if (words.starts_with("//") || words.starts_with(";") || words.starts_with("--"))
        return "; a comment begins with '#'";
    const auto equals = words.find('=');
    if (words[0] == '[')
        return equals == std::string_view::npos ? "; a table is [name], a list [[name]]" : "";
    if (equals == std::string_view::npos)
        return words.find(':') != std::string_view::npos ? "; write '=' in place of ':'"
                                                         : "; write KEY = VALUE";
    const auto key = trimmed(words.substr(0, equals));
    if (key.find(' ') != std::string_view::npos) return "; a key has no blanks";
    return hint_of_value(trimmed(words.substr(equals + 1)));
}

std::string number_hint(std::string_view words) {
    const auto plain = trimmed(words);
    if (const auto number = with_point(plain); !number.empty()) return text("; write ", shown(number));
    const auto whole = digits_of(plain);
    if (whole == 0) return "";
    auto rest = plain.substr(whole);
    if (rest.starts_with('.')) rest = rest.substr(1 + digits_of(rest.substr(1)));
    return rest.empty() ? text("; write ", shown(plain), " without quotes") : "";
}

std::optional<std::uint32_t> parse_colour(std::string_view words) {
    if (words.size() != 7 || words[0] != '#') return std::nullopt;
    std::uint32_t colour = 0;
    const auto* end = words.data() + words.size();
    const auto read = std::from_chars(words.data() + 1, end, colour, 16);
    return read.ptr == end && read.ec == std::errc() ? std::optional(colour) : std::nullopt;
}

}  // namespace thaum::detail

namespace thaum {

std::string in_quotes(std::string_view words) {
    constexpr std::string_view digits = "0123456789ABCDEF";
    std::string out = "\"";
    for (const char c : words) {
        const auto byte = static_cast<unsigned char>(c);
        if (byte < 0x20 || byte == 0x7F) {
            out += text("\\u00", digits.substr(byte / 16, 1), digits.substr(byte % 16, 1));
            continue;
        }
        if (c == '"' || c == '\\') out += '\\';
        out += c;
    }
    return out + '"';
}

}  // namespace thaum
