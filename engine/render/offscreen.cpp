// An OpenGL context in memory. Mesa's surfaceless platform needs no display and no graphics card. If the EGL
// library lacks this platform, its default display is tried.
#include <epoxy/egl.h>
// epoxy/egl.h must come before epoxy/gl.h.
#include <epoxy/gl.h>

#include <algorithm>
#include <array>
#include <utility>

#include "core/assert.h"
#include "core/text.h"
#include "render/context.h"

namespace thaum::render {

struct Offscreen::State {
    EGLDisplay display = EGL_NO_DISPLAY;
    EGLSurface surface = EGL_NO_SURFACE;
    EGLContext context = EGL_NO_CONTEXT;
    Size size;

    State() = default;
    State(const State&) = delete;
    State& operator=(const State&) = delete;
    ~State() {
        if (display == EGL_NO_DISPLAY) return;
        if (eglGetCurrentContext() == context) {
            eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        }
        if (context != EGL_NO_CONTEXT) eglDestroyContext(display, context);
        if (surface != EGL_NO_SURFACE) eglDestroySurface(display, surface);
        // No eglTerminate: all contexts of a platform share one display, and another may still be in use.
    }
};

namespace {

EGLDisplay surfaceless_display() {
    if (!epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_EXT_platform_base") ||
        !epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_MESA_platform_surfaceless")) {
        return EGL_NO_DISPLAY;
    }
    // The function of the extension is called, because the one of the core, eglGetPlatformDisplay, aborts in
    // epoxy before a display is initialised.
    return eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
}

bool initialised(EGLDisplay display) {
    return display != EGL_NO_DISPLAY && eglInitialize(display, nullptr, nullptr) == EGL_TRUE;
}

EGLDisplay open_display() {
    if (!epoxy_has_egl()) return EGL_NO_DISPLAY;
    if (EGLDisplay d = surfaceless_display(); initialised(d)) return d;
    if (EGLDisplay d = eglGetDisplay(EGL_DEFAULT_DISPLAY); initialised(d)) return d;
    return EGL_NO_DISPLAY;
}

EGLConfig choose_config(EGLDisplay display) {
    constexpr EGLint wanted[] = {EGL_SURFACE_TYPE,
                                 EGL_PBUFFER_BIT,
                                 EGL_RENDERABLE_TYPE,
                                 EGL_OPENGL_BIT,
                                 EGL_RED_SIZE,
                                 8,
                                 EGL_GREEN_SIZE,
                                 8,
                                 EGL_BLUE_SIZE,
                                 8,
                                 EGL_NONE};
    std::array<EGLConfig, 64> configs{};
    EGLint count = 0;
    if (eglChooseConfig(display, wanted, configs.data(), static_cast<EGLint>(configs.size()), &count) !=
        EGL_TRUE) {
        return nullptr;
    }
    // EGL sorts deeper colours first, but 10 bits take a software rasteriser twice as long as 8. With alpha
    // the pixel layout is that of windows, so read_pixels only copies. Views have depth in a target of their
    // own (Renderer): without depth here a software rasteriser copies rectangles fast, so one with depth is
    // only the second choice.
    const auto has = [&](EGLConfig config, EGLint name, EGLint wanted_value) {
        EGLint value = 0;
        return eglGetConfigAttrib(display, config, name, &value) == EGL_TRUE && value == wanted_value;
    };
    for (const bool any_depth : {false, true}) {
        for (const EGLint alpha : {8, 0}) {
            const auto* const end = configs.data() + count;
            const auto* found = std::find_if(std::as_const(configs).data(), end, [&](EGLConfig c) {
                return has(c, EGL_RED_SIZE, 8) && has(c, EGL_ALPHA_SIZE, alpha) && has(c, EGL_SAMPLES, 0) &&
                       (any_depth || (has(c, EGL_DEPTH_SIZE, 0) && has(c, EGL_STENCIL_SIZE, 0)));
            });
            if (found != end) return *found;
        }
    }
    return count > 0 ? configs[0] : nullptr;
}

EGLContext create_context(EGLDisplay display, EGLConfig config) {
    constexpr EGLint wanted[] = {EGL_CONTEXT_MAJOR_VERSION_KHR,
                                 3,
                                 EGL_CONTEXT_MINOR_VERSION_KHR,
                                 3,
                                 EGL_CONTEXT_OPENGL_PROFILE_MASK_KHR,
                                 EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT_KHR,
                                 EGL_NONE};
    if (eglBindAPI(EGL_OPENGL_API) != EGL_TRUE) return EGL_NO_CONTEXT;
    return eglCreateContext(display, config, EGL_NO_CONTEXT, wanted);
}

Error no_context(std::string_view what) {
    return fail(
        text("cannot draw without a window: ", what,
             "; install the packages libegl1 and libgl1-mesa-dri, which draw without a graphics card"));
}

}  // namespace

Offscreen::Offscreen(std::unique_ptr<State> state) : state_(std::move(state)) {}
Offscreen::Offscreen(Offscreen&&) noexcept = default;
Offscreen& Offscreen::operator=(Offscreen&&) noexcept = default;
Offscreen::~Offscreen() = default;

Expected<Offscreen> Offscreen::create(int width, int height) {
    THAUM_ASSERT(width > 0 && height > 0, "an offscreen context needs a size");
    auto state = std::make_unique<State>();
    state->size = {width, height};
    state->display = open_display();
    if (state->display == EGL_NO_DISPLAY) return no_context("EGL does not start");
    EGLConfig config = choose_config(state->display);
    if (config == nullptr) return no_context("EGL has no OpenGL pixel buffer");
    state->context = create_context(state->display, config);
    if (state->context == EGL_NO_CONTEXT) return no_context("OpenGL 3.3 is not available through EGL");
    const EGLint size[] = {EGL_WIDTH, width, EGL_HEIGHT, height, EGL_NONE};
    state->surface = eglCreatePbufferSurface(state->display, config, size);
    if (state->surface == EGL_NO_SURFACE) {
        return no_context(text("EGL makes no pixel buffer of ", width, " x ", height));
    }
    return Offscreen(std::move(state));
}

Size Offscreen::size() const { return state_->size; }

void Offscreen::make_current() {
    const auto& s = *state_;
    const auto made = eglMakeCurrent(s.display, s.surface, s.surface, s.context);
    THAUM_ASSERT(made == EGL_TRUE, "the context is current on another thread");
}

void Offscreen::release_current() {
    eglMakeCurrent(state_->display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
}

void Offscreen::present() { glFlush(); }

}  // namespace thaum::render
