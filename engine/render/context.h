// render/context.h: where pictures go. Two kinds of OpenGL 3.3 core context with the same face:
//
//   Window     on the desktop (GLFW), with keys, mouse and pads
//   Offscreen  in memory (EGL), for tests and films; needs no display
//
//   make_current()     the calling thread owns OpenGL from here (no other thread may at that time)
//   release_current()  it no longer does
//   present()          shows what was drawn; on the thread that owns OpenGL
//   size()             of the framebuffer, px; any thread
//
// A Window is created, polled and destroyed on the main thread; pictures are made on the render thread, which must
// have released the context before the Window goes. A Renderer must go before its context does.
#pragma once
#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "core/error.h"

namespace thaum::render {

struct Size {
    int width{}, height{};  ///< px
    bool operator==(const Size&) const = default;
};

struct WindowSpec {
    std::string title = "Thaum";
    Size size{1280, 720};  ///< ignored when full-screen
    bool fullscreen = false;
    bool vsync = true;  ///< a wish: under Xvfb present() does not block; use render/pace.h as well
};

/// Called from Window::poll, on the main thread. An empty function ignores its event.
struct WindowEvents {
    /// key: a code as key_name takes it, -1 if the key has none; scancode: the platform's number of the physical
    /// key. Repeats are not reported.
    std::function<void(int key, int scancode, bool pressed)> key;
    std::function<void(char32_t character)> character;           ///< typed text
    std::function<void(int button, bool pressed)> mouse_button;  ///< 0 left, 1 right, 2 middle, ...
    std::function<void(double dx, double dy)> mouse_move;        ///< counts, while the cursor is captured
    std::function<void(double x, double y)> cursor;              ///< px from the top left, while it is not
    std::function<void(double steps)> wheel;                     ///< away from the user is positive
    std::function<void(bool focused)> focus;
    std::function<void(Size)> resize;
};

/// A gamepad in the layout of an Xbox pad.
struct PadState {
    bool present = false;
    std::string name;
    std::array<float, 6> axes{};  ///< left x, left y, right x, right y (right and down +1), triggers 0 to 1
    std::uint32_t buttons{};      ///< bit n: A B X Y LB RB Back Start Guide L R Up Right Down Left
};

class Window {
public:
    /// Errors: no display, no OpenGL 3.3. One Window at a time.
    static Expected<Window> create(const WindowSpec& spec);
    Window(Window&&) noexcept;
    Window& operator=(Window&&) noexcept;
    ~Window();

    // Main thread.
    /// Waits up to timeout_s for an event (0: does not wait), then tells all that have come.
    void poll(const WindowEvents& events, double timeout_s = 0);
    /// Ends a waiting poll; any thread.
    void wake();
    /// Hides the cursor and reports motion without bounds, unaccelerated where the system can.
    void capture_cursor(bool capture);
    void set_fullscreen(bool fullscreen);
    void set_title(const std::string& title);
    /// A pad keeps its place until it is unplugged.
    std::array<PadState, 4> pads();

    // Any thread.
    Size size() const;
    bool minimised() const;  ///< nothing need be drawn
    bool focused() const;
    bool should_close() const;
    void request_close();

    // Render thread.
    void make_current();
    void release_current();
    void present();

    struct State;  // of window.cpp

private:
    explicit Window(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

class Offscreen {
public:
    /// Error: no EGL or no OpenGL 3.3 through it. Not current on return.
    static Expected<Offscreen> create(int width, int height);
    Offscreen(Offscreen&&) noexcept;
    Offscreen& operator=(Offscreen&&) noexcept;
    ~Offscreen();

    Size size() const;
    void make_current();
    void release_current();
    void present();

private:
    struct State;
    explicit Offscreen(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

/// Names for settings files: "W", "Space", "KP_8", "Left", "Esc". They name places on a US keyboard, whatever is
/// printed on the key. Empty for a code that is no key.
std::string_view key_name(int code);
/// The name in any case; nothing if no key is called so.
std::optional<int> key_code(std::string_view name);

}  // namespace thaum::render
