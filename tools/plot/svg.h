// tools/plot/svg.h: figures as self-contained SVG. They are legible on white paper and, if the reader's
// system asks for dark colours, on a dark screen. They need no script and no font of their own.
#pragma once
#include <string>

#include "tools/plot/axis.h"
#include "tools/plot/figure.h"

namespace thaum::plot {

/// Axes used by to_svg(FrontFigure).
struct FrontAxes {
    LogAxis time;   ///< horizontal axis, to the right
    LogAxis error;  ///< vertical axis, upwards
};
FrontAxes axes_of(const FrontFigure&);

/// Draws every point with its row as a tooltip. The points of the Pareto front are joined by lines and
/// labelled, and the shipped setting is ringed. Labels for which there is no room are left out.
std::string to_svg(const FrontFigure&);

/// Draws bars from 1 to the ratio, labelled with their numbers, on a logarithmic axis.
std::string to_svg(const RatioFigure&);

}  // namespace thaum::plot
