// haptics/coupling.h: the virtual coupling of the lift and swing wands (paper 002, 3.1.1): a spring and damper between
// the haptic interface point (HIP) and an object in the world.
//
//     force on the object = stiffness (P_HIP - P_obj) + damping (V_HIP - V_obj),   the opposite on the hand
//
// Explicit steps of such a spring blow up where stiffness dt^2 / mass is large, implicit ones eat its energy. This one is
// integrated exactly over the step (haptics/oscillator.h) while the HIP moves at constant velocity, so it is right at any
// stiffness, mass ratio and step, and cannot be unstable: it does what the continuous spring would.
//
// Data flow: settings, masses and dt -> CouplingStep (once) -> couple() each step -> an impulse for the physics. A physics
// that moves a body by its new velocity is off in position by half the impulse times dt; one that is given displacement / dt
// for the step, and after it what is missing to velocity + velocity_change, follows the spring exactly and still collides.
#pragma once
#include "core/maths.h"
#include "haptics/oscillator.h"

namespace thaum::haptics {

struct Coupling {
    double stiffness{};  ///< N/m, >= 0
    double damping{};    ///< N s/m, >= 0
    double drag{};       ///< N s/m, >= 0: of the object against the player's frame; the hand does not bear it
};

/// What one step needs and no step changes.
struct CouplingStep {
    Coupling coupling{};
    double inverse_object{};  ///< 1/kg
    double inverse_hand{};    ///< 1/kg
    double share{};           ///< of a relative motion, the object's part: 1 where the hand is prescribed
    Oscillator relative{};    ///< HIP minus object
    Response response{};      ///< of it over dt
};

/// dt in s, > 0. inverse_object and inverse_hand in 1/kg, >= 0; 0 is a body that nothing moves. A hand with inverse mass 0, the
/// usual one, is prescribed: it moves as it is given to. A drag needs a prescribed hand (with a free one the pair is of third order).
CouplingStep coupling_step(Coupling coupling, double inverse_object, double inverse_hand, double dt);

/// World frame, at the start of the step.
struct CouplingState {
    vec3 hand{};  ///< m, P_HIP
    vec3
        hand_velocity{};  ///< m/s, V_HIP; constant over the step but for what the coupling does to a free hand
    vec3 object{};        ///< m, P_obj: where the spring holds it
    vec3 object_velocity{};      ///< m/s
    vec3 drag_velocity{};        ///< m/s, of the frame that the drag holds on to
    vec3 object_acceleration{};  ///< m/s^2, from constant other forces, such as gravity
};

struct CouplingResult {
    vec3 impulse{};          ///< N s, of spring and damper on the object; minus this on the hand
    vec3 mean_force{};       ///< N, impulse / dt
    vec3 drag_impulse{};     ///< N s, on the object
    vec3 velocity_change{};  ///< m/s, of the object, from coupling, drag and other forces together
    vec3 displacement{};     ///< m, of the object over the step, where nothing else touches it
};

/// Exact to rounding; finite for finite input that does not overflow.
CouplingResult couple(const CouplingStep& step, const CouplingState& state);

/// Between the device's frame and the world's, and their two scales (haptics.md, "Two scales, one rule").
struct CouplingFrame {
    mat3 player_to_world{1.0};    ///< R_g, a rotation
    mat3 device_to_player{1.0};   ///< R_d, orthonormal, axes may be exchanged or mirrored
    double metres_per_metre = 1;  ///< s_x, world per device, > 0
    double newtons_per_newton{};  ///< s_f, device per world, >= 0
    vec3 player{};                ///< m, P_player in the world
    vec3 taken_object{};          ///< m, P_obj0: the object in the player's frame when it was taken
    vec3 taken_device{};          ///< m, P_device0: the device in its own frame then
};

/// P_HIP = P_player + R_g (P_obj0 + R_d s_x (P_device - P_device0)), m, world. Where the object is when it is taken.
vec3 interface_point(const CouplingFrame& frame, vec3 device);
/// R_d^T R_g^T v: a vector of the world in the device's frame. What the hand bears while the object gets F is -s_f times that of F.
vec3 to_device(const CouplingFrame& frame, vec3 world);
/// N/m that the hand feels, s_f s_x k: must stay under the device's limit.
double felt_stiffness(const CouplingFrame& frame, double stiffness);

}  // namespace thaum::haptics
