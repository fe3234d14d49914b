// render/with_renderer.h: runs a function that draws in a window.
#pragma once
#include <filesystem>
#include <utility>

#include "render/context.h"
#include "render/renderer.h"

namespace thaum::render {

/// Makes the window's OpenGL context current, and calls the function with a renderer, which is destroyed
/// before the context is released. Returns the function's error, or why there is no renderer.
template <class Run>
Expected<void> with_renderer(Window& window, const std::filesystem::path& assets, Run&& run) {
    window.make_current();
    Expected<void> went;
    {
        auto renderer = Renderer::create(assets);
        went = renderer ? std::forward<Run>(run)(*renderer) : renderer.error();
    }
    window.release_current();
    return went;
}

}  // namespace thaum::render
