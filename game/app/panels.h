// game/app/panels.h: panels with sliders and lists over a picture (Dear ImGui). The lab uses them.
//
//     Panels panels(size of text);
//     events = panels.listening(events of the program)     panels get what happens on them, the program the rest
//     panels.begin(size of the window, seconds since the last picture);
//     ImGui::...                                            between begin and draw
//     panels.draw();                                        after the renderer's picture, before it is shown
#pragma once
#include "render/context.h"

namespace thaum::app {

class Panels {
public:
    /// A context of OpenGL must be current, now and until the end of the life of this object. Only one may exist.
    explicit Panels(float text_px);
    Panels(const Panels&) = delete;
    Panels& operator=(const Panels&) = delete;
    ~Panels();

    /// Events for Window::poll: those on a panel go to the panels alone. Ends of presses go to both.
    render::WindowEvents listening(const render::WindowEvents& program);
    void begin(render::Size size, double seconds);
    void draw();
};

}  // namespace thaum::app
