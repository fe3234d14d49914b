// gesture/trials/methods.h: all recognisers of this folder behind one interface, to compare them.
#pragma once
#include <memory>
#include <optional>
#include <span>
#include <string_view>

#include "core/error.h"
#include "gesture/calibration.h"
#include "gesture/gesture.h"

namespace thaum::gesture {

/// dot: dot product of paper 000 (Mora and Lee 2008). tdnn: time-delay network of paper 002 (on the game
/// HaptiCast). directions: network of paper 000 with directions as input. elastic: elastic distance to every
/// template. standard: the recogniser of the game. early: the likely gesture of an unfinished stroke
/// (prefix.h).
enum class Method : std::uint8_t { dot, tdnn, directions, elastic, standard, early };

/// Names of all methods, in the order of Method.
std::span<const std::string_view> method_names();
/// The method with this name; std::nullopt: there is none.
std::optional<Method> method_of(std::string_view name);

/// Answer of a method to one stroke.
struct Answer {
    std::uint32_t gesture = 0xffffffff;  ///< 0xffffffff for a stroke without a shape
    Evidence evidence{};
    double probability{};  ///< probability by the method's own calibration, 0 to 1; 1 if the method has none
};

/// A method of recognition, ready for strokes: it has been given its templates.
class Classifier {
public:
    virtual ~Classifier() = default;
    /// Recognises one stroke.
    virtual Answer classify(Points stroke) = 0;
};

/// Settings of a method.
struct MethodSettings {
    Channels channels{};
    std::uint64_t seed = 1;
    bool calibrate = false;  ///< true: calibrate the method itself with synthetic strokes
};

/// Makes a classifier from recorded strokes. The error names the gesture and the fault.
Expected<std::unique_ptr<Classifier>> make_classifier(Method method, std::span<const Gesture> gestures,
                                                      const MethodSettings& settings);

}  // namespace thaum::gesture
