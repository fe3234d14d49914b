// Draws one moment of a bot duel into a PNG file without a display, and prints the times of each step:
//
//     live_shot OUT.png [TICKS [SPLIT [WIDTH HEIGHT [X Z YAW PITCH [QUALITY [ARENA [Y]]]]]]]
//
// SPLIT: top_bottom, side_by_side, first, second. X Z (m) and YAW PITCH (degrees) move the first camera. Y is
// the height of its feet (m). QUALITY: 0 low, 1 medium (default), 2 high. ARENA: name of an arena's file.
#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <iostream>

#include "core/text.h"
#include "game/bots/bot_file.h"
#include "game/hud/hud.h"
#include "render/context.h"

using namespace thaum;
using namespace thaum::game;

namespace {

/// Processor time of all threads (ms), divided by two to estimate the duration on two cores.
double cpu_ms() { return 0.5e3 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

double now_ms() {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now().time_since_epoch())
        .count();
}

template <class T>
T must(Expected<T> value) {
    if (!value) {
        std::cerr << value.error().message << '\n';
        std::exit(1);
    }
    if constexpr (!std::is_void_v<T>) return std::move(*value);
}

void play(Simulation& match, Tick count) {
    Bots bots;
    const auto skill = must(load_bot_skill(find_assets(), "level_1"));
    for (std::uint32_t p = 0; p < players; ++p) bots.add(match, p, p, skill, 7 + p);
    for (Tick t = 0; t < count; ++t) {
        input::InputFrame frame;
        bots.sample(match, frame);
        match.tick(frame);
    }
}

HudSettings settings_of(std::string_view split) {
    HudSettings s;
    if (split == "side_by_side") s.split = render::Split::side_by_side;
    if (split == "first") s.watch = Watch::first;
    if (split == "second") s.watch = Watch::second;
    return s;
}

/// Moves the first wizard to a position, with a direction of view.
void place_first_wizard(Picture& picture, vec3 centre, double yaw_degrees, double pitch_degrees) {
    auto& p = picture.wizards[0];
    p.vitals.centre = centre;
    p.vitals.eye = p.vitals.centre + vec3(0, 0.75, 0);
    p.vitals.yaw = yaw_degrees * radians_per_degree;
    p.vitals.pitch = pitch_degrees * radians_per_degree;
}

void print_picture_time(const Simulation& match, Picture& picture) {
    const double before = now_ms();
    for (int i = 0; i < 1000; ++i) take_picture(match, picture);
    std::cout << "take_picture " << fixed(now_ms() - before, 2) << " us\n";
}

/// Draws 30 frames, and prints their processor time and the median duration of a frame.
void print_frame_times(render::Renderer& renderer, const std::function<void()>& draw) {
    std::vector<double> times;
    const double cpu = cpu_ms();
    for (int i = 0; i < 30; ++i) {
        const double begin = now_ms();
        draw();
        times.push_back(now_ms() - begin);
    }
    std::cout << "cpu " << fixed((cpu_ms() - cpu) / 30, 1) << " ms\n";
    std::sort(times.begin(), times.end());
    const auto& s = renderer.statistics();
    std::cout << "frame " << fixed(times[15], 1) << " ms, " << s.triangles << " triangles, " << s.draws
              << " draws, " << s.shadow_draws << " for the shadow map, " << s.instances_drawn
              << " instances\n";
}

}  // namespace

int main(int argc, char** argv) {
    const auto number = [&](int i, int otherwise) { return argc > i ? std::atoi(argv[i]) : otherwise; };
    const std::string out = argc > 1 ? argv[1] : "shot.png";
    const render::Size size{number(4, 1280), number(5, 720)};
    const auto data = std::make_shared<const MatchData>(
        must(load_match_data(find_assets(), {.arena = argc > 11 ? argv[11] : "boiling_court"})));
    Simulation match(data, {.seed = 3, .devices = {bot_device(0, "level_1"), bot_device(1, "level_1")}});
    play(match, static_cast<Tick>(number(2, 0)));

    auto context = must(render::Offscreen::create(size.width, size.height));
    context.make_current();
    const double opened = now_ms();
    auto renderer = must(render::Renderer::create(find_assets()));
    const double start = now_ms();
    std::cout << "shaders " << fixed(start - opened, 1) << " ms\n";
    const auto arena_scene = make_arena_scene(renderer, *data);
    std::cout << "arena " << fixed(now_ms() - start, 1) << " ms\n";
    auto picture = make_picture();
    print_picture_time(match, picture);
    if (argc > 9) {
        const vec3 centre(std::atof(argv[6]), 0.9 + number(12, 0), std::atof(argv[7]));
        place_first_wizard(picture, centre, std::atof(argv[8]), std::atof(argv[9]));
    }
    FrameMemory memory;
    auto settings = settings_of(argc > 3 ? argv[3] : "top_bottom");
    settings.quality = static_cast<render::Quality>(std::clamp(number(10, 1), 0, 2));
    const auto draw = [&] { renderer.draw(make_frame(arena_scene, picture, settings, size, memory)); };
    print_frame_times(renderer, [&] {
        draw();
        context.present();
    });
    draw();
    must(render::write_png(out, renderer.read_pixels()));
}
