#include "input/pad_mapping.h"

#include <algorithm>
#include <array>

#include "core/letters.h"
#include "core/one_line.h"
#include "core/text.h"

namespace thaum::input {
namespace {

constexpr std::size_t max_of_line_shown = 40;  // longest part of a line that an error quotes (bytes)
constexpr std::size_t model_digits = 32;

/// Names of SDL's controls, without the sign for a side of an axis.
constexpr std::array<std::string_view, 23> controls{
    "a",           "b",           "x",      "y",      "back",     "guide",        "start",
    "leftstick",   "rightstick",  "dpup",   "dpdown", "dpleft",   "dpright",      "leftx",
    "lefty",       "rightx",      "righty", "misc1",  "touchpad", "leftshoulder", "rightshoulder",
    "lefttrigger", "righttrigger"};

bool is_control(std::string_view field) {
    if (field.starts_with('+') || field.starts_with('-')) field.remove_prefix(1);
    return std::ranges::find(controls, field) != controls.end();
}

/// Whether a field describes the whole line, such as its platform, instead of a control.
bool is_remark(std::string_view field) {
    return field == "platform" || field == "crc" || field == "hint" || field == "type" || field == "face" ||
           field.starts_with("sdk");
}

/// Removes a number of one to three digits from the beginning of a word. Returns whether there was one.
bool take_number(std::string_view& word) {
    std::size_t digits = 0;
    while (digits < word.size() && is_digit(word[digits])) ++digits;
    word.remove_prefix(digits);
    return digits > 0 && digits <= 3;
}

/// Whether a word names a part of a joystick: a button ("b3"), a direction of a hat ("h0.4"), or an axis
/// ("a2", one side of it "+a2" or "-a2", inverted "a2~").
bool is_part(std::string_view word) {
    const bool side = word.starts_with('+') || word.starts_with('-');
    if (side) word.remove_prefix(1);
    if (word.empty()) return false;
    const char kind = word.front();
    word.remove_prefix(1);
    if (!take_number(word)) return false;
    if (kind == 'a') return word.empty() || word == "~";
    if (side) return false;
    if (kind == 'b') return word.empty();
    if (kind != 'h' || !word.starts_with('.')) return false;
    word.remove_prefix(1);
    return take_number(word) && word.empty();
}

bool is_model(std::string_view word) {
    return word.size() == model_digits && std::ranges::all_of(word, [](char c) {
               return is_digit(c) || (lower_case(c) >= 'a' && lower_case(c) <= 'f');
           });
}

/// Removes and returns the text up to the next comma from the beginning of a line.
std::string_view take_word(std::string_view& line) {
    const auto end = std::min(line.find(','), line.size());
    const auto word = trimmed(line.substr(0, end));
    line.remove_prefix(std::min(end + 1, line.size()));
    return word;
}

}  // namespace

Expected<PadMapping> read_pad_mapping(std::string_view line) {
    line = trimmed(line);
    PadMapping mapping{.words = std::string(line), .for_linux = true};
    const auto model = take_word(line);
    const bool printable_line =
        std::ranges::none_of(mapping.words, [](char c) { return static_cast<unsigned char>(c) < ' '; });
    if (!is_model(model) || !printable_line)
        return fail(text("'", printable(mapping.words, max_of_line_shown),
                         "' is no mapping of a pad: must be as in SDL's gamecontrollerdb.txt, 32 hexadecimal "
                         "digits, a name and controls such as a:b0, with commas between them"));
    std::ranges::transform(model, std::back_inserter(mapping.model), lower_case);
    take_word(line);  // skips the model's name
    std::size_t mapped = 0;
    while (!line.empty()) {
        const auto element = take_word(line);
        if (element.empty()) continue;
        const auto colon = std::min(element.find(':'), element.size());
        const auto field = element.substr(0, colon),
                   part = element.substr(std::min(colon + 1, element.size()));
        if (field == "platform") mapping.for_linux = same_word(part, "Linux");
        if (is_remark(field)) continue;
        if (!is_part(part))
            return fail(
                text("'", printable(element, max_of_line_shown),
                     "' must be a control and a part of the joystick, such as a:b0, leftx:a0 or dpup:h0.1"));
        if (is_control(field)) ++mapped;
    }
    if (mapped == 0) return fail("maps no control of a pad, such as a:b0 or leftx:a0");
    return mapping;
}

std::string_view model_of_mapping(std::string_view mapping) {
    return trimmed(mapping.substr(0, mapping.find(',')));
}

bool same_pad_controls(std::string_view a, std::string_view b) {
    const auto controls_of = [](std::string_view mapping) {
        take_word(mapping);  // skips the model
        std::string words(take_word(mapping));
        while (!mapping.empty()) {
            const auto element = take_word(mapping);
            if (!element.empty() && !is_remark(element.substr(0, element.find(':'))))
                words += text(",", element);
        }
        return words;
    };
    return controls_of(a) == controls_of(b);
}

}  // namespace thaum::input
