// tools/plot/svg.h: figures as SVG that stands alone. Legible on white paper and, where the reader asks for it, on a dark
// screen; needs no script and no font of its own.
#pragma once
#include <string>

#include "tools/plot/axis.h"
#include "tools/plot/figure.h"

namespace thaum::plot {

/// The axes that to_svg(FrontFigure) draws by.
struct FrontAxes {
    LogAxis time;   ///< to the right
    LogAxis error;  ///< upwards
};
FrontAxes axes_of(const FrontFigure&);

/// Every point is there, with its row as a tooltip. The front is joined and labelled, the default ringed; a label that finds
/// no room is left out.
std::string to_svg(const FrontFigure&);

/// Bars from 1 to the ratio, on a logarithmic axis, with their numbers.
std::string to_svg(const RatioFigure&);

}  // namespace thaum::plot
