// core/detail/toml_hint.h: examines the text of a TOML file. Before parsing it finds keys that nest so deeply
// that the parser could exhaust the stack; after a failure it explains common mistakes.
#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace thaum::detail {

/// Most dots in one line, decimal points not counted. toml++ destroys nested tables recursively, and a key
/// such as a.a.a... nests one table per dot.
inline constexpr std::size_t max_dots = 200;

/// Number of the first line with more than max_dots dots, counted from 1; 0 if there is none.
std::size_t overdotted_line(std::string_view source);

/// The place and a description of a fault in a text that is not TOML.
struct TomlSlip {
    std::size_t line{};  ///< line to mend, counted from 1
    std::string words;   ///< what is wrong there, and what to write instead if that is clear
};

/// Explains why a file is not TOML. `line` and `parsers_words` are the parser's own error, returned if no
/// common mistake is found.
TomlSlip toml_slip(std::string_view source, std::size_t line, std::string_view parsers_words);

/// The colour "#RRGGBB" as 0xRRGGBB; std::nullopt for another text.
std::optional<std::uint32_t> parse_colour(std::string_view words);

/// Advice for a text where a number is expected, such as "; write 1.5". Empty if the text is no number.
std::string number_hint(std::string_view words);

}  // namespace thaum::detail
