// Tests that Bullet and all other code of the program use the functions of core/maths.h.
#include <LinearMath/btTransformUtil.h>
#include <btBulletDynamicsCommon.h>
#include <dlfcn.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/maths.h"
#include "physics/bullet_maths.h"

namespace thaum::physics {
namespace {

/// The C library's own function, which ours of the same name hides.
template <class Function>
Function* of_libm(const char* name) {
    void* const library = dlopen("libm.so.6", RTLD_LAZY);
    return library == nullptr ? nullptr : reinterpret_cast<Function*>(dlsym(library, name));
}

TEST(PhysicsMaths, BulletTakesNoFunctionFromTheMachine) {
    for (const auto& function : foreign_maths()) ADD_FAILURE() << function;
}

TEST(PhysicsMaths, ProcessSeesOurFunctionsFirst) {
    for (const char* name : {"sin", "cos", "sincos", "acos", "asin", "atan2", "pow"}) {
        void* const seen = dlsym(RTLD_DEFAULT, name);
        ASSERT_NE(seen, nullptr) << name;
        EXPECT_NE(seen, reinterpret_cast<void*>(of_libm<void()>(name))) << name;
    }
}

/// btRigidBody::applyDamping is compiled into Bullet's library. It multiplies the velocity by
/// pow(1 - damping, dt).
TEST(PhysicsMaths, DampingInsideBulletsLibraryIsOurs) {
    auto* const machine_pow = of_libm<double(double, double)>("pow");
    ASSERT_NE(machine_pow, nullptr);
    btSphereShape sphere(1);
    btRigidBody body(btRigidBody::btRigidBodyConstructionInfo(1, nullptr, &sphere, {1, 1, 1}));
    int format = 0;
    for (int i = 1; i < 1000; ++i) {
        const double damping = i * 0.000999, dt = 0.37 + i * 0.0011;
        const double ours = det::pow(1 - damping, dt);
        body.setLinearVelocity({1, 0, 0});
        body.setDamping(damping, 0);
        body.applyDamping(dt);
        ASSERT_EQ(body.getLinearVelocity().x(), ours) << damping << ' ' << dt;
        format += machine_pow(1 - damping, dt) != ours;
    }
    EXPECT_GT(format, 10)
        << "too few arguments at which the system's function differs; the test could not fail";
}

/// btRigidBody::predictIntegratedTransform turns a body by sin and cos of half the angle. The same
/// header compiled into this file certainly calls our functions, because the linker binds those calls.
TEST(PhysicsMaths, TurnInsideBulletsLibraryIsOurs) {
    auto* const machine_sin = of_libm<double(double)>("sin");
    ASSERT_NE(machine_sin, nullptr);
    btSphereShape sphere(1);
    btRigidBody body(btRigidBody::btRigidBodyConstructionInfo(1, nullptr, &sphere, {1, 1, 1}));
    int format = 0;
    for (int i = 1; i < 5000; ++i) {
        const double angle = i * 0.000156;
        body.setAngularVelocity({angle, 0, 0});
        btTransform turned, expected;
        body.predictIntegratedTransform(1, turned);
        btTransformUtil::integrateTransform(body.getWorldTransform(), {0, 0, 0}, {angle, 0, 0}, 1, expected);
        for (int row = 0; row < 3; ++row)
            ASSERT_TRUE(turned.getBasis()[row] == expected.getBasis()[row]) << angle;
        format += machine_sin(0.5 * angle) != det::sin(0.5 * angle);
    }
    EXPECT_GT(format, 10);
}

TEST(PhysicsMaths, RestOfTheProgramGetsThemToo) {
    volatile double x = 1e22;
    EXPECT_EQ(std::sin(x), -0.8522008497671888);
    x = HUGE_VAL;
    EXPECT_TRUE(std::isnan(std::cos(x)));
    x = 10;
    EXPECT_EQ(std::pow(x, 22), 1e22);
    x = -8;
    EXPECT_EQ(std::pow(x, 3), -512);
    x = -0.0;
    EXPECT_TRUE(std::signbit(std::asin(x)));
    double sine = 0, cosine = 0;
    x = 0.5;
    sincos(x, &sine, &cosine);
    EXPECT_EQ(sine, det::sin(0.5));
    EXPECT_EQ(cosine, det::cos(0.5));
}

/// The value must be the same in every build and on every processor; tests run it again without FMA. If it
/// changes, the version of the rules must change.
TEST(PhysicsMaths, ProbeIsTheSameEverywhere) { EXPECT_EQ(maths_probe(), 11705066217827735670U); }

}  // namespace
}  // namespace thaum::physics
