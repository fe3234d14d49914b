// Drops a ball on a box in the installed physics and prints the state's hash, then mixes a sound, prints its
// size, and looks for pads. install_probe FILE also writes a picture by the installed renderer's code. It
// does not compile without the flags that the package carries.
#include <algorithm>
#include <array>
#include <iostream>

#include "audio/mixer.h"
#include "core/hash.h"
#include "core/text.h"
#include "input/pads.h"
#include "physics/bullet_maths.h"
#include "physics/physics.h"
#include "render/image.h"

#if !defined(BT_USE_DOUBLE_PRECISION)
#error "Bullet's types would be in single precision"
#endif
#if defined(__FMA__)
#error "results would depend on the processor"
#endif

/// Largest sample of a steady tone, heard from the right; -1 if nothing can be mixed.
float loudest_sample() {
    using namespace thaum::audio;
    SoundBank bank;
    bank.sounds.resize(1);
    bank.sounds[0].loops = true;
    bank.sounds[0].samples.assign(1000, 0.5F);
    auto mixer = Mixer::create(bank, {});
    if (!mixer) return -1;
    AudioFrame frame;
    frame.lasts.add({.position = {1, 0, 0}});
    std::array<float, block_values> block{};
    for (int i = 0; i < 4; ++i) mixer->play(frame, block);
    return *std::max_element(block.begin(), block.end());
}

int main(int count, char** arguments) {
    using namespace thaum;
    physics::Physics physics;
    physics.add(1, {.shape = physics::Shape::box, .size = {5, 1, 5}}, {.position = {0, -1, 0}});
    physics.add(2, {.shape = physics::Shape::sphere, .size = {0.1, 0, 0}, .mass = 1, .restitution = 0.8},
                {.position = {0, 1, 0}, .velocity = {1, 0, 0.5}});
    for (int tick = 0; tick < 2000; ++tick) physics.step(0.001);
    std::cout << text("ball at height ", physics.state(2).position.y, " m\nmathematics ",
                      hex(physics::maths_probe()), "\nhash ", hex(hash_value(physics.state(2))),
                      "\nloudest sample ", loudest_sample(), "\n");
    input::PadReader pads;
    pads.poll();
    if (!pads.fault().empty()) return 1;
    const render::Image image{2, 1, {255, 0, 0, 0, 0, 255}};
    return count < 2 || render::write_png(arguments[1], image) ? 0 : 1;
}
