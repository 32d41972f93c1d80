// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <chrono>
#include <system_error>

#include "filter_mgf_skeleton/catalogue.h"
#include "filter_mgf_skeleton/export_bundle.h"
#include "filter_mgf_skeleton/filters/filters.h"
#include "filter_mgf_skeleton/io/peak_memory.h"
#include "filter_mgf_skeleton/io/report_json.h"
#include "filter_mgf_skeleton/precise_coordinates.h"
#include "filter_mgf_skeleton/reporting.h"
#include "vcg_ext/core/parallel.h"

namespace mgf::plugin {
namespace {

namespace fs = std::filesystem;

class Stopwatch {
 public:
  double seconds() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point start_ = Clock::now();
};

fs::path open_folder(const std::string& name) {
  if (name.empty()) {
    throw InputError("no_output_folder", "Say where the files shall go: 'outputFolder' is empty.");
  }
  std::error_code error;
  fs::create_directories(name, error);
  if (error) {
    throw InputError("output_folder",
                     "The folder '" + name + "' can't be made: " + error.message() + ".");
  }
  return name;
}

StudyOptions study_options(const ParameterValues& values, const TriangleSurface& mesh) {
  StudyOptions options;
  options.medial_axis = parameters::medial_axis_options(values, mesh);
  options.skeleton = parameters::skeleton_options(values);
  options.geodesics.threads = static_cast<unsigned>(values.count(parameters::threads()));
  options.medial_axis.use_threads(options.geodesics.threads);
  return options;
}

/// Computes everything; adds what the stages of the library don't time themselves to `stages`.
ExportBundle compute(const FilterInput& input, const TriangleSurface& mesh,
                     std::vector<io::StageReport>& stages) {
  constexpr double kStudyDone = 0.9;
  const StudyOptions options = study_options(input.values, mesh);
  ExportBundle bundle{mesh, {}, {}, {}, {}};
  bundle.study = input.workbench.study(mesh, options, Stage::kHierarchy,
                                       input.progress.slice(0.0, kStudyDone));
  const Stopwatch smoothing;
  input.progress.report(kStudyDone, "Smoothing");
  bundle.level = skeleton_level(bundle.study.result->hierarchy, options.skeleton.theta,
                                options.skeleton.prune);
  bundle.smooth = smooth_level(bundle.study, bundle.level);
  stages.push_back({"branches_and_smoothing", smoothing.seconds()});
  const Stopwatch segmentation;
  input.progress.report(0.95, "Segmentation");
  bundle.analysis = analyse_surface(bundle.study, bundle.level,
                                    input.values.number(parameters::eccentricity_threshold()));
  stages.push_back({"segmentation", segmentation.seconds()});
  return bundle;
}

/// Fills in what the bundle doesn't know.
void complete(io::Report& report, const FilterInput& input, const Stopwatch& watch) {
  const ParameterValues& values = input.values;
  report.input.file = input.name;
  report.input.vertices = to_index(input.mesh.points.size());
  report.input.faces = to_index(input.mesh.triangles.size());
  if (report.skeleton) {
    report.skeleton->theta = values.number(parameters::theta());
    report.skeleton->prune = values.number(parameters::prune());
  }
  if (report.segmentation) {
    report.segmentation->eccentricity_threshold =
        values.number(parameters::eccentricity_threshold());
  }
  report.threads = thread_count(static_cast<unsigned>(values.count(parameters::threads())));
  report.peak_memory_mb = io::peak_memory_mb();
  report.total_seconds = watch.seconds();
}

/// True if a warning of that code is only for the record.
bool is_harmless(const Warning& warning, const Diagnosis& diagnosis) {
  const Finding* finding = diagnosis.find(warning.code);
  return finding != nullptr && finding->severity == Severity::kHarmless;
}

FilterOutput describe(const ExportBundle& bundle, const fs::path& folder) {
  FilterOutput output;
  output.notes.push_back("Files written to " + folder.string());
  report_medial_axis(*bundle.study.axis, output);
  report_medial_geodesic_function(bundle.study.function->field, output);
  report_skeleton(*bundle.study.result, bundle.level, output);
  report_smooth(bundle.smooth, output);
  report_segmentation(bundle.analysis.segmentation, output);
  return output;
}

/// Computes and writes all files and the report.
FilterOutput export_all(const FilterInput& input, const fs::path& folder, const Stopwatch& watch) {
  const std::string& file = input.values.text(parameters::coordinates_file());
  const TriangleSurface mesh =
      file.empty() ? input.mesh : with_precise_coordinates(input.mesh, file);
  std::vector<io::StageReport> stages;
  const ExportBundle bundle = compute(input, mesh, stages);
  input.progress.report(0.98, "Writing files");
  const Stopwatch writing;
  write_bundle(folder, bundle);

  io::Report report = report_of(bundle);
  report.stages.insert(report.stages.end(), stages.begin(), stages.end());
  report.stages.push_back({"writing", writing.seconds()});
  const bool clean = std::all_of(
      report.warnings.begin(), report.warnings.end(),
      [&](const Warning& warning) { return is_harmless(warning, bundle.study.axis->diagnosis); });
  report.status = clean ? io::ReportStatus::kOk : io::ReportStatus::kWarning;
  complete(report, input, watch);
  io::write_report_json(folder / "report.json", report);
  return describe(bundle, folder);
}

/// Leaves a report of the failure and none of the other files, which would be of an earlier run.
void write_failure(const FilterInput& input, const fs::path& folder, const Stopwatch& watch,
                   const InputError& error) {
  remove_bundle(folder);
  io::Report report;
  report.status = io::ReportStatus::kFailed;
  report.error = Warning{error.code(), error.what()};
  complete(report, input, watch);
  io::write_report_json(folder / "report.json", report);
}

FilterOutput export_files(const FilterInput& input) {
  const Stopwatch watch;
  const fs::path folder = open_folder(input.values.text(parameters::output_folder()));
  try {
    try {
      return export_all(input, folder, watch);
    } catch (const InputError& error) {
      write_failure(input, folder, watch, error);
      throw;
    }
  } catch (const io::FileError& error) {
    throw InputError("file_error", error.what());
  }
}

}  // namespace

Filter export_files_filter() {
  using namespace parameters;
  Filter filter;
  filter.name = "Export Curve Skeleton Files";
  filter.python_name = "save_curve_skeleton_files";
  filter.effect = FilterEffect::kWritesFiles;
  filter.parameters =
      with_input_parameters({output_folder(), coordinates_file(), theta(), prune(),
                             eccentricity_threshold(), marking_rule(), open_pockets()});
  filter.parameters.push_back(threads());
  filter.help =
      std::string(
          "Computes everything and writes it to a folder, in double precision and in formats that "
          "other programs open: the medial axis with its geodesic function, the curve skeleton "
          "raw and smooth (PLY, SWC, GraphML, VTP), its branches as a table (CSV), the geodesic "
          "circles, the tubular/flat segmentation, the parts, the skeleton as coloured tubes, and "
          "a report of all numbers (JSON). MeshLab's own savers lose edges or attributes of "
          "these.<br>"
          "Each file appears whole or not at all. A mesh that can't be served leaves a report "
          "with the reason. No layer changes.") +
      kRequirement + kReference;
  filter.run = export_files;
  return filter;
}

}  // namespace mgf::plugin
