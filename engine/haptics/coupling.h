// haptics/coupling.h: the virtual coupling of the lift and swing wands (paper 002, on the game HaptiCast,
// section 3.1.1): a spring and damper between the haptic interface point (HIP) and an object in the world.
//
//     force on the object = stiffness (P_HIP - P_obj) + damping (V_HIP - V_obj),   the opposite on the hand
//
// Explicit steps of such a spring are unstable if stiffness dt^2 / mass is large, and implicit steps
// dissipate its energy. This one is integrated exactly over the step (haptics/oscillator.h) while the HIP
// moves at constant velocity. It is therefore accurate and stable at any stiffness, mass ratio and step.
//
// Data flow: settings, masses and dt -> CouplingStep (once) -> couple() each step -> an impulse for the
// physics. If the physics moves the body by its new velocity alone, the position is off by about half of
// velocity_change times dt. To follow the spring exactly and still collide, give the body the velocity
// displacement / dt for the step. After the step, set its velocity to velocity + velocity_change.
#pragma once
#include "core/maths.h"
#include "haptics/oscillator.h"

namespace thaum::haptics {

/// Spring and damper between hand and object, and drag of the object.
struct Coupling {
    double stiffness{};  ///< stiffness of the spring, >= 0 (N/m)
    double damping{};    ///< damping between hand and object, >= 0 (N s/m)
    /// Damping of the object's velocity against CouplingState::drag_velocity, such as the player's, >= 0 (N
    /// s/m). The hand does not feel it.
    double drag{};
};

/// A coupling, with the constants that depend only on the step length and the two masses.
struct CouplingStep {
    Coupling coupling{};
    double inverse_object{};  ///< inverse mass of the object (1/kg)
    double inverse_hand{};    ///< inverse mass of the hand (1/kg)
    /// Share of the relative motion of hand and object that the object makes, by their masses; 1 if the
    /// coupling does not move the hand.
    double share{};
    Oscillator relative{};  ///< oscillator that describes the HIP's motion relative to the object
    Response response{};    ///< closed-form motion of that oscillator over a step
};

/// Prepares steps of `dt` seconds, dt > 0. The inverse masses are in 1/kg, >= 0; 0 is a body that nothing
/// moves. A hand with inverse mass 0, the usual case, moves at its given velocity whatever the coupling does
/// (a prescribed hand). A drag needs a prescribed hand: with a free hand, the equation of the relative motion
/// would be of third order.
CouplingStep coupling_step(Coupling coupling, double inverse_object, double inverse_hand, double dt);

/// Motion of hand and object at the start of a step (world frame).
struct CouplingState {
    vec3 hand{};  ///< position P_HIP (m)
    /// Velocity V_HIP (m/s); constant over the step except for the coupling's effect on a free hand.
    vec3 hand_velocity{};
    vec3 object{};               ///< position P_obj, where the spring holds the object (m)
    vec3 object_velocity{};      ///< velocity of the object (m/s)
    vec3 drag_velocity{};        ///< velocity of the frame against which the drag acts (m/s)
    vec3 object_acceleration{};  ///< acceleration by other constant forces, such as gravity (m/s^2)
};

/// Impulses and motions of one step of a coupling between hand and object.
struct CouplingResult {
    vec3 impulse{};       ///< impulse of spring and damper on the object; the hand gets the opposite (N s)
    vec3 mean_force{};    ///< mean force of spring and damper on the object over the step (N)
    vec3 drag_impulse{};  ///< impulse of the drag on the object (N s)
    /// Change of the object's velocity by coupling, drag and other forces (m/s).
    vec3 velocity_change{};
    vec3 displacement{};  ///< displacement of the object over the step if nothing else touches it (m)
};

/// Advances a coupling between hand and object by one step. The result is exact to rounding, and finite for
/// finite input that does not overflow.
CouplingResult couple(const CouplingStep& step, const CouplingState& state);

/// Transform between device frame and world frame, with a scale for lengths and one for forces (HAPTICS.md,
/// "Units, frames and state").
struct CouplingFrame {
    mat3 player_to_world{1.0};    ///< R_g: rotation from the player's frame to the world
    mat3 device_to_player{1.0};   ///< R_d: device frame to player's frame, orthonormal; may exchange or
                                  ///< mirror axes
    double metres_per_metre = 1;  ///< s_x: world length per device length, > 0
    double newtons_per_newton{};  ///< s_f: device force per world force, >= 0
    vec3 player{};                ///< P_player: position of the player (m, world)
    vec3 taken_object{};          ///< P_obj0: position of the object when it was taken (m, player's frame)
    /// P_device0: position of the device when the object was taken (m, device frame)
    vec3 taken_device{};
};

/// Place of the hand in the world (haptic interface point), with the symbols of CouplingFrame and the
/// device's position P_device: P_HIP = P_player + R_g (P_obj0 + R_d s_x (P_device - P_device0)) (m, world).
/// When the object is taken, it equals the object's position.
vec3 interface_point(const CouplingFrame& frame, vec3 device);
/// Turns a world vector v into the device frame: R_d^T R_g^T v. If the object gets the force F, the hand
/// feels -s_f to_device(F), with the scale of forces s_f = CouplingFrame::newtons_per_newton.
vec3 to_device(const CouplingFrame& frame, vec3 world);
/// Stiffness that the hand feels (N/m): `stiffness` times the frame's scales of force and length. It must
/// stay below the largest stiffness that the device renders stably.
double felt_stiffness(const CouplingFrame& frame, double stiffness);

}  // namespace thaum::haptics
