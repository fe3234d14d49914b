#include "game/app/sound_picture.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "audio/analysis.h"
#include "core/text.h"
#include "core/utf8.h"

namespace thaum::game::inline app {
namespace {

struct Colour {
    double red, green, blue;
};

struct Box {
    int x, y, width, height;
};

constexpr Colour paper{18, 18, 24}, ink{225, 222, 214}, dim{120, 118, 126}, wave{110, 190, 240},
    line{52, 52, 62};
/// Colours of a spectrogram, from silence to its loudest point.
constexpr std::array<Colour, 5> heat{
    {{8, 8, 14}, {52, 20, 92}, {170, 44, 96}, {242, 130, 48}, {252, 246, 190}}};
constexpr double shown_db = 60;  // range of levels that the colours show (dB)

render::Image blank(int width, int height) {
    render::Image image{width, height, {}};
    image.rgb.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 3);
    return image;
}

void put(render::Image& image, int x, int y, Colour colour, double share = 1) {
    if (x < 0 || y < 0 || x >= image.width || y >= image.height) return;
    const auto at =
        (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(x)) *
        3;
    const std::array<double, 3> wanted{colour.red, colour.green, colour.blue};
    for (std::size_t i = 0; i < 3; ++i)
        image.rgb[at + i] = static_cast<std::uint8_t>(image.rgb[at + i] * (1 - share) + wanted[i] * share);
}

void fill(render::Image& image, Box box, Colour colour) {
    for (int y = box.y; y < box.y + box.height; ++y)
        for (int x = box.x; x < box.x + box.width; ++x) put(image, x, y, colour);
}

void write(render::Image& image, render::Font& font, int x, int y, int size, std::string_view words,
           Colour colour) {
    const auto laid = font.lay_out(render::lines_of(words).front(), size);
    for (const auto& placed : laid.glyphs) {
        const auto& glyph = font.glyph(placed.character, size);
        for (int row = 0; row < glyph.height; ++row)
            for (int column = 0; column < glyph.width; ++column)
                put(image, x + placed.x + column, y + placed.y + row, colour,
                    glyph.coverage[static_cast<std::size_t>(row) * static_cast<std::size_t>(glyph.width) +
                                   static_cast<std::size_t>(column)] /
                        255.0);
    }
}

Colour heat_at(double share) {
    const double at = std::clamp(share, 0.0, 1.0) * (heat.size() - 1);
    const auto low = std::min(static_cast<std::size_t>(at), heat.size() - 2);
    const double part = at - static_cast<double>(low);
    const auto mix = [part](double a, double b) { return a + (b - a) * part; };
    return {mix(heat[low].red, heat[low + 1].red), mix(heat[low].green, heat[low + 1].green),
            mix(heat[low].blue, heat[low + 1].blue)};
}

/// Draws the waveform: in each pixel column a line over the range of its samples.
void draw_waveform(render::Image& image, Box box, const std::vector<float>& samples) {
    fill(image, {box.x, box.y + box.height / 2, box.width, 1}, line);
    for (int x = 0; x < box.width; ++x) {
        const auto from = samples.size() * static_cast<std::size_t>(x) / static_cast<std::size_t>(box.width);
        const auto to =
            samples.size() * static_cast<std::size_t>(x + 1) / static_cast<std::size_t>(box.width);
        if (from >= to) continue;
        const auto [low, high] = std::minmax_element(samples.begin() + static_cast<std::ptrdiff_t>(from),
                                                     samples.begin() + static_cast<std::ptrdiff_t>(to));
        const auto row = [&](float sample) {
            return box.y + static_cast<int>((1 - static_cast<double>(sample)) / 2 * (box.height - 1));
        };
        fill(image, {box.x + x, row(*high), 1, row(*low) - row(*high) + 1}, wave);
    }
}

void draw_spectrogram(render::Image& image, Box box, const std::vector<float>& samples) {
    const auto shown = audio::spectrogram_of(samples, static_cast<std::size_t>(box.width),
                                             static_cast<std::size_t>(box.height));
    const double loudest = std::max(1e-20, *std::max_element(shown.power.begin(), shown.power.end()));
    for (int x = 0; x < box.width; ++x) {
        for (int y = 0; y < box.height; ++y) {
            const double power =
                shown.at(static_cast<std::size_t>(x), static_cast<std::size_t>(box.height - 1 - y));
            const double db = 10 * std::log10(std::max(power / loudest, 1e-12));
            put(image, box.x + x, box.y + y, heat_at(1 + db / shown_db));
        }
    }
}

void draw_frequencies(render::Image& image, Box box, render::Font& font, int size) {
    for (const auto& [hz, label] :
         {std::pair{100.0, "100 Hz"}, std::pair{1000.0, "1 kHz"}, std::pair{10000.0, "10 kHz"}}) {
        const double share =
            std::log(hz / audio::lowest_row_hz) / std::log(audio::highest_row_hz / audio::lowest_row_hz);
        const int y = box.y + static_cast<int>((1 - share) * box.height);
        for (int x = box.x; x < box.x + box.width; x += 6) put(image, x, y, dim, 0.7);
        write(image, font, box.x + 4, y - size - 4, size, label, dim);
    }
}

std::string title_of(const audio::Sound& sound) {
    const double seconds = static_cast<double>(sound.samples.size()) / audio::sample_rate;
    return text(sound.name, "  ", fixed(seconds, 2), " s", sound.loops ? ", loops" : "");
}

/// Title of a sound, with name and length, that fits one cell of the picture of many sounds.
std::string short_title_of(const audio::Sound& sound) {
    const double seconds = static_cast<double>(sound.samples.size()) / audio::sample_rate;
    return text(sound.name, " ", fixed(seconds, 2), sound.loops ? "~" : "");
}

}  // namespace

render::Image draw_sound(const audio::Sound& sound, render::Font& font) {
    constexpr int width = 640, margin = 12;
    auto image = blank(width, 440);
    fill(image, {0, 0, image.width, image.height}, paper);
    write(image, font, margin, 8, 16, title_of(sound), ink);
    write(image, font, margin, 30, 12, sound.description, dim);
    draw_waveform(image, {margin, 54, width - 2 * margin, 120}, sound.samples);
    const Box spectrum{margin, 184, width - 2 * margin, 244};
    draw_spectrogram(image, spectrum, sound.samples);
    draw_frequencies(image, spectrum, font, 10);
    return image;
}

render::Image draw_sounds(std::span<const audio::Sound* const> sounds, render::Font& font) {
    constexpr int across = 9, width = 150, height = 150, gap = 8, label = 18;
    const int down = (static_cast<int>(sounds.size()) + across - 1) / across;
    auto image = blank(gap + across * (width + gap), gap + down * (height + label + gap));
    fill(image, {0, 0, image.width, image.height}, paper);
    for (std::size_t i = 0; i < sounds.size(); ++i) {
        const int x = gap + static_cast<int>(i) % across * (width + gap);
        const int y = gap + static_cast<int>(i) / across * (height + label + gap);
        write(image, font, x, y, 10, short_title_of(*sounds[i]), ink);
        draw_waveform(image, {x, y + label, width, 40}, sounds[i]->samples);
        draw_spectrogram(image, {x, y + label + 42, width, height - 42}, sounds[i]->samples);
    }
    return image;
}

}  // namespace thaum::game::inline app
