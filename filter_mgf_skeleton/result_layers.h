// SPDX-License-Identifier: GPL-3.0-or-later
// The library's results as layers.
#pragma once

#include <string>
#include <vector>

#include "filter_mgf_skeleton/analysis.h"
#include "filter_mgf_skeleton/catalogue.h"
#include "filter_mgf_skeleton/layer.h"

namespace mgf::plugin {

/// What a value is shown as: 0, below every real one, for what isn't finite. Eccentricity can be
/// undefined, and the MGF infinite between pieces of a surface that cross each other.
double shown(double value);

/// A colour scale and the sentence for the log that says what it means.
struct Legend {
  io::ColourScale scale;
  std::string sentence;
};

/// The paper's colours over `values` but for the few most extreme; values that aren't finite don't
/// count. `quantity` is what they are, as the log calls it.
Legend make_legend(const std::string& quantity, std::vector<double> values);

/// The Voronoi facets as fans of triangles, with the radius as quality of the vertices and the two
/// contact points (in the user's numbering) and the facet's number kept per triangle; and as edges
/// the Voronoi edges that bound no facet.
struct FacetLayer {
  Layer layer;
  std::vector<Index> facet;  ///< one per triangle of the layer
};
FacetLayer facet_layer(const std::string& name, const MedialAxis& axis);

/// The quality chosen for a skeleton, and its colours.
struct SkeletonPaint {
  std::vector<double> of_node;
  std::vector<double> of_edge;
  std::vector<Colour> branch_colour;  ///< for quality by branch; else empty
  Legend legend;

  Colour colour(double quality) const;
};

/// Paint for the skeleton of `level`.
SkeletonPaint paint_skeleton(const SkeletonLevel& level, parameters::SkeletonQuality quality);

/// The same paint for its smooth form: same quality, same colours.
SkeletonPaint paint_smooth(const SmoothSkeleton& smooth, const SkeletonPaint& raw,
                           parameters::SkeletonQuality quality);

/// The skeleton as lines, with quality and colour on its nodes.
Layer line_layer(const std::string& name, const CurveSkeleton& skeleton,
                 const SkeletonPaint& paint);

/// The skeleton as tubes: colour that MeshLab shows and that survives every save. Quality and
/// colour are on faces and on vertices, since MeshLab forgets to show the faces' when a layer is
/// replaced. `graph` has the skeleton's own branches.
Layer tube_layer(const std::string& name, const CurveSkeleton& skeleton, const BranchGraph& graph,
                 const SkeletonPaint& paint);

/// The geodesic circles as closed lines with the eccentricity as quality of their points.
Layer circle_layer(const std::string& name, const GeodesicCircles& circles, const Legend& legend);

}  // namespace mgf::plugin
