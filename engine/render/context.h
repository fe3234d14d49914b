// render/context.h: the targets of drawing. Two kinds of OpenGL 3.3 core context share one interface:
//
//     Window     on the desktop (GLFW), with keys and mouse
//     Offscreen  in memory (EGL), for tests and films; needs no display
//
//     make_current()     gives OpenGL to the calling thread (no other thread may hold it)
//     release_current()  takes OpenGL from the calling thread
//     present()          shows the drawn picture; called on the thread that holds OpenGL
//     size()             size of the framebuffer (px); any thread
//
// The main thread creates, polls and destroys a Window. The render thread draws, and must release the context
// before the Window is destroyed. A Renderer must be destroyed before its context.
#pragma once
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "core/error.h"

namespace thaum::render {

/// Size of a window or picture. Aligned, so that std::atomic<Size> is lock-free with every compiler.
struct alignas(8) Size {
    int width{}, height{};  ///< size (px)
    bool operator==(const Size&) const = default;
};

/// Settings with which a window is opened.
struct WindowSpec {
    std::string title = "Thaum";
    Size size{1280, 720};  ///< size on the desktop, ignored in full screen (px)
    bool fullscreen = false;
    /// true: ask for vertical synchronisation. Under Xvfb, which has no screen, present() does not wait for
    /// it, so the pictures need render/pace.h as well.
    bool vsync = true;
};

/// Callbacks of Window::poll, on the main thread. An empty function ignores its event.
struct WindowEvents {
    /// A key went down or up. `key` is a code as for key_name, or -1 if the key has none. `scancode` is the
    /// platform's number of the physical key. Repeats are not reported.
    std::function<void(int key, int scancode, bool pressed)> key;
    std::function<void(char32_t character)> character;           ///< one character of typed text
    std::function<void(int button, bool pressed)> mouse_button;  ///< button 0 left, 1 right, 2 middle, ...
    std::function<void(double dx, double dy)> mouse_move;  ///< motion while the cursor is captured (counts)
    /// Position of the cursor from the window's top left, while the cursor is not captured (px).
    std::function<void(double x, double y)> cursor;
    std::function<void(double steps)> wheel;  ///< motion of the wheel; positive away from the user
    std::function<void(bool focused)> focus;
    std::function<void(Size)> resize;
};

/// The window, with its events.
class Window {
public:
    /// Opens the window; only one may exist at a time. Errors: no display, no OpenGL 3.3.
    static Expected<Window> create(const WindowSpec& spec);
    Window(Window&&) noexcept;
    Window& operator=(Window&&) noexcept;
    ~Window();

    // Called on the main thread.
    /// Waits up to `timeout_s` for an event (0: does not wait), then reports all events that have arrived.
    void poll(const WindowEvents& events, double timeout_s = 0);
    /// Ends a waiting poll. Any thread may call it.
    void wake();
    /// Hides the cursor and reports unbounded motion, unaccelerated if the system supports it.
    void capture_cursor(bool capture);
    /// Changes between full screen and a window of the former size.
    void set_fullscreen(bool fullscreen);
    /// Changes the title of the window.
    void set_title(const std::string& title);

    // The next functions may be called on any thread.
    Size size() const;
    bool minimised() const;  ///< the window is minimised, so drawing may be skipped
    /// Whether the window gets the keyboard's events.
    bool focused() const;
    /// Whether the user asked to close the window.
    bool should_close() const;
    void cancel_close();  ///< makes should_close() false again

    // Called on the render thread.
    /// @{
    /// Three functions: make the window's OpenGL context current in the calling thread, release the context,
    /// and show the drawn picture.
    void make_current();
    void release_current();
    void present();
    /// @}

    struct State;  // state of the window, defined in window.cpp

private:
    explicit Window(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

/// A context with a framebuffer and no window.
class Offscreen {
public:
    /// Creates a context, which is not current on return. Error: no EGL, or EGL without OpenGL 3.3.
    static Expected<Offscreen> create(int width, int height);
    Offscreen(Offscreen&&) noexcept;
    Offscreen& operator=(Offscreen&&) noexcept;
    ~Offscreen();

    Size size() const;
    /// @{
    /// Three functions: make the context current in the calling thread, release it, and send all drawing to
    /// the driver.
    void make_current();
    void release_current();
    void present();
    /// @}

private:
    struct State;
    explicit Offscreen(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

/// Name of a key for settings files: "W", "Space", "KP_8", "Left", "Esc". Names refer to positions on a US
/// keyboard, whatever is printed on the key. Returns an empty string for an unknown code.
std::string_view key_name(int code);
/// Code of a key name, in upper or lower case. Returns std::nullopt if no key has this name.
std::optional<int> key_code(std::string_view name);

/// Name of a key by the user's keyboard layout: "Z" for the key of "W" on a French keyboard, "Comma" for the
/// key of "M". A key without a character has the name from key_name. Digits keep their names, because most
/// layouts that give digits only with Shift still print them on the keys. Without a window, all keys are
/// those of a US keyboard. Any thread may call it.
std::string key_label(int code);
/// Name of a key by the user's keyboard layout (key_label), but with the character in place of its name: ","
/// for "Comma".
std::string key_sign(int code);

}  // namespace thaum::render
