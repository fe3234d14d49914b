#include <epoxy/gl.h>
// epoxy/gl.h must come before GLFW, which would include its own OpenGL header.
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <atomic>
#include <utility>

#include "core/assert.h"
#include "core/text.h"
#include "render/context.h"
#include "render/detail/key_labels.h"
#include "render/display.h"

namespace thaum::render {

struct Window::State {
    GLFWwindow* handle = nullptr;
    WindowSpec spec;

    // Any thread may read the size.
    std::atomic<Size> size{Size{}};
    std::atomic<bool> minimised = false, focused = false, closing = false;

    // The next members are used by the main thread only.
    const WindowEvents* events = nullptr;  // callbacks of the current poll; null otherwise
    bool captured = false;
    /// true: the next change of the cursor's position in this poll is a jump, not a motion of the mouse
    bool jumps = false;
    double last_x = 0, last_y = 0;
    int windowed_x = 0, windowed_y = 0;
    Size windowed_size;

    State() = default;
    State(const State&) = delete;
    State& operator=(const State&) = delete;
    ~State();
};

namespace {

bool alive = false;  // true: a Window exists; used by the main thread only

// GLFW reports errors only through a callback, on the calling thread. The callback keeps them here.
thread_local std::string last_glfw_error;
void keep_glfw_error(int, const char* what) { last_glfw_error = what; }

Error no_display() {
    return fail(text("cannot open a window: ", last_glfw_error.empty() ? "no display" : last_glfw_error,
                     "; start it in a desktop session or set DISPLAY"));
}

Error no_opengl(std::string_view what) {
    return fail(text("cannot open a window with OpenGL 3.3: ", what,
                     "; install a graphics driver, or libgl1-mesa-dri, which draws without a graphics card"));
}

template <class Function, class... Arguments>
void tell(const Function& function, Arguments... arguments) {
    if (function) function(arguments...);
}

GLFWmonitor* full_screen_monitor(const WindowSpec& spec) {
    return spec.fullscreen ? glfwGetPrimaryMonitor() : nullptr;
}

/// The wanted size of a window, limited to the part of the screen that windows may cover.
Size size_on_screen(Size wanted) {
    GLFWmonitor* monitor = glfwGetPrimaryMonitor();
    if (monitor == nullptr) return wanted;
    int left = 0, top = 0;
    Size room;
    glfwGetMonitorWorkarea(monitor, &left, &top, &room.width, &room.height);
    if (room.width <= 0 || room.height <= 0) return wanted;
    return {std::min(wanted.width, room.width), std::min(wanted.height, room.height)};
}

GLFWwindow* open_window(const WindowSpec& spec) {
    glfwDefaultWindowHints();
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
    // Views have depth in a target of their own (Renderer). In a window without depth a software rasteriser
    // copies and stretches a picture several times as fast.
    glfwWindowHint(GLFW_DEPTH_BITS, 0);
    glfwWindowHint(GLFW_STENCIL_BITS, 0);
    // By default, a full-screen window that loses the focus is minimised and the screen's mode changes. This
    // must not happen while another player uses the window, for example in a menu.
    glfwWindowHint(GLFW_AUTO_ICONIFY, GLFW_FALSE);
    GLFWmonitor* monitor = full_screen_monitor(spec);
    Size size = size_on_screen(spec.size);
    if (monitor != nullptr) {
        const GLFWvidmode* mode = glfwGetVideoMode(monitor);
        if (mode != nullptr) size = {mode->width, mode->height};
    }
    return glfwCreateWindow(size.width, size.height, spec.title.c_str(), monitor, nullptr);
}

}  // namespace

namespace {

// State of a window. It is stored in GLFW's pointer for users, since callbacks get nothing but GLFW's window.
Window::State& state_of(GLFWwindow* w) { return *static_cast<Window::State*>(glfwGetWindowUserPointer(w)); }

const WindowEvents& events_of(GLFWwindow* w) {
    static const WindowEvents none;
    const auto* events = state_of(w).events;
    return events == nullptr ? none : *events;
}

void on_resize(GLFWwindow* w, int width, int height) {
    state_of(w).size = Size{width, height};
    state_of(w).jumps = true;
    tell(events_of(w).resize, Size{width, height});
}

void on_minimise(GLFWwindow* w, int minimised) { state_of(w).minimised = minimised != 0; }

void on_focus(GLFWwindow* w, int focused) {
    state_of(w).focused = focused != 0;
    state_of(w).jumps = true;
    if (focused != 0) read_key_labels();
    tell(events_of(w).focus, focused != 0);
}

void on_close(GLFWwindow* w) { state_of(w).closing = true; }

void on_key(GLFWwindow* w, int key, int scancode, int action, int) {
    // A key may also switch the keyboard layout, so the labels are read again.
    if (action == GLFW_PRESS) read_key_labels();
    if (action != GLFW_REPEAT) tell(events_of(w).key, key, scancode, action == GLFW_PRESS);
}

void on_character(GLFWwindow* w, unsigned character) {
    tell(events_of(w).character, static_cast<char32_t>(character));
}

void on_mouse_button(GLFWwindow* w, int button, int action, int) {
    tell(events_of(w).mouse_button, button, action == GLFW_PRESS);
}

void on_wheel(GLFWwindow* w, double, double steps) { tell(events_of(w).wheel, steps); }

/// Framebuffer pixels for each unit of window coordinates; not 1 on some high-density screens.
double pixels_per_unit(GLFWwindow* w) {
    int width = 0, height = 0;
    glfwGetWindowSize(w, &width, &height);
    return width > 0 ? static_cast<double>(state_of(w).size.load().width) / width : 1;
}

/// If a window is made so small that the cursor would be outside, the cursor is moved into it. GLFW then
/// reports where it entered, even for a captured cursor, which has no position.
void on_enter(GLFWwindow* w, int) { state_of(w).jumps = true; }

void on_cursor(GLFWwindow* w, double x, double y) {
    auto& s = state_of(w);
    const bool jump = std::exchange(s.jumps, false);
    const double dx = x - s.last_x, dy = y - s.last_y;
    s.last_x = x;
    s.last_y = y;
    const double scale = pixels_per_unit(w);
    if (!s.captured)
        tell(events_of(w).cursor, scale * x, scale * y);
    else if (!jump)
        tell(events_of(w).mouse_move, dx, dy);
}

void install_callbacks(Window::State& state) {
    glfwSetWindowUserPointer(state.handle, &state);
    glfwSetFramebufferSizeCallback(state.handle, on_resize);
    glfwSetWindowIconifyCallback(state.handle, on_minimise);
    glfwSetWindowFocusCallback(state.handle, on_focus);
    glfwSetWindowCloseCallback(state.handle, on_close);
    glfwSetKeyCallback(state.handle, on_key);
    glfwSetCharCallback(state.handle, on_character);
    glfwSetMouseButtonCallback(state.handle, on_mouse_button);
    glfwSetScrollCallback(state.handle, on_wheel);
    glfwSetCursorEnterCallback(state.handle, on_enter);
    glfwSetCursorPosCallback(state.handle, on_cursor);
}

}  // namespace

Window::State::~State() {
    if (handle != nullptr) glfwDestroyWindow(handle);
    glfwTerminate();
    alive = false;
}

Window::Window(std::unique_ptr<State> state) : state_(std::move(state)) {}
Window::Window(Window&&) noexcept = default;
Window& Window::operator=(Window&&) noexcept = default;
Window::~Window() = default;

Expected<Window> Window::create(const WindowSpec& spec) {
    THAUM_ASSERT(!alive, "there is a window already");
    last_glfw_error.clear();
    glfwSetErrorCallback(keep_glfw_error);
    if (glfwInit() == 0) return no_display();
    end_with_display();
    alive = true;
    auto state = std::make_unique<State>();
    state->spec = spec;
    state->handle = open_window(spec);
    if (state->handle == nullptr) return no_opengl(last_glfw_error);
    glfwMakeContextCurrent(state->handle);
    const int version = epoxy_gl_version();
    glfwMakeContextCurrent(nullptr);
    if (version < 33) return no_opengl(text("the driver has ", version / 10, ".", version % 10));
    install_callbacks(*state);
    read_key_labels();
    Size size;
    glfwGetFramebufferSize(state->handle, &size.width, &size.height);
    state->size = size;
    state->focused = glfwGetWindowAttrib(state->handle, GLFW_FOCUSED) != 0;
    return Window(std::move(state));
}

void Window::poll(const WindowEvents& events, double timeout_s) {
    state_->events = &events;
    if (timeout_s > 0)
        glfwWaitEventsTimeout(timeout_s);
    else
        glfwPollEvents();
    state_->events = nullptr;
    state_->jumps = false;
}

void Window::wake() { glfwPostEmptyEvent(); }

void Window::capture_cursor(bool capture) {
    if (capture == state_->captured) return;
    glfwSetInputMode(state_->handle, GLFW_CURSOR, capture ? GLFW_CURSOR_DISABLED : GLFW_CURSOR_NORMAL);
    if (glfwRawMouseMotionSupported() != 0) {
        glfwSetInputMode(state_->handle, GLFW_RAW_MOUSE_MOTION, capture ? GLFW_TRUE : GLFW_FALSE);
    }
    // The cursor jumps when captured or freed. Reading its position here keeps the jump out of the reported
    // motion.
    glfwGetCursorPos(state_->handle, &state_->last_x, &state_->last_y);
    state_->captured = capture;
}

void Window::set_fullscreen(bool fullscreen) {
    auto& s = *state_;
    if (fullscreen == (glfwGetWindowMonitor(s.handle) != nullptr)) return;
    GLFWmonitor* monitor = glfwGetPrimaryMonitor();
    const GLFWvidmode* mode = monitor == nullptr ? nullptr : glfwGetVideoMode(monitor);
    if (fullscreen && mode != nullptr) {
        glfwGetWindowPos(s.handle, &s.windowed_x, &s.windowed_y);
        glfwGetWindowSize(s.handle, &s.windowed_size.width, &s.windowed_size.height);
        glfwSetWindowMonitor(s.handle, monitor, 0, 0, mode->width, mode->height, mode->refreshRate);
    }
    if (!fullscreen) {
        const Size size = s.windowed_size == Size{} ? size_on_screen(s.spec.size) : s.windowed_size;
        glfwSetWindowMonitor(s.handle, nullptr, s.windowed_x, s.windowed_y, size.width, size.height,
                             GLFW_DONT_CARE);
    }
}

void Window::set_title(const std::string& title) { glfwSetWindowTitle(state_->handle, title.c_str()); }

Size Window::size() const { return state_->size; }
bool Window::minimised() const { return state_->minimised; }
bool Window::focused() const { return state_->focused; }
bool Window::should_close() const { return state_->closing; }
void Window::cancel_close() { state_->closing = false; }

void Window::make_current() {
    glfwMakeContextCurrent(state_->handle);
    glfwSwapInterval(state_->spec.vsync ? 1 : 0);
}

void Window::release_current() { glfwMakeContextCurrent(nullptr); }
void Window::present() { glfwSwapBuffers(state_->handle); }

}  // namespace thaum::render
