#include "game/app/gesture/stroke_window.h"

#include <algorithm>

#include "core/clock.h"
#include "core/text.h"
#include "game/app/command.h"
#include "game/data/match_data.h"
#include "game/hud/overlay.h"
#include "game/hud/stroke_lines.h"
#include "game/live/end_watch.h"
#include "game/settings/settings.h"
#include "gesture/gesture.h"
#include "render/display.h"
#include "render/renderer.h"
#include "render/with_renderer.h"

namespace thaum::game::inline app {
namespace {

// Longest wait for a window event (s). It is short, so that the hand's motion is sampled often enough.
constexpr double patience_s = 0.002;
constexpr double shown_m = 0.2;  // height of the window in metres of hand motion

/// Arc length of a stroke, without the part that the tremor of a resting hand adds (m).
double way_of(gesture::Points stroke) {
    constexpr double step = 5e-4;  // least distance between counted points, too large for tremor (m)
    double way = 0;
    for (std::size_t i = 1, from = 0; i < stroke.size(); ++i) {
        const double gone = glm::distance(stroke[from].at, stroke[i].at);
        if (gone < step) continue;
        way += gone;
        from = i;
    }
    return way;
}

bool ends(const StrokeDesk& desk, const render::Window& window) {
    return desk.complete() || desk.left() || window.should_close() || EndWatch::asked();
}

render::WindowEvents events_of(StrokeDesk& desk, DrawingHand& hand) {
    render::WindowEvents events;
    events.key = [&](int key, int, bool pressed) {
        if (pressed) desk.key(render::key_name(key));
    };
    events.mouse_button = [&](int button, bool pressed) {
        if (button == 0 || button == 1) hand.press(pressed);
    };
    events.mouse_move = [&](double dx, double dy) { hand.move(dx, dy); };
    events.focus = [&](bool focused) {
        if (!focused) hand.press(false);
    };
    return events;
}

/// Fills the frame with the earlier strokes, the stroke that is being drawn, and the window's texts.
void fill(render::Frame& frame, const StrokeDesk& desk, render::Size size) {
    frame.width = size.width;
    frame.height = size.height;
    auto& out = frame.overlay;
    out.items.clear();
    const float width = static_cast<float>(size.width), height = static_cast<float>(size.height);
    const float unit = height / 720;
    const auto& strokes = desk.recorder().strokes();
    const fvec2 middle(0.5F * width, 0.54F * height);
    const double scale = static_cast<double>(height) / shown_m;
    for (const auto& stroke : strokes)
        add_stroke(out, stroke, {stroke.front().at, middle, scale},
                   {.colour = opaque(fvec3(paints.soft), 0.35F), .width = 3 * unit});
    if (const auto open = desk.recorder().open(); !open.empty())
        add_stroke(out, open, {open.front().at, middle, scale}, {.width = 6 * unit, .by_force = true});
    add_text(out, desk.title(), {0.5F * width, 0.05F * height}, 30 * unit, paints.white,
             render::Align::centre);
    add_text(out, desk.note(), {0.5F * width, 0.14F * height}, 22 * unit, paints.amber,
             render::Align::centre);
    add_text(out, desk.advice(), {0.5F * width, 0.93F * height}, 20 * unit, paints.soft,
             render::Align::centre);
}

Expected<void> run(StrokeDesk& desk, DrawingHand& hand, double frames_per_second, render::Window& window,
                   render::Renderer& renderer) {
    const EndWatch watch;
    const auto events = events_of(desk, hand);
    render::Frame frame;
    window.capture_cursor(true);
    const auto picture_ns = static_cast<std::int64_t>(1e9 / frames_per_second);
    auto next_ns = monotonic_ns();
    while (!ends(desk, window)) {
        window.poll(events, patience_s);
        hand.advance(monotonic_ns(), desk.recorder());
        desk.take_ended();
        if (auto fault = hand.fault(); !fault.empty()) return fail(std::move(fault));
        const auto size = window.size();
        if (monotonic_ns() < next_ns || window.minimised() || size.width <= 0 || size.height <= 0) continue;
        next_ns = monotonic_ns() + picture_ns;
        fill(frame, desk, size);
        renderer.draw(frame);
        window.present();
    }
    window.capture_cursor(false);
    if (!desk.complete())
        return fail("the window was closed before all strokes were drawn; nothing was written");
    return {};
}

Expected<std::unique_ptr<DrawingHand>> hand_of(const std::string& device, const Settings& settings,
                                               const MatchData& data) {
    if (device == "mouse") return std::make_unique<DrawingMouse>(data.device, monotonic_ns());
    const auto percent = force_choices[settings.players[0].force].percent;
    auto arm = DrawingArm::open(device, percent ? *percent / 100.0 : haptics::gentle_share);
    if (!arm) return arm.error();
    return std::move(*arm);
}

}  // namespace

std::string fault_of(gesture::Points stroke, const LeastStroke& least) {
    // Arc length above which the hand did more than press the button (m)
    constexpr double min_move = 0.0015;
    const double way = way_of(stroke), lasts = stroke.empty() ? 0 : stroke.back().t - stroke.front().t;
    if (way < min_move) return "a press without a stroke does not count: hold the button while you draw";
    if (way < least.way)
        return text("a stroke of ", fixed(1000 * way, 0), " mm is too small to be read: draw it larger");
    if (lasts < least.seconds)
        return text("a stroke of ", fixed(lasts, 2), " s is too short to be read: draw it more slowly");
    if (stroke.size() > gesture::max_template_points)
        return text("a stroke of ", fixed(lasts, 0), " s is too long: draw it faster");
    return {};
}

void StrokeDesk::take_ended() {
    if (recorder_.strokes().size() > taken_) {
        note_ = fault_of(recorder_.strokes().back(), min_);
        if (!note_.empty()) recorder_.drop_last();
    }
    taken_ = recorder_.strokes().size();
}

void StrokeDesk::key(std::string_view name) {
    if (name == "Esc") left_ = true;
    if (name == "Backspace") recorder_.drop_last();
}

std::string StrokeDesk::title() const {
    const auto number = std::min(recorder_.strokes().size() + 1, wish_.count);
    return text(wish_.name, ": stroke ", number, " of ", wish_.count);
}

std::string StrokeDesk::advice() const {
    return text(
        wish_.device == "mouse" ? "Hold a mouse button and draw" : "Hold a button of the stylus and draw",
        "   Backspace: last stroke again   Esc: leave");
}

Expected<std::vector<std::vector<gesture::StrokePoint>>> draw_strokes(const StrokeWish& wish) {
    if (!render::display_there())
        return fail("drawing strokes needs a display; --log and --strokes take recorded ones without it");
    const auto assets = find_assets();
    const auto settings = settings_to_play_with(settings_file(), assets).settings;
    const auto data = load_match_data(assets, {});
    if (!data) return data.error();
    auto hand = hand_of(wish.device, settings, *data);
    if (!hand) return hand.error();
    auto window = render::Window::create({.title = "Thaum: record a gesture"});
    if (!window) return window.error();
    StrokeDesk desk(wish, data->casting
                              ? LeastStroke{data->casting->smallest, seconds(data->casting->shortest)}
                              : LeastStroke{});
    const auto went = render::with_renderer(*window, assets, [&](render::Renderer& renderer) {
        return run(desk, **hand, settings.frames_per_second, *window, renderer);
    });
    if (!went) return went.error();
    return desk.recorder().strokes();
}

}  // namespace thaum::game::inline app
