// core/sin_cos.h: sine and cosine of one angle, for little more than the cost of one of them.
#pragma once

namespace thaum::det {

/// Sine and cosine of one angle.
struct SinCos {
    double sine;
    double cosine;
};

/// Sine and cosine of x (rad), with the same bits as `sin` and `cos` of core/maths.h.
SinCos sin_cos(double x);

}  // namespace thaum::det
