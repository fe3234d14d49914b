#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <map>
#include <mutex>
#include <vector>

#include "core/assert.h"
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

/// Names, separated by spaces, of the keys with codes from `first` to `last`.
struct KeyRun {
    int first, last;
    std::string_view names;
};

constexpr KeyRun runs[] = {
    {GLFW_KEY_A, GLFW_KEY_Z, "A B C D E F G H I J K L M N O P Q R S T U V W X Y Z"},
    {GLFW_KEY_0, GLFW_KEY_9, "0 1 2 3 4 5 6 7 8 9"},
    {GLFW_KEY_SPACE, GLFW_KEY_SPACE, "Space"},
    {GLFW_KEY_ESCAPE, GLFW_KEY_END,
     "Esc Enter Tab Backspace Insert Delete Right Left Down Up PageUp PageDown Home End"},
    {GLFW_KEY_CAPS_LOCK, GLFW_KEY_PAUSE, "CapsLock ScrollLock NumLock PrintScreen Pause"},
    {GLFW_KEY_LEFT_SHIFT, GLFW_KEY_MENU,
     "LeftShift LeftCtrl LeftAlt LeftSuper RightShift RightCtrl RightAlt RightSuper Menu"},
    {GLFW_KEY_APOSTROPHE, GLFW_KEY_APOSTROPHE, "Apostrophe"},
    {GLFW_KEY_COMMA, GLFW_KEY_SLASH, "Comma Minus Period Slash"},
    {GLFW_KEY_SEMICOLON, GLFW_KEY_SEMICOLON, "Semicolon"},
    {GLFW_KEY_EQUAL, GLFW_KEY_EQUAL, "Equal"},
    {GLFW_KEY_LEFT_BRACKET, GLFW_KEY_RIGHT_BRACKET, "LeftBracket Backslash RightBracket"},
    {GLFW_KEY_GRAVE_ACCENT, GLFW_KEY_GRAVE_ACCENT, "Grave"},
    {GLFW_KEY_WORLD_1, GLFW_KEY_WORLD_2, "World1 World2"},
    {GLFW_KEY_F1, GLFW_KEY_F12, "F1 F2 F3 F4 F5 F6 F7 F8 F9 F10 F11 F12"},
    {GLFW_KEY_KP_0, GLFW_KEY_KP_EQUAL,
     "KP_0 KP_1 KP_2 KP_3 KP_4 KP_5 KP_6 KP_7 KP_8 KP_9 KP_Decimal KP_Divide KP_Multiply KP_Subtract KP_Add "
     "KP_Enter KP_Equal"},
};

std::vector<Key> named_keys() {
    std::vector<Key> all;
    for (auto [code, last, names] : runs) {
        for (; !names.empty(); ++code) {
            const auto name = names.substr(0, names.find(' '));
            all.push_back({code, name});
            names.remove_prefix(std::min(name.size() + 1, names.size()));
        }
        THAUM_ASSERT(code == last + 1, "a run of keys has as many names as codes");
    }
    return all;
}

const std::vector<Key>& keys() {
    static const auto all = named_keys();
    return all;
}

/// A sign of ASCII, with the name that its key has on a US keyboard.
struct Sign {
    char32_t character;
    std::string_view name;
};
constexpr Sign signs[] = {{U'\'', "Apostrophe"}, {U',', "Comma"},       {U'-', "Minus"},
                          {U'.', "Period"},      {U'/', "Slash"},       {U';', "Semicolon"},
                          {U'=', "Equal"},       {U'[', "LeftBracket"}, {U']', "RightBracket"},
                          {U'\\', "Backslash"},  {U'`', "Grave"}};

/// Characters of the current layout that differ from a US keyboard's, by key code.
struct LayoutLabels {
    std::mutex mutex;  // guards the member by_key
    std::map<int, std::string> by_key;
};

LayoutLabels& layout_labels() {
    static LayoutLabels labels;
    return labels;
}

bool has_letter(int code) {
    return code > GLFW_KEY_SPACE && code <= GLFW_KEY_WORLD_2 && !(code >= GLFW_KEY_0 && code <= GLFW_KEY_9);
}

/// Label for the character that GLFW reports for a key; empty: the key's own name is used.
std::string label_of(std::string_view character) {
    const auto code_points = decode_utf8(character);
    if (code_points.size() != 1) return {};
    const char32_t c = code_points[0];
    if (c <= U' ' || c == U'\u00A0') return {};
    // Punctuation of ASCII gets a name, such as "Comma", which players recognise more easily.
    const auto* const sign = std::ranges::find(signs, c, &Sign::character);
    if (sign != std::end(signs)) return std::string(sign->name);
    return encode_utf8(upper_case(c));
}

}  // namespace

void read_key_labels() {
    std::map<int, std::string> by_key;
    for (const Key& key : keys()) {
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
    const auto* const sign = std::ranges::find(signs, label, &Sign::name);
    return sign == std::end(signs) ? label : encode_utf8(sign->character);
}

std::string_view key_name(int code) {
    const auto found = std::ranges::find(keys(), code, &Key::code);
    return found == keys().end() ? std::string_view{} : found->name;
}

std::optional<int> key_code(std::string_view name) {
    const auto found = std::ranges::find_if(keys(), [&](const Key& k) { return same_word(k.name, name); });
    if (found == keys().end()) return std::nullopt;
    return found->code;
}

}  // namespace thaum::render
