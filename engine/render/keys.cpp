#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <map>
#include <mutex>

#include "core/letters.h"
#include "core/utf8.h"
#include "render/context.h"
#include "render/detail/key_labels.h"

namespace thaum::render {
namespace {

struct Key {
    int code;
    std::string_view name;
};

constexpr Key keys[] = {
    {GLFW_KEY_A, "A"},
    {GLFW_KEY_B, "B"},
    {GLFW_KEY_C, "C"},
    {GLFW_KEY_D, "D"},
    {GLFW_KEY_E, "E"},
    {GLFW_KEY_F, "F"},
    {GLFW_KEY_G, "G"},
    {GLFW_KEY_H, "H"},
    {GLFW_KEY_I, "I"},
    {GLFW_KEY_J, "J"},
    {GLFW_KEY_K, "K"},
    {GLFW_KEY_L, "L"},
    {GLFW_KEY_M, "M"},
    {GLFW_KEY_N, "N"},
    {GLFW_KEY_O, "O"},
    {GLFW_KEY_P, "P"},
    {GLFW_KEY_Q, "Q"},
    {GLFW_KEY_R, "R"},
    {GLFW_KEY_S, "S"},
    {GLFW_KEY_T, "T"},
    {GLFW_KEY_U, "U"},
    {GLFW_KEY_V, "V"},
    {GLFW_KEY_W, "W"},
    {GLFW_KEY_X, "X"},
    {GLFW_KEY_Y, "Y"},
    {GLFW_KEY_Z, "Z"},
    {GLFW_KEY_0, "0"},
    {GLFW_KEY_1, "1"},
    {GLFW_KEY_2, "2"},
    {GLFW_KEY_3, "3"},
    {GLFW_KEY_4, "4"},
    {GLFW_KEY_5, "5"},
    {GLFW_KEY_6, "6"},
    {GLFW_KEY_7, "7"},
    {GLFW_KEY_8, "8"},
    {GLFW_KEY_9, "9"},
    {GLFW_KEY_SPACE, "Space"},
    {GLFW_KEY_ESCAPE, "Esc"},
    {GLFW_KEY_ENTER, "Enter"},
    {GLFW_KEY_TAB, "Tab"},
    {GLFW_KEY_BACKSPACE, "Backspace"},
    {GLFW_KEY_INSERT, "Insert"},
    {GLFW_KEY_DELETE, "Delete"},
    {GLFW_KEY_RIGHT, "Right"},
    {GLFW_KEY_LEFT, "Left"},
    {GLFW_KEY_DOWN, "Down"},
    {GLFW_KEY_UP, "Up"},
    {GLFW_KEY_PAGE_UP, "PageUp"},
    {GLFW_KEY_PAGE_DOWN, "PageDown"},
    {GLFW_KEY_HOME, "Home"},
    {GLFW_KEY_END, "End"},
    {GLFW_KEY_CAPS_LOCK, "CapsLock"},
    {GLFW_KEY_SCROLL_LOCK, "ScrollLock"},
    {GLFW_KEY_NUM_LOCK, "NumLock"},
    {GLFW_KEY_PRINT_SCREEN, "PrintScreen"},
    {GLFW_KEY_PAUSE, "Pause"},
    {GLFW_KEY_LEFT_SHIFT, "LeftShift"},
    {GLFW_KEY_LEFT_CONTROL, "LeftCtrl"},
    {GLFW_KEY_LEFT_ALT, "LeftAlt"},
    {GLFW_KEY_LEFT_SUPER, "LeftSuper"},
    {GLFW_KEY_RIGHT_SHIFT, "RightShift"},
    {GLFW_KEY_RIGHT_CONTROL, "RightCtrl"},
    {GLFW_KEY_RIGHT_ALT, "RightAlt"},
    {GLFW_KEY_RIGHT_SUPER, "RightSuper"},
    {GLFW_KEY_MENU, "Menu"},
    {GLFW_KEY_APOSTROPHE, "Apostrophe"},
    {GLFW_KEY_COMMA, "Comma"},
    {GLFW_KEY_MINUS, "Minus"},
    {GLFW_KEY_PERIOD, "Period"},
    {GLFW_KEY_SLASH, "Slash"},
    {GLFW_KEY_SEMICOLON, "Semicolon"},
    {GLFW_KEY_EQUAL, "Equal"},
    {GLFW_KEY_LEFT_BRACKET, "LeftBracket"},
    {GLFW_KEY_BACKSLASH, "Backslash"},
    {GLFW_KEY_RIGHT_BRACKET, "RightBracket"},
    {GLFW_KEY_GRAVE_ACCENT, "Grave"},
    {GLFW_KEY_WORLD_1, "World1"},
    {GLFW_KEY_WORLD_2, "World2"},
    {GLFW_KEY_F1, "F1"},
    {GLFW_KEY_F2, "F2"},
    {GLFW_KEY_F3, "F3"},
    {GLFW_KEY_F4, "F4"},
    {GLFW_KEY_F5, "F5"},
    {GLFW_KEY_F6, "F6"},
    {GLFW_KEY_F7, "F7"},
    {GLFW_KEY_F8, "F8"},
    {GLFW_KEY_F9, "F9"},
    {GLFW_KEY_F10, "F10"},
    {GLFW_KEY_F11, "F11"},
    {GLFW_KEY_F12, "F12"},
    {GLFW_KEY_KP_0, "KP_0"},
    {GLFW_KEY_KP_1, "KP_1"},
    {GLFW_KEY_KP_2, "KP_2"},
    {GLFW_KEY_KP_3, "KP_3"},
    {GLFW_KEY_KP_4, "KP_4"},
    {GLFW_KEY_KP_5, "KP_5"},
    {GLFW_KEY_KP_6, "KP_6"},
    {GLFW_KEY_KP_7, "KP_7"},
    {GLFW_KEY_KP_8, "KP_8"},
    {GLFW_KEY_KP_9, "KP_9"},
    {GLFW_KEY_KP_DECIMAL, "KP_Decimal"},
    {GLFW_KEY_KP_DIVIDE, "KP_Divide"},
    {GLFW_KEY_KP_MULTIPLY, "KP_Multiply"},
    {GLFW_KEY_KP_SUBTRACT, "KP_Subtract"},
    {GLFW_KEY_KP_ADD, "KP_Add"},
    {GLFW_KEY_KP_ENTER, "KP_Enter"},
    {GLFW_KEY_KP_EQUAL, "KP_Equal"},
};

/// Signs of ASCII with the names that their keys have on a US keyboard.
struct Sign {
    char32_t character;
    std::string_view name;
};
constexpr Sign signs[] = {{U'\'', "Apostrophe"}, {U',', "Comma"},       {U'-', "Minus"},
                          {U'.', "Period"},      {U'/', "Slash"},       {U';', "Semicolon"},
                          {U'=', "Equal"},       {U'[', "LeftBracket"}, {U']', "RightBracket"},
                          {U'\\', "Backslash"},  {U'`', "Grave"}};

/// Characters of the layout that differ from a US keyboard's, by the key's code.
struct LayoutLabels {
    std::mutex mutex;  // guards by_key
    std::map<int, std::string> by_key;
};

LayoutLabels& layout_labels() {
    static LayoutLabels labels;
    return labels;
}

bool has_letter(int code) {
    return code > GLFW_KEY_SPACE && code <= GLFW_KEY_WORLD_2 && !(code >= GLFW_KEY_0 && code <= GLFW_KEY_9);
}

/// Label for what GLFW says of a key's character; empty: no other one than the key's name.
std::string label_of(std::string_view character) {
    const auto code_points = decode_utf8(character);
    if (code_points.size() != 1) return {};
    const char32_t c = code_points[0];
    if (c <= U' ' || c == U'\u00A0') return {};
    // Punctuation of ASCII is easier to tell by its name: "Comma".
    const auto sign =
        std::find_if(std::begin(signs), std::end(signs), [&](const Sign& s) { return s.character == c; });
    if (sign != std::end(signs)) return std::string(sign->name);
    return encode_utf8(upper_case(c));
}

}  // namespace

void read_key_labels() {
    std::map<int, std::string> by_key;
    for (const Key& key : keys) {
        if (!has_letter(key.code)) continue;
        const char* const character = glfwGetKeyName(key.code, 0);
        if (character == nullptr) continue;
        if (auto label = label_of(character); !label.empty() && label != key.name)
            by_key.emplace(key.code, std::move(label));
    }
    auto& labels = layout_labels();
    const std::lock_guard lock(labels.mutex);
    labels.by_key = std::move(by_key);
}

std::string key_label(int code) {
    auto& labels = layout_labels();
    const std::lock_guard lock(labels.mutex);
    const auto found = labels.by_key.find(code);
    return found != labels.by_key.end() ? found->second : std::string(key_name(code));
}

std::string key_sign(int code) {
    const auto label = key_label(code);
    const auto* const sign =
        std::find_if(std::begin(signs), std::end(signs), [&](const Sign& s) { return s.name == label; });
    return sign == std::end(signs) ? label : encode_utf8(sign->character);
}

std::string_view key_name(int code) {
    const auto* found =
        std::find_if(std::begin(keys), std::end(keys), [&](const Key& k) { return k.code == code; });
    return found == std::end(keys) ? std::string_view{} : found->name;
}

std::optional<int> key_code(std::string_view name) {
    const auto* found =
        std::find_if(std::begin(keys), std::end(keys), [&](const Key& k) { return same_word(k.name, name); });
    if (found == std::end(keys)) return std::nullopt;
    return found->code;
}

}  // namespace thaum::render
