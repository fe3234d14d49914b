// gesture/close_look.h: finds exactly where a stroke within continuous motion starts and ends, and its
// distance to a template there.
//
// The spotter (spotter.h) compares parts of the motion, its windows, with the templates. Windows are coarse:
// their starts are a ninth of their length apart. A close look moves start and end of a window by 8, 4 and at
// last 2 % of its length, each time to the best of the eight neighbours, by the elastic distance of fine
// shapes (shape.h). Its work is cut into steps of four shapes or one comparison of eight pairs.
#pragma once
#include "gesture/recogniser.h"

namespace thaum::gesture {

/// Search for the exact beginning and end of a spotted stroke, a step at a time.
class CloseLook {
public:
    /// The recogniser must outlive this object.
    explicit CloseLook(const Recogniser& recogniser) : recogniser_(recogniser) {}

    /// Begins with a part of the motion (window) that the spotter found, from the point `first` to `last`,
    /// and the template that it resembles.
    void begin(std::size_t first, std::size_t last, const RecogniserSpace::Survivor& match);
    /// Ends the search without a result.
    void stop() { active_ = false; }
    /// Whether a search has begun and not ended yet.
    bool is_active() const { return active_; }
    /// Does one step, of which a search has many so that no tick takes long. Returns true when the search has
    /// ended; then the results below are valid.
    bool step(ShapeSpace& points);

    /// Index of the first point of the part of the motion that fits the template best.
    std::size_t first() const { return first_; }
    /// Index of the last point of that part.
    std::size_t last() const { return last_; }
    /// Elastic distance of that part from the template.
    float distance() const { return distance_; }

private:
    struct Place {
        std::size_t first{}, last{};
        bool is_shape{};
    };
    void look_at_centre(ShapeSpace& points);
    void make_neighbour(ShapeSpace& points);
    void compare();

    const Recogniser& recogniser_;
    FineKind kind_{};
    bool active_ = false;
    /// round_: number of the round of the search; 0 while the window with which it began is compared. made_:
    /// number of neighbouring windows whose shapes have been computed in this round.
    std::size_t round_ = 0, made_ = 0;
    std::size_t first_{}, last_{};
    float distance_{};
    FineShape template_{};
    std::array<Place, lanes> places_{};
    std::array<FineShape, lanes> shapes_{};
    EightFineShapes templates_{}, strokes_{};
};

}  // namespace thaum::gesture
