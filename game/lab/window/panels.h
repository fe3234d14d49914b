// game/lab/window/panels.h: panels with sliders and lists over a picture (Dear ImGui). The lab uses them.
//
//     Panels panels(size of text);
//     events = panels.listening(events of the program)     panels get events on them, the program others
//     panels.begin(size of the window, seconds since the last picture);
//     ImGui::...                                            between begin and draw
//     panels.draw();                                        after the renderer's picture, before it is shown
#pragma once
#include <array>
#include <cstddef>
#include <string_view>

#include "render/context.h"

namespace thaum::game::inline lab {

class Panels {
public:
    /// An OpenGL context must be current now and during the whole lifetime of this object. Only one such
    /// object may exist.
    explicit Panels(float text_px);
    Panels(const Panels&) = delete;
    Panels& operator=(const Panels&) = delete;
    ~Panels();

    /// Number of mouse buttons and keys that panels use.
    static constexpr std::size_t switches = 23;

    /// Event handlers for Window::poll, valid while this object exists. Events on a panel go only to the
    /// panels, and so do all keys while a text field, a list or a question is open (Esc closes these).
    /// Releases of buttons and keys go to panels and program.
    render::WindowEvents listening(const render::WindowEvents& program);
    void begin(render::Size size, double seconds);
    void draw();

private:
    /// Reports a press or release to Dear ImGui. Dear ImGui reads this state once per picture, so a press
    /// that has already ended is kept until then.
    void set(std::size_t number, bool down);
    /// Passes a key to the panels if they use it. Returns whether they alone use it, so that the program must
    /// ignore it.
    bool take_key(std::string_view name, bool pressed);
    void add_mouse(const render::WindowEvents& program, render::WindowEvents& heard);

    std::array<bool, switches> fresh_{};  ///< for each button or key, true if pressed since the last picture
    std::array<bool, switches> ended_{};  ///< for each button or key, true if released since the last picture
};

}  // namespace thaum::game::inline lab
