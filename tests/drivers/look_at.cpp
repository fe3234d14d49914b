// Prints what the X server named by DISPLAY shows. Tests that wait for a change of the screen run this
// program repeatedly: it takes a few milliseconds of processor time, ImageMagick or xdotool several times as
// much.
//
//     look_at title         the title of the first window whose title begins with "Thaum"; none: nothing
//     look_at colours AREA  the number of different colours
//     look_at pixels AREA   the colour of each pixel, #RRGGBB, rows from the top
//     look_at mean AREA     the mean colour, #RRGGBB
//
// AREA is WIDTHxHEIGHT+X+Y, in pixels of the whole screen, which has 24 bits of colour. The library comes
// with xdotool, which tests need anyway, but without headers, so it is loaded at run time.
#include <dlfcn.h>

#include <array>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <set>
#include <string_view>
#include <vector>

namespace {

struct Display;
using Window = unsigned long;

/// The beginning of Xlib's XImage, since Xlib's headers need not be installed.
struct Image {
    int width, height, offset, format;
    unsigned char* data;
    int byte_order, unit, bit_order, pad, depth, bytes_per_line, bits_per_pixel;
};

template <class F>
F* x11(const char* name) {
    static auto* library = ::dlopen("libX11.so.6", RTLD_NOW);
    auto* found = library == nullptr ? nullptr : ::dlsym(library, name);
    if (found == nullptr) {
        std::fprintf(stderr, "look_at: no %s in libX11.so.6\n", name);
        std::exit(77);
    }
    return reinterpret_cast<F*>(found);
}

/// Prints the title of the game's window. Without a window manager, the windows of programs are direct
/// children of the root window.
void print_title(Display* display, Window root) {
    auto* tree = x11<int(Display*, Window, Window*, Window*, Window**, unsigned*)>("XQueryTree");
    auto* property = x11<int(Display*, Window, unsigned long, long, long, int, unsigned long, unsigned long*,
                             int*, unsigned long*, unsigned long*, unsigned char**)>("XGetWindowProperty");
    const auto name =
        x11<unsigned long(Display*, const char*, int)>("XInternAtom")(display, "_NET_WM_NAME", 0);
    Window parent = 0, *windows = nullptr;
    unsigned count = 0;
    if (tree(display, root, &root, &parent, &windows, &count) == 0) return;
    for (unsigned i = 0; i < count; ++i) {
        unsigned long type = 0, items = 0, left = 0;
        int format = 0;
        unsigned char* title = nullptr;
        if (property(display, windows[i], name, 0, 256, 0, 0, &type, &format, &items, &left, &title) != 0)
            continue;
        const std::string_view words(title == nullptr ? "" : reinterpret_cast<const char*>(title));
        if (!words.starts_with("Thaum")) continue;
        std::puts(words.data());
        return;
    }
}

/// The colours of an area, 0xRRGGBB, rows from the top; none if it is no area of the screen.
std::vector<std::uint32_t> colours_of(Display* display, Window root, const char* area) {
    unsigned width = 0, height = 0;
    int x = 0, y = 0;
    if (std::sscanf(area, "%ux%u+%d+%d", &width, &height, &x, &y) != 4) return {};
    auto* take = x11<Image*(Display*, Window, int, int, unsigned, unsigned, unsigned long, int)>("XGetImage");
    constexpr int z_pixmap = 2;
    const auto* image = take(display, root, x, y, width, height, ~0UL, z_pixmap);
    if (image == nullptr || image->bits_per_pixel != 32) return {};
    std::vector<std::uint32_t> colours;
    for (int row = 0; row < image->height; ++row) {
        const auto* at = image->data + static_cast<std::ptrdiff_t>(row) * image->bytes_per_line;
        for (int i = 0; i < image->width; ++i) {
            std::uint32_t colour = 0;
            std::memcpy(&colour, at + 4 * static_cast<std::ptrdiff_t>(i), sizeof colour);
            colours.push_back(colour & 0xFFFFFFU);
        }
    }
    return colours;
}

std::uint32_t mean_of(const std::vector<std::uint32_t>& colours) {
    std::uint32_t mean = 0;
    for (const unsigned shift : {0U, 8U, 16U}) {
        std::uint64_t sum = 0;
        for (const auto colour : colours) sum += (colour >> shift) & 0xFFU;
        mean |= static_cast<std::uint32_t>((sum + colours.size() / 2) / colours.size()) << shift;
    }
    return mean;
}

}  // namespace

int main(int argc, char** argv) {
    const std::string_view what = argc > 1 ? argv[1] : "";
    auto* display = x11<Display*(const char*)>("XOpenDisplay")(nullptr);
    if (display == nullptr) return std::fprintf(stderr, "look_at: no display\n"), 1;
    const auto root = x11<Window(Display*)>("XDefaultRootWindow")(display);
    if (what == "title") return print_title(display, root), 0;
    const auto colours = colours_of(display, root, argc > 2 ? argv[2] : "");
    if (colours.empty()) return std::fprintf(stderr, "look_at: no such area of the screen\n"), 1;
    if (what == "colours")
        std::printf("%zu\n", std::set(colours.begin(), colours.end()).size());
    else if (what == "pixels")
        for (const auto colour : colours) std::printf("#%06X\n", colour);
    else if (what == "mean")
        std::printf("#%06X\n", mean_of(colours));
    else
        return 2;
    return 0;
}
