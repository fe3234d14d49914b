// core/sin_cos.h: sine and cosine of one angle; both together cost little more than the sine alone.
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
