// Tests with a real window. They need a display, for example under xvfb-run.
#include <gtest/gtest.h>

#include <cstdlib>
#include <thread>

#include "render/context.h"
#include "render/renderer.h"
#include "unit/message_of.h"

namespace thaum::render {
namespace {

bool has_display() { return std::getenv("DISPLAY") != nullptr; }

TEST(WindowTest, NoDisplayIsOneClearLine) {
    if (has_display() || std::getenv("WAYLAND_DISPLAY") != nullptr) GTEST_SKIP() << "there is a display";
    const auto message = message_of(Window::create({}));
    EXPECT_NE(message.find("DISPLAY"), std::string::npos) << message;
    EXPECT_EQ(message.find('\n'), std::string::npos);
}

TEST(WindowTest, DrawsFromAThreadOfItsOwn) {
    if (!has_display()) GTEST_SKIP() << "no display";
    auto window = Window::create({.title = "test", .size = {320, 200}}).value();
    EXPECT_EQ(window.size(), (Size{320, 200}));
    Image image;
    std::jthread drawing([&] {
        window.make_current();
        {
            auto renderer = Renderer::create(THAUM_SOURCE_DIR "/assets");
            if (renderer) {
                Frame frame{.width = 320, .height = 200};
                frame.overlay.items = {RectItem{{10, 10}, {20, 20}, fvec4(1, 0, 0, 1)}};
                renderer->draw(frame);
                image = renderer->read_pixels();
                window.present();
            }
        }
        window.release_current();
    });
    for (int i = 0; i < 10; ++i) window.poll({}, 0.01);
    drawing.join();
    ASSERT_EQ(image.rgb.size(), 3U * 320 * 200);
    EXPECT_EQ(image.rgb[3 * (15 * 320 + 15)], 255);
    EXPECT_EQ(image.rgb[3 * (25 * 320 + 25)], 0);
    EXPECT_FALSE(window.should_close());
}

TEST(WindowTest, IsNotLargerThanTheScreen) {
    if (!has_display()) GTEST_SKIP() << "no display";
    constexpr Size beyond_every_screen{9000, 6000};
    auto window = Window::create({.title = "test", .size = beyond_every_screen}).value();
    EXPECT_LT(window.size().width, beyond_every_screen.width);
    EXPECT_LT(window.size().height, beyond_every_screen.height);
    EXPECT_GE(window.size().width, 320);
}

TEST(WindowTest, CanBeOpenedAgain) {
    if (!has_display()) GTEST_SKIP() << "no display";
    for (int i = 0; i < 2; ++i) {
        auto window = Window::create({.title = "test", .size = {64, 64}}).value();
        window.capture_cursor(true);
        window.poll({});
        window.capture_cursor(false);
    }
}

}  // namespace
}  // namespace thaum::render
