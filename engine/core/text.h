// core/text.h: builds one line of text. It never uses a locale, so every machine produces the same bytes.
#pragma once
#include <concepts>
#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>

namespace thaum {

/// One part of a line of text: words, a character, a truth value or a number. Words must outlive
/// the part. Integers are written in decimal, and floating-point numbers in the shortest form
/// that reads back to the same value.
class TextPart {
public:
    template <class Words>
    requires std::convertible_to<const Words&, std::string_view> TextPart(const Words& words)
        : kind_(Kind::words), words_(words) {}
    TextPart(char c) : kind_(Kind::character), character_(c) {}
    // std::same_as, because a plain bool parameter would accept pointers, too.
    TextPart(std::same_as<bool> auto truth) : kind_(Kind::words), words_(truth ? "true" : "false") {}
    template <std::signed_integral Integer>
    TextPart(Integer value) : kind_(Kind::integer), integer_(value) {}
    template <std::unsigned_integral Integer>
    requires(!std::same_as<Integer, bool>) TextPart(Integer value)
        : kind_(Kind::unsigned_integer), unsigned_(value) {}
    TextPart(float value) : kind_(Kind::single), single_(value) {}
    TextPart(double value) : kind_(Kind::number), number_(value) {}

    /// Appends the part as text.
    void append_to(std::string& out) const;

private:
    enum class Kind : std::uint8_t { words, character, integer, unsigned_integer, single, number };
    Kind kind_;
    union {
        std::string_view words_;
        char character_;
        std::int64_t integer_;
        std::uint64_t unsigned_;
        float single_;
        double number_;
    };
};

/// Appends one part as text.
inline void append_text(std::string& out, const TextPart& part) { part.append_to(out); }

/// Returns the text of all parts, one after the other.
std::string joined_text(std::initializer_list<TextPart> parts);

/// text("tick ", 12, " differs") -> "tick 12 differs". The work is done by joined_text, which is compiled
/// only once, whereas this template is compiled for each of many combinations of types.
template <class... Parts>
inline std::string text(const Parts&... parts) {
    return joined_text({TextPart(parts)...});
}

/// Formats `value` with `digits` (0 to 60) decimal places: fixed(1.25, 1) -> "1.2".
std::string fixed(double value, int digits);

/// Formats a time in minutes and seconds: clock_text(245) -> "4:05".
std::string clock_text(unsigned long long seconds);

/// Formats `value` as 16 lower-case hexadecimal digits.
std::string hex(unsigned long long value);

/// A name with a capital as its first letter, if that letter is one of a to z.
std::string capitalised(std::string_view name);

}  // namespace thaum
