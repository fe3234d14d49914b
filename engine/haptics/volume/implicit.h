// haptics/volume/implicit.h: implicit surfaces, objects given by a potential f(x) that is positive
// outside, zero on the surface and negative inside (Kim and others, "Virtual reality game modeling
// for a haptic jacket", section 3).
//
//     shapes (f in metres) --> Merged (one surface of several objects) --> Thickened, Decorated
//                          --> mode isosurface
//
// Each shape is a scalar field. The mode isosurface, with level 0 and solid_below, gives the contact point,
// friction that grows with depth, and the magnetic surface. Away from edges and from the middle of a shape,
// the length of the gradient of each shape is 1, so f is the distance to the surface.
//
// Each shape is constant data, views and numbers; reading it allocates nothing.
#pragma once
#include <span>

#include "field/field.h"
#include "haptics/surface/surface.h"

namespace thaum::haptics {

/// A ball.
struct Ball {
    vec3 centre{};    ///< place of the centre (m)
    double radius{};  ///< distance of the surface from the centre (m)

    field::Scalar operator()(vec3 place) const;
};

/// Everything behind a plane.
struct HalfSpace {
    vec3 place{};          ///< a point on the plane (m)
    vec3 normal{0, 1, 0};  ///< unit vector out of the solid

    field::Scalar operator()(vec3 place) const;
};

/// A bar with round ends.
struct Bar {
    vec3 from{}, to{};  ///< ends of the axis (m)
    double radius{};    ///< distance of the surface from the axis (m)

    field::Scalar operator()(vec3 place) const;
};

/// A box along the axes, with edges and corners rounded by `round`.
struct Block {
    vec3 centre{};   ///< place of the centre (m)
    vec3 half{};     ///< half extents, rounding included (m)
    double round{};  ///< radius of edges and corners, >= 0, at most the least half extent (m)

    field::Scalar operator()(vec3 place) const;
};

/// A ring about an axis.
struct Ring {
    vec3 centre{};       ///< place of the centre (m)
    vec3 axis{0, 1, 0};  ///< unit vector
    double radius{};     ///< radius of the middle line (m)
    double thickness{};  ///< radius of the ring's round cross-section (m)

    field::Scalar operator()(vec3 place) const;
};

/// Several objects as one: f = -blend log sum exp(-f_i / blend), with the potential f_i of each object. The
/// surface of f joins those of the objects by fillets of about the size of `blend`. Where two surfaces
/// coincide, the common one lies blend log 2 further out. The order of the parts changes nothing but
/// rounding.
struct Merged {
    std::span<const field::ScalarField> parts{};
    double blend{};  ///< size of the fillets, > 0 (m)

    field::Scalar operator()(vec3 place) const;
};

/// An object that is thicker by a distance on all sides. So a tip cannot pass through a sheet that is thinner
/// than the tip's motion in a tick. The gradient, and so the force's direction, is that of the object.
struct Thickened {
    field::ScalarField object{};
    double distance{};  ///< distance by which the object grows (m)

    field::Scalar operator()(vec3 place) const;
};

/// An object with a texture on its potential: f minus the height at the place. The texture's axes are fixed
/// in the field's frame.
struct Decorated {
    field::ScalarField object{};
    Texture texture{};
    const BumpMap* bumps{};  ///< map of heights for bumps; may be null for a grating

    field::Scalar operator()(vec3 place) const;
};

}  // namespace thaum::haptics
