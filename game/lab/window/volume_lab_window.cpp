// A volume of the lab in a window: the hand follows the mouse, panels choose modes, transfer functions and
// tools. One thread handles input, computes the ticks that are due by the clock, and draws a picture. If
// ticks take too long, the lab runs more slowly, since it has no real-time deadlines.
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "core/clock.h"
#include "core/file.h"
#include "core/one_line.h"
#include "core/text.h"
#include "game/command_line/command.h"
#include "game/data/match_data.h"
#include "game/lab/saved_body.h"
#include "game/lab/volume_trace.h"
#include "game/lab/window/panels.h"
#include "game/lab/window/view_controls.h"
#include "game/lab/window/volume_lab.h"
#include "game/lab/window/volume_panels.h"
#include "game/live/end_watch.h"
#include "game/settings/settings.h"
#include "render/pace.h"
#include "render/with_renderer.h"

namespace thaum::game::inline lab {
namespace {

constexpr Tick ticks_of_a_frame = 100;  // maximum number of ticks per picture; time beyond them is dropped
constexpr double way_per_step = 0.003;  // displacement of the hand along the view, for one step of the mouse
                                        // wheel (m)
constexpr double min_way = 1e-4;        // minimum displacement for which the hand counts as moving (m)
// Time without motion after which a sharp picture is drawn (ns)
constexpr std::int64_t rest_ns = 400'000'000;
constexpr float text_px = 14;

/// State that the last picture showed. A difference from the present state means that something has moved.
struct Seen {
    vec3 tip{}, aim{}, eye{};
    std::uint32_t body{};
};

struct Session {
    VolumeLabPlan plan;
    LabTrace trace;
    VolumeLabFigures figures{};
    VolumePanelState panels{};
    std::optional<fvec2> cursor{};  ///< position of the mouse (px); std::nullopt: not yet known
    vec3 target{};                  ///< target position of the hand (m)
    double depth{};                 ///< distance of the hand beyond the middle, along the view (m)
    bool by_mouse = false, carving = false, turning = false, panning = false, leaves = false, control = false;
    int height = 1;   ///< height of the window (px)
    int history = 0;  ///< undo (-1) or redo (1) that is due
    Seen seen{};
    std::int64_t moved = 0;  ///< time at which the picture last changed (ns)
    /// Number of the body's newest change (Bricks::newest) when the body was opened or saved. A newer
    /// one means that the body has changes that are not saved.
    std::uint32_t saved = 1;
};

/// Whether the body was carved and has not been saved since.
bool unsaved(const Session& session) {
    const auto& lab = session.plan.lab;
    return lab.carvable() && lab.edited && lab.body.bricks.newest != session.saved;
}

/// Ends the session at once, or asks first if a carved body would be lost. With the option --save the body is
/// saved at the end anyway, so nothing is asked.
void leave(Session& session) {
    using Before = UnsavedQuestion::Before;
    if (session.plan.out.save || !unsaved(session))
        session.leaves = true;
    else if (session.panels.question.before == Before::nothing)
        session.panels.question.before = Before::leaving;
}

/// Position at which the mouse points, in the plane perpendicular to the view at the hand's depth, limited to
/// the workspace.
vec3 pointed_at(const Session& session, render::Size size) {
    const auto camera = camera_of(session.plan.view.eye, session.plan.lab);
    const double tall = std::tan(double{camera.fov_y} / 2), half = 0.5 * std::max(size.height, 1);
    const quat turn(camera.orientation);
    const vec3 ray = turn * vec3(tall * (double{session.cursor->x} - 0.5 * size.width) / half,
                                 tall * (half - double{session.cursor->y}) / half, -1);
    const double away = glm::dot(vec3(camera.position), turn * vec3(0, 0, 1)) + session.depth;
    const vec3 reach = 0.5 * session.plan.lab.data.device.workspace;
    return glm::clamp(vec3(camera.position) + away * ray, -reach, reach);
}

/// Places the hand in front of the volume, where it touches nothing and is visible.
void put_hand_before(Session& session) {
    auto& lab = session.plan.lab;
    const quat turn(camera_of(session.plan.view.eye, lab).orientation);
    session.target = place_before(turn * vec3(0, 0, 1), lab.data.device.workspace);
    session.depth = -glm::length(session.target);
    session.by_mouse = true;
    rest_hand(lab, session.target);
}

void press(Session& session, std::string_view key) {
    if (key == "Esc") leave(session);
    if (key == "Z") session.history = -1;
    if (key == "Y") session.history = 1;
    if (key == "H") session.panels.hand_held = !session.panels.hand_held;
    if (key == "PageUp") session.depth += way_per_step;
    if (key == "PageDown") session.depth -= way_per_step;
}

/// Moves the picture by the mouse's displacement `way` (px).
void pan(Session& session, fvec2 way) {
    auto& eye = session.plan.view.eye;
    const auto camera = camera_of(eye, session.plan.lab);
    const double metres = 2 * std::tan(double{camera.fov_y} / 2) *
                          glm::distance(vec3(camera.position), eye.aim) / std::max(session.height, 1);
    const vec3 aim = eye.aim + quat(camera.orientation) * vec3(-way.x, way.y, 0) * metres;
    const vec3 reach = session.plan.lab.data.device.workspace;
    eye.aim = glm::clamp(aim, -reach, reach);
}

void cursor_moved(Session& session, fvec2 to) {
    if (session.turning && session.cursor) {
        const fvec2 way = to - *session.cursor;
        auto& eye = session.plan.view.eye;
        eye.yaw = std::remainder(eye.yaw - turn_per_px * double{way.x}, 2 * pi);
        eye.pitch = std::clamp(eye.pitch + turn_per_px * double{way.y}, -1.5, 1.5);
    }
    if (session.panning && session.cursor) pan(session, to - *session.cursor);
    session.cursor = to;
    session.by_mouse = true;
}

render::WindowEvents lab_events(Session& session) {
    render::WindowEvents events;
    events.key = [&](int key, int, bool pressed) {
        const auto name = render::key_name(key);
        if (name == "LeftCtrl" || name == "RightCtrl") session.control = pressed;
        if (name == "Space") session.carving = pressed;
        if (pressed) press(session, name);
    };
    events.mouse_button = [&](int button, bool pressed) {
        if (button == 0) session.carving = pressed;
        if (button == 1) session.turning = pressed;
        if (button == 2) session.panning = pressed;
    };
    events.cursor = [&](double x, double y) { cursor_moved(session, fvec2(vec2(x, y))); };
    events.wheel = [&](double steps) {
        if (session.control)
            session.plan.view.eye.away =
                std::clamp(session.plan.view.eye.away * std::pow(nearer_per_step, steps), 0.1, 8.0);
        else
            session.depth += way_per_step * steps;
    };
    events.focus = [&](bool focused) {
        if (!focused) session.carving = session.turning = session.panning = session.control = false;
    };
    return events;
}

/// Updates the panels from the current settings.
void show_what_is_set(const VolumeLab& lab, VolumePanelState& panels) {
    panels.modes = lab.settings.modes;
    panels.feel = lab.settings.feel;
    panels.places = lab.settings.places;
}

void step(Session& session) {
    auto input = planned_input(session.plan);
    if (session.by_mouse) {
        if (!session.plan.path.uses.empty()) input = {};
        input.target = session.target;
    }
    if (session.carving) {
        input.carve = true;
        input.tool = session.panels.tool;
    }
    if (session.history != 0) input.history = std::exchange(session.history, 0);
    input.change = std::exchange(session.panels.change, std::nullopt);
    session.figures = step_volume_lab(session.plan.lab, input);
    if (!session.figures.refused.empty()) {
        session.panels.note = session.figures.refused;
        show_what_is_set(session.plan.lab, session.panels);
    }
    session.trace.add(
        [&](std::string& rows) { append_volume_row(session.plan.lab, input, session.figures, rows); });
    add_force(session.panels, glm::length(session.figures.force));
}

/// Saves the body and shows a message. Returns whether it was saved.
bool save_body(Session& session) {
    const auto file = session.plan.out.save.value_or("carved.nrrd");
    const auto saved = save_volume(session.plan.lab, file);
    session.panels.note = saved ? text("saved: ", file.string()) : in_one_line(saved.error().message);
    if (saved) session.saved = session.plan.lab.body.bricks.newest;
    return saved.has_value();
}

/// Carries out the answer to the question about an unsaved body.
void obey_answer(Session& session) {
    using Answer = UnsavedQuestion::Answer;
    auto& panels = session.panels;
    if (!panels.question.answer) return;
    const auto [before, shown, answer] = std::exchange(panels.question, {});
    const bool goes_on = answer == Answer::drop || (answer == Answer::save && save_body(session));
    if (goes_on && before == UnsavedQuestion::Before::leaving) session.leaves = true;
    if (goes_on) session.saved = session.plan.lab.body.bricks.newest;
    if (!goes_on) panels.open.reset();
}

/// Carries out what a button in the panels asked for.
void obey(Session& session) {
    auto& panels = session.panels;
    obey_answer(session);
    if (panels.history != 0) session.history = std::exchange(panels.history, 0);
    if (std::exchange(panels.saves, false)) save_body(session);
    if (std::exchange(panels.saves_session, false)) {
        const auto file = session.plan.session_file.value_or("lab.toml");
        const auto saved = save_session(session_of(session.plan), file);
        panels.note = saved ? text("saved: ", file.string()) : in_one_line(saved.error().message);
    }
}

/// Puts the device that was chosen in the panels into the hand. The body is kept.
void take_chosen_device(Session& session) {
    auto& panels = session.panels;
    const auto name = std::exchange(panels.next_device, std::nullopt);
    if (!name || *name == panels.device) return;
    auto spec = load_lab_device(find_assets(), *name);
    if (!spec) {
        panels.note = in_one_line(spec.error().message);
        return;
    }
    change_device(session.plan.lab, std::move(*spec));
    session.plan.device = panels.device = *name;
    put_hand_before(session);
    panels.note = text("device: ", *name);
    show_what_is_set(session.plan.lab, panels);
}

Expected<void> open_chosen(Session& session, std::optional<VolumePicture>& picture,
                           render::Renderer& renderer) {
    if (!session.panels.open) return {};
    if (unsaved(session)) {
        session.panels.question.before = UnsavedQuestion::Before::opening;
        return {};
    }
    const auto wanted = *std::exchange(session.panels.open, std::nullopt);
    auto next = session_of(session.plan);
    const bool same = wanted.name == session.plan.first.volume;
    next.first.volume = wanted.name;
    next.first.moment = wanted.moment;
    if (!same) {
        next.modes.clear();
        next.feel.clear();
    }
    auto plan = plan_of(next);
    if (!plan) {
        session.panels.note = in_one_line(plan.error().message);
        return {};
    }
    if (!same) plan->view = usual_view(plan->lab);
    plan->lab.tick = session.plan.lab.tick;  // the clock goes on, because the times in a trace must increase
    session.saved = 1;
    session.plan.lab = std::move(plan->lab);
    session.plan.view = plan->view;
    session.plan.first = next.first;
    session.plan.notes = std::move(plan->notes);
    put_hand_before(session);
    show_what_is_set(session.plan.lab, session.panels);
    session.panels.one_level = levels_agree(session.plan.view, session.panels);
    session.panels.tool = usual_tool(session.plan.lab);
    picture.emplace(renderer, session.plan.lab);
    return {};
}

/// Whether hand, view or body moved a short time ago. A sharp picture takes long to draw, so it waits until
/// nothing moves.
bool is_moving(Session& session, std::int64_t now) {
    const auto& eye = session.plan.view.eye;
    const Seen seen{session.figures.tip, eye.aim, vec3(eye.yaw, eye.pitch, eye.away),
                    session.plan.lab.body.bricks.newest};
    const bool same = glm::distance(seen.tip, session.seen.tip) < min_way && seen.aim == session.seen.aim &&
                      seen.eye == session.seen.eye && seen.body == session.seen.body;
    if (!same) {
        session.seen = seen;
        session.moved = now;
    }
    return now - session.moved < rest_ns;
}

/// Saves the picture if one has become due since the tick `before`.
Expected<void> save_due_shot(const VolumeLabPlan& plan, Tick before, render::Renderer& renderer) {
    const auto every = static_cast<Tick>(plan.out.every);
    if (!plan.out.shots || before / every == plan.lab.tick / every) return {};
    return write_lab_shot(*plan.out.shots, static_cast<std::int64_t>(plan.lab.tick), renderer.read_pixels());
}

/// Handles a request to close the window: asks about an unsaved body. A second request leaves without saving.
/// Returns whether the window stays open.
bool stays_open(Session& session, render::Window& window) {
    if (!window.should_close()) return true;
    if (session.panels.question.before != UnsavedQuestion::Before::nothing) return false;
    window.cancel_close();
    leave(session);
    return !session.leaves;
}

Expected<void> run(Session& session, double frames_per_second, render::Window& window,
                   render::Renderer& renderer) {
    Panels imgui(text_px);
    const auto events = imgui.listening(lab_events(session));
    std::optional<VolumePicture> picture(std::in_place, renderer, session.plan.lab);
    render::Pacer pacer(frames_per_second);
    auto last = monotonic_ns();
    double owed = 0;
    while (!session.leaves && !EndWatch::asked()) {
        if (!stays_open(session, window)) break;
        if (session.plan.seconds && session.plan.lab.seconds() >= *session.plan.seconds) break;
        window.poll(events);
        const auto size = window.size();
        const auto now = monotonic_ns();
        const double passed = static_cast<double>(now - std::exchange(last, now)) * 1e-9;
        owed = std::min(owed + passed, seconds(ticks_of_a_frame));
        session.height = size.height;
        if (session.cursor && !session.turning && !session.panning && !session.panels.hand_held &&
            session.plan.lab.tick > 0)
            session.target = pointed_at(session, size);
        const auto before = session.plan.lab.tick;
        for (; owed >= tick_seconds; owed -= tick_seconds) step(session);
        if (!window.minimised() && size.width > 0 && size.height > 0) {
            session.plan.view.moving = is_moving(session, now);
            renderer.draw(picture->frame(session.plan.lab, session.figures, session.plan.view, size));
            if (auto put = save_due_shot(session.plan, before, renderer); !put) return put;
            imgui.begin(size, passed);
            show_panels(session.plan, session.figures, session.panels);
            imgui.draw();
            window.present();
            obey(session);
            take_chosen_device(session);
            if (auto opened = open_chosen(session, picture, renderer); !opened) return opened;
        }
        pacer.wait();
    }
    return {};
}

Expected<void> end(Session& session) {
    if (auto closed = session.trace.close(); !closed) return closed;
    return session.plan.out.save ? save_volume(session.plan.lab, *session.plan.out.save) : Expected<void>();
}

}  // namespace

int run_volume_window(VolumeLabPlan plan) {
    const auto assets = find_assets();
    const auto settings = settings_to_play_with(settings_file(), assets).settings;
    auto window = render::Window::create(
        {.title = "Thaum: " + plan.first.volume, .size = plan.out.size, .fullscreen = settings.fullscreen});
    if (!window) return refuse(window.error());
    const EndWatch watch;
    auto trace = LabTrace::open(plan.out.trace, volume_trace_header());
    if (!trace) return refuse(trace.error());
    if (auto made = make_lab_folder(plan.out, plan.out.every); !made) return refuse(made.error());
    Session session{.plan = std::move(plan), .trace = std::move(*trace)};
    show_what_is_set(session.plan.lab, session.panels);
    session.panels.one_level = levels_agree(session.plan.view, session.panels);
    if (session.plan.by_mouse) put_hand_before(session);
    session.panels.device = session.plan.device;
    session.panels.tool = usual_tool(session.plan.lab);
    const auto went = render::with_renderer(*window, assets, [&](render::Renderer& renderer) {
        return run(session, settings.frames_per_second, *window, renderer);
    });
    if (!went) return refuse(went.error());
    if (auto ended = end(session); !ended) return refuse(ended.error());
    tell_end_by_signal();
    return done;
}

}  // namespace thaum::game::inline lab
