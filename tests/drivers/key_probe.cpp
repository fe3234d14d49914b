// Opens a window and prints the labels of keys in the keyboard layout, one line for each key: its name, its
// label ("Comma") and its sign (","):
//
//     key_probe NAME...
#include <cstdio>
#include <string_view>
#include <vector>

#include "render/context.h"

int main(int count, char** words) {
    using namespace thaum;
    const auto window = render::Window::create({.title = "keys", .size = {64, 64}});
    if (!window) {
        std::printf("%s\n", window.error().message.c_str());
        return 1;
    }
    for (const std::string_view name : std::vector<std::string_view>(words + 1, words + count)) {
        const int code = render::key_code(name).value_or(-1);
        std::printf("%s %s %s\n", name.data(), render::key_label(code).c_str(),
                    render::key_sign(code).c_str());
    }
    return 0;
}
