// core/sin_cos.h: sine and cosine of one angle for little more than the price of one.
#pragma once

namespace thaum::det {

struct SinCos {
    double sine;
    double cosine;
};

/// The same bits as core/maths.h's sin and cos (rad).
SinCos sin_cos(double x);

}  // namespace thaum::det
