#include "core/detail/toml_hint.h"

#include <algorithm>
#include <charconv>

#include "core/config.h"
#include "core/invisible.h"
#include "core/letters.h"
#include "core/one_line.h"
#include "core/text.h"
#include "core/utf8.h"

namespace thaum::detail {
namespace {

constexpr std::string_view blanks = " \t\r";

/// A part of the source file, shortened for a message of one line.
std::string shown(std::string_view words) { return printable(words, 60); }

std::string_view line_of(std::string_view source, std::size_t line) {
    for (; line > 1; --line) {
        const auto end = source.find('\n');
        if (end == std::string_view::npos) return {};
        source.remove_prefix(end + 1);
    }
    return source.substr(0, source.find('\n'));
}

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

/// Returns true if the digits around the dot form a number and not a key such as 1.1.1.
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
    return dots > max_dots;
}

/// Number of digits at the beginning of a word, with the sign before them.
std::size_t digits_of(std::string_view words) {
    const std::size_t sign = !words.empty() && (words[0] == '-' || words[0] == '+') ? 1 : 0;
    std::size_t length = sign;
    while (length < words.size() && is_digit(words[length])) ++length;
    return length > sign ? length : 0;
}

/// A number with a decimal comma, such as "1,5", as TOML writes it; empty if the text is no such number.
std::string with_point(std::string_view words) {
    const auto whole = digits_of(words);
    if (whole == 0 || whole + 1 >= words.size() || words[whole] != ',') return {};
    const auto after = words.substr(whole + 1);
    if (!is_digit(after[0]) || digits_of(after) != after.size()) return {};
    return text(words.substr(0, whole), ".", after);
}

/// A line without its comment. A '#' within quotes begins no comment.
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

/// A line without its comment and without the text between quotes; the quotes themselves stay.
std::string bare(std::string_view line) {
    std::string out;
    char quote = 0;
    for (const char c : without_comment(line)) {
        if (quote == 0 || c == quote) out += c;
        if (quote == 0 && (c == '"' || c == '\''))
            quote = c;
        else if (c == quote)
            quote = 0;
    }
    return out;
}

bool is_one_of(std::string_view word, std::initializer_list<std::string_view> words) {
    return std::ranges::any_of(words, [&](auto one) { return same_word(one, word); });
}

bool begins_with_one_of(std::string_view word, std::initializer_list<std::string_view> words) {
    return std::ranges::any_of(words, [&](auto one) { return word.starts_with(one); });
}

bool begins_other_comment(std::string_view words) {
    return begins_with_one_of(words, {"//", ";", "--", "/*", "<!--", "%"});
}

constexpr std::string_view comment_words = "a comment begins with '#'";
constexpr std::string_view list_words = "a list is [1, 2, 3], with commas between its values";

/// Advice on mending a character that looks like one of TOML's characters but is another.
std::string hint_of_characters(std::string_view line) {
    const auto words = bare(line);
    if (const auto found = invisible_character(words); !found.empty())
        return text("outside of quotes there is ", found, ": delete it, or write a space");
    for (const char32_t c : decode_utf8(words)) {
        if (c == '`' || (c >= 0x2018 && c <= 0x201F) || c == 0xAB || c == 0xBB)
            return "write straight quotes, \"like this\"";
        if ((c >= 0x2010 && c <= 0x2015) || c == 0x2212)
            return text("'", encode_utf8(c), "' is no minus sign: write '-'");
        if (c >= 0xFF01 && c <= 0xFF5E)
            return text("'", encode_utf8(c), "' is a wide character: write '",
                        static_cast<char>(c - 0xFF01 + '!'), "'");
    }
    return "";
}

/// Advice on mending the text that follows a number at the beginning of a value.
std::string hint_after_number(std::string_view number, std::string_view remaining) {
    if (remaining.find('=') != remaining.npos) return "a line has one KEY = VALUE";
    if (begins_other_comment(remaining)) return std::string(comment_words);
    if (begins_with_one_of(remaining, {"*", "/", "+", "-"})) return "a value is no sum: write its result";
    if (digits_of(remaining) == remaining.size() && is_digit(remaining[0]))
        return text("a number has no blanks: write ", shown(text(number, remaining)));
    return text("after the number only a comment may stand, which begins with '#'; a number has no unit");
}

/// True if a number begins with a zero before another digit, as in 012, which TOML does not allow.
bool is_zero_first(std::string_view number) {
    const auto first = number.find_first_of("0123456789");
    return first + 1 < number.size() && number[first] == '0';
}

/// True for words such as "e400" or "E+07".
bool is_exponent(std::string_view word) {
    if (word[0] != 'e' && word[0] != 'E') return false;
    const auto number = word.substr(1);
    return !number.empty() && digits_of(number) == number.size() && is_digit(number.back());
}

/// Advice on mending a word that begins like a number but is none.
std::string hint_of_number(std::string_view word) {
    if (begins_with_one_of(word, {"0x", "0X"})) return "a hexadecimal number is 0x and digits 0-9, a-f";
    if (begins_with_one_of(word, {"--", "++", "+-", "-+"})) return "a number has one sign";
    if (word.find(':') != word.npos) return "a number has no ':', and a text stands in quotes";
    if (word.find_first_of("*/") != word.npos) return "a value is no sum: write its result";
    if (word[0] == '.' || word.ends_with('.')) return "a number has digits before and after its point";
    if (std::ranges::count(word, '.') > 1) return "a number has one point";
    const auto digits = digits_of(word);
    if (digits == word.size())
        return is_zero_first(word) ? "a number does not begin with a zero"
                                   : "a whole number is at most 9223372036854775807 in size";
    if (digits == 0) return "a number has digits after its sign";
    if (word[digits] == '\'' || word[digits] == '_')
        return "write the digits of a number without a sign between them";
    if (is_one_of(word.substr(word.size() - 1), {"e"})) return "a number has digits after its 'e'";
    const auto end = word.find_first_not_of("0123456789.", digits);
    if (end != word.npos && is_exponent(word.substr(end))) return "a number is below 1.8e308 in size";
    if (end == word.npos || word[end] == '-') return "";
    return text("a number has no unit: write ", shown(word.substr(0, end)));
}

/// Advice on mending a value that begins with a digit, a sign or a point.
std::string hint_of_numbers(std::string_view value) {
    if (const auto number = with_point(value); !number.empty()) {
        const auto comma = value.find(',');
        if (value.size() - comma != 4)
            return text("a number has a point, not a comma: write ", shown(number));
        return text("a number has no comma: write ",
                    shown(text(value.substr(0, comma), value.substr(comma + 1))), " or ", shown(number));
    }
    if (value.ends_with(']')) return text("a list begins with '[': [", shown(value));
    if (value.ends_with(',') || value.ends_with(';'))
        return text("leave out the '", value.substr(value.size() - 1), "' at the end");
    const auto end = std::min(value.find_first_of(" \t,;"), value.size());
    const auto remaining = trimmed(value.substr(end));
    const auto number = value.substr(0, end);
    return remaining.empty() || remaining[0] == '#' ? hint_of_number(number)
                                                    : hint_after_number(number, remaining);
}

/// Advice on mending a value that begins with a quote.
std::string hint_of_text(std::string_view value, std::string_view parsers_words) {
    const auto end = value.find(value[0], 1);
    if (end == value.npos) return "a quote is not closed";
    const bool is_escape = parsers_words.find("escape sequence") != parsers_words.npos ||
                           parsers_words.find("unicode scalar") != parsers_words.npos;
    if (is_escape) return "a text in \"...\" has \\\\ for each backslash; in '...' it stands as it is";
    const auto remaining = trimmed(value.substr(end + 1));
    if (remaining.empty()) return "";
    if (remaining == "," || remaining == ";") return text("leave out the '", remaining, "' at the end");
    if (begins_other_comment(remaining)) return std::string(comment_words);
    return "after a text only a comment may stand, which begins with '#'; a quote within \"...\" is written "
           "\\\"";
}

std::string hint_of_list(std::string_view value) {
    const auto words = bare(value);
    const auto letter = std::ranges::find_if(words, is_letter);
    const auto remaining = std::string_view(words).substr(static_cast<std::size_t>(letter - words.begin()));
    const bool in_number = letter != words.end() && letter != words.begin() && is_digit(*(letter - 1));
    if (in_number) return "a number in a list has no unit";
    if (!remaining.empty() && !begins_with_one_of(remaining, {"true", "false", "inf", "nan"}))
        return "a text in a list stands in quotes";
    return std::string(list_words);
}

/// Advice on mending a value that begins with a letter.
std::string hint_of_word(std::string_view value) {
    if (is_one_of(value, {"true", "false", "yes", "no", "on", "off", "ture", "flase", "fasle", "treu"}))
        return "write true or false";
    if (is_one_of(value, {"null", "nil", "undefined"}))
        return text("there is no '", shown(value), "': write a value, or leave out the line");
    if (value.ends_with('"') || value.ends_with('\'')) value.remove_suffix(1);
    return text("'", shown(value), "' is no number, and a text stands in quotes: \"", shown(value), "\"");
}

std::string hint_of_value(std::string_view value, std::string_view parsers_words) {
    if (value.empty()) return "a value is missing after '='";
    if (value[0] == '=' || value[0] == '>') return "one '=' stands between a key and its value";
    if (value[0] == '"' || value[0] == '\'') return hint_of_text(value, parsers_words);
    if (value[0] == '(') return "a list stands in [ ], not in ( )";
    if (value[0] == '{')
        return value.find('=') == value.npos
                   ? "a list stands in [ ], not in { }"
                   : "a table in one line is { a = 1, b = 2 }, without a comma at its end";
    if (value[0] == '[') return hint_of_list(value);
    if (is_digit(value[0]) || (value.size() > 1 && (value[0] == '-' || value[0] == '+' || value[0] == '.')))
        return hint_of_numbers(value);
    return is_letter(value[0]) ? hint_of_word(value) : "";
}

/// Advice on mending a line without '='.
std::string hint_without_equals(std::string_view words) {
    const auto colon = words.find(':');
    const auto blank = words.find_first_of(blanks);
    if (colon != words.npos && trimmed(words.substr(0, colon)).find_first_of(blanks) == words.npos)
        return "write '=' in place of ':'";
    const auto second = blank == words.npos ? std::string_view() : trimmed(words.substr(blank));
    const auto key = words.substr(0, blank);
    const bool is_value = !second.empty() && (is_digit(second[0]) || second[0] == '"' || second[0] == '[' ||
                                              is_one_of(second, {"true", "false"}));
    if (is_value && is_letter(key[0])) return text("'=' is missing: write ", shown(text(key, " = ", second)));
    return "a line is KEY = VALUE, a table [name], or a comment, which begins with '#'";
}

std::string hint_of_key(std::string_view key) {
    if (key.empty()) return "a key is missing before '='";
    if (key.ends_with(':')) return "write '=' in place of ':='";
    if (std::ranges::count(key, '"') % 2 == 1) return "a quote is not closed";
    const bool is_quoted = key[0] == '"' || key[0] == '\'';
    if (is_quoted) return "";
    if (key.find_first_of(blanks) != key.npos) return "a key has no blanks";
    const auto is_plain = [](char c) {
        return is_letter(c) || is_digit(c) || c == '_' || c == '-' || c == '.';
    };
    return std::ranges::all_of(key, is_plain) ? "" : "a key has only letters a-z, digits, '_' and '-'";
}

/// Advice on mending a line, if its fault can be seen without the lines before it; else empty.
std::string hint_of_line(std::string_view line, std::string_view parsers_words) {
    if (line.find('\r') < line.size() - 1) return "end lines with a line feed";
    if (begins_with_one_of(line, {"<<<<<<<", "=======", ">>>>>>>", "|||||||"}))
        return "a mark of two versions that were not merged: keep one of them, and delete the marks";
    if (auto hint = hint_of_characters(line); !hint.empty()) return hint;
    const auto words = trimmed(without_comment(line));
    if (words.empty()) return "";
    if (begins_other_comment(words)) return std::string(comment_words);
    const auto equals = words.find('=');
    if (words[0] == '[')
        return equals == words.npos ? "a table is [name], a list [[name]], and a name has no blanks" : "";
    if (equals == words.npos) return hint_without_equals(words);
    const auto key = trimmed(words.substr(0, equals));
    if (auto hint = hint_of_key(key); !hint.empty()) return hint;
    const auto value = trimmed(words.substr(equals + 1));
    const auto comment = trimmed(line.substr(std::min(line.find('#'), line.size())));
    if (value.empty() && parse_colour(comment.substr(0, 7)))
        return text("a colour stands in quotes: \"", comment.substr(0, 7), "\"");
    return hint_of_value(value, parsers_words);
}

/// Calls act(number, line) for the lines before `end`, counted from 1.
template <class Act>
void for_lines_before(std::string_view source, std::size_t end, Act act) {
    for (std::size_t number = 1; number < end && !source.empty(); ++number) {
        const auto length = std::min(source.find('\n'), source.size());
        act(number, source.substr(0, length));
        source.remove_prefix(std::min(length + 1, source.size()));
    }
}

/// Number of the line in which a list begins whose bracket is not closed before the line `end`; 0: none.
std::size_t open_list_before(std::string_view source, std::size_t end) {
    std::ptrdiff_t open = 0;
    std::size_t first = 0;
    for_lines_before(source, end, [&](std::size_t number, std::string_view line) {
        auto words = bare(line);
        if (open <= 0) {
            const auto equals = words.find('=');
            words.erase(0, equals == words.npos ? words.size() : equals);
            open = 0;
            first = number;
        }
        open += std::ranges::count(words, '[') - std::ranges::count(words, ']');
    });
    return open > 0 ? first : 0;
}

/// Name in a table header: "look.wand" of "[[look.wand]]"; empty for any other line.
std::string_view table_name(std::string_view line) {
    auto words = trimmed(without_comment(line));
    if (!words.starts_with('[') || !words.ends_with(']')) return {};
    words.remove_prefix(words.starts_with("[[") ? 2 : 1);
    return trimmed(words.substr(0, words.find(']')));
}

std::string_view key_of(std::string_view line) {
    const auto words = without_comment(line);
    const auto equals = words.find('=');
    return equals == words.npos ? std::string_view() : trimmed(words.substr(0, equals));
}

/// Advice on mending a table or key that is defined twice. The words are empty if the first definition is not
/// found.
TomlSlip second_of_name(std::string_view source, std::size_t line) {
    const auto here = trimmed(line_of(source, line));
    const auto name = table_name(here), key = key_of(here);
    std::size_t first = 0;
    bool is_list = false;
    for_lines_before(source, line, [&](std::size_t number, std::string_view other) {
        // A table begins here, so a key of this name that was found before belongs to another table.
        if (name.empty() && !table_name(other).empty()) first = 0;
        if (first != 0 || (name.empty() ? key_of(other) != key : table_name(other) != name)) return;
        first = number;
        is_list = trimmed(other).starts_with("[[");
    });
    if (first == 0) return {};
    if (name.empty()) return {line, text("'", shown(key), "' is there twice, first in line ", first)};
    if (is_list == here.starts_with("[["))
        return {line, text("[", shown(name), "] is there twice, first in line ", first)};
    const auto single = is_list ? line : first, other = is_list ? first : line;
    return {single, text("[", shown(name), "] here and [[", shown(name), "]] in line ", other,
                         ": each entry of a list begins with [[", shown(name), "]]")};
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

TomlSlip toml_slip(std::string_view source, std::size_t line, std::string_view parsers_words) {
    if (source.starts_with("\xff\xfe") || source.starts_with("\xfe\xff") || source.find('\0') != source.npos)
        return {line, "the file is no text in UTF-8: save it as UTF-8"};
    if (parsers_words.find("utf-8") != parsers_words.npos)
        return {line, "a character is not UTF-8: save the file as UTF-8"};
    if (const auto first = source.find_first_not_of(" \t\r\n"); first != source.npos && source[first] == '{')
        return {line,
                "this is JSON or the like: a data file is TOML, with a line KEY = VALUE for each value"};
    const auto here = line_of(source, line);
    if (parsers_words.find("redefine") != parsers_words.npos) {
        auto slip = second_of_name(source, line);
        return slip.words.empty() ? TomlSlip{line, text(parsers_words, "; it is there twice")}
                                  : std::move(slip);
    }
    if (const auto first = open_list_before(source, line); first != 0) {
        const bool is_next = trimmed(here).empty() || !key_of(here).empty() ||
                             (!table_name(here).empty() && is_letter(table_name(here)[0]));
        return is_next ? TomlSlip{first, "a list is not closed: ']' is missing"}
                       : TomlSlip{line, hint_of_list(here)};
    }
    auto hint = hint_of_line(here, parsers_words);
    return {line, hint.empty() ? std::string(parsers_words) : std::move(hint)};
}

std::string number_hint(std::string_view words) {
    const auto plain = trimmed(words);
    if (const auto number = with_point(plain); !number.empty()) return text("; write ", shown(number));
    const auto whole = digits_of(plain);
    if (whole == 0) return "";
    auto remaining = plain.substr(whole);
    if (remaining.starts_with('.')) remaining = remaining.substr(1 + digits_of(remaining.substr(1)));
    if (remaining.empty()) return text("; write ", shown(plain), " without quotes");
    const auto number = plain.substr(0, plain.size() - remaining.size());
    constexpr std::size_t longest_unit = 8;
    const bool is_unit = trimmed(remaining).size() <= longest_unit &&
                         remaining.find_first_of("0123456789.,") == remaining.npos;
    return is_unit ? text("; write ", shown(number), " without quotes and unit") : "";
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
