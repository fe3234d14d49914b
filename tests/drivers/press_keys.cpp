// Presses and releases keys, one after the other, on the X server named by DISPLAY. All requests are sent in
// one write, so that a busy machine cannot delay the release of a key: a held key repeats in a menu, as it
// should, and a test that counts presses would choose the wrong row.
//
//     press_keys KEY...
//
// KEY is the name of an X keysym, such as Down, KP_0 or Q. The libraries come with xdotool, which tests need
// anyway, but without headers, so they are loaded at run time.
#include <dlfcn.h>

#include <cstdio>
#include <cstdlib>

namespace {

struct Display;

/// Time from a release to the next press, by the server's clock (ms). If the time is below 20 ms, GLFW takes
/// the next press for a repetition of a held key.
constexpr unsigned long after_ms = 25;

void* function(const char* library, const char* name) {
    auto* opened = ::dlopen(library, RTLD_NOW);
    auto* found = opened == nullptr ? nullptr : ::dlsym(opened, name);
    if (found != nullptr) return found;
    std::fprintf(stderr, "press_keys: no %s in %s\n", name, library);
    std::exit(77);
}

template <class F>
F* x11(const char* name) {
    return reinterpret_cast<F*>(function("libX11.so.6", name));
}

using KeySym = unsigned long;
using KeyCode = unsigned char;

struct Keyboard {
    Display* display = x11<Display*(const char*)>("XOpenDisplay")(nullptr);
    KeySym (*symbol)(const char*) = x11<KeySym(const char*)>("XStringToKeysym");
    KeyCode (*code)(Display*, KeySym) = x11<KeyCode(Display*, KeySym)>("XKeysymToKeycode");
    KeySym (*symbol_of)(Display*, KeyCode, int) = x11<KeySym(Display*, KeyCode, int)>("XKeycodeToKeysym");
    int (*fake)(Display*, unsigned, int, unsigned long) =
        reinterpret_cast<int (*)(Display*, unsigned, int, unsigned long)>(function("libXtst.so.6",
                                                                                   "XTestFakeKeyEvent"));
    int (*sync)(Display*, int) = x11<int(Display*, int)>("XSync");
};

/// Adds a press and a release to the requests. Returns false for a key that the keyboard does not have.
bool press(const Keyboard& keys, const char* name) {
    const auto symbol = keys.symbol(name);
    const auto code = symbol == 0 ? KeyCode{0} : keys.code(keys.display, symbol);
    if (code == 0) return false;
    const bool shifted = keys.symbol_of(keys.display, code, 0) != symbol;
    const auto shift = keys.code(keys.display, keys.symbol("Shift_L"));
    if (shifted) keys.fake(keys.display, shift, 1, 0);
    keys.fake(keys.display, code, 1, after_ms);
    keys.fake(keys.display, code, 0, 0);
    if (shifted) keys.fake(keys.display, shift, 0, 0);
    return true;
}

}  // namespace

int main(int argc, char** argv) {
    const Keyboard keys;
    if (keys.display == nullptr) return std::fprintf(stderr, "press_keys: no display\n"), 1;
    // Asks the server for all keys before the first press, so that its answers delay none.
    for (int i = 1; i < argc; ++i) keys.code(keys.display, keys.symbol(argv[i]));
    keys.sync(keys.display, 0);
    for (int i = 1; i < argc; ++i)
        if (!press(keys, argv[i])) return std::fprintf(stderr, "press_keys: no key '%s'\n", argv[i]), 1;
    keys.sync(keys.display, 0);
    return 0;
}
