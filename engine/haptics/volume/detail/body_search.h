// haptics/volume/detail/body_search.h: search for the surface of a body of samples, as its picture shows it
// (haptics/volume/level_contact.h).
//
// The place of the surface comes from the samples that are drawn, linear between them (the drawn surface). So
// sheets of one sample are felt too. The direction of the surface comes from a smoothed field, whose own
// surface is the smooth surface (haptics/volume/smooth_grid.h). If the box has averages of blocks of samples,
// and their direction nearly agrees with that of the smoothed field, they give the direction, because it is
// less rough. Near the border of the box they do so only if the samples make coarse steps. A field that no
// picture shows, such as a filtered one, gives both place and direction.
//
// Samples make small steps in a surface, which a hand would feel as chatter. So a plane is put where the
// smooth field has its surface, but not farther from the drawn surface than a share of the tip's depth. Then
// the tip still feels the plane if and only if it is in the body that is drawn. Where a tip slides over
// deeper steps, the plane follows them by a limited distance in each tick, the slew. The proxy lies on the
// plane of the last tick, so the distance is measured from the proxy. A step on the tip's way may put the tip
// outside of the body, or nearly so. Then the force would fall at once. So the plane sinks before such a
// step, over the ticks that the tip needs to get there.
//
// Samples that are not finite count as a picture shows them (field::ShownRange).
//
// The body ends at the box of the samples. Where it reaches a face, the cut face is a wall with the
// face's normal. Within one sample of an edge, of the box or between cut face and surface, the
// normal turns from one to the other.
#pragma once
#include <optional>

#include "field/placement.h"
#include "haptics/volume/level_contact.h"

namespace thaum::haptics {

/// Searches in a frame with the middle of the box as its origin and the axes of the samples. Its lengths are
/// those of the reader's frame, the frame in which the field is read.
class BodySearch {
public:
    BodySearch(const LevelSurface& surface, const field::SampleBox& box, LevelContact& contact);

    /// The plane that holds a proxy on its way to `target` (reader's frame); std::nullopt if none does.
    std::optional<ContactPlane> first(vec3 proxy, vec3 target);
    /// The plane that keeps the place where the proxy would land out of the body; std::nullopt if that place
    /// is free.
    std::optional<ContactPlane> next(vec3 proxy, vec3 landing, vec3 target);

private:
    /// Direction out of the body at a place.
    struct Way {
        vec3 out{};
        double gradient{};  ///< length of the field's gradient there (1/m)
        double smooth{};    ///< distance along `out` to the surface of the smooth field, estimated by value
                            ///< and slope (m)
    };
    /// A place on the surface of the body, and the direction out of the body there.
    struct Found {
        vec3 place{};
        Way way{};
    };
    /// Gradient of the smoothed field at a place (axes of the sample box), and the place's depth.
    struct Slope {
        vec3 up{};
        double depth{};  ///< depth of the place behind the surface, estimated by value and slope (m)
    };
    /// A part of a straight line with one end outside the body and the other end inside.
    struct Bracket {
        vec3 from{}, to{};
        double at_from{}, at_to{};  ///< depth in the body at both ends (inside())
    };

    vec3 to_box(vec3 place) const;
    vec3 to_reader(vec3 place) const;
    vec3 to_samples(vec3 place) const;
    bool in_box(vec3 place) const;
    bool is_solid(double inside) const;
    /// Depth in the body, in units of the field; -infinity outside of the box and where the field is not
    /// finite.
    double inside(vec3 place);
    bool solid(vec3 place) { return is_solid(inside(place)); }
    std::optional<Way> way_out(vec3 place);
    std::optional<Slope> slope_of(const field::Scalar& here) const;
    std::optional<Slope> slope_at(vec3 place);
    double sample_along(vec3 out) const;
    vec3 at_box(vec3 out, double depth, vec3 place) const;

    std::optional<Found> near(vec3 place, vec3 target);
    std::optional<Found> on_smooth(vec3 place, const Way& way, vec3 target);
    std::optional<Found> leaving(vec3 place, double at_place, const Way& way, double limit);
    std::optional<Found> out_of_crevice(vec3 place, double at_place);
    std::optional<Found> entering(vec3 place, double at_place, const Way& way, double limit);
    std::optional<Found> between(vec3 from, vec3 to);
    vec3 crossing(Bracket bracket, double accuracy);
    std::optional<Found> found_at(vec3 place);
    Found found_at(vec3 place, vec3 start, const Way& way);
    bool is_on_way(const Found& found, vec3 from, vec3 to);
    bool stays_in(vec3 target, vec3 out, double depth, double height);
    double eased(const Found& found, vec3 proxy, vec3 target);
    std::optional<ContactPlane> plane_of(const std::optional<Found>& found, vec3 proxy, vec3 target);

    const LevelSurface& surface_;
    const field::SampleBox& box_;
    LevelContact& contact_;
    vec3 motion_{};  ///< motion of the tip in a tick (m)
    vec3 half_{};    ///< half of the box's extent (m)
    vec3 samples_per_metre_{};
    /// Factor from lengths in the frame in which the field is read to those of the samples' frame.
    double per_scale_{};
    double fine_{};  ///< smallest distance between samples (m)
};

}  // namespace thaum::haptics
