#include "core/parse.h"

#include <charconv>
#include <type_traits>

#include "core/text.h"

namespace thaum {
namespace {

template <class T>
Expected<T> parse_value(std::string_view word, std::string_view what, T low, T high) {
    T value{};
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    const bool whole_word = error == std::errc{} && end == word.data() + word.size();
    if (whole_word && value >= low && value <= high) return value;
    const bool in_digits = !std::is_integral_v<T> || whole_word;
    return fail(text(what, " '", word, "': must be a number from ", low, " to ", high,
                     in_digits ? "" : ", in digits alone"));
}

}  // namespace

Expected<std::uint64_t> parse_whole(std::string_view word, std::string_view what, std::uint64_t low,
                                    std::uint64_t high) {
    return parse_value<std::uint64_t>(word, what, low, high);
}

Expected<double> parse_number(std::string_view word, std::string_view what, double low, double high) {
    return parse_value<double>(word, what, low, high);
}

}  // namespace thaum
