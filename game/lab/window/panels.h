// game/lab/window/panels.h: panels with sliders and lists over a picture (Dear ImGui). The lab uses them.
//
//     Panels panels(size of text);
//     events = panels.listening(events of the program)     panels get what happens on them, the program the rest
//     panels.begin(size of the window, seconds since the last picture);
//     ImGui::...                                            between begin and draw
//     panels.draw();                                        after the renderer's picture, before it is shown
#pragma once
#include <array>
#include <cstddef>
#include <string_view>

#include "render/context.h"

namespace thaum::app {

class Panels {
public:
    /// A context of OpenGL must be current, now and until the end of the life of this object. Only one may exist.
    explicit Panels(float text_px);
    Panels(const Panels&) = delete;
    Panels& operator=(const Panels&) = delete;
    ~Panels();

    /// Number of mouse buttons and keys that panels use.
    static constexpr std::size_t switches = 23;

    /// Events for Window::poll, to be used while this object lives. Those on a panel go to the panels alone, and so do
    /// all keys while a text field, a list or a question is open: Esc closes it. Ends of presses go to both.
    render::WindowEvents listening(const render::WindowEvents& program);
    void begin(render::Size size, double seconds);
    void draw();

private:
    /// Tells Dear ImGui of a press. It looks once a picture, so a press that ends before is held until then.
    void set(std::size_t number, bool down);
    /// Returns whether the key is for the panels alone.
    bool take_key(std::string_view name, bool pressed);
    void add_mouse(const render::WindowEvents& program, render::WindowEvents& heard);

    std::array<bool, switches> fresh_{};  ///< pressed since the last picture
    std::array<bool, switches> ended_{};  ///< released since then
};

}  // namespace thaum::app
