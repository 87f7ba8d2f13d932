// A field throughout its volume, as a cloud.
#pragma once

#include "render/field_layer.h"

namespace delos::render {

/// Compose the grids of a field over what is opaque, front to back along a ray for each
/// pixel: densest where the metric is good, a grey haze where it is blind, and nothing
/// within solids. Values are blended between the samples that have one; where less than
/// half of the weight has one it is blind.
///
/// On a way ds of a ray lies the opacity 1 − exp(−ρ ds/D), D the diagonal of the grid;
/// ρ = 0.6 + 9 g³ with g from 0, worst, to 1, best; ρ = 1.6 of what is blind.
///
/// Source: Max, Optical models for direct volume rendering, IEEE TVCG 1 (1995), 99-108,
///         absorption and emission.
void draw_cloud(const Pen& pen, const session::DrawnField& drawn,
                const ColourRange& colours);

}  // namespace delos::render
