// tests/unit/renderer_rig.h: a renderer without a window, for tests of pictures.
#pragma once
#include <gtest/gtest.h>

#include <optional>

#include "render/context.h"
#include "render/renderer.h"

namespace thaum::render {

/// A square picture of `Side` px. All tests of a suite share one renderer, because compiling its shaders
/// takes longer than drawing all pictures.
template <int Side>
class RendererTest : public testing::Test {
protected:
    static void SetUpTestSuite() {
        auto made = Offscreen::create(Side, Side);
        if (!made) return;
        context.emplace(std::move(*made));
        context->make_current();
        renderer.emplace(Renderer::create(THAUM_SOURCE_DIR "/assets").value());
        cube = renderer->upload(box(fvec3(0.5F), fvec3(1)));
    }
    static void TearDownTestSuite() {
        renderer.reset();
        context.reset();
    }
    void SetUp() override {
        if (!context) GTEST_SKIP() << "no OpenGL";
        ASSERT_TRUE(renderer);
    }

    static inline std::optional<Offscreen> context;
    static inline std::optional<Renderer> renderer;
    static inline MeshId cube{};  ///< mesh of a white cube, 1 m wide
};

}  // namespace thaum::render
