// SPDX-License-Identifier: GPL-3.0-or-later
// Times the parts of the geodesics engine on the pairs of one mesh, one thread each; prints one
// line of JSON.
#include <cstdlib>
#include <iostream>
#include <vector>

#include "bench/bench_support.h"
#include "vcg_ext/geodesics/coherent_paths.h"
#include "vcg_ext/geodesics/flat_vertices.h"
#include "vcg_ext/geodesics/path_certificate.h"
#include "vcg_ext/geodesics/spatial_numbering.h"
#include "vcg_ext/geodesics/window_propagation.h"
#include "vcg_ext/mgf_skeleton.h"

namespace {

using mgf::Index;
using mgf::bench::Json;
using mgf::bench::Stopwatch;

/// Seconds of processor time since the last call.
class Lap {
 public:
  double next() {
    const double now = watch_.cpu();
    const double lap = now - last_;
    last_ = now;
    return lap;
  }

 private:
  Stopwatch watch_;
  double last_ = 0.0;
};

/// Paths for all pairs with the effort given.
mgf::PairPaths find_paths(const mgf::HalfedgeMesh& mesh, const mgf::PairNumbering& question,
                          mgf::ShorteningEffort effort) {
  mgf::PairPaths paths(question.pairs().size());
  mgf::CoherentPaths(mesh, question.pairs(), question.links(), effort, 1, paths).run({});
  return paths;
}

/// Nanoseconds a directed edge of straightening all corridors once.
double time_funnel(const mgf::HalfedgeMesh& mesh, const mgf::PairNumbering& question,
                   const mgf::PairPaths& paths) {
  mgf::Funnel funnel(mesh);
  std::size_t crossed = 0;
  double length = 0.0;
  Lap lap;
  for (Index i = 0; i < question.pairs().size(); ++i) {
    if (!paths.has(i)) continue;
    length += funnel.straighten(question.pairs()[i].a, question.pairs()[i].b, paths.corridor[i]);
    crossed += paths.corridor[i].size();
  }
  const double seconds = lap.next();
  return length > 0.0 ? 1e9 * seconds / static_cast<double>(crossed) : 0.0;
}

/// Searches from every 16th pair's first end to its second; nanoseconds a window.
double time_windows(const mgf::HalfedgeMesh& mesh, const mgf::PairNumbering& question,
                    const mgf::PairPaths& paths) {
  constexpr Index kStride = 16;
  mgf::WindowPropagation search(mesh);
  std::size_t windows = 0;
  Lap lap;
  for (Index i = 0; i < question.pairs().size(); i += kStride) {
    const auto [a, b] = question.pairs()[i];
    search.run(mgf::place_of_vertex(mesh, a), {{mgf::place_of_vertex(mesh, b), paths.length[i]}});
    windows += search.window_count();
  }
  return 1e9 * lap.next() / static_cast<double>(windows);
}

Json measure(const std::string& file) {
  const mgf::MedialAxis axis = mgf::compute_medial_axis(mgf::bench::read_surface(file));
  const mgf::TriangleSurface& surface = axis.surface.surface;
  const mgf::PairTable table = mgf::detail::pairs_of_complex(axis.complex, surface);

  Json line;
  line["mesh"] = file;
  line["vertices"] = surface.points.size();
  line["pairs"] = table.pairs().size();
  Json& seconds = line["cpu_seconds"];
  Lap lap;
  const mgf::SpatialNumbering numbering(surface);
  const mgf::PairNumbering question(numbering, table.pairs(),
                                    mgf::detail::links_of_complex(axis.complex, table));
  seconds["numbering"] = lap.next();
  const mgf::HalfedgeMesh mesh = mgf::make_halfedge_mesh(numbering.surface());
  seconds["halfedge_mesh"] = lap.next();
  const mgf::CoarseSurface coarse = mgf::without_flat_vertices(numbering.surface());
  seconds["flat_vertices"] = lap.next();
  mgf::PairPaths rough = find_paths(mesh, question, mgf::ShorteningEffort::kRough);
  seconds["rough_paths"] = lap.next();
  const mgf::PairPaths full = find_paths(mesh, question, mgf::ShorteningEffort::kFull);
  seconds["full_paths"] = lap.next();
  mgf::PathCertificate(mesh, mgf::SearchSurface(numbering.surface(), mesh), question.pairs(), 1, {},
                       rough)
      .run(1, {});
  seconds["certificate"] = lap.next();
  line["flat_vertices"] = surface.points.size() - coarse.surface.points.size();
  line["funnel_ns_per_edge"] = time_funnel(mesh, question, full);
  line["propagation_ns_per_window"] = time_windows(mesh, question, full);
  return line;
}

}  // namespace

int main(int count, char** values) {
  if (count != 2) {
    std::cerr << "usage: geodesics_micro MESH\n";
    return 2;
  }
  return mgf::bench::report_line([&] { return measure(values[1]); });
}
